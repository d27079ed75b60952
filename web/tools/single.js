// The whole page as one HTML file that runs from a disk, for vite: script, style and the module without
// threads, deflated. Invariant: what runs is the same script as the folder's, with the same module.
import { readFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';

/** As tools/workers.js: here every worker has the one script there is, and its name tells its part. */
const url = /new URL\(\s*'\.\/([\w-]+)\.worker\.[jt]s',\s*import\.meta\.url\)/g;
/** Comes first among the aliases. */
export const alias = [{ find: /^@modules\/([\w-]+)\.wasm\?url$/, replacement: 'virtual:module/$1' }];
const module = 'virtual:module/';

/** In place of the link to the icon. */
const head = '        <link rel="icon" href="@icon">\n        <style>@style</style>\n';

/** @param {string | Uint8Array} content */
const pack = (content) => deflateRawSync(content, { level: 9 }).toString('base64');

/**
 * @param {string} page the folder's HTML file
 * @param {string} inside what stands in it in place of its script
 * @param {string} wasm
 * @param {string} icon an SVG file
 * @returns {import('vite').Plugin}
 */
export function single(page, inside, wasm, icon) {
    return {
        name: 'single',
        enforce: 'pre',
        resolveId: (source) => (source.startsWith(module) ? `\0${source}` : null),
        load: (id) => (id.startsWith(`\0${module}`)
            ? `export default ${/\/(skvalp|bodies)$/.test(id) ? 'globalThis.skvalpModule' : "''"};` : null),
        transform: (code) => (url.test(code)
            ? { code: code.replaceAll(url, "import.meta.url.split('#')[0] + '#$1'"), map: null } : null),
        generateBundle: {
            order: 'post',
            handler(_, bundle) {
                const parts = Object.values(bundle);
                const scripts = parts.filter((part) => part.type === 'chunk');
                const styles = parts.flatMap((part) =>
                    (part.type === 'asset' && part.fileName.endsWith('.css') ? [part.source] : []));
                if (scripts.length !== 1 || parts.length !== 1 + styles.length) {
                    throw new Error(`more than one file is left: ${Object.keys(bundle).join(', ')}`);
                }
                /** @type {Record<string, string>} */
                const content = {
                    icon: `data:image/svg+xml;base64,${readFileSync(icon).toString('base64')}`,
                    style: styles.join(''),
                    script: pack(scripts[0].code),
                    module: pack(readFileSync(wasm)),
                };
                parts.forEach((part) => delete bundle[part.fileName]);
                const source = readFileSync(page, 'utf8')
                    .replace(/ *<link rel="icon".*\n/, head)
                    .replace(/ *<script type="module".*\n/, () => readFileSync(inside, 'utf8'))
                    .replace(/@(icon|style|script|module)\b/g, (_, name) => content[name]);
                this.emitFile({ type: 'asset', fileName: 'skvalp.html', source });
            },
        },
    };
}
