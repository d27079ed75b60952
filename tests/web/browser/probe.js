// The jobs of jobs.js in a browser: in a worker, which does what it is sent and sends the lines back, or
// on the page, which calls `perform`.
import { load } from '../../../web/src/browser.js';
import { makeJobs } from '../jobs.js';

/** What browsers may deny: see `without`. */
const denials = {
    /** Large ones fail on some phones. */
    'large memory': (size) => size < 200 * 1024 * 1024,
    memory: () => false,
};

/**
 * @param {object} task
 * @param {string} task.job @param {string[]} task.rest its arguments
 * @param {number} task.threads
 * @param {Map<string, Uint8Array>} task.files
 * @param {'' | 'workers' | 'memory' | 'large memory'} [task.without] what cannot be had here
 */
async function perform({ job, threads, rest, files, without = '' }) {
    const { Memory } = WebAssembly;
    if (without in denials) {
        WebAssembly.Memory = class extends Memory {
            constructor(limits) {
                if (limits.shared && !denials[without](65536 * limits.maximum)) {
                    throw new RangeError('no such memory');
                }
                super(limits);
            }
        };
    }
    const library = await load('/', {
        workers: (threads - 1) * (job === 'lab' ? 2 : 1), name: job === 'bits' ? 'bits' : 'skvalp',
        ...(without === 'workers' && { makeWorker: () => new Worker('/missing.js') }),
    });
    WebAssembly.Memory = Memory;
    const lines = [];
    const outside = { print: (line) => lines.push(line), read: (path) => files.get(path) };
    makeJobs(library, library.workers > 0 ? threads : 1, outside)[job](...rest);
    await library.end();
    return { lines, workers: library.workers };
}

if (typeof document === 'undefined') {
    onmessage = async ({ data }) => {
        try {
            postMessage(await perform(data));
        } catch (error) {
            postMessage({ error: String(error.stack ?? error) });
        }
    };
} else {
    window.perform = perform;
}
