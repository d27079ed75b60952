// The stopwatch of the world that is open. Invariant: with another one it begins anew; what was cut off
// the log was never pressed.
import type { Library } from '../../src/library.js';
import { using } from '../../src/memory.js';

import type { Worlds } from './worlds';

export class Stopwatch {
    #library;
    #worlds;
    #watch;
    #opened = 0;

    constructor(library: Library, worlds: Worlds) {
        this.#library = library;
        this.#worlds = worlds;
        this.#watch = library.make('skv_stopwatch');
    }

    #follow() {
        const { opened, end, moment } = this.#worlds.first;
        if (opened !== this.#opened) {
            this.#watch.count = 0;
        }
        this.#opened = opened;
        this.#library.c.skv_stopwatch_cut(this.#watch, end);
        return moment;
    }

    press(lap: boolean) {
        const moment = this.#follow();
        this.#library.c.skv_stopwatch_press(this.#watch, moment, lap);
        this.read();
    }

    read() {
        const moment = this.#follow();
        const { c } = this.#library;
        return using(this.#library, c.skv_stopwatch_read(this.#watch, moment), ({ running, frames, laps, lap }) => {
            c.skv_stage_set_timed(this.#worlds.stage, running);
            return { used: this.#watch.count > 0, running, frames: Number(frames), laps, lap: Number(lap) };
        });
    }
}
