// The worlds: what the library's stage shows, one or two of them, each in its area of the canvas.
//
// Invariant: there are as many as the stage has sides; all that is done is asked of the stage.
import type { Library } from '../../src/library.js';
import type { skv_camera, skv_picture } from '../../src/interface.js';
import { assign, using } from '../../src/memory.js';

import type { Side } from './protocol';

/** For rewinding: half a minute of 8000 particles, and the memory of a phone holds two of it. */
const history = 32 << 20;

/** A part of the canvas, in CSS pixels. */
export interface Area {
    x: number;
    y: number;
    width: number;
    height: number;
}

export interface World {
    /** As looked at last. */
    picture: skv_picture;
    /** In device pixels of its own area. */
    readonly camera: skv_camera;
    area: Area;
}

export class Worlds {
    readonly stage: number;
    /** Device pixels of a CSS pixel. */
    ratio = 1;
    /** What shows is something else than was drawn. */
    stale = true;
    all: World[] = [];
    #library;
    #width = 640;
    #height = 360;

    constructor(library: Library, threads: number) {
        const { c, instance } = library;
        this.#library = library;
        this.stage = using(library, c.skv_default_stage_def(), (def) => {
            def.threads = threads;
            def.own_thread = false;
            def.history = history;
            def.margin = library.view('skv_limits', c.skv_control_limits()).margin;
            def.clock = instance.exports.skv_wasm_clock();
            return library.create((out, error) => c.skv_stage_create(def, out, error));
        });
        this.look();
    }

    get first() {
        return this.all[0].picture;
    }

    at(side: Side) {
        return this.all[side] ?? this.all[0];
    }

    /** Takes the newest pictures and cameras. */
    look() {
        const { c } = this.#library, sides = c.skv_stage_sides(this.stage), before = this.all.length;
        if (c.skv_stage_look(this.stage) === 0 && sides === before) {
            return;
        }
        this.stale = true;
        this.all.splice(sides).forEach(({ camera }) => this.#library.release(camera));
        for (let side = this.all.length; side < sides; side++) {
            const area = { x: 0, y: 0, width: 0, height: 0 };
            this.all.push({ picture: this.#picture(side), camera: this.#library.make('skv_camera'), area });
        }
        this.all.forEach((world, side) => {
            world.picture = this.#picture(side);
        });
        if (sides === before) {
            this.#takeCameras();
        } else {
            this.setView(this.#width, this.#height, this.ratio);
        }
    }

    #picture(side: number) {
        return this.#library.view('skv_picture', this.#library.c.skv_stage_picture(this.stage, side));
    }

    #takeCameras() {
        const library = this.#library;
        this.all.forEach(({ camera }, side) => using(library, library.c.skv_stage_camera(this.stage, side),
            (newest) => assign(library, 'skv_camera', camera, newest)));
    }

    /** The canvas: two worlds lie beside each other, or above each other if they are larger then. */
    setView(width: number, height: number, ratio: number) {
        this.#width = width;
        this.#height = height;
        this.ratio = ratio;
        this.stale = true;
        this.#takeCameras();
        const { all } = this, { world_width: wide, world_height: high } = all[0].camera;
        const beside = Math.min(width / 2 / wide, height / high);
        const above = Math.min(width / wide, height / 2 / high);
        const across = all.length > 1 && beside >= above, down = all.length > 1 && !across;
        const area = { width: across ? width / 2 : width, height: down ? height / 2 : height };
        const [pixels, lines] = [area.width, area.height].map((size) => Math.max(Math.round(size * ratio), 1));
        all.forEach((world, i) => {
            world.area = { ...area, x: across ? i * area.width : 0, y: down ? i * area.height : 0 };
            this.#library.c.skv_stage_set_view(this.stage, i, pixels, lines);
        });
        this.#takeCameras();
    }
}
