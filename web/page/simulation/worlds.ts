// The worlds: one, or a second one beside it, which are a pair then.
//
// Invariants: there are two exactly while their sessions are a pair; what goes on in time is asked of
// the pair, instruments of both; what ends the first world's scene ends the second before.
import type { Library } from '../../src/library.js';
import { withBytes, withOptions, written } from '../../src/memory.js';

import type { Settings, Side } from './protocol';
import { World } from './world';

export class Worlds {
    readonly first: World;
    second: World | null = null;
    /** Hands and gravity are for both. */
    linked = true;
    /** The moment that was asked for last, until it is reached. */
    goal: number | null = null;
    #pair = 0;
    #library;
    #threads;
    #width = 640;
    #height = 360;
    #ratio = 1;

    constructor(library: Library, threads: number) {
        this.#library = library;
        this.#threads = threads;
        this.first = new World(library, threads);
    }

    get all() {
        return this.second && this.#pair ? [this.first, this.second] : [this.first];
    }

    at(side: Side) {
        return this.all[side] ?? this.first;
    }

    // ---- Asking ----------------------------------------------------------------------------------

    /** Of the pair if there is one, else of the session. */
    ask<Given extends unknown[]>(
        ofPair: (pair: number, ...given: Given) => void,
        ofSession: (session: number, ...given: Given) => void,
        ...given: Given
    ) {
        if (this.#pair) {
            ofPair(this.#pair, ...given);
        } else {
            ofSession(this.first.session, ...given);
        }
    }

    /** Of each session. */
    each(call: (session: number) => void) {
        this.all.forEach(({ session }) => call(session));
    }

    /** Of the world at a side, or of both where they are linked. */
    touch(side: Side, call: (world: World, seenBy: World) => void) {
        const seenBy = this.at(side);
        (this.linked ? this.all : [seenBy]).forEach((world) => call(world, seenBy));
    }

    advance(seconds: number, drawing: number) {
        const { c } = this.#library;
        this.ask(c.skv_pair_advance, c.skv_session_advance, seconds, drawing);
    }

    get active() {
        const { c } = this.#library;
        return this.#pair ? c.skv_pair_is_active(this.#pair) : c.skv_session_is_active(this.first.session);
    }

    /** Takes the newest pictures; whether there is another one. */
    look() {
        const newer = this.all.map((world) => world.look()).some((another) => another);
        if (!this.first.picture.seeking) {
            this.goal = null;
        }
        return newer;
    }

    // ---- The view --------------------------------------------------------------------------------

    /** The canvas: two worlds lie beside each other, or above each other if they are larger then. */
    setView(width: number, height: number, ratio: number) {
        this.#width = width;
        this.#height = height;
        this.#ratio = ratio;
        const { all } = this;
        const { world_width: wide, world_height: high } = this.first.camera;
        const beside = Math.min(width / 2 / wide, height / high);
        const above = Math.min(width / wide, height / 2 / high);
        const across = all.length > 1 && beside >= above, down = all.length > 1 && !across;
        const area = { width: across ? width / 2 : width, height: down ? height / 2 : height };
        all.forEach((world, i) => world.setArea(
            { ...area, x: across ? i * area.width : 0, y: down ? i * area.height : 0 }, ratio));
    }

    /** After the camera of one side was moved: the other one shows the same part. */
    follow(side: Side) {
        this.all.filter((world) => world !== this.at(side)).forEach((world) => world.showAs(this.at(side)));
    }

    // ---- Comparing -------------------------------------------------------------------------------

    /** Opens in a second world what the first has shared; that reports to its own session. */
    openSecond(settings: Settings) {
        this.end();
        const library = this.#library, { c } = library;
        const second = new World(library, this.#threads);
        this.second = second;
        const shared = written(library,
            (write, user) => c.skv_session_read_shared(this.first.session, write, user));
        withBytes(library, shared, (data) => withOptions(library, settings, (options) =>
            c.skv_session_open_memory(second.session, data, shared.length, 'skvr',
                this.first.picture.name, options)));
    }

    /** Once it is open: both go on together. */
    join() {
        const library = this.#library, { c } = library;
        const { first, second } = this;
        if (!second || this.#pair) {
            return;
        }
        this.#pair = library.create((out, error) =>
            c.skv_pair_create(first.session, second.session, out, error));
        c.skv_session_set_tool(second.session, c.skv_session_tool(first.session));
        c.skv_session_set_dye(second.session, c.skv_session_dye(first.session));
        c.skv_pair_set_paused(this.#pair, false);
        second.look();
        this.setView(this.#width, this.#height, this.#ratio);
        this.follow(0);
    }

    end() {
        if (!this.second) {
            return;
        }
        this.#library.c.skv_pair_destroy(this.#pair);
        this.#pair = 0;
        this.second.destroy();
        this.second = null;
        this.setView(this.#width, this.#height, this.#ratio);
    }
}
