// Workers, for vite: their scripts become parts of the same build as the page, which share what they
// have in common. By itself vite makes a bundle of its own of each, and a first visit would load the
// library's host side three times.
//
// Invariant: the sources say `new Worker(new URL('./x.worker.ts', import.meta.url), ...)`, which goes
// in every browser and in vite's server as it stands.
import { dirname, resolve } from 'node:path';

const url = /new URL\(\s*'(\.\/[\w.-]+\.worker\.[jt]s)',\s*import\.meta\.url\)/g;

/** @returns {import('vite').Plugin} */
export function workers() {
    return {
        name: 'workers',
        apply: 'build',
        enforce: 'pre',
        transform(code, id) {
            const file = id.split('?')[0];
            const found = code.replaceAll(url, (_, path) => {
                const reference = this.emitFile({ type: 'chunk', id: resolve(dirname(file), path) });
                return `import.meta.ROLLUP_FILE_URL_${reference}`;
            });
            return found === code ? null : { code: found, map: null };
        },
    };
}
