// The simulation: what the page asks of it (protocol.ts), passed on to the library. It lives in a
// worker, on the page, or in node without a picture.
//
// Invariant: whatever numbers are asked for, the library gets what it takes.
import type { Library } from '../../src/library.js';
import { table, written } from '../../src/memory.js';

import { amountsOf } from './amount';
import { makeCatalogue } from './catalogue';
import { Playing, type Surroundings } from './playing';
import { Pointers } from './pointers';
import type { FileFormat, PointerMessage, Settings, Side, Simulation, Style } from './protocol';
import { Tilt } from './tilt';

/** Times what is felt; pixels. */
const strongest = 2, largestView = 16384;

function bounded(value: number, least: number, most: number) {
    return Number.isFinite(value) ? Math.min(Math.max(value, least), most) : 0;
}

/** A number of frames. */
function whole(frames: number) {
    return BigInt(Math.round(bounded(frames, -Number.MAX_SAFE_INTEGER, Number.MAX_SAFE_INTEGER)));
}

export class Simulator implements Simulation {
    #library: Library;
    #surroundings;
    #playing;
    #worlds;
    #pointers;
    #tilt;
    /** How often something was opened. */
    #opened = 0;
    /** The pictures that were kept last. */
    #kept = '';

    constructor(surroundings: Surroundings) {
        this.#library = surroundings.library;
        this.#surroundings = surroundings;
        this.#playing = new Playing(surroundings);
        this.#worlds = this.#playing.worlds;
        this.#pointers = new Pointers(this.#library, this.#worlds, () => this.#playing.asked());
        this.#tilt = new Tilt(this.#library, surroundings.reversed);
    }

    /** Asks something of the stage. */
    #ask<Given extends unknown[]>(call: (stage: number, ...given: Given) => unknown, ...given: Given) {
        call(this.#worlds.stage, ...given);
        this.#playing.asked();
    }

    /** The same with an entry of a table last, if it is there. */
    #askWith<Given extends unknown[]>(entry: number,
        call: (stage: number, ...given: [...Given, number]) => unknown, ...given: Given) {
        if (entry !== 0) {
            this.#ask(call, ...given, entry);
        }
    }

    // ---- Another one in its place (grow.ts) ----------------------------------------------------------

    get playing() {
        return this.#playing;
    }

    /** Ends, with the canvas for another one; the last state. */
    end() {
        this.#opened++;
        this.#pointers.cancel();
        this.#surroundings.painter?.destroy();
        return this.#playing.end();
    }

    // ---- What is open ----------------------------------------------------------------------------

    open(scene: string, settings?: Settings) {
        const open = () => this.#playing.opening.scene(scene, settings);
        const infos = table(this.#library, 'skv_scene_info', this.#library.c.skv_builtin_scene);
        if (infos.some(({ name, painted }) => painted && name === scene)) {
            this.#openPacked(open);
            return;
        }
        this.#opened++;
        this.#playing.attempt('open', open);
    }

    openBytes(bytes: Uint8Array, format: FileFormat, label: string, settings?: Settings) {
        this.#openPacked(() => this.#playing.opening.bytes(bytes, format, label, settings));
    }

    openKept(bytes: Uint8Array, label: string) {
        this.#openPacked(() => this.#playing.opening.bytes(bytes, 'skvr', label, {}, false));
    }

    openLink(text: string) {
        this.#openPacked(() => this.#playing.opening.link(text));
    }

    /** What takes codecs, when they are there; unless something else was opened while they came. */
    #openPacked(open: () => void) {
        const { instance } = this.#library, turn = ++this.#opened;
        if (instance.hasCodecs) {
            this.#playing.attempt('open', open);
            return;
        }
        const fail = (error: unknown) => () => {
            throw error;
        };
        void instance.bringCodecs().then(() => open, fail).then((next) => {
            if (turn === this.#opened) {
                this.#playing.attempt('open', next);
            }
        });
    }

    openExperiment(index: number) {
        this.#opened++;
        this.#playing.attempt('open', () => this.#playing.opening.experiment(index));
    }

    async experimentParticles(index: number, chosen: number) {
        return this.#library.c.skv_experiment_particles(index, chosen);
    }

    setParticles(count: number) {
        this.#playing.setParticles(Math.round(bounded(count, 0, amountsOf(this.#library).at(-1)!)));
    }

    change(settings: Settings) {
        this.#playing.attempt('open', () => this.#playing.opening.change(settings));
    }

    reset() {
        this.seek(0);
    }

    replay() {
        this.#ask(this.#library.c.skv_stage_replay);
    }

    takeOver() {
        this.#ask(this.#library.c.skv_stage_take_over);
    }

    skip() {
        this.#ask(this.#library.c.skv_stage_skip);
    }

    async save(what: 'skv' | 'skvr' | 'csv' | 'png') {
        const { c } = this.#library, { painter } = this.#surroundings;
        if (what === 'png') {
            if (!painter) {
                throw new Error('there is no picture here');
            }
            return painter.png(this.#worlds.all[0], this.#playing.style);
        }
        if (what === 'csv') {
            const { csvOf } = await import('./files');
            return csvOf(this.#library, this.#worlds);
        }
        return this.#written(c.skv_stage_save, `saved.${what}`);
    }

    async keep() {
        const { c } = this.#library, { stage, all } = this.#worlds;
        const shown = all.map(({ picture }) => picture.number).join();
        if (shown === this.#kept || !c.skv_control_would_be_missed(stage)) {
            return null;
        }
        this.#kept = shown;
        return this.#written(c.skv_stage_save_moment, 'kept');
    }

    /** What the stage writes to a file. */
    async #written(write: (stage: number, path: string) => void, path: string) {
        const { files } = this.#surroundings;
        await this.#playing.settled('save', () => write(this.#worlds.stage, path));
        const bytes = files.get(path)!;
        files.delete(path);
        return bytes;
    }

    async share() {
        const { c, instance } = this.#library, { stage } = this.#worlds;
        await instance.bringCodecs();
        await this.#playing.settled('share', () => c.skv_stage_share(stage));
        const { linkOf } = await import('./files');
        return linkOf(this.#library,
            written(this.#library, (write, user) => c.skv_stage_read_shared(stage, write, user)));
    }

    compare(settings: Settings | null) {
        this.#playing.compare(settings);
    }

    compareWith(choice: string) {
        this.#askWith(this.#library.c.skv_choice_named(choice), this.#library.c.skv_control_compare);
    }

    setLinked(linked: boolean) {
        this.#ask(this.#library.c.skv_stage_set_linked, linked);
    }

    // ---- Time ------------------------------------------------------------------------------------

    setPaused(paused: boolean) {
        this.#ask(this.#library.c.skv_stage_set_paused, paused);
    }

    togglePaused() {
        this.setPaused(!this.#worlds.first.paused);
    }

    stepOnce() {
        this.#ask(this.#library.c.skv_stage_step_once);
    }

    setSpeed(speed: number) {
        this.#ask(this.#library.c.skv_stage_set_speed, speed);
    }

    shiftSpeed(direction: number) {
        this.#ask(this.#library.c.skv_control_shift_speed, Math.sign(direction) || 0);
    }

    seek(frame: number) {
        this.#ask(this.#library.c.skv_stage_seek, whole(frame));
    }

    seekBy(frames: number) {
        this.#ask(this.#library.c.skv_control_go, whole(frames));
    }

    scrub(frame: number) {
        this.#ask(this.#library.c.skv_control_seek, whole(frame));
    }

    undo() {
        this.#ask(this.#library.c.skv_stage_undo);
    }

    redo() {
        this.#ask(this.#library.c.skv_stage_redo);
    }

    pressStopwatch(lap: boolean) {
        this.#playing.stopwatch.press(lap);
        this.#playing.asked();
    }

    // ---- The world -------------------------------------------------------------------------------

    setGravity(x: number, y: number) {
        this.#ask(this.#library.c.skv_stage_set_gravity, 0, x, y);
    }

    motion(x: number, y: number, _z: number, angle: number, time: number) {
        const { gravity, push } = this.#tilt.feel(x, y, angle, time, this.#worlds.first);
        if (gravity) {
            this.setGravity(gravity.x, gravity.y);
        }
        if (push) {
            this.push(push.x, push.y);
        }
    }

    setTilt(strength: number) {
        this.#tilt.strength = bounded(strength, 0, strongest);
    }

    push(vx: number, vy: number) {
        this.#ask(this.#library.c.skv_stage_push, 0, vx, vy);
    }

    set(path: string, text: string, side: Side = 0) {
        this.#ask(this.#library.c.skv_stage_set, side, path, text);
    }

    setPlanet(index: number, side: Side = 0) {
        this.#askWith(this.#library.c.skv_planet_at(index), this.#library.c.skv_control_planet, side);
    }

    // ---- The picture -----------------------------------------------------------------------------

    setView(width: number, height: number, ratio: number) {
        const [wide, high] = [width, height].map((size) => bounded(size, 1, largestView) || 1);
        this.#playing.setView(wide, high, bounded(ratio, 0.5, 4) || 1);
        this.#playing.asked();
    }

    setStyle(style: Partial<Style>) {
        this.#playing.attempt('edit', () => this.#playing.setStyle(style));
    }

    setUnits(si: boolean) {
        this.#playing.reader.si = si;
        this.#playing.asked();
    }

    zoom(factor: number, x: number, y: number, side: Side = 0) {
        const { ratio } = this.#worlds, { area } = this.#worlds.at(side);
        this.#ask(this.#library.c.skv_stage_zoom, side, factor, (x - area.x) * ratio, (y - area.y) * ratio);
    }

    pan(dx: number, dy: number, side: Side = 0) {
        const { ratio } = this.#worlds;
        this.#ask(this.#library.c.skv_stage_pan, side, dx * ratio, dy * ratio);
    }

    showAll() {
        this.#ask(this.#library.c.skv_stage_show_all);
    }

    setHidden(hidden: boolean) {
        this.#playing.setHidden(hidden);
    }

    // ---- Tools -----------------------------------------------------------------------------------

    setTool(tool: number) {
        this.#ask(this.#library.c.skv_stage_set_tool, tool);
    }

    setBrush(radius: number) {
        this.#ask(this.#library.c.skv_stage_set_brush, radius);
    }

    scaleBrush(factor: number) {
        this.#ask(this.#library.c.skv_control_scale_brush, factor);
    }

    setDye(dye: number) {
        this.#ask(this.#library.c.skv_stage_set_dye, dye);
    }

    chooseTool(tool: number) {
        const { c, instance } = this.#library;
        this.#ask(c.skv_control_tool, tool);
        if (instance.exports.skv_wasm_wants_more && this.#library.view('skv_tool', c.skv_tool_info(tool)).drops) {
            this.#surroundings.grow?.(true);
        }
    }

    chooseFluid(fluid: number) {
        this.#ask(this.#library.c.skv_control_fluid, fluid);
    }

    nextFluid() {
        this.#ask(this.#library.c.skv_control_next_fluid);
    }

    pointer(event: PointerMessage) {
        this.#pointers.tell(event);
        this.#playing.asked();
    }

    cancelPointers() {
        this.#pointers.cancel();
        this.#playing.asked();
    }

    keyboard(right: number, up: number, down: boolean) {
        this.#ask(this.#library.c.skv_stage_keyboard, 0, Math.sign(right) || 0, Math.sign(up) || 0, down);
    }

    // ---- Instruments -----------------------------------------------------------------------------

    addProbe(kind: number, x0: number, y0: number, x1: number, y1: number) {
        const { c } = this.#library;
        if (!Number.isInteger(kind) || kind < 0 || !c.skv_instrument_kind_name(kind)) {
            return;
        }
        const def = c.skv_default_instrument_def(kind);
        Object.assign(def, { x0, y0, x1, y1, name: c.skv_instrument_kind_name(kind) });
        this.#ask(c.skv_stage_add_probe, def);
        this.#library.release(def);
    }

    moveProbe(id: number, x0: number, y0: number, x1: number, y1: number) {
        this.#ask(this.#library.c.skv_stage_move_probe, id, x0, y0, x1, y1);
    }

    addGauge(kind: number) {
        this.#askWith(this.#library.c.skv_gauge_of(kind), this.#library.c.skv_control_add_gauge);
    }

    dragProbe(id: number, end: number, x: number, y: number, side: Side = 0) {
        this.#ask(this.#library.c.skv_control_drag, side, id, end, x, y);
    }

    shiftProbe(id: number, dx: number, dy: number) {
        this.#ask(this.#library.c.skv_stage_shift_probe, id, dx, dy);
    }

    removeProbe(id: number) {
        this.#ask(this.#library.c.skv_stage_remove_probe, id);
    }

    watchProbe(id: number, watched: boolean) {
        this.#ask(this.#library.c.skv_stage_watch_probe, id, watched);
    }

    async catalogue() {
        return makeCatalogue(this.#library);
    }
}
