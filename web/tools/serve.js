// Serves a folder on this machine, with the headers that isolate a page.
//   node serve.js FOLDER [PORT]   (default: 8420, or the next that is free)
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve } from 'node:path';

const folder = resolve(process.argv[2] ?? 'dist');
const given = process.argv[3];
const host = '127.0.0.1';
const types = /** @type {Record<string, string>} */ ({
    '.css': 'text/css', '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.png': 'image/png',
    '.svg': 'image/svg+xml', '.wasm': 'application/wasm', '.webmanifest': 'application/manifest+json',
    '.webp': 'image/webp',
});
const isolation = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

const server = createServer(async (request, response) => {
    try {
        const { pathname } = new URL(request.url ?? '/', `http://${host}`);
        const path = join(folder, normalize(`/${decodeURIComponent(pathname)}`), pathname.endsWith('/') ? 'index.html' : '');
        const body = await readFile(path);
        response.writeHead(200, {
            'Content-Type': types[extname(path)] ?? 'application/octet-stream', 'Cache-Control': 'no-cache', ...isolation,
        });
        response.end(body);
    } catch {
        response.writeHead(404).end();
    }
});
let port = Number(given ?? 8420);
server.on('error', (/** @type {NodeJS.ErrnoException} */ error) => {
    if (error.code === 'EADDRINUSE' && given === undefined && port < 8440) {
        server.listen(++port, host);
        return;
    }
    console.error(`serve.js: ${error.message}`);
    process.exit(1);
});
server.on('listening', () => console.log(`http://localhost:${/** @type {import('node:net').AddressInfo} */ (server.address()).port}/`));
server.listen(port, host);
