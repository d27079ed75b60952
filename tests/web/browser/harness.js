// Chromium for the tests: a server of folders, with the headers that isolate a page and without them,
// and pages in a browser without a window.
//
// Invariant: what goes wrong in a page unasked fails the test, at the latest in close.
import { existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, normalize } from 'node:path';

const fromWeb = createRequire(new URL('../../../web/package.json', import.meta.url));
const { chromium } = fromWeb('playwright-core');

/**
 * Chromium without a browser's own windows: the same engine in a third less of a processor's time. It has no
 * screen that can be turned.
 */
const shell = '/usr/bin/chromium-headless-shell';
const programOf = ({ whole = false }) =>
    process.env.SKV_CHROMIUM ?? (whole || !existsSync(shell) ? '/usr/bin/chromium' : shell);
const types = {
    '.html': 'text/html; charset=utf-8', '.css': 'text/css',
    '.js': 'text/javascript', '.mjs': 'text/javascript',
    '.json': 'application/json', '.webmanifest': 'application/manifest+json', '.wasm': 'application/wasm',
    '.png': 'image/png', '.svg': 'image/svg+xml',
};
const isolation = {
    'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp',
};
const empty = '<!doctype html><title>empty</title><link rel="icon" href="data:,">';
/** WebGL is drawn by the processor; root has no sandbox. */
const flags = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
if (process.getuid() === 0) {
    flags.push('--no-sandbox');
}
/** Pages are put together without a detour by WebGL, which takes a third of a test's time. */
const direct = '--disable-gpu-compositing';

/** ms: what a page is waited for takes seconds; a busy machine must not fail it. */
export const longest = 180000;
/**
 * ms: a browser that was told to end is not waited for longer, nor what is left of it. Twice it, or the
 * program after it, took 160 s.
 */
const patience = 10000;
const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms).unref());
/** @type {ReturnType<typeof setTimeout> | undefined} */
let end;

/**
 * Before a page begins: what goes by itself after some seconds, as messages and hints do, stays, for a busy machine
 * comes to look late.
 */
function letStay() {
    const { setTimeout } = window;
    window.setTimeout = (act, ms, ...given) => setTimeout(act, ms >= 5000 ? 2 ** 31 - 1 : ms, ...given);
}

/** Serves what the first of the folders has that has it; '/empty.html' is always there. */
function serve(folders, headers) {
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
        const within = path.endsWith('/') ? `${path}index.html` : path;
        const isFile = (/** @type {string} */ file) => existsSync(file) && statSync(file).isFile();
        const file = folders.map((folder) => join(folder, within)).find(isFile);
        if (!file && path !== '/empty.html') {
            response.writeHead(404, headers).end();
            return;
        }
        const type = types[extname(within)] ?? 'application/octet-stream';
        response.writeHead(200, { 'Content-Type': type, 'Cache-Control': 'no-store', ...headers });
        response.end(file ? readFileSync(file) : empty);
    });
    server.unref(); // a program that has failed ends
    return new Promise((resolve) => {
        server.listen(0, 'localhost', () =>
            resolve({ server, origin: `http://localhost:${server.address().port}` }));
    });
}

/**
 * Starts a browser that sees these folders.
 * @param {string[]} folders
 * @param {{ flags?: string[], composited?: boolean, whole?: boolean }} [options] flags besides those that are
 * always needed; whether the process of graphics puts pages together; and whether it is the browser that
 * people have
 */
export async function launch(folders, options = {}) {
    const program = programOf(options);
    if (!existsSync(program)) {
        throw new Error(`${program} is missing; ./test.sh installs it (Debian's package chromium)`);
    }
    const plain = await serve(folders, {});
    const isolated = await serve(folders, isolation);
    const args = [...flags, ...options.composited ? [] : [direct], ...options.flags ?? []];
    const browser = await chromium.launch({ executablePath: program, timeout: longest, args })
        .catch((error) => {
            throw new Error(`${program} does not start: ${error.message.split('\n')[0]}`, { cause: error });
        });
    /** @type {string[]} */
    const troubles = [];
    /**
     * A page in a context of its own, or in that of another page, to share what it has stored.
     * @param {string} path what comes after the server's name; or a whole URL, file: for example
     * @param {object} [view]
     * @param {boolean} [view.isolated]
     * @param {number} [view.width] CSS pixels
     * @param {number} [view.height]
     * @param {boolean} [view.touch]
     * @param {number} [view.ratio] device pixels in one
     * @param {import('playwright-core').BrowserContextOptions} [view.more] of playwright's
     * @param {import('playwright-core').BrowserContext} [view.context]
     * @param {(() => void) | (() => void)[]} [view.before] done in the page, and in its frames, before anything of theirs
     */
    const open = async (path, view = {}) => {
        const { width = 1024, height = 768, touch = false, ratio = 1 } = view;
        const context = view.context ?? await browser.newContext({
            // One would fetch all that a page could need, once for each page that a test opens.
            serviceWorkers: 'block', viewport: { width, height }, hasTouch: touch, isMobile: touch, deviceScaleFactor: ratio,
            ...view.more,
        });
        const page = await context.newPage();
        page.setDefaultTimeout(longest);
        for (const before of [letStay, view.before ?? []].flat()) {
            await page.addInitScript(before);
        }
        page.on('pageerror', (error) => troubles.push(error.stack ?? String(error)));
        page.on('console', (message) => message.type() === 'error'
            && troubles.push(`${message.text()} (${message.location().url})`));
        await page.goto(new URL(path, view.isolated ? isolated.origin : plain.origin).href);
        return page;
    };
    return {
        open,
        /** What has gone wrong since it was asked; whoever provokes something takes it. */
        takeTroubles: () => troubles.splice(0),
        /** Closes all pages: whoever waits for something in one of them is told so. */
        async closePages() {
            const all = browser.contexts().map((context) => context.close());
            await Promise.race([Promise.allSettled(all), pause(patience)]);
        },
        /** Ends the browser; throws if anything in a page has gone wrong. */
        async close() {
            await Promise.race([browser.close(), pause(patience)]);
            plain.server.close();
            isolated.server.close();
            if (troubles.length > 0) {
                throw new Error(`in the page: ${troubles.join('\n')}`);
            }
        },
    };
}

/**
 * A whole test: a browser for the time of `work`, whose failure is the program's, in one line
 * (SKV_VERBOSE=1: with where it was).
 * @param {string[]} folders
 * @param {(browser: Awaited<ReturnType<typeof launch>>) => Promise<void>} work
 * @param {Parameters<typeof launch>[1]} [options]
 */
export async function run(folders, work, options) {
    clearTimeout(end);
    try {
        const browser = await launch(folders, options);
        try {
            await work(browser);
        } catch (error) {
            console.error(browser.takeTroubles().join('\n'));
            throw error;
        } finally {
            await browser.close();
        }
    } catch (error) {
        console.error(process.env.SKV_VERBOSE ? error : error.message);
        process.exitCode = 1;
    }
    end = setTimeout(() => process.exit(), patience).unref();
}
