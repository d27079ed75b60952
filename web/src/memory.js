// Small things around the module's memory: records for the time of a call, tables, settings, bytes.
//
// Invariant: what is made here for a call is released after it, whatever the call does.
/**
 * @import { Library } from './library.js'
 * @import { Located, Records } from './interface.js'
 */

/**
 * What a function has returned by value, for a moment.
 * @template {Located} Given
 * @template Result
 * @param {Library} library @param {Given} record @param {(record: Given) => Result} use
 */
export function using(library, record, use) {
    try {
        return use(record);
    } finally {
        library.release(record);
    }
}

/**
 * Copies a structure over another of its kind.
 * @param {Library} library @param {keyof Records & string} name @param {Located} to @param {Located} from
 */
export function assign(library, name, to, from) {
    const { instance } = library;
    instance.bytes(to.address, library.size(name)).set(instance.copy(from.address, library.size(name)));
}

/**
 * The entries of one of the library's static tables.
 * @template {keyof Records & string} Name
 * @param {Library} library @param {Name} name @param {(i: number) => number} entry
 */
export function table(library, name, entry) {
    /** @type {Records[Name][]} */
    const all = [];
    for (let i = 0, address; (address = entry(i)) !== 0; i++) {
        all.push(library.view(name, address));
    }
    return all;
}

/**
 * A structure as plain data, which stays.
 * @template {Located} Given
 * @param {Given} record @returns {Omit<Given, 'address'>}
 */
export function plain(record) {
    /** @type {any} */
    const members = {};
    for (const name in record) {
        members[name] = record[name];
    }
    delete members.address;
    return members;
}

/**
 * Calls with a list of these settings.
 * @template Result
 * @param {Library} library @param {Record<string, string>} settings
 * @param {(list: number, count: number) => Result} use
 */
export function withSettings(library, settings, use) {
    const { instance } = library;
    const entries = Object.entries(settings);
    const size = library.size('skv_setting');
    const list = instance.allocate(size * Math.max(entries.length, 1));
    /** @type {number[]} */
    const texts = [];
    const place = (/** @type {string} */ text) => {
        texts.push(instance.allocateText(text));
        return texts.at(-1);
    };
    try {
        for (const [i, [path, value]] of entries.entries()) {
            const setting = library.view('skv_setting', list + i * size);
            Object.assign(setting, { path: place(path), value: place(value) });
        }
        return use(list, entries.length);
    } finally {
        texts.forEach((pointer) => instance.release(pointer));
        instance.release(list);
    }
}

/**
 * Calls with scene options that have these settings; "particles" may be one of them.
 * @template Result
 * @param {Library} library @param {Record<string, string>} settings
 * @param {(options: Records['skv_scene_options']) => Result} use
 */
export function withOptions(library, settings, use) {
    return withSettings(library, settings, (list, count) =>
        using(library, library.c.skv_default_scene_options(), (options) => {
            Object.assign(options, { settings: list, setting_count: count });
            return use(options);
        }));
}

/**
 * Calls with bytes that lie in the memory for that time.
 * @template Result
 * @param {Library} library @param {Uint8Array} bytes @param {(data: number) => Result} use
 */
export function withBytes(library, bytes, use) {
    const data = library.instance.allocateBytes(bytes.length > 0 ? bytes : new Uint8Array(1));
    try {
        return use(data);
    } finally {
        library.instance.release(data);
    }
}

/** One after the other. @param {Uint8Array[]} pieces */
export function joined(pieces) {
    const whole = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
    let at = 0;
    for (const piece of pieces) {
        whole.set(piece, at);
        at += piece.length;
    }
    return whole;
}

/**
 * What a function writes to a skv_write.
 * @param {Library} library @param {(write: number, user: number) => unknown} call
 */
export function written(library, call) {
    const { instance } = library;
    /** @type {Uint8Array[]} */
    const pieces = [];
    instance.lend((/** @type {Uint8Array} */ piece) => pieces.push(piece) > 0,
        (user) => call(instance.exports.skv_wasm_write(), user));
    return joined(pieces);
}

/**
 * The same of one that takes a place for an error, too; throws what it says.
 * @param {Library} library @param {(write: number, user: number, error: Located) => number} call
 */
export function made(library, call) {
    return written(library, (write, user) => library.check((error) => call(write, user, error)));
}
