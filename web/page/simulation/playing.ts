// What goes on: the worlds, their time, and what is told of them.
//
// Invariant: after every call, and after every frame, what has become of it is told: outcomes as
// reports, what shows as a state.
import type { Library } from '../../src/library.js';
import type { skv_outcome, skv_render_style } from '../../src/interface.js';
import { plain, using, withOptions } from '../../src/memory.js';

import { chooseAmount } from './amount';
import { Opening } from './opening';
import { Frames, Sharpness } from './pacing';
import type { Painter } from './painter';
import type { Listener, Report, Settings, State, Style } from './protocol';
import { Reader } from './state';
import { Stopwatch } from './stopwatch';
import { Worlds } from './worlds';

/** Between two states, s. */
const statePeriod = 1 / 30;
/** Frames: who loses the device is refused pictures at first, and hears of it later. */
const patience = 60;

export interface Surroundings {
    library: Library;
    /** On which each world is stepped. */
    threads: number;
    /** What the module saves goes here. */
    files: Map<string, Uint8Array>;
    listener: Listener;
    painter: Painter | null;
    /** requestAnimationFrame, or what stands for it. */
    nextFrame: (callback: (ms: number) => void) => void;
    /** Seconds. */
    clock: () => number;
    /** Of scenes that would have 3000; null: it is measured. */
    particles: number | null;
    /** devicemotion has the other signs here: Apple's. */
    reversed: boolean;
    /** Bodies are wanted, and the module has none: in what is to be opened, or, as is foreseen, in what is open. */
    grow?: (foresees: boolean) => void;
}

type Waiting = { resolve: () => void; reject: (error: Error) => void };

export class Playing {
    readonly worlds;
    readonly opening;
    readonly reader;
    readonly stopwatch;
    readonly style: skv_render_style;
    /** What it was set to. */
    styleNames: Style = { view: 'water', overlays: [], palette: 'dark', detail: 'auto', range: 0, comma: false };
    #library;
    #surroundings;
    #frames;
    #sharpness = new Sharpness();
    #outcome: skv_outcome;
    #view = { width: 640, height: 360, ratio: 1 };
    #chosen;
    #drawing = 0;
    /** Frames in a row in which the picture was refused. */
    #refusals = 0;
    #told = -Infinity;
    #late: ReturnType<typeof setTimeout> | undefined;
    #waiting: { save: Waiting[]; share: Waiting[] } = { save: [], share: [] };

    constructor(surroundings: Surroundings) {
        const { library, threads, nextFrame, particles } = surroundings;
        const { c } = library;
        this.#library = library;
        this.#surroundings = surroundings;
        this.#chosen = particles;
        this.worlds = new Worlds(library, threads);
        this.opening = new Opening(library, this.worlds.stage, (of) => this.#amount(of));
        this.#frames = new Frames(nextFrame, (seconds) => this.#pass(seconds));
        this.reader = new Reader(library);
        this.stopwatch = new Stopwatch(library, this.worlds);
        this.#outcome = library.make('skv_outcome');
        this.style = c.skv_default_render_style();
    }

    #amount(of: string | number) {
        const { library, threads, clock, painter } = this.#surroundings;
        this.#chosen ??= chooseAmount(library, threads, clock,
            (frame) => painter?.measure(frame, this.style, clock) ?? 0);
        return typeof of === 'number'
            ? library.c.skv_experiment_particles(of, this.#chosen) : library.c.skv_amount_of(of, this.#chosen);
    }

    /** How many particles scenes begin with that would have 3000; 0: it is measured. */
    setParticles(count: number) {
        this.#chosen = count || null;
    }

    // ---- After a call ----------------------------------------------------------------------------

    /** Something was asked for: its outcomes, a frame for the picture, a state. */
    asked() {
        this.#takeOutcomes();
        this.worlds.look();
        if (this.#active || this.worlds.stale) {
            this.#frames.ask();
        }
        this.#tellState();
    }

    /** Does what may throw; that is reported, unless a larger module does it. */
    attempt(kind: Report['kind'], call: () => void) {
        try {
            call();
        } catch (error) {
            if (!this.#grows()) {
                this.#report(kind, error instanceof Error ? error.message : String(error));
            }
        }
        this.asked();
    }

    /** Whether what failed is wanted of a larger module, which goes on with what is to be opened. */
    #grows() {
        const { library, grow } = this.#surroundings;
        const grows = grow && library.instance.exports.skv_wasm_wants_more?.();
        if (grows) {
            grow(false);
        }
        return grows;
    }

    /** Asks for what is reported later; when it is. */
    settled(what: 'save' | 'share', ask: () => void) {
        const done = new Promise<void>((resolve, reject) => this.#waiting[what].push({ resolve, reject }));
        ask();
        this.asked();
        return done;
    }

    #report(kind: Report['kind'], error: string | null) {
        this.#surroundings.listener.report({ kind, error });
    }

    get #active() {
        return this.#library.c.skv_stage_is_active(this.worlds.stage);
    }

    #takeOutcomes() {
        while (this.#library.c.skv_stage_next_outcome(this.worlds.stage, this.#outcome)) {
            this.#settle(this.#outcome.kind, this.#outcome.error);
        }
    }

    #kindOf(kind: number): Report['kind'] {
        const { constants } = this.#library;
        return kind === constants.SKV_OUTCOME_OPEN || kind === constants.SKV_OUTCOME_COMPARE ? 'open'
            : kind === constants.SKV_OUTCOME_SAVE ? 'save'
                : kind === constants.SKV_OUTCOME_SHARE ? 'share'
                    : kind === constants.SKV_OUTCOME_STEP ? 'step' : 'edit';
    }

    #settle(number: number, { code, text }: { code: number; text: string }) {
        const kind = this.#kindOf(number), error = code === 0 ? null : text;
        if (kind === 'save' || kind === 'share') {
            const waiting = this.#waiting[kind].shift();
            if (error) {
                waiting?.reject(new Error(error));
            } else {
                waiting?.resolve();
            }
            return;
        }
        if (number === this.#library.constants.SKV_OUTCOME_OPEN) {
            if (error && this.#grows()) {
                return;
            }
            this.opening.done(!error);
        }
        if (error || kind === 'open') {
            this.#report(kind, error);
        }
    }

    compare(settings: Settings | null) {
        const { c } = this.#library, { stage } = this.worlds;
        if (settings) {
            withOptions(this.#library, settings, (options) => c.skv_stage_compare(stage, options));
        } else {
            c.skv_stage_end_compare(stage);
        }
        this.asked();
    }

    // ---- States -----------------------------------------------------------------------------------

    /** Now, or as soon as the last one is old enough. */
    #tellState() {
        const rest = this.#told + statePeriod - this.#surroundings.clock();
        if (rest <= 0) {
            this.#tell();
        } else {
            this.#late ??= setTimeout(() => this.#tell(), 1000 * rest);
        }
    }

    #tell() {
        clearTimeout(this.#late);
        this.#late = undefined;
        this.#told = this.#surroundings.clock();
        this.#surroundings.listener.state(this.#state());
    }

    #state(): State {
        const { c } = this.#library, { all, first: picture, stage, ratio } = this.worlds;
        return using(this.#library, c.skv_stage_now(stage), (now) => ({
            worlds: all.map((world) => this.reader.world(world, this.worlds, this.style)),
            moment: Number(picture.moment),
            end: Number(picture.end),
            paused: picture.paused,
            atRest: now.at_rest,
            seeking: now.seeking,
            canUndo: now.can_undo,
            canRedo: now.can_redo,
            following: picture.following,
            watching: picture.watching,
            withheld: picture.withheld,
            choice: c.skv_stage_choice(stage)!,
            asRecorded: picture.as_recorded,
            mismatch: picture.mismatch,
            speed: picture.speed,
            pace: now.pace,
            going: using(this.#library, c.skv_control_going(stage), plain),
            stopwatch: this.stopwatch.read(),
            stepMs: now.step_ms,
            drawMs: 1000 * this.#drawing,
            gravity: { x: picture.tilt_x, y: picture.tilt_y },
            tool: picture.tool,
            brush: picture.brush,
            dye: c.skv_stage_dye(stage),
            fluid: c.skv_stage_fluid(stage),
            linked: c.skv_stage_linked(stage),
            threads: this.#surroundings.threads,
            chosen: this.#chosen,
            ratio,
            style: { ...this.styleNames, overlays: [...this.styleNames.overlays] },
        }));
    }

    /** Throws what there is no such name for. */
    setStyle(style: Partial<Style>) {
        const { c, constants } = this.#library;
        const part = (number: number, names: string | undefined) => names !== undefined &&
            this.#library.check((error) => c.skv_render_style_set(this.style, number, names, error));
        part(constants.SKV_STYLE_VIEW, style.view);
        part(constants.SKV_STYLE_OVERLAY, style.overlays && (style.overlays.join(',') || 'none'));
        part(constants.SKV_STYLE_PALETTE, style.palette);
        part(constants.SKV_STYLE_DETAIL, style.detail);
        if (style.range !== undefined && Number.isFinite(style.range) && style.range >= 0) {
            this.style.range = style.range;
        }
        this.style.comma = style.comma ?? this.style.comma;
        this.styleNames = { ...this.styleNames, ...style };
        c.skv_stage_set_look(this.worlds.stage, this.styleNames.view, this.styleNames.overlays.join());
        this.worlds.stale = true;
    }

    /** Nothing passes and nothing is told any more; what would have been. */
    end() {
        clearTimeout(this.#late);
        this.setHidden(true);
        return this.#state();
    }

    // ---- Frames ----------------------------------------------------------------------------------

    #pass(seconds: number) {
        const { clock } = this.#surroundings;
        const before = clock(), moves = this.#active;
        if (moves) {
            this.#library.c.skv_stage_advance(this.worlds.stage, seconds, this.#drawing);
        }
        this.#takeOutcomes();
        this.worlds.look();
        const stepping = clock() - before;
        this.#draw();
        const active = this.#active;
        if (moves && this.#sharpness.tell(seconds, stepping, this.#drawing)) {
            this.#layOut();
        }
        this.#tellState();
        return active || (this.#refusals > 0 && this.#refusals < patience);
    }

    #draw() {
        const { clock, painter } = this.#surroundings;
        if (!this.worlds.stale || this.worlds.first.opened === 0) {
            return;
        }
        const before = clock();
        try {
            if (painter && !painter.draw(this.worlds, this.style)) {
                return;
            }
        } catch {
            if (++this.#refusals < patience) {
                return;
            }
            this.#surroundings.listener.picture('lost');
            this.worlds.stale = false;
            return;
        }
        if (this.#refusals >= patience) {
            this.#surroundings.listener.picture(null);
        }
        this.#refusals = 0;
        this.worlds.stale = false;
        this.#drawing = clock() - before;
    }

    setView(width: number, height: number, ratio: number) {
        this.#view = { width, height, ratio };
        this.#layOut();
    }

    setHidden(hidden: boolean) {
        this.#frames.setHidden(hidden);
    }

    #layOut() {
        const { width, height, ratio } = this.#view;
        const used = Math.min(ratio, this.#sharpness.limit);
        this.#surroundings.painter?.resize(Math.round(width * used), Math.round(height * used));
        this.worlds.setView(width, height, used);
    }
}
