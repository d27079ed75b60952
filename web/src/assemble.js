// A library from its parts, wherever it runs: what node.js and browser.js have in common.
import { Instance, isShared } from './instance.js';
import { Library } from './library.js';
/** @import { Post, Surroundings } from './instance.js' */

/**
 * @param {WebAssembly.Module} module
 * @param {typeof import('./interface.js')} description
 * @param {Surroundings} surroundings
 * @param {number} count of workers to compute on; none without memory to share
 * @param {(post: Post, fail: () => void) => { terminate(): unknown }} start as Instance.employ
 */
export async function assemble(module, description, surroundings, count, start) {
    const instance = new Instance(module, surroundings);
    /** @type {{ terminate(): unknown }[]} */
    const workers = [];
    const end = () => Promise.all(workers.map((worker) => worker.terminate()));
    try {
        if (isShared(module)) {
            await instance.employ(count, (post, fail) => workers.push(start(post, fail)));
        }
    } catch (error) {
        await end();
        throw error;
    }
    /** `workers`: how many wait for work. `end` dismisses them: nothing may be called after it. */
    return Object.assign(new Library(instance, description), { workers: workers.length, end });
}
