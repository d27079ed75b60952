// What goes on: the worlds, their time, and what is told of them.
//
// Invariant: after every call, and after every frame, what has become of it is told: outcomes as
// reports, what shows as a state.
import type { Library } from '../../src/library.js';
import type { skv_outcome, skv_render_style } from '../../src/interface.js';

import { amountOf, chooseAmount } from './amount';
import { Opening } from './opening';
import { Frames, Sharpness } from './pacing';
import type { Painter } from './painter';
import type { Listener, Report, Settings, State, Style } from './protocol';
import { Reader } from './state';
import { Worlds } from './worlds';

/** Between two states, s. */
const statePeriod = 1 / 30;

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
}

type Waiting = { resolve: () => void; reject: (error: Error) => void };

export class Playing {
    readonly worlds;
    readonly opening;
    readonly reader;
    readonly style: skv_render_style;
    /** What it was set to. */
    styleNames: Style = { view: 'water', overlays: [], palette: 'dark', detail: 'auto', range: 0 };
    #library;
    #surroundings;
    #frames;
    #sharpness = new Sharpness();
    #outcome: skv_outcome;
    #view = { width: 640, height: 360, ratio: 1 };
    #chosen;
    #drawing = 0;
    #told = -Infinity;
    #late: ReturnType<typeof setTimeout> | undefined;
    #waiting: { save: Waiting[]; share: Waiting[] } = { save: [], share: [] };
    #comparing: Settings | null = null;

    constructor(surroundings: Surroundings) {
        const { library, threads, nextFrame, particles } = surroundings;
        const { c } = library;
        this.#library = library;
        this.#surroundings = surroundings;
        this.#chosen = particles;
        this.worlds = new Worlds(library, threads);
        this.opening = new Opening(library, this.worlds.first.session, (name) => this.#amount(name));
        this.#frames = new Frames(nextFrame, (seconds) => this.#pass(seconds));
        this.reader = new Reader(library);
        this.#outcome = library.make('skv_outcome');
        this.style = c.skv_default_render_style();
    }

    #amount(name: string) {
        const { library, threads, clock } = this.#surroundings;
        this.#chosen ??= chooseAmount(library, threads, clock);
        return amountOf(library, name, this.#chosen);
    }

    // ---- After a call ----------------------------------------------------------------------------

    /** Something was asked for: its outcomes, a frame for the picture, a state. */
    asked() {
        this.#takeOutcomes();
        this.worlds.look();
        if (this.worlds.active || this.worlds.all.some(({ stale }) => stale)) {
            this.#frames.ask();
        }
        this.#tellState();
    }

    /** Does what may throw; that is reported. */
    attempt(kind: Report['kind'], call: () => void) {
        try {
            call();
        } catch (error) {
            this.#report(kind, error instanceof Error ? error.message : String(error));
        }
        this.asked();
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

    #takeOutcomes() {
        const { c } = this.#library, { first, second } = this.worlds;
        while (c.skv_session_next_outcome(first.session, this.#outcome)) {
            this.#settle(this.#outcome.kind, this.#outcome.error);
        }
        const isThere = () => second && second === this.worlds.second;
        while (second && isThere() && c.skv_session_next_outcome(second.session, this.#outcome)) {
            const { kind, error } = this.#outcome;
            if (kind === this.#library.constants.SKV_OUTCOME_OPEN) {
                this.#join(error.code === 0 ? null : error.text);
            } else if (error.code !== 0) {
                this.#report(this.#kindOf(kind), error.text);
            }
        }
    }

    #kindOf(kind: number): Report['kind'] {
        const { constants } = this.#library;
        return kind === constants.SKV_OUTCOME_OPEN ? 'open'
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
        if (kind === 'open') {
            this.opening.done(!error);
            if (!error) {
                this.worlds.end();
            }
        }
        if (error || kind === 'open') {
            this.#report(kind, error);
        }
    }

    // ---- Comparing -------------------------------------------------------------------------------

    compare(settings: Settings | null) {
        const { c } = this.#library;
        this.#comparing = settings;
        if (!settings) {
            this.worlds.end();
            this.asked();
            return;
        }
        this.settled('share', () => c.skv_session_share(this.worlds.first.session)).then(
            () => {
                if (this.#comparing === settings) {
                    this.attempt('open', () => this.worlds.openSecond(settings));
                }
            },
            (error: Error) => this.#report('open', error.message));
    }

    /** The second world is open, or is not. */
    #join(error: string | null) {
        if (error) {
            this.worlds.end();
        } else {
            this.worlds.join();
        }
        this.#report('open', error);
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
        const { all } = this.worlds, { picture } = this.worlds.first;
        const pictures = all.map((world) => world.picture);
        return {
            worlds: all.map((world) => this.reader.world(world, this.style)),
            moment: Number(picture.moment),
            end: Number(picture.end),
            paused: picture.paused,
            atRest: pictures.every(({ at_rest: rests }) => rests),
            seeking: pictures.some(({ seeking }) => seeking),
            canUndo: pictures.some(({ can_undo: can }) => can),
            canRedo: pictures.every(({ can_redo: can }) => can),
            following: picture.following,
            asRecorded: picture.as_recorded,
            mismatch: picture.mismatch,
            speed: picture.speed,
            pace: Math.min(...pictures.map(({ pace }) => pace)),
            stepMs: pictures.reduce((sum, { step_ms: ms }) => sum + ms, 0),
            drawMs: 1000 * this.#drawing,
            gravity: { x: picture.tilt_x, y: picture.tilt_y },
            tool: picture.tool,
            brush: picture.brush,
            dye: this.#library.c.skv_session_dye(this.worlds.first.session),
            linked: this.worlds.linked,
            threads: this.#surroundings.threads,
            chosen: this.#chosen,
            ratio: this.worlds.first.ratio,
            style: { ...this.styleNames, overlays: [...this.styleNames.overlays] },
        };
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
        this.styleNames = { ...this.styleNames, ...style };
        this.worlds.all.forEach((world) => {
            world.stale = true;
        });
    }

    // ---- Frames ----------------------------------------------------------------------------------

    #pass(seconds: number) {
        const { clock } = this.#surroundings;
        const before = clock(), moves = this.worlds.active;
        if (moves) {
            this.worlds.advance(seconds, this.#drawing);
        }
        this.#takeOutcomes();
        this.worlds.look();
        const stepping = clock() - before;
        this.#draw();
        const { active } = this.worlds;
        if (moves && this.#sharpness.tell(seconds, stepping, this.#drawing)) {
            this.#layOut();
        }
        this.#tellState();
        return active;
    }

    #draw() {
        const { clock, painter } = this.#surroundings;
        const { all } = this.worlds;
        if (!all.some(({ stale }) => stale) || this.worlds.first.picture.opened === 0) {
            return;
        }
        const before = clock();
        try {
            if (painter && !painter.draw(all, this.style)) {
                return;
            }
        } catch (error) {
            this.#report('step', error instanceof Error ? error.message : String(error));
        }
        all.forEach((world) => {
            world.stale = false;
        });
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
