// What JSON holds, as the library takes it: one event after the other; and the events of texts that the
// library itself has written, built-in scenes, which need no strict reader (json.js).
//
// Invariant: of such a text both readers give the same events.

/** skv_entry_kind */
export const entryKinds = /** @type {const} */ ({ null: 0, boolean: 1, number: 2, text: 3, list: 4, object: 5 });

/**
 * A value, a key, or the end of an object or list.
 * @typedef {{ kind: 'key' | 'close' | number, value: string, number: number }} Event
 * @typedef {{ fault: number, line: number, position: number, words: string }} Failure
 */

/** @param {any} value @param {Event[]} events */
function add(value, events) {
    if (Array.isArray(value)) {
        events.push({ kind: entryKinds.list, value: '', number: 0 });
        value.forEach((one) => add(one, events));
        events.push({ kind: 'close', value: '', number: 0 });
    } else if (value !== null && typeof value === 'object') {
        events.push({ kind: entryKinds.object, value: '', number: 0 });
        for (const [key, one] of Object.entries(value)) {
            events.push({ kind: 'key', value: key, number: 0 });
            add(one, events);
        }
        events.push({ kind: 'close', value: '', number: 0 });
    } else if (typeof value === 'string') {
        events.push({ kind: entryKinds.text, value, number: 0 });
    } else {
        const kind = value === null ? 'null' : typeof value === 'number' ? 'number' : 'boolean';
        events.push({ kind: entryKinds[kind], value: '', number: Number(value) });
    }
}

/**
 * As parseJson of json.js, for a text of the library's own; of another's the reader has not come yet.
 * @param {Uint8Array} bytes
 * @returns {{ events: Event[] } | Failure}
 */
export function readOwn(bytes) {
    /** @type {Event[]} */
    const events = [];
    try {
        add(JSON.parse(new TextDecoder().decode(bytes)), events);
        return { events };
    } catch {
        return { fault: 0, line: 1, position: 0, words: 'its reader has not come' };
    }
}
