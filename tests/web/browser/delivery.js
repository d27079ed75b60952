// The built page where people will meet it: on a server that knows nothing of isolation, without that
// server, after a new version, in another page, where nothing can be kept, without workers, and as a file
// from a disk; and how much of it a first visit takes.
// Arguments: the folder that was built, and one for another version of it.
import { cpSync, existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';

import * as arrival from './arrival.js';
import { carryOut } from './trials.js';

const [built, other] = process.argv.slice(2);
const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm', '.svg': 'image/svg+xml',
    '.css': 'text/css', '.webmanifest': 'application/manifest+json', '.png': 'image/png' };

/** Bytes of a first visit, in brotli. */
const most = 220000;

function expect(right, what) {
    if (!right) {
        throw new Error(what);
    }
}

/** A static server like those that give no headers; `folder` may change, `close` is felt at once. */
function serve(folder) {
    const asked = [];
    const self = { folder, asked, origin: '', close: () => {} };
    const server = createServer(({ url }, response) => {
        const path = new URL(url, 'http://localhost').pathname;
        const file = join(self.folder, path.endsWith('/') ? `${path}index.html` : path);
        asked.push(path);
        if (path === '/frame.html') {
            response.writeHead(200, { 'Content-Type': 'text/html' }).end('<link rel="icon" href="data:,"><iframe src="/" width=800 height=600></iframe>');
        } else if (path === '/favicon.ico') { // a picture alone asks for it
            response.writeHead(204).end();
        } else if (!existsSync(file)) {
            response.writeHead(404).end();
        } else {
            response.writeHead(200, { 'Content-Type': types[extname(file)] ?? 'application/octet-stream' });
            response.end(readFileSync(file));
        }
    });
    self.close = () => {
        server.closeAllConnections();
        return new Promise((resolve) => server.close(resolve));
    };
    server.unref();
    return new Promise((resolve) => server.listen(0, 'localhost', () => {
        self.origin = `http://localhost:${server.address().port}`;
        resolve(self);
    }));
}

/** Waits until the fluid of a page or frame has moved. */
async function plays(frame, what) {
    const moving = () => /playing/.test(document.body.innerText) && /\b(0\.[2-9]|[1-9]\d*\.\d)\ss\b/.test(document.body.innerText);
    await frame.waitForFunction(moving).catch(() => expect(false, `${what}: nothing moves`));
}

/** Whether its service worker is there, and has begun all that it begins with. */
const controlled = () => navigator.serviceWorker.controller?.state === 'activated';
const isolated = () => crossOriginIsolated;
/** Where the page may keep itself for a time without a network. */
const offline = { more: { serviceWorkers: 'allow' } };

/** Sets another version: what any change of the page makes of the folder. */
function makeOther() {
    cpSync(built, other, { recursive: true });
    const script = readdirSync(join(other, 'assets')).find((name) => /^index-.*\.js$/.test(name));
    const rename = (file) => writeFileSync(join(other, file),
        readFileSync(join(other, file), 'utf8').replaceAll(script, 'index-changed.js').replace(/version = '/, "version = 'changed"));
    cpSync(join(other, 'assets', script), join(other, 'assets/index-changed.js'));
    for (const file of ['index.html', 'service.js', ...readdirSync(join(other, 'assets')).filter((name) => name.endsWith('.js'))
        .map((name) => `assets/${name}`)]) {
        rename(file);
    }
}

const trials = {
    async 'it isolates itself, is renewed whole, and needs no server then'(browser) {
        const server = await serve(built);
        const page = await browser.open(`${server.origin}/`, offline);
        await plays(page, 'the first visit');
        expect(!(await page.evaluate(isolated)), 'the server isolates: nothing is shown');
        await page.waitForFunction(controlled);

        await page.reload();
        await plays(page, 'the second visit');
        expect(await page.evaluate(isolated), 'the page is not isolated once its service worker is there');

        const inside = await browser.open(`${server.origin}/frame.html`, { context: page.context() });
        await plays(inside.frames()[1], 'in a frame');
        expect(!(await inside.frames()[1].evaluate(isolated)), 'a frame says that it is isolated');
        await inside.close();

        makeOther();
        server.folder = other;
        server.asked.length = 0;
        await page.evaluate(async () => {
            const renewed = new Promise((resolve) => navigator.serviceWorker.addEventListener('controllerchange', resolve));
            await (await navigator.serviceWorker.ready).update();
            await renewed;
        });
        expect(!server.asked.some((path) => path.endsWith('.wasm')), 'what had not changed was fetched again');
        await page.reload();
        const scripts = () => [...document.scripts].map(({ src }) => src).join();
        expect((await page.evaluate(scripts)).includes('index-changed'), 'the new version does not come');

        await server.close();
        await page.reload();
        await plays(page, 'without the server');
        expect(await page.evaluate(isolated), 'the page is not isolated without the server');
    },

    async 'where nothing may be kept, it plays all the same'(browser) {
        const server = await serve(built);
        const awaitRefusal = () => {
            const { prototype } = ServiceWorkerContainer, { register } = prototype;
            prototype.register = async function (...given) {
                const registration = await register.apply(this, given), worker = registration.installing;
                const look = () => (window.refused = !worker || worker.state === 'redundant');
                worker?.addEventListener('statechange', look);
                look();
                return registration;
            };
        };
        const page = await browser.open(`${server.origin}/icon.svg`, { ...offline, before: awaitRefusal });
        const devtools = await page.context().newCDPSession(page);
        await devtools.send('Storage.overrideQuotaForOrigin', { origin: server.origin, quotaSize: 1000 });
        const refused = await page.evaluate(async () => {
            const cache = await caches.open('trial');
            const error = await cache.put('/trial', new Response('x'.repeat(100000))).catch(({ name }) => name);
            await caches.delete('trial');
            return error;
        });
        expect(refused === 'QuotaExceededError', `there is room: ${refused}`);
        await page.goto(`${server.origin}/`);
        await plays(page, 'with no room to keep anything');
        await page.waitForFunction(() => window.refused);
        expect((await page.evaluate(() => caches.keys())).length === 0, 'something half kept is left');
        await server.close();
    },

    async 'it plays without workers and memory to share, and says what that costs'(browser) {
        const server = await serve(built);
        const page = await browser.open(`${server.origin}/`, { before: () => {
            delete window.Worker;
            delete window.SharedArrayBuffer;
        } });
        await plays(page, 'without workers');
        expect(page.workers().length === 0, 'a worker came from somewhere');
        await page.getByRole('button', { name: 'Scenes and experiments' }).click();
        await page.locator('.panel .list button').first().click();
        await page.locator('.panel').getByRole('button', { name: 'Measure', exact: true }).click();
        await page.getByRole('alert').filter({ hasText: 'no workers, without which nothing is measured' }).waitFor()
            .catch(() => expect(false, 'an experiment does not run, and nobody says why'));
        await server.close();
    },

    async 'the single file runs from a disk'(browser) {
        const page = await browser.open(`file://${built}/skvalp.html`);
        await plays(page, 'the single file');
        const text = readFileSync(join(built, 'skvalp.html'), 'utf8');
        expect(!/(src|href)="(?!data:)/.test(text), 'the single file wants others');
        /* It has bodies, and nothing begins anew for them. */
        const { opened } = await page.evaluate(() => window.skvalp.state.value.worlds[0]);
        await page.getByRole('button', { name: 'Body', exact: true }).click();
        await page.waitForFunction(() => window.skvalp.state.value.tool === 8);
        const duck = readFileSync(new URL('../../../examples/duck.json', import.meta.url), 'utf8');
        await page.evaluate((text) => window.skvalp.simulation.openBytes(
            new TextEncoder().encode(text), 'json', 'duck.json', { particles: '500' }), duck);
        await page.waitForFunction(() => window.skvalp.state.value.worlds[0].title === 'Duck');
        expect((await page.evaluate(() => window.skvalp.state.value.worlds[0].opened)) === opened + 1,
            'something was opened besides');
        await page.evaluate(() => window.skvalp.simulation.open('dam-break'));
        await page.waitForFunction(() => window.skvalp.state.value.worlds[0].name === 'dam-break');
        await page.getByRole('button', { name: 'Main menu' }).click();
        await page.getByRole('button', { name: 'Share', exact: true }).click();
        await page.waitForFunction(() => document.querySelector('textarea.link')?.value);
        const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
        expect(/^skvalp:\d+\.[\w-]+$/.test(link), `the single file shares ${link.slice(0, 60)}`);
    },

    async 'a first visit, lab and plot included, takes no more than it may'(browser) {
        const server = await arrival.serve(built);
        const page = await arrival.prepare(browser);
        await page.goto(server.home);
        await plays(page, 'the first visit');
        await arrival.measure(page);
        server.close();
        // The gallery's pictures come as they are scrolled into view.
        const counts = (path) => !path.endsWith('.webp');
        const bytes = arrival.total(server.sent, counts);
        const parts = [...server.sent].filter(([path]) => counts(path)).sort(([, a], [, b]) => b - a);
        const largest = parts.slice(0, 8).map(([path, size]) => `${path} ${arrival.kilo(size)}`).join(', ');
        expect(parts.some(([path]) => /Plot/.test(path)), `no plot was fetched: ${largest}`);
        expect(bytes <= most, `a first visit takes ${arrival.kilo(bytes)} of ${arrival.kilo(most)}: ${largest}`);
        console.log(`a first visit takes ${arrival.kilo(bytes)}`);
    },
};

await carryOut([built], trials, [], { whole: true });
