// How the page is built: `npm run build` makes dist/, a folder for any static host, and in it
// skvalp.html (mode `single`), which is all of it in one file.
/// <reference types="vitest/config" />
import { fileURLToPath } from 'node:url';

import { defineConfig } from 'vite';

import { alias, page } from './tools/modules.js';
import { offline } from './tools/offline.js';
import { preload } from './tools/preload.js';
import { alias as inFile, single } from './tools/single.js';
import { words } from './tools/words.js';
import { workers } from './tools/workers.js';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const icon = here('../app/resources/icons/org.skvalp.Play.svg');

/** ms: a test takes seconds; a busy machine must not fail it. */
const longest = 300000;

/** Packages of which less is needed than they would bring in. */
const smaller = [
    { find: /^jsonc-parser$/, replacement: here('tools/jsonc.js') },
    { find: /^fflate$/, replacement: here('tools/inflating.js') },
];

const toFolder = {
    alias: [...smaller, ...alias],
    // A picture is fetched when it is to be seen.
    build: { emptyOutDir: true, assetsInlineLimit: 0 },
    plugins: [workers(), preload(), offline(icon, here('page/offline/service.js'))],
};
const toFile = {
    alias: [...inFile, ...smaller, ...alias],
    build: {
        emptyOutDir: false, cssCodeSplit: false, assetsInlineLimit: 1e6,
        rolldownOptions: { input: here('page/single/start.ts'), output: { codeSplitting: false } },
    },
    plugins: [single(here('page/index.html'), here('page/single/inside.html'), `${page}/bodies.wasm`, icon)],
};

export default defineConfig(({ mode }) => {
    const { build, plugins, alias } = mode === 'single' ? toFile : toFolder;
    return {
        root: 'page',
        cacheDir: here('node_modules/.vite'),
        base: './',
        resolve: { alias },
        build: {
            outDir: '../dist', target: 'es2022', modulePreload: false, minify: 'terser',
            terserOptions: { ecma: 2020, module: true, compress: { passes: 3 } }, ...build,
        },
        plugins: [...plugins, words(here('../po'), here('page'))],
        worker: { format: 'es' },
        // Files share a process: none changes what is global, and each would load all anew.
        test: { testTimeout: longest, hookTimeout: longest, isolate: false },
        oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
    };
});
