// A first visit to the built page, with nothing cached: for visit.js, which tells how long it takes, and
// delivery.js, which holds how much of it there may be.
//
// Invariant: a file counts once, with the bytes that brotli at its best makes of it; a KB is 1000 bytes.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { brotliCompressSync } from 'node:zlib';

const types = {
    '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.svg': 'image/svg+xml',
    '.wasm': 'application/wasm', '.webp': 'image/webp', '.webmanifest': 'application/manifest+json',
};

export const kilo = (bytes) => `${(bytes / 1000).toFixed(1)} KB`;

/** The page of a folder on a server that packs; `sent` has the bytes of each file that was asked for. */
export async function serve(folder) {
    const sent = new Map();
    const packed = new Map();
    const server = createServer((request, response) => {
        const path = normalize(new URL(request.url, 'http://localhost').pathname).replace(/\/$/, '/index.html');
        try {
            const body = packed.get(path) ?? brotliCompressSync(readFileSync(join(folder, path)));
            packed.set(path, body);
            sent.set(path, body.length);
            response.writeHead(200, {
                'Content-Type': types[extname(path)] ?? 'application/octet-stream', 'Content-Encoding': 'br',
                'Cache-Control': 'no-store', 'Cross-Origin-Opener-Policy': 'same-origin',
                'Cross-Origin-Embedder-Policy': 'require-corp',
            }).end(body);
        } catch {
            response.writeHead(404).end();
        }
    });
    server.unref();
    await new Promise((resolve) => server.listen(0, 'localhost', resolve));
    const home = `http://localhost:${server.address().port}/index.html`;
    return { home, sent, close: () => server.close() };
}

/** Bytes of some of the files; all of them unless it is said which. */
export function total(sent, counts = () => true) {
    return [...sent].reduce((sum, [path, size]) => sum + (counts(path) ? size : 0), 0);
}

/** The page before a visit begins. */
export const prepare = (browser) => browser.open('/empty.html', { width: 1024, height: 768 });

/** Opens an experiment and measures, until its plot shows. */
export async function measure(page) {
    await page.getByRole('button', { name: 'Scenes and experiments' }).click();
    await page.locator('.panel .list button').first().click();
    await page.getByRole('heading', { name: '1. Question' }).waitFor();
    await page.locator('.panel').getByRole('button', { name: 'Measure', exact: true }).click();
    await page.locator('.plot [role=img]').first().waitFor();
}
