// The npm package as bundlers take it. Arguments: a project that has it, the folder where bundlers are installed, and
// the hash that its world has natively.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { carryOut } from './trials.js';

const [project, bundlers, hash] = process.argv.slice(2);
const installed = createRequire(join(bundlers, 'package.json'));
const vite = await import(pathToFileURL(join(import.meta.dirname, '../../../web/node_modules/vite/dist/node/index.js')).href);

const isolation = {
    'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp',
};
const seenIn = async (browser, address) => {
    const page = await browser.open(address, { isolated: true });
    const seen = await page.waitForFunction(() => window.seen); // a server may load the page once more
    return seen.jsonValue();
};
/** One that nobody listens at: the page that vite serves is told of it, so it has to be known before. */
const freePort = () => new Promise((resolve) => {
    const server = createServer().listen(0, 'localhost', () => {
        const { port } = server.address();
        server.close(() => resolve(port));
    });
});
const both = { page: hash, worker: { hash, workers: 1 } };

const trials = {
    async 'vite builds it'(browser) {
        await vite.build({ root: project, configFile: false, logLevel: 'error', base: '/vite/',
            build: { outDir: join(project, 'out/vite'), target: 'es2022' } });
        assert.deepEqual(await seenIn(browser, '/vite/index.html'), both);
    },

    async 'vite serves it'(browser) {
        const server = await vite.createServer({ root: project, configFile: false, logLevel: 'error',
            server: { port: await freePort(), host: 'localhost', headers: isolation } });
        await server.listen();
        try {
            assert.deepEqual(await seenIn(browser, server.resolvedUrls.local[0]), both);
        } finally {
            await server.close();
        }
    },

    async 'webpack builds it'(browser) {
        const webpack = installed('webpack'), out = join(project, 'out/webpack');
        const stats = await new Promise((resolve, reject) => webpack({
            mode: 'production', context: project, entry: './main.js', output: { path: out, publicPath: 'auto' },
        }, (error, stats) => (error ? reject(error) : resolve(stats))));
        const { errors, warnings } = stats.toJson({ all: false, errors: true, warnings: true });
        assert.deepEqual(errors.map(({ message }) => message), []);
        assert.deepEqual(warnings.map(({ message }) => message).filter((text) => !/size limit|performance/.test(text)), []);
        writeFileSync(join(out, 'index.html'), '<!doctype html><link rel="icon" href="data:,"><script src="main.js"></script>');
        assert.deepEqual(await seenIn(browser, '/webpack/index.html'), both);
    },

    async 'esbuild builds it, and hands in the module'(browser) {
        const out = join(project, 'out/esbuild');
        execFileSync(process.execPath, [join(bundlers, 'node_modules/esbuild/bin/esbuild'), 'handed.js', '--bundle',
            '--format=esm', '--loader:.wasm=file', `--outdir=${out}`, '--log-level=error'], { cwd: project });
        writeFileSync(join(out, 'index.html'),
            '<!doctype html><link rel="icon" href="data:,"><script type="module" src="handed.js"></script>');
        assert.deepEqual(await seenIn(browser, '/esbuild/index.html'), { page: hash });
    },
};

await carryOut([join(project, 'out')], trials, [], { whole: true });
