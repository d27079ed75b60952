// The scripts that the page's own imports, for vite: named in its HTML, so that they are fetched beside it and
// not after it. What vite does about that itself would not go in workers, which share these scripts.

/** @returns {import('vite').Plugin} */
export function preload() {
    return {
        name: 'preload',
        apply: 'build',
        transformIndexHtml: (_, { chunk }) => (chunk?.imports ?? []).map((name) => ({
            tag: 'link', attrs: { rel: 'modulepreload', crossorigin: true, href: `./${name}` }, injectTo: 'head',
        })),
    };
}
