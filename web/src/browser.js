// The library in a browser, over the network or from its parts.
import { loadParts } from './parts.js';
/** @import { Parts } from './parts.js' */

/** @param {string | URL} folder @returns {Promise<Parts>} */
async function partsOf(folder) {
    const base = new URL(String(folder).replace(/\/*$/, '/'), location.href);
    return {
        module: (file) => fetch(new URL(file, base)),
        description: await import(/* @vite-ignore */ new URL('interface.js', base).href),
    };
}

/**
 * As loadParts.
 * @param {string | URL | Parts} where the URL of the folder where skvalp.wasm, skvalp-threads.wasm
 *     and interface.js lie, or what there is of them
 * @param {NonNullable<Parameters<typeof loadParts>[1]> & { lean?: boolean }} [options] lean: the caller brings the
 *     codecs once they are wanted (Instance)
 */
export async function load(where, { lean = false, ...options } = {}) {
    const isFolder = typeof where === 'string' || where instanceof URL;
    const codecs = lean ? undefined : await import('./codecs.js');
    return loadParts(isFolder ? await partsOf(where) : where, { codecs, ...options });
}
