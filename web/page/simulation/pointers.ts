// Pointers: what the page tells of them goes through the library's fingers, which tell a gesture from
// a hand; what comes out goes to the worlds and their cameras.
import type { Library } from '../../src/library.js';
import type { skv_fingers, skv_gesture, skv_pointer_event } from '../../src/interface.js';
import { using } from '../../src/memory.js';

import type { PointerMessage, Side } from './protocol';
import type { Worlds } from './worlds';

/** CSS pixels within which a finger has not moved. */
const tremble = 12;

export class Pointers {
    #library;
    #worlds;
    #undo;
    #changed;
    #event: skv_pointer_event;
    /** Each side's own. */
    #fingers: skv_fingers[];
    #waiting: (ReturnType<typeof setTimeout> | undefined)[] = [];

    /** @param undo what three fingers ask for @param changed something may have, later than asked */
    constructor(library: Library, worlds: Worlds, undo: () => void, changed: () => void) {
        this.#library = library;
        this.#worlds = worlds;
        this.#undo = undo;
        this.#changed = changed;
        this.#event = library.make('skv_pointer_event');
        this.#fingers = [library.make('skv_fingers'), library.make('skv_fingers')];
    }

    tell(message: PointerMessage) {
        const { c, constants } = this.#library;
        const { area, ratio } = this.#worlds.at(message.side);
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
        const fingers = this.#fingers[message.side];
        fingers.tremble = tremble * ratio;
        this.#carryOut(message.side, c.skv_fingers_event(fingers, this.#event));
    }

    #carryOut(side: Side, made: skv_gesture) {
        const { c } = this.#library;
        clearTimeout(this.#waiting[side]);
        using(this.#library, made, (gesture) => {
            for (const event of gesture.events.slice(0, gesture.event_count)) {
                this.#worlds.touch(side, (world, seenBy) => world.send(event, seenBy));
            }
            const world = this.#worlds.at(side);
            if (gesture.dx !== 0 || gesture.dy !== 0) {
                world.pan(gesture.dx, gesture.dy);
            }
            if (gesture.factor !== 1) {
                world.zoom(gesture.factor, gesture.px, gesture.py);
            }
            if (gesture.dx !== 0 || gesture.dy !== 0 || gesture.factor !== 1) {
                this.#worlds.follow(side);
            }
            if (gesture.undo) {
                this.#undo();
            }
            if (gesture.wait > 0) {
                this.#waiting[side] = setTimeout(() => {
                    this.#carryOut(side, c.skv_fingers_wait(this.#fingers[side]));
                    this.#changed();
                }, Math.ceil(1000 * gesture.wait));
            }
        });
    }

    cancel() {
        const { c, instance } = this.#library;
        this.#waiting.forEach(clearTimeout);
        for (const { address } of this.#fingers) {
            instance.bytes(address, this.#library.size('skv_fingers')).fill(0);
        }
        this.#worlds.each(c.skv_session_cancel_pointers);
    }
}
