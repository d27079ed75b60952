// The scripts that the page's own imports, for vite: named in its HTML, so that they are fetched beside it and
// not after it. What vite does about that itself would not go in workers, which share these scripts; so parts that
// come later are loaded without its help, of which two styles' files would be all the use.

/** The module that vite lets load what is imported later. */
const helper = '\0vite/preload-helper.js';

/** @returns {import('vite').Plugin} */
export function preload() {
    return {
        name: 'preload',
        apply: 'build',
        enforce: 'pre',
        config: () => ({ build: { cssCodeSplit: false } }),
        load: (id) => (id === helper ? 'export const __vitePreload = (load) => load();' : null),
        transformIndexHtml: (_, { chunk }) => (chunk?.imports ?? []).map((name) => ({
            tag: 'link', attrs: { rel: 'modulepreload', crossorigin: true, href: `./${name}` }, injectTo: 'head',
        })),
    };
}
