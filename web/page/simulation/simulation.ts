// The simulation: what the page asks of it (protocol.ts), passed on to the library. It lives in a
// worker, on the page, or in node without a picture.
//
// Invariant: whatever numbers are asked for, the library gets what it takes.
import type { Library } from '../../src/library.js';
import { written } from '../../src/memory.js';

import { makeCatalogue } from './catalogue';
import { csvOf, linkOf } from './files';
import { Playing, type Surroundings } from './playing';
import { Pointers } from './pointers';
import type { FileFormat, PointerMessage, Settings, Side, Simulation, Style } from './protocol';
import { Tilt } from './tilt';

/** What people choose from. */
const speeds = [0.1, 0.25, 0.5, 1, 2];
/** What a session takes. */
const strongest = 2, fastestPush = 10, widestBrush = 100, longestWay = 1e9, largestView = 16384;

function bounded(value: number, least: number, most: number) {
    return Number.isFinite(value) ? Math.min(Math.max(value, least), most) : 0;
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

    constructor(surroundings: Surroundings) {
        this.#library = surroundings.library;
        this.#surroundings = surroundings;
        this.#playing = new Playing(surroundings);
        this.#worlds = this.#playing.worlds;
        this.#pointers = new Pointers(this.#library, this.#worlds,
            () => this.undo(), () => this.#playing.asked());
        this.#tilt = new Tilt(this.#library, surroundings.reversed);
    }

    /** Asks something of each session. */
    #each(call: (session: number) => void) {
        this.#worlds.each(call);
        this.#playing.asked();
    }

    /** Asks something of time: of the pair, or of the session. */
    #ask<Given extends unknown[]>(
        ofPair: (pair: number, ...given: Given) => void,
        ofSession: (session: number, ...given: Given) => void,
        ...given: Given
    ) {
        this.#worlds.ask(ofPair, ofSession, ...given);
        this.#playing.asked();
    }

    // ---- What is open ----------------------------------------------------------------------------

    open(scene: string, settings?: Settings) {
        this.#opened++;
        this.#playing.attempt('open', () => this.#playing.opening.scene(scene, settings));
    }

    openBytes(bytes: Uint8Array, format: FileFormat, label: string, settings?: Settings) {
        this.#openPacked(() => this.#playing.opening.bytes(bytes, format, label, settings));
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

    change(settings: Settings) {
        this.#playing.attempt('open', () => this.#playing.opening.change(settings));
    }

    reset() {
        this.seek(0);
    }

    replay() {
        this.#each(this.#library.c.skv_session_replay);
    }

    async save(what: 'skv' | 'skvr' | 'csv' | 'png') {
        const { c } = this.#library, { files, painter } = this.#surroundings;
        if (what === 'png') {
            if (!painter) {
                throw new Error('there is no picture here');
            }
            return painter.png(this.#worlds.first, this.#playing.style);
        }
        if (what === 'csv') {
            return csvOf(this.#library, this.#worlds.first);
        }
        const path = `saved.${what}`;
        await this.#playing.settled('save', () => c.skv_session_save(this.#worlds.first.session, path));
        const bytes = files.get(path)!;
        files.delete(path);
        return bytes;
    }

    async share() {
        const { c, instance } = this.#library, { session } = this.#worlds.first;
        await instance.bringCodecs();
        await this.#playing.settled('share', () => c.skv_session_share(session));
        return linkOf(this.#library,
            written(this.#library, (write, user) => c.skv_session_read_shared(session, write, user)));
    }

    compare(settings: Settings | null) {
        this.#playing.compare(settings);
    }

    setLinked(linked: boolean) {
        this.#pointers.cancel();
        this.#worlds.linked = linked;
        this.#playing.asked();
    }

    // ---- Time ------------------------------------------------------------------------------------

    setPaused(paused: boolean) {
        const { c } = this.#library;
        this.#ask(c.skv_pair_set_paused, c.skv_session_set_paused, paused);
    }

    togglePaused() {
        this.setPaused(!this.#worlds.first.picture.paused);
    }

    stepOnce() {
        const { c } = this.#library;
        this.#ask(c.skv_pair_step_once, c.skv_session_step_once);
    }

    setSpeed(speed: number) {
        const { c } = this.#library;
        if (Number.isFinite(speed)) {
            this.#ask(c.skv_pair_set_speed, c.skv_session_set_speed, speed);
        }
    }

    shiftSpeed(direction: number) {
        const { speed } = this.#worlds.first.picture;
        const at = speeds.findIndex((known) => known >= speed - 1e-9) + Math.sign(direction);
        this.setSpeed(speeds[bounded(at, 0, speeds.length - 1)]);
    }

    seek(frame: number) {
        const { c } = this.#library;
        const goal = Math.round(bounded(frame, 0, longestWay));
        this.#worlds.goal = goal;
        this.#ask(c.skv_pair_seek, c.skv_session_seek, BigInt(goal));
    }

    seekBy(frames: number, reach: number) {
        const { moment, end, paused } = this.#worlds.first.picture, last = Number(end);
        if (!paused) { // a message, for which whatever follows would wait while it seeks
            this.setPaused(true);
        }
        this.seek(Math.min(last, Math.max(last - reach, (this.#worlds.goal ?? Number(moment)) + frames)));
    }

    undo() {
        const { c } = this.#library;
        this.#ask(c.skv_pair_undo, c.skv_session_undo);
    }

    redo() {
        const { c } = this.#library;
        this.#ask(c.skv_pair_redo, c.skv_session_redo);
    }

    // ---- The world -------------------------------------------------------------------------------

    setGravity(x: number, y: number) {
        const { c } = this.#library;
        const [gx, gy] = [x, y].map((part) => bounded(part, -strongest, strongest));
        this.#worlds.touch(0, ({ session }) => c.skv_session_set_gravity(session, gx, gy));
        this.#playing.asked();
    }

    motion(x: number, y: number, _z: number, angle: number, time: number) {
        const { gravity, push } = this.#tilt.feel(x, y, angle, time, this.#worlds.first.picture);
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
        const { c } = this.#library;
        const [x, y] = [vx, vy].map((speed) => bounded(speed, -fastestPush, fastestPush));
        this.#worlds.touch(0, ({ session }) => c.skv_session_push(session, x, y));
        this.#playing.asked();
    }

    set(path: string, text: string, side: Side = 0) {
        this.#library.c.skv_session_set(this.#worlds.at(side).session, path, text);
        this.#playing.asked();
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
        const world = this.#worlds.at(side), { area, ratio } = world;
        if (factor > 0 && [factor, x, y].every(Number.isFinite)) {
            world.zoom(factor, (x - area.x) * ratio, (y - area.y) * ratio);
        }
        this.#worlds.follow(side);
        this.#playing.asked();
    }

    pan(dx: number, dy: number, side: Side = 0) {
        const world = this.#worlds.at(side);
        const [x, y] = [dx, dy].map((way) => bounded(way, -longestWay, longestWay) * world.ratio);
        world.pan(x, y);
        this.#worlds.follow(side);
        this.#playing.asked();
    }

    showAll() {
        this.#worlds.all.forEach((world) => world.showAll());
        this.#playing.asked();
    }

    setHidden(hidden: boolean) {
        this.#playing.setHidden(hidden);
    }

    // ---- Tools -----------------------------------------------------------------------------------

    setTool(tool: number) {
        const { c } = this.#library;
        if (Number.isInteger(tool) && tool >= 0 && c.skv_tool_info(tool)) {
            this.#each((session) => c.skv_session_set_tool(session, tool));
        }
    }

    setBrush(radius: number) {
        const { c } = this.#library;
        this.#each((session) => c.skv_session_set_brush(session, bounded(radius, 0, widestBrush)));
    }

    scaleBrush(factor: number, least: number, most: number) {
        this.setBrush(bounded(this.#worlds.first.picture.brush * factor, least, most));
    }

    setDye(dye: number) {
        const { c } = this.#library;
        if (Number.isInteger(dye) && dye >= 0 && c.skv_dye_name(dye)) {
            this.#each((session) => c.skv_session_set_dye(session, dye));
        }
    }

    nextDye() {
        const { c } = this.#library, next = c.skv_session_dye(this.#worlds.first.session) + 1;
        this.setDye(c.skv_dye_name(next) ? next : 0);
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
        const { c } = this.#library;
        const [x, y] = [right, up].map((way) => Math.sign(way) || 0);
        this.#worlds.touch(0, ({ session }) => c.skv_session_keyboard(session, x, y, down));
        this.#playing.asked();
    }

    // ---- Instruments -----------------------------------------------------------------------------

    addProbe(kind: number, x0: number, y0: number, x1: number, y1: number) {
        const { c } = this.#library;
        if (!Number.isInteger(kind) || kind < 0 || !c.skv_instrument_kind_name(kind)) {
            return;
        }
        const def = c.skv_default_instrument_def(kind);
        Object.assign(def, { x0, y0, x1, y1, name: c.skv_instrument_kind_name(kind) });
        this.#each((session) => c.skv_session_add_probe(session, def));
        this.#library.release(def);
    }

    moveProbe(id: number, x0: number, y0: number, x1: number, y1: number) {
        this.#each((session) => this.#library.c.skv_session_move_probe(session, id, x0, y0, x1, y1));
    }

    /** From where it is now: steps that come faster than states add up. */
    shiftProbe(id: number, dx: number, dy: number) {
        const { picture } = this.#worlds.first;
        const probe = picture.probes.slice(0, picture.probe_count).find((known) => known.id === id);
        if (probe) {
            const { x0, y0, x1, y1 } = probe.def;
            this.moveProbe(id, x0 + dx, y0 + dy, x1 + dx, y1 + dy);
        }
    }

    removeProbe(id: number) {
        this.#each((session) => this.#library.c.skv_session_remove_probe(session, id));
    }

    watchProbe(id: number, watched: boolean) {
        this.#each((session) => this.#library.c.skv_session_watch_probe(session, id, watched));
    }

    async catalogue() {
        return makeCatalogue(this.#library);
    }
}
