// What makes the page an app that is there without a network, for vite: icons, the manifest, and the
// service worker with the list of all files.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';

const sizes = [192, 512];

/** @param {string} svg @param {number} size @returns {Buffer} a PNG */
function draw(svg, size) {
    try {
        return execFileSync('rsvg-convert', ['--width', String(size), '--height', String(size), svg]);
    } catch (error) {
        throw new Error(`rsvg-convert cannot draw ${svg} (Debian's package librsvg2-bin): ${error}`);
    }
}

const manifest = {
    name: 'Skvalp',
    short_name: 'Skvalp',
    description: 'Water to play with, calibrated like the real thing.',
    start_url: './',
    scope: './',
    display: 'standalone',
    orientation: 'any',
    background_color: '#0e1520',
    theme_color: '#0e1520',
    icons: [
        { src: 'icon.svg', sizes: 'any', type: 'image/svg+xml' },
        ...sizes.map((size) => ({ src: `icon-${size}.png`, sizes: `${size}x${size}`, type: 'image/png' })),
    ],
};

/** In a frame there is nothing to install, and nothing is isolated. */
const register = `if ('serviceWorker' in navigator && window.top === window)
    navigator.serviceWorker.register('./service.js').catch(() => {});`;

/**
 * @param {string} icon the app's, an SVG file
 * @param {string} service the service worker's source
 * @returns {import('vite').Plugin}
 */
export function offline(icon, service) {
    return {
        name: 'offline',
        apply: 'build',
        transformIndexHtml: () => [
            { tag: 'link', attrs: { rel: 'manifest', href: './manifest.webmanifest' }, injectTo: 'head' },
            { tag: 'link', attrs: { rel: 'apple-touch-icon', href: './icon-192.png' }, injectTo: 'head' },
            { tag: 'script', children: register, injectTo: 'body' },
        ],
        generateBundle: {
            order: 'post',
            handler(_, bundle) {
                const put = (/** @type {string} */ fileName, /** @type {string | Uint8Array} */ source) =>
                    this.emitFile({ type: 'asset', fileName, source });
                put('icon.svg', readFileSync(icon));
                put('manifest.webmanifest', JSON.stringify(manifest));
                sizes.forEach((size) => put(`icon-${size}.png`, draw(icon, size)));
                const names = Object.keys(bundle).filter((name) => name !== 'index.html').sort();
                const isSpare = (/** @type {string} */ name) => /\/(skvalp-(?!threads-)|bodies-)[^/]*\.wasm$/.test(name);
                const kept = names.filter((name) => !isSpare(name) && !/^icon-/.test(name));
                const files = ['./', ...new Set([...kept, 'manifest.webmanifest', 'icon.svg'])];
                const list = (/** @type {string[]} */ all) => all.map((name) => `'${name}'`).join(', ');
                const source = readFileSync(service, 'utf8');
                const page = bundle['index.html'];
                const version = createHash('sha256').update(source).update(files.join())
                    .update(page?.type === 'asset' ? page.source : '').digest('hex').slice(0, 12);
                put('service.js', source.replace("'@files'", list(files))
                    .replace("'@ifUsed'", list(names.filter(isSpare))).replace('@version', version));
            },
        },
    };
}
