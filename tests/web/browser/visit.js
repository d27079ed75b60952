// What a first visit to the page costs, in Chromium with nothing cached: for scripts/bench-web.sh, no test.
// Prints a Markdown table: of each visit the seconds from its start until the simulation is there and
// until water is, and how far the first second after it keeps up with real time; then the bytes that went
// over the network, brotli, until water is there and with an experiment and a plot open.
// Arguments: the folder of the built page, how many visits.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { brotliCompressSync } from 'node:zlib';

import { launch } from './harness.js';

const [folder, count = '5'] = process.argv.slice(2);
const types = {
    '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.svg': 'image/svg+xml',
    '.wasm': 'application/wasm', '.webp': 'image/webp', '.webmanifest': 'application/manifest+json',
};
/** Of each file that was asked for: its bytes. */
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
await new Promise((resolve) => server.listen(0, 'localhost', resolve));

/** Runs in the page before anything else: looks, frame by frame, how far it is. */
function watch() {
    const seen = window.seen = {};
    const look = () => {
        const now = performance.now() / 1000, state = window.skvalp?.state.value;
        seen.there ??= window.skvalp ? now : undefined;
        if (state?.worlds[0].particles > 0) {
            seen.water ??= { now, moment: state.moment };
            if (now - seen.water.now >= 1) {
                seen.pace = (state.moment - seen.water.moment) / 60 / (now - seen.water.now);
                return;
            }
        }
        requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
}

const total = () => [...sent.values()].reduce((sum, size) => sum + size, 0);
const kilo = (bytes) => `${(bytes / 1000).toFixed(1)} KB`;
const browser = await launch([folder]);
const view = { width: 1024, height: 768, more: { serviceWorkers: 'block' } };
const home = `http://localhost:${server.address().port}/index.html`;
console.log('| visit | simulation, s | water, s | pace of the first second |\n|--:|--:|--:|--:|');
for (let i = 0; i <= Number(count); i++) {
    sent.clear();
    const page = await browser.open('/empty.html', view);
    await page.addInitScript(watch);
    await page.goto(home);
    await page.waitForFunction(() => window.seen.water);
    const first = total();
    await page.waitForFunction(() => window.seen.pace !== undefined);
    const { there, water, pace } = await page.evaluate(() => window.seen);
    if (i > 0) { // the one before has made the browser itself ready, and packed the files
        console.log(`| ${i} | ${there.toFixed(2)} | ${water.now.toFixed(2)} | ${pace.toFixed(2)} |`);
    }
    if (i === Number(count)) {
        const early = new Set(sent.keys());
        await page.getByRole('button', { name: 'Scenes and experiments' }).click();
        await page.locator('.panel .list button').first().click();
        await page.getByRole('heading', { name: '1. Question' }).waitFor();
        await page.locator('.panel').getByRole('button', { name: 'Measure', exact: true }).click();
        await page.locator('.plot canvas').first().waitFor();
        console.log(`\nUntil water is there ${kilo(first)}; with an experiment and its plot ${kilo(total())}.\n`);
        for (const [path, size] of [...sent].sort(([, a], [, b]) => b - a)) {
            console.log(`    ${kilo(size).padStart(9)} ${early.has(path) ? ' ' : '+'} ${path.slice(1)}`);
        }
    }
    await page.context().close();
}
await browser.close();
server.close();
