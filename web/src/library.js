// The library over a WebAssembly instance: every public function of include/skvalp under its name,
// with texts, booleans and structures as JavaScript has them.
//
// Invariant: no view of the memory is kept across a call, for memory that grows leaves old views
// behind.
/**
 * @import { Functions, Records, Located, Type, Member } from './interface.js'
 * @import { Instance } from './instance.js'
 */

/** @type {Record<string, string>} */
const getters = {
    bool: 'getUint8', i8: 'getInt8', u8: 'getUint8', i32: 'getInt32', u32: 'getUint32',
    i64: 'getBigInt64', u64: 'getBigUint64', f32: 'getFloat32', f64: 'getFloat64',
    text: 'getUint32', pointer: 'getUint32',
};
/** @type {Record<string, number>} */
const sizes = { bool: 1, i8: 1, u8: 1, i32: 4, u32: 4, i64: 8, u64: 8, f32: 4, f64: 8, text: 4, pointer: 4 };

/** What a public function reports: the line, and the code by which programs tell. */
export class SkvalpError extends Error {
    /** @param {number} code @param {string} text which names a setting as the command line has it */
    constructor(code, text) {
        super(text.replace(/^--(set )?/, ''));
        this.name = 'SkvalpError';
        this.code = code;
    }
}

export class Library {
    /** @type {Functions} the public functions by their names in C */
    c;
    #instance;
    #interface;
    /** @type {Map<string, new (address: number) => any>} */
    #views = new Map();

    /**
     * @param {Instance} instance
     * @param {typeof import('./interface.js')} description
     */
    constructor(instance, description) {
        this.#instance = instance;
        this.#interface = description;
        for (const [name, record] of Object.entries(description.records)) {
            this.#views.set(name, this.#makeView(record.members));
        }
        const calls = Object.entries(description.functions)
            .filter(([name]) => name in instance.exports)
            .map(([name, type]) => [name, this.#makeCall(name, type)]);
        this.c = /** @type {any} */ (Object.fromEntries(calls));
    }

    get constants() {
        return this.#interface.constants;
    }

    get instance() {
        return this.#instance;
    }

    /**
     * A structure in the memory: reading and writing its members goes there.
     * @template {keyof Records & string} Name
     * @param {Name} name
     * @param {number} address
     * @returns {Records[Name]}
     */
    view(name, address) {
        const View = /** @type {new (address: number) => any} */ (this.#views.get(name));
        return new View(address);
    }

    /**
     * Memory for so many structures, all 0; to be released.
     * @template {keyof Records & string} Name
     * @param {Name} name
     */
    make(name, count = 1) {
        const size = this.size(name) * count;
        const pointer = this.#instance.allocate(size);
        this.#instance.bytes(pointer, size).fill(0);
        return this.view(name, pointer);
    }

    /** Bytes that a structure takes. @param {keyof Records & string} name */
    size(name) {
        return this.#interface.records[name].size;
    }

    /** @param {Located} record one that was made, or came as the value of a function */
    release(record) {
        this.#instance.release(record.address);
    }

    /**
     * Makes a call that takes a place for an error last; throws what it says.
     * @template Result
     * @param {(error: Located) => Result} call returns a skv_result
     */
    check(call) {
        const error = this.make('skv_error');
        try {
            const code = Number(call(error));
            if (code !== this.constants.SKV_OK) {
                throw new SkvalpError(code, error.text);
            }
        } finally {
            this.release(error);
        }
    }

    /**
     * The same for one that also leaves a pointer: to what it has made.
     * @param {(out: number, error: Located) => number} call
     * @returns {number}
     */
    create(call) {
        const out = this.#instance.allocate(4);
        try {
            this.check((error) => call(out, error));
            return this.#instance.data().getUint32(out, true);
        } finally {
            this.#instance.release(out);
        }
    }

    /** @param {Record<string, Member>} members */
    #makeView(members) {
        const library = this;
        class View {
            /** @param {number} address */
            constructor(address) {
                this.address = address;
            }
        }
        for (const [name, member] of Object.entries(members)) {
            Object.defineProperty(View.prototype, name, {
                enumerable: true,
                get() {
                    return library.#read(member, this.address + member.offset);
                },
                set(value) {
                    library.#write(member, this.address + member.offset, value);
                },
            });
        }
        return View;
    }

    /** @param {Type} type @param {number} address @returns {any} */
    #read(type, address) {
        if (type.kind === 'record') {
            return this.view(/** @type {keyof Records} */ (type.name), address);
        }
        if (type.kind === 'array') {
            const of = /** @type {Type} */ (type.of);
            return of.kind === 'i8'
                ? this.#instance.text(address)
                : Array.from({ length: type.count ?? 0 }, (_, i) => this.#read(of, address + i * this.#size(of)));
        }
        const data = /** @type {any} */ (this.#instance.data());
        const value = data[getters[type.kind]](address, true);
        return type.kind === 'text' ? this.#instance.text(value) : type.kind === 'bool' ? value !== 0 : value;
    }

    /** @param {Type} type @param {number} address @param {any} value */
    #write(type, address, value) {
        if (type.kind === 'array' && type.of?.kind === 'i8') {
            this.#instance.write(value, address, type.count ?? 0);
        } else if (type.kind in getters && type.kind !== 'text') {
            const data = /** @type {any} */ (this.#instance.data());
            const setter = getters[type.kind].replace('get', 'set');
            data[setter](address, type.kind === 'pointer' ? value?.address ?? value ?? 0 : value, true);
        } else if (type.kind === 'text' && typeof value === 'number') {
            this.#instance.data().setUint32(address, value, true);
        } else {
            throw new TypeError(`a ${type.kind} cannot be assigned; write to what it holds`);
        }
    }

    /** @param {Type} type @returns {number} */
    #size(type) {
        return type.kind === 'record' ? this.#interface.records[/** @type {keyof Records} */ (type.name)].size
            : type.kind === 'array' ? (type.count ?? 0) * this.#size(/** @type {Type} */ (type.of))
                : sizes[type.kind];
    }

    /**
     * @param {string} name
     * @param {{ result: Type, parameters: Type[] }} type
     */
    #makeCall(name, { result, parameters }) {
        const instance = this.#instance;
        const call = /** @type {Function} */ (instance.exports[name]);
        const byText = parameters.some((parameter) => parameter.kind === 'text');
        /** @param {any[]} given */
        return (...given) => {
            /** @type {number[]} */
            const texts = [];
            const place = (/** @type {Type} */ parameter, /** @type {any} */ value) => {
                if (parameter.kind === 'text' && typeof value === 'string') {
                    texts.push(instance.allocateText(value));
                    return texts.at(-1);
                }
                return value?.address ?? value ?? 0;
            };
            const values = given.map((value, i) => place(parameters[i], value));
            try {
                if (result.kind === 'record') {
                    const made = this.make(/** @type {keyof Records} */ (result.name));
                    call(made.address, ...values);
                    return made;
                }
                const value = call(...values);
                return result.kind === 'text' ? (value ? instance.text(value) : null)
                    : result.kind === 'bool' ? value !== 0
                        : result.kind === 'u64' ? BigInt.asUintN(64, value)
                            : result.kind === 'u32' || result.kind === 'pointer' ? value >>> 0
                                : value;
            } finally {
                if (byText) {
                    texts.forEach((text) => instance.release(text));
                }
            }
        };
    }
}
