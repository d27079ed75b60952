// Where vite finds what CMake has built (build/web, or the folder in SKV_MODULES): '@modules' is what the
// page has of it, and interface.js lies there, though web/src imports it as a neighbour.
import { fileURLToPath } from 'node:url';

export const folder = process.env.SKV_MODULES ?? fileURLToPath(new URL('../../build/web', import.meta.url));

/** The modules that export what the page calls. */
export const page = `${folder}/page`;

export const alias = [
    { find: '@modules', replacement: page },
    { find: /^.*\/interface\.js$/, replacement: `${page}/interface.js` },
];
