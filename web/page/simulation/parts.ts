// Where the parts of the library are once the page is built: '@modules' is the folder that the modules
// were built into (vite.config.ts).
import * as description from '../../src/interface.js';
import bodies from '@modules/bodies.wasm?url';
import bodiesThreads from '@modules/bodies-threads.wasm?url';
import single from '@modules/skvalp.wasm?url';
import threads from '@modules/skvalp-threads.wasm?url';

const urls: Record<string, string> = {
    'skvalp.wasm': single,
    'skvalp-threads.wasm': threads,
    'bodies.wasm': bodies,
    'bodies-threads.wasm': bodiesThreads,
};

export const parts = { description, module: (file: string) => fetch(urls[file]) };
