// The library in node: the module from a file, the pool on worker threads, and files of the system.
import { existsSync, readFileSync, renameSync, statSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Worker, isMainThread, workerData } from 'node:worker_threads';

import { assemble } from './assemble.js';
import * as codecs from './codecs.js';
import { serve } from './pool.js';

/** @param {string} path */
function readFile(path) {
    return existsSync(path) && statSync(path).isFile() ? new Uint8Array(readFileSync(path)) : null;
}

/** @param {string} path @param {Uint8Array} bytes */
function writeFile(path, bytes) {
    try {
        writeFileSync(`${path}.part`, bytes);
        renameSync(`${path}.part`, path);
        return true;
    } catch {
        return false;
    }
}

/**
 * Loads the module for so many workers besides the caller's thread, or the one without threads. A
 * pool of n threads takes n - 1 of them; each world that has threads of its own has such a pool. They
 * end with the program, or with `end`.
 * @param {string} folder where skvalp.wasm, skvalp-threads.wasm and interface.js lie
 * @param {{ workers?: number, name?: string }} [options]
 */
export async function load(folder, { workers = 0, name = 'skvalp' } = {}) {
    const file = `${folder}/${name}${workers > 0 ? '-threads' : ''}.wasm`;
    const module = await WebAssembly.compile(readFileSync(file));
    const description = await import(pathToFileURL(resolve(folder, 'interface.js')).href);
    return assemble(module, description, { readFile, writeFile, codecs }, workers, (post, fail) => {
        const worker = new Worker(new URL(import.meta.url), { workerData: post });
        worker.on('error', fail);
        worker.unref();
        return worker;
    });
}

if (!isMainThread && workerData?.module) {
    serve(workerData);
}
