// The package in a browser: bundled as lib/skvalp.js, beside its modules.
import { load } from './browser.js';
import { Skvalp } from './index.js';

export * from './index.js';

const here = import.meta.url;

/**
 * Loads the library. There are threads in a worker of an isolated page; elsewhere it is one.
 * @param {{ threads?: number }} [options]
 */
export async function open({ threads = 1 } = {}) {
    return new Skvalp(await load(new URL('.', here), { workers: threads - 1 }));
}
