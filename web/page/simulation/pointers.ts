// Pointers: what the page tells of them goes to the stage, which tells a gesture from a hand.
import type { Library } from '../../src/library.js';
import type { skv_pointer_event } from '../../src/interface.js';

import type { PointerMessage, Side } from './protocol';
import type { Worlds } from './worlds';

/** CSS pixels within which a finger has not moved. */
const tremble = 12;

export class Pointers {
    #library;
    #worlds;
    #changed;
    #event: skv_pointer_event;
    #waiting: (ReturnType<typeof setTimeout> | undefined)[] = [];

    /** @param changed something may have, later than asked */
    constructor(library: Library, worlds: Worlds, changed: () => void) {
        this.#library = library;
        this.#worlds = worlds;
        this.#changed = changed;
        this.#event = library.make('skv_pointer_event');
    }

    tell(message: PointerMessage) {
        const { c, constants } = this.#library, { side } = message, { ratio, stage } = this.#worlds;
        const { area } = this.#worlds.at(side);
        Object.assign(this.#event, {
            phase: constants[`SKV_PHASE_${message.phase.toUpperCase()}` as keyof typeof constants],
            device: constants[`SKV_DEVICE_${message.device.toUpperCase()}` as keyof typeof constants],
            pointer: BigInt(Math.trunc(message.pointer) || 0),
            px: (message.x - area.x) * ratio,
            py: (message.y - area.y) * ratio,
            time: message.time,
            pressure: message.pressure,
            secondary: message.secondary,
            straight: message.straight,
        });
        this.#wait(side, c.skv_stage_touch(stage, side, this.#event, tremble * ratio));
    }

    /** What is due in so many seconds if nothing comes before. */
    #wait(side: Side, seconds: number) {
        clearTimeout(this.#waiting[side]);
        this.#waiting[side] = seconds > 0 ? setTimeout(() => {
            this.#wait(side, this.#library.c.skv_stage_touch_waited(this.#worlds.stage, side));
            this.#changed();
        }, Math.ceil(1000 * seconds)) : undefined;
    }

    cancel() {
        this.#waiting.forEach(clearTimeout);
        this.#library.c.skv_stage_cancel_pointers(this.#worlds.stage);
    }
}
