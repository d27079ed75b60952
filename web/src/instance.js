// A WebAssembly instance of the library and its memory: the host's side of src/base/wasm/host.h.
//
// Invariant: nothing that the host does for the module throws through it: what goes wrong is told as
// a result.
import { entryKinds, readOwn } from './entries.js';
import { Gl } from './gl.js';

/** The most memory that is asked for at first, and less where so much is refused; in MiB. */
const memorySizes = [256, 128];
/** skv_result and skv_inflated, as far as they are told from here. */
const results = { ok: 0, format: 3 };
const inflated = { whole: 0, damaged: 1 };

const page = 65536;
const initialPages = 256;
const stackSize = 256 * 1024;

/**
 * What surrounds the module. All of it may be left out.
 * @typedef {object} Surroundings
 * @property {(path: string) => Uint8Array | null | undefined} [readFile] a file that scenes name
 * @property {(path: string, bytes: Uint8Array) => boolean} [writeFile]
 * @property {() => number} [clock] seconds, from any origin
 * @property {(user: number) => void} [wake] as skv_stage_def.wake
 * @property {typeof import('./codecs.js')} [codecs] what links and pictures take, if it is there at once
 */

/**
 * What a worker of the pool needs to come in: see pool.js.
 * @typedef {object} Post
 * @property {WebAssembly.Module} module
 * @property {WebAssembly.Memory} memory
 * @property {number} stack its end
 */

/** Whether a module is one for threads. @param {WebAssembly.Module} module */
export function isShared(module) {
    return WebAssembly.Module.imports(module).some((entry) => entry.kind === 'memory');
}

function makeMemory() {
    for (const size of memorySizes) {
        try {
            return new WebAssembly.Memory({
                initial: initialPages, maximum: (size * 1024 * 1024) / page, shared: true,
            });
        } catch {
            continue;
        }
    }
    throw new RangeError('no memory can be shared here; use the module without threads');
}

export class Instance {
    /** @type {Record<string, any>} */
    exports;
    /** @type {WebAssembly.Memory} */
    memory;
    module;
    #codecs;
    /** What the renderer draws by: see canvas.js. */
    gl = new Gl(this);
    #surroundings;
    /** @type {Map<number, Function>} */
    #callbacks = new Map();
    #nextCallback = 1;

    /**
     * @param {WebAssembly.Module} module
     * @param {Surroundings} [surroundings]
     */
    constructor(module, surroundings = {}) {
        this.module = module;
        this.#surroundings = surroundings;
        this.#codecs = surroundings.codecs;
        const shared = isShared(module) ? makeMemory() : null;
        const instance = new WebAssembly.Instance(module, {
            host: this.#host(), gl: this.gl.imports(), ...(shared && { env: { memory: shared } }),
        });
        this.exports = instance.exports;
        this.memory = shared ?? /** @type {WebAssembly.Memory} */ (instance.exports.memory);
    }

    /**
     * Brings workers in to compute on. `start` makes one of them call serve (pool.js), or says that it
     * has failed to.
     * @param {number} count
     * @param {(post: Post, fail: () => void) => void} start
     */
    async employ(count, start) {
        const wanted = this.exports.skv_wasm_servants() + count;
        let failed = false;
        for (let i = 0; i < count; i++) {
            const stack = this.allocate(stackSize) + stackSize;
            start({ module: this.module, memory: this.memory, stack }, () => {
                failed = true;
            });
        }
        for (let turns = 0; this.exports.skv_wasm_servants() < wanted; turns++) {
            if (failed || turns > 10000) {
                throw new Error('the workers did not start; use fewer threads');
            }
            await new Promise((resolve) => setTimeout(resolve, 1));
        }
    }

    /** Whether links, pictures and JSON of others can be read, and links written. */
    get hasCodecs() {
        return this.#codecs !== undefined;
    }

    /** Until they are there, links and pictures are refused as damaged, and JSON has to be the library's own. */
    async bringCodecs() {
        this.#codecs ??= await import('./codecs.js');
    }

    // ---- Memory ---------------------------------------------------------------------------------

    /** @param {number} size @returns {number} */
    allocate(size) {
        const pointer = this.exports.skv_wasm_allocate(size);
        if (!pointer) {
            throw new RangeError(`out of memory for ${size} bytes`);
        }
        return pointer;
    }

    /** @param {number} pointer */
    release(pointer) {
        this.exports.skv_wasm_release(pointer);
    }

    data() {
        return new DataView(this.memory.buffer);
    }

    /** @param {number} pointer @param {number} size */
    bytes(pointer, size) {
        return new Uint8Array(this.memory.buffer, pointer, size);
    }

    /** Bytes of its own: decoders refuse shared ones. @param {number} pointer @param {number} size */
    copy(pointer, size) {
        return new Uint8Array(this.bytes(pointer, size));
    }

    /** The text at an address. @param {number} pointer */
    text(pointer) {
        const all = new Uint8Array(this.memory.buffer);
        return new TextDecoder().decode(all.slice(pointer, all.indexOf(0, pointer)));
    }

    /** Writes a text, cut to fit. @param {string} text @param {number} to @param {number} room */
    write(text, to, room) {
        const bytes = new TextEncoder().encode(text).subarray(0, room - 1);
        this.bytes(to, bytes.length).set(bytes);
        this.bytes(to + bytes.length, 1)[0] = 0;
    }

    /** @param {Uint8Array} bytes */
    allocateBytes(bytes) {
        const pointer = this.allocate(bytes.length);
        this.bytes(pointer, bytes.length).set(bytes);
        return pointer;
    }

    /** @param {string} text */
    allocateText(text) {
        return this.allocateBytes(new TextEncoder().encode(`${text}\0`));
    }

    // ---- What the module asks for ---------------------------------------------------------------

    /**
     * Lends the module a function for the time of a call: `use` gets what goes in as `user`, beside
     * skv_wasm_write() or skv_wasm_observe().
     * @template Result
     * @param {Function} callback
     * @param {(user: number) => Result} use
     */
    lend(callback, use) {
        const user = this.#nextCallback++;
        this.#callbacks.set(user, callback);
        try {
            return use(user);
        } finally {
            this.#callbacks.delete(user);
        }
    }

    /** @returns {Record<string, (...values: any[]) => any>} */
    #host() {
        const { readFile, writeFile, wake } = this.#surroundings;
        const clock = this.#surroundings.clock ?? (() => performance.now() / 1000);
        const file = (/** @type {number} */ path) => readFile?.(this.text(path));
        return {
            clock,
            wake: (user) => wake?.(user),
            write: (text, length, user) => this.#callbacks.get(user)?.(this.copy(text, length)) !== false,
            observe: (moment, user) => this.#callbacks.get(user)?.(moment) !== false,
            file_size: (path) => file(path)?.length ?? -1,
            file_read: (path, to, size) => {
                const bytes = file(path);
                if (!bytes || bytes.length !== size) {
                    return false;
                }
                this.bytes(to, size).set(bytes);
                return true;
            },
            file_write: (path, bytes, size) => writeFile?.(this.text(path), this.copy(bytes, size)) ?? false,
            parse_json: (text, size, visitor, failure) => this.#parse(this.copy(text, size), visitor, failure),
            decode_png: (data, size, width, height, pixels, reason, room) =>
                this.#decode(this.copy(data, size), width, height, pixels, reason, room),
            deflate: (data, size, to, room) => {
                const packed = this.#codecs?.deflate(this.copy(data, size));
                if (!packed || packed.length > room) {
                    return 0;
                }
                this.bytes(to, packed.length).set(packed);
                return packed.length;
            },
            inflate: (packed, size, to, room, used) => this.#inflate(this.copy(packed, size), to, room, used),
        };
    }

    /** @param {Uint8Array} text @param {number} visitor @param {number} failure */
    #parse(text, visitor, failure) {
        const { skv_wasm_json_key, skv_wasm_json_value, skv_wasm_json_close, skv_wasm_json_fail } = this.exports;
        const parsed = this.#codecs?.parseJson(text) ?? readOwn(text);
        if ('fault' in parsed) {
            this.#withText(parsed.words, (words) =>
                skv_wasm_json_fail(failure, parsed.fault, parsed.line, parsed.position, words));
            return false;
        }
        for (const { kind, value, number } of parsed.events) {
            const go = kind === 'key' ? this.#withText(value, (key) => skv_wasm_json_key(visitor, key))
                : kind === 'close' ? skv_wasm_json_close(visitor)
                    : kind === entryKinds.text
                        ? this.#withText(value, (text) => skv_wasm_json_value(visitor, kind, 0, text))
                        : skv_wasm_json_value(visitor, kind, number, 0);
            if (!go) {
                break;
            }
        }
        return true;
    }

    /** @template Result @param {string} text @param {(pointer: number) => Result} use */
    #withText(text, use) {
        const pointer = this.allocateText(text);
        try {
            return use(pointer);
        } finally {
            this.release(pointer);
        }
    }

    /**
     * @param {Uint8Array} data @param {number} width @param {number} height @param {number} pixels
     * @param {number} reason @param {number} room
     */
    #decode(data, width, height, pixels, reason, room) {
        const decoded = this.#codecs?.decodePng(data) ?? 'its reader has not come';
        if (typeof decoded === 'string') {
            this.write(decoded, reason, room);
            return results.format;
        }
        this.bytes(pixels, 4 * width * height).set(decoded);
        return results.ok;
    }

    /** @param {Uint8Array} packed @param {number} to @param {number} room @param {number} used */
    #inflate(packed, to, room, used) {
        const { bytes, whole, rest } = this.#codecs?.inflate(packed, room, { raw: true })
            ?? { bytes: new Uint8Array(), whole: false, rest: 0 };
        this.bytes(to, bytes.length).set(bytes);
        this.data().setUint32(used, bytes.length, true);
        return whole && rest === 0 ? inflated.whole : inflated.damaged;
    }
}
