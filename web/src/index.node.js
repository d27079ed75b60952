// The package in node: its modules lie in lib/.
import { fileURLToPath } from 'node:url';

import { Skvalp } from './index.js';
import { load } from './node.js';

export * from './index.js';

/**
 * Loads the library. With threads, a world at a time is stepped on all of them.
 * @param {{ threads?: number }} [options]
 */
export async function open({ threads = 1 } = {}) {
    return new Skvalp(await load(fileURLToPath(new URL('../lib', import.meta.url)), { workers: threads - 1 }));
}
