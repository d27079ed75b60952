// The package in a browser: lib/skvalp.js, beside its modules.
//
// Invariant: each file is named by an address that bundlers know as that of an asset, written out whole.
import * as codecs from './codecs.js';
import { Skvalp } from './index.js';
import * as description from './interface.js';
import { loadParts } from './parts.js';
/** @import { Source } from './parts.js' */

export * from './index.js';

const addresses = {
    'skvalp.wasm': () => new URL('./skvalp.wasm', import.meta.url),
    'skvalp-threads.wasm': () => new URL('./skvalp-threads.wasm', import.meta.url),
};

/**
 * What a bundler that knows no such addresses hands in.
 * @typedef {object} OwnParts
 * @property {(file: 'skvalp.wasm' | 'skvalp-threads.wasm') => Source | Promise<Source>} module fetched, or its bytes
 * @property {() => Worker} [makeWorker] one over lib/pool.worker.js; wanted where there are to be threads
 */

/**
 * Loads the library. There are threads in a worker of an isolated page; elsewhere it is one.
 * @param {{ threads?: number, parts?: OwnParts }} [options]
 */
export async function open({ threads = 1, parts } = {}) {
    const module = parts?.module ?? ((file) => fetch(addresses[file]()));
    const makeWorker = parts?.makeWorker;
    return new Skvalp(await loadParts({ module, description },
        { workers: threads - 1, makeWorker, codecs }));
}
