// Tilt: what devicemotion says becomes gravity and pushes, by the library's filter.
//
// Invariant: it acts only on what plays at its own end: who looks at the past, or at a replay, is not
// disturbed.
import type { Library } from '../../src/library.js';
import type { skv_picture, skv_tilt_filter } from '../../src/interface.js';
import { using } from '../../src/memory.js';

/** Of the scene's gravity: less is the sensor's own noise. */
const stillness = 0.02;

interface Vector {
    x: number;
    y: number;
}

export class Tilt {
    /** Of gravity and pushes. */
    strength = 1;
    #library;
    #reversed;
    #filter: skv_tilt_filter;
    #last: number | null = null;

    /** @param reversed the signs are the other way round */
    constructor(library: Library, reversed: boolean) {
        this.#library = library;
        this.#reversed = reversed;
        this.#filter = library.make('skv_tilt_filter');
    }

    /** Which edge is up on a screen that is turned by so many degrees. */
    #up(angle: number) {
        const { constants } = this.#library;
        switch (((Math.round(angle / 90) % 4) + 4) % 4) {
            case 1: return constants.SKV_ORIENTATION_RIGHT;
            case 2: return constants.SKV_ORIENTATION_BOTTOM;
            case 3: return constants.SKV_ORIENTATION_LEFT;
            default: return constants.SKV_ORIENTATION_TOP;
        }
    }

    /** What the water feels: what of it differs from what it feels already. */
    feel(x: number, y: number, angle: number, time: number, picture: skv_picture) {
        const sign = this.#reversed ? -1 : 1;
        const seconds = this.#last === null ? 0 : time - this.#last;
        this.#last = time;
        return using(this.#library,
            this.#library.c.skv_tilt_feel(this.#filter, sign * x, sign * y, seconds, this.#up(angle)),
            (felt) => {
                const { strength } = this;
                const gravity_x = strength * felt.gravity_x, gravity_y = strength * felt.gravity_y;
                const push_x = strength * felt.push_x, push_y = strength * felt.push_y;
                const { paused, seeking, moment, end, tilt_x, tilt_y } = picture;
                if (paused || seeking || moment < end) {
                    return { gravity: null, push: null };
                }
                const turned = Math.hypot(gravity_x - tilt_x, gravity_y - tilt_y) > stillness;
                return {
                    gravity: turned ? { x: gravity_x, y: gravity_y } as Vector : null,
                    push: push_x !== 0 || push_y !== 0 ? { x: push_x, y: push_y } as Vector : null,
                };
            });
    }
}
