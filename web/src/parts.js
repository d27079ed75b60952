// The library in a browser from its parts, in a worker or on the page: the module from whatever has it,
// the pool on workers, files from a map.
//
// Invariant: what cannot be had with threads is had without: where the page is not isolated, may not
// block, gets no memory to share or no workers.
import { assemble } from './assemble.js';

/**
 * What a bundler or a page of one file has instead of a folder.
 * @typedef {object} Parts
 * @property {(file: any) => Source | Promise<Source>} module 'skvalp.wasm' or 'skvalp-threads.wasm'
 * @property {typeof import('./interface.js')} description interface.js
 */
/** @typedef {Response | BufferSource | WebAssembly.Module} Source */

/** A page may not wait in memory; workers may. */
const mayBlock = typeof document === 'undefined';

/** @param {Source} source */
async function compile(source) {
    if (source instanceof WebAssembly.Module) {
        return source;
    }
    if (!(source instanceof Response)) {
        return WebAssembly.compile(source);
    }
    if (!source.ok) {
        throw new Error(`${source.url}: the server answers ${source.status}`);
    }
    return source.headers.get('Content-Type') === 'application/wasm'
        ? WebAssembly.compileStreaming(source)
        : WebAssembly.compile(await source.arrayBuffer());
}

/**
 * Loads the module for so many workers besides the caller's thread, or the one without threads: the
 * library's `workers` says how many there are. A pool of n threads takes n - 1 of them; each world that
 * has threads of its own has such a pool. `files` has what scenes name and gets what is saved.
 * @param {Parts} parts
 * @param {object} [options]
 * @param {number} [options.workers]
 * @param {() => Worker} [options.makeWorker] one over pool.worker.js
 * @param {Map<string, Uint8Array>} [options.files]
 * @param {(user: number) => void} [options.wake] as skv_stage_def.wake
 * @param {string} [options.name] of the module
 * @param {import('./instance.js').Surroundings['codecs']} [options.codecs] else they come once they are wanted
 *     (Instance)
 */
export async function loadParts({ module, description }, options = {}) {
    const { workers = 0, files = new Map(), wake, codecs, name = 'skvalp' } = options;
    const makeWorker = options.makeWorker
        ?? (() => new Worker(new URL('./pool.worker.js', import.meta.url), { type: 'module' }));
    const surroundings = {
        readFile: (/** @type {string} */ path) => files.get(path),
        writeFile: (/** @type {string} */ path, /** @type {Uint8Array} */ bytes) => !!files.set(path, bytes),
        wake,
        codecs,
    };
    const put = async (/** @type {string} */ flavour) => {
        const compiled = await compile(await module(`${name}${flavour}.wasm`));
        return assemble(compiled, description, surroundings, workers, (post, fail) => {
            const worker = makeWorker();
            worker.addEventListener('error', fail);
            worker.postMessage(post);
            return worker;
        });
    };
    if (workers > 0 && mayBlock && globalThis.crossOriginIsolated) {
        try {
            return await put('-threads');
        } catch {
            return put('');
        }
    }
    return put('');
}
