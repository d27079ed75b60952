// The library as a few classes, over all of it (`library.c`): a scene, and worlds that are made of it.
//
// Invariant: what was destroyed, or has been left behind by its world, throws when it is used.
/** @import { Library } from './library.js' */
/** @import { Located, skv_particles } from './interface.js' */

import { table, withBytes, withOptions } from './memory.js';

export { SkvalpError } from './library.js';

const frame = 1 / 60;

/**
 * @typedef {object} SceneOptions
 * @property {number} [particles] how many; the scene's own number if it is not given
 * @property {Record<string, string | number | boolean>} [settings] by path, as scene files have them:
 *     { 'fluid.law': 'clavet' }
 */

/** Who collects what nobody holds any more cannot free it: the module may have ended. */
const left = new FinalizationRegistry((/** @type {string} */ kind) =>
    console.warn(`skvalp: a ${kind} was left without destroy(): its memory stays taken`));

/** Something in the module's memory that is there until it is destroyed. */
class Owned {
    #pointer;
    #free;

    /** @param {number} pointer @param {(pointer: number) => void} free @param {string} kind */
    constructor(pointer, free, kind) {
        this.#pointer = pointer;
        this.#free = free;
        left.register(this, kind, this);
    }

    /** Its address, for `library.c`. */
    get pointer() {
        if (this.#pointer === 0) {
            throw new ReferenceError('it was destroyed');
        }
        return this.#pointer;
    }

    destroy() {
        if (this.#pointer !== 0) {
            this.#free(this.#pointer);
            this.#pointer = 0;
            left.unregister(this);
        }
    }
}

/**
 * A world's particles at one moment: views of the module's memory, not copies. Asked for too late, they throw; an
 * array that is kept shows whatever its memory holds by then: `x.slice()` keeps the moment.
 */
export class Particles {
    #world;
    #moment;
    #arrays;
    count;

    /** @param {World} world @param {Float32Array[]} arrays */
    constructor(world, arrays) {
        this.#world = world;
        this.#moment = world.moment;
        this.#arrays = arrays;
        this.count = arrays[0].length;
    }

    /** @param {number} i */
    #view(i) {
        const array = this.#arrays[i];
        const { pointer, moment } = this.#world;
        if (!pointer || moment !== this.#moment || array.length !== this.count) {
            throw new ReferenceError('the world has moved on: ask for its particles again');
        }
        return array;
    }

    /** m */
    get x() {
        return this.#view(0);
    }

    get y() {
        return this.#view(1);
    }

    /** m/s */
    get vx() {
        return this.#view(2);
    }

    get vy() {
        return this.#view(3);
    }
}

/** A fluid in its tank. Make one by Scene.world. */
export class World extends Owned {
    #library;
    /** How often it was changed by the methods here. */
    moment = 0;

    /** @param {Library} library @param {number} pointer */
    constructor(library, pointer) {
        super(pointer, (world) => library.c.skv_world_destroy(world), 'world');
        this.#library = library;
    }

    /** @param {number} [seconds] at most what skv_world_step takes */
    step(seconds = frame) {
        const { c } = this.#library, { pointer } = this;
        this.moment++;
        this.#library.check((error) => c.skv_world_step(pointer, Math.fround(seconds), error));
    }

    /** In m/s^2, y up. @param {number} x @param {number} y */
    setGravity(x, y) {
        const { c } = this.#library, { pointer } = this;
        this.#library.check((error) => c.skv_world_set_gravity(pointer, x, y, error));
    }

    /** Those of this moment; when the world steps, ask again. */
    particles() {
        const { c, instance } = this.#library;
        const all = /** @type {skv_particles} */ (/** @type {unknown} */ (c.skv_world_particles(this.pointer)));
        const { buffer } = instance.memory;
        const arrays = [all.x, all.y, all.vx, all.vy].map((at) => new Float32Array(buffer, Number(at), all.count));
        this.#library.release(all);
        return new Particles(this, arrays);
    }

    /** The same for the same world on every machine. */
    get hash() {
        return this.#library.c.skv_world_hash(this.pointer).toString(16).padStart(16, '0');
    }
}

/** What a world begins with. */
export class Scene extends Owned {
    #library;
    #threads;

    /** @param {Library} library @param {number} pointer @param {number} threads */
    constructor(library, pointer, threads) {
        super(pointer, (scene) => library.c.skv_scene_destroy(scene), 'scene');
        this.#library = library;
        this.#threads = threads;
    }

    world() {
        const { c } = this.#library, { pointer } = this;
        return new World(this.#library, this.#library.create((out, error) =>
            c.skv_scene_create_world(pointer, this.#threads, out, error)));
    }
}

/** The library, loaded. Make one by open(). */
export class Skvalp {
    library;

    /** @param {Library & { workers: number, end: () => Promise<unknown> }} library */
    constructor(library) {
        this.library = library;
    }

    /** The names of the built-in scenes. */
    get scenes() {
        const { library } = this;
        return table(library, 'skv_scene_info', library.c.skv_builtin_scene).map(({ name }) => name);
    }

    /**
     * @param {string | object | Uint8Array} source a built-in scene's name, a scene as files have it, or
     *     the bytes of such a JSON file or of a PNG that is painted
     * @param {SceneOptions} [wanted]
     */
    scene(source, wanted = {}) {
        const { library } = this;
        const settings = Object.fromEntries(
            Object.entries(wanted.settings ?? {}).map(([path, value]) => [path, String(value)]));
        return withOptions(library, settings, (options) => {
            if (wanted.particles !== undefined) {
                options.particles = wanted.particles;
            }
            return new Scene(library, this.#load(source, options), library.workers + 1);
        });
    }

    /** @param {string | object | Uint8Array} source @param {Located} options */
    #load(source, options) {
        const { library } = this, { c } = library;
        if (typeof source === 'string') {
            return library.create((out, error) => c.skv_scene_load(source, options, out, error));
        }
        const bytes = source instanceof Uint8Array ? source : new TextEncoder().encode(JSON.stringify(source));
        const format = bytes[0] === 0x89 ? 'png' : 'json';
        return withBytes(library, bytes, (data) => library.create((out, error) =>
            c.skv_scene_load_memory(data, bytes.length, format, 'scene', options, out, error)));
    }

    /** Ends its workers; nothing may be called after it. */
    async end() {
        await this.library.end();
    }
}
