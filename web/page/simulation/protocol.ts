// What the page and the simulation say to each other. The simulation is one class (simulation.ts),
// which lives in a worker, or on the page where that has no OffscreenCanvas; the page sees it through
// this interface either way (connect.ts).
//
// Invariant: all of it can be posted to a worker: plain data, no functions, no views of the module's
// memory. What returns void only leaves a message; what has become of it shows in the next state, or
// comes as a report.

import type {
    skv_choice, skv_experiment, skv_gauge, skv_going, skv_key, skv_limits, skv_named_number, skv_numerals,
    skv_scene_info, skv_tool,
} from '../../src/interface.js';

/** A structure of the library's without its place in the memory. */
type Plain<Given> = Omit<Given, 'address'>;

/** One of the two worlds: 0, or 1 for the one that it is compared with. */
export type Side = 0 | 1;

export interface Simulation {
    // What is open
    open(scene: string, settings?: Settings): void;
    openBytes(bytes: Uint8Array, format: FileFormat, label: string, settings?: Settings): void;
    /** What a link holds (docs/share.md): the text after its '#'. */
    openLink(text: string): void;
    /** What keep() gave. */
    openKept(bytes: Uint8Array, label: string): void;
    /** The set-up of an experiment, to play with. */
    openExperiment(index: number): void;
    /** With how many an experiment begins where that many are chosen; 0: as it says itself. */
    experimentParticles(index: number, chosen: number): Promise<number>;
    reset(): void;
    /** Back to the start, and all that was done since is played again. */
    replay(): void;
    /** Ends watching a replay here, or goes to its end. */
    takeOver(): void;
    skip(): void;
    /** What is open as bytes: a state, a replay, the readings as CSV, the picture as PNG. */
    save(what: 'skv' | 'skvr' | 'csv' | 'png'): Promise<Uint8Array>;
    /** This moment, to go on from; null if nobody would miss it, or nothing has changed since it was asked for. */
    keep(): Promise<Uint8Array | null>;
    /** The text of a link to this moment, without its '#'; fails if it would be too long. */
    share(): Promise<string>;

    // Time
    setPaused(paused: boolean): void;
    stepOnce(): void;
    setSpeed(speed: number): void;
    seek(frame: number): void;
    // Each of these goes on from those before, though no state has told of them yet.
    togglePaused(): void;
    /** To the next of the speeds that people choose from, in either direction. */
    shiftSpeed(direction: number): void;
    /** Waits so many frames from where it is, or is on its way to, as far as the bar reaches. */
    seekBy(frames: number): void;
    /** Waits at a frame that the bar reaches. */
    scrub(frame: number): void;
    undo(): void;
    redo(): void;
    /** Starts or stops it, or takes a lap. */
    pressStopwatch(lap: boolean): void;

    // The world
    /** In units of the scene's own strength, x to the right and y up as the screen is held. */
    setGravity(x: number, y: number): void;
    /**
     * What devicemotion says of accelerationIncludingGravity, in m/s^2 in the device's axes, as it
     * says it; with screen.orientation's angle in degrees, and the time in s.
     */
    motion(x: number, y: number, z: number, angle: number, time: number): void;
    /** How much of what motion says the water feels: 0..2, at first 1. */
    setTilt(strength: number): void;
    push(vx: number, vy: number): void;
    /** A parameter of one world by its path, as catalogue().parameters names it. */
    set(path: string, text: string, side?: Side): void;
    /** Gravity as on one of catalogue().planets. */
    setPlanet(index: number, side?: Side): void;
    /** Scenes that would have 3000 particles begin with so many from now on; 0: with as many as are measured. */
    setParticles(count: number): void;
    /** The scene that is open, with other settings: what cannot be changed while it runs. */
    change(settings: Settings): void;

    // The picture
    /** Size in CSS pixels, and device pixels in each. */
    setView(width: number, height: number, ratio: number): void;
    setStyle(style: Partial<Style>): void;
    /** Readings and legends in SI units, or in those that people know. */
    setUnits(si: boolean): void;
    /** About a point, in CSS pixels. */
    zoom(factor: number, x: number, y: number, side?: Side): void;
    pan(dx: number, dy: number, side?: Side): void;
    showAll(): void;
    /** Nobody sees it: nothing is stepped or drawn. */
    setHidden(hidden: boolean): void;

    // Tools
    setTool(tool: number): void;
    /** Radius in m; 0: the default. */
    setBrush(radius: number): void;
    /** As seekBy: each goes on from those before. */
    scaleBrush(factor: number): void;
    setDye(dye: number): void;
    /** As setTool; one that dyes and is chosen again takes its next colour. */
    chooseTool(tool: number): void;
    /** What is poured, as worlds[0].fluids; and the next of them. */
    chooseFluid(fluid: number): void;
    nextFluid(): void;
    pointer(event: PointerMessage): void;
    cancelPointers(): void;
    keyboard(right: number, up: number, down: boolean): void;

    // Instruments
    /** In m. */
    addProbe(kind: number, x0: number, y0: number, x1: number, y1: number): void;
    moveProbe(id: number, x0: number, y0: number, x1: number, y1: number): void;
    /** One of catalogue().gauges, by its kind, where it is seen. */
    addGauge(kind: number): void;
    /** An end of it (0 or 1) to a place of a world; the first takes the second with it. */
    dragProbe(id: number, end: number, x: number, y: number, side?: Side): void;
    /** By so much; each adds to those before, though no state has told of them yet. */
    shiftProbe(id: number, dx: number, dy: number): void;
    removeProbe(id: number): void;
    /** Whether states hold its history. */
    watchProbe(id: number, watched: boolean): void;

    /** Puts a second world beside this one: what is open, with these settings; null takes it away. */
    compare(settings: Settings | null): void;
    /** The same with one of catalogue().choices. */
    compareWith(choice: string): void;
    /** Whether hands and gravity are for both worlds; at first they are. */
    setLinked(linked: boolean): void;

    /** All that there is to choose from; it never changes. */
    catalogue(): Promise<Catalogue>;
}

/** What the simulation tells, unasked. */
export interface Listener {
    /** After a picture was drawn or something was changed, at most thirty times a second. */
    state(state: State): void;
    report(report: Report): void;
    /** The picture can't be drawn, or can be again. */
    picture(trouble: Trouble): void;
}

/** Why there is no picture: the device is gone for a while, or draws none. */
export type Trouble = null | 'lost' | 'unsupported';

export type Settings = Record<string, string>;

export type FileFormat = 'json' | 'png' | 'skv' | 'skvr';

export interface Style {
    view: string;
    overlays: string[];
    palette: string;
    detail: string;
    /** The upper end of the view's scale, in SI units; 0: it follows the water. */
    range: number;
    /** Figures in the picture have a decimal comma. */
    comma: boolean;
}

export interface PointerMessage {
    phase: 'down' | 'move' | 'up' | 'leave';
    device: 'mouse' | 'finger' | 'pen' | 'eraser';
    pointer: number;
    /** CSS pixels from the canvas's upper left corner, as are all places on the screen. */
    x: number;
    y: number;
    /** Seconds, as event.timeStamp / 1000. */
    time: number;
    pressure: number;
    secondary: boolean;
    straight: boolean;
    /** In whose area it went down, or is. */
    side: Side;
}

/** What became of something that was asked for, as skv_outcome. */
export interface Report {
    kind: 'open' | 'save' | 'share' | 'step' | 'edit';
    /** One line; null: it was done. */
    error: string | null;
}

export interface WorldState {
    name: string;
    title: string;
    description: string;
    /** Changes when something else was opened. */
    opened: number;
    /** What the library says of that scene: what it left out or changed. */
    notes: string[];
    /** How that is to be shown; '' if it does not say. */
    view: string;
    overlays: string;
    /** Simulated seconds. */
    time: number;
    particles: number;
    substeps: number;
    width: number;
    height: number;
    spacing: number;
    parameters: Record<string, string>;
    /** The first included; colours as CSS writes them. */
    fluids: { name: string; color: string }[];
    /** Where on the canvas it is drawn, in CSS pixels. */
    area: { x: number; y: number; width: number; height: number };
    /** A point of the world in m is at (originX + scale x, originY - scale y) in CSS pixels. */
    camera: { scale: number; originX: number; originY: number; zoom: number };
    legend: Legend | null;
    probes: Probe[];
    hands: number;
}

export interface State {
    worlds: WorldState[]; // one, or two that are compared
    moment: number; // frames since the start
    end: number;
    paused: boolean;
    atRest: boolean;
    seeking: boolean;
    canUndo: boolean;
    canRedo: boolean;
    following: boolean;
    /** A replay plays, and people only watch; how often they did something that was not done for that. */
    watching: boolean;
    withheld: number;
    /** Which of the catalogue's choices the second world is; '': none of them. */
    choice: string;
    asRecorded: boolean;
    mismatch: boolean;
    speed: number;
    /** 1, or less where the machine cannot keep up. */
    pace: number;
    /** The same in words. */
    going: Plain<skv_going>;
    stopwatch: { used: boolean; running: boolean; frames: number; laps: number; lap: number };
    stepMs: number;
    drawMs: number;
    gravity: { x: number; y: number };
    tool: number;
    brush: number;
    dye: number;
    fluid: number;
    linked: boolean;
    threads: number;
    /** How many particles a scene of 3000 begins with here, as was measured; null: not yet. */
    chosen: number | null;
    /** Device pixels in a CSS pixel: fewer than there are where drawing is slow. */
    ratio: number;
    style: Style;
}

export interface Legend {
    label: string;
    /** As it is to be shown, and how much of the SI unit one of it is. */
    unit: string;
    size: number;
    /** In SI units, as are the other figures. */
    low: number;
    high: number;
    step: number;
    /** CSS colours from low to high. */
    colors: string[];
}

export interface Channel {
    name: string;
    value: number;
    lack: string;
    unit: string;
    size: number;
    decimals: number;
    theory: boolean;
}

export interface Probe {
    id: number;
    kind: number;
    x0: number;
    y0: number;
    x1: number;
    y1: number;
    /** Values are in SI units; they are shown in `unit`, each of which is `size` of the SI unit, with so
     * many decimals (-1: four significant digits). `lack` says why there is none, or is empty. */
    channels: Channel[];
    /** If it is watched: seconds, and for each channel its values. */
    times: Float64Array | null;
    values: Float64Array[] | null;
}

export interface Named {
    name: string;
    title: string;
    help: string;
}

export interface Catalogue {
    version: string;
    scenes: Plain<skv_scene_info>[];
    tools: (Omit<Plain<skv_tool>, 'key'> & { key: string })[];
    views: Named[];
    overlays: Named[];
    palettes: Named[];
    details: Named[];
    dyes: string[];
    /** How languages write numbers. */
    numerals: Plain<skv_numerals>[];
    /** Names of all kinds; and those that people put into the picture. */
    instruments: string[];
    gauges: Plain<skv_gauge>[];
    choices: Plain<skv_choice>[];
    speeds: Plain<skv_named_number>[];
    planets: Plain<skv_named_number>[];
    keys: Plain<skv_key>[];
    /** What to say of a refused number, and of a whole one. */
    refusals: string[];
    /** The numbers of particles that people choose from. */
    amounts: number[];
    limits: Plain<skv_limits>;
    /** What can be set while it runs, and what a scene or an experiment can be opened with. */
    parameters: Field[];
    sceneFields: Field[];
    experimentFields: Field[];
    experiments: Experiment[];
}

export interface Field {
    path: string;
    type: 'number' | 'integer' | 'text' | 'choice' | 'boolean';
    unit: string;
    minimum: number;
    maximum: number;
    choices: string[];
    default: string;
    help: string;
}

export type Experiment = Plain<skv_experiment>;

// ---- The laboratory: experiments run in a worker of their own (lab.worker.ts) ----------------------

export interface Curve {
    label: string;
    style: 'dots' | 'rings' | 'line' | 'theory';
    x: Float64Array;
    y: Float64Array;
}

export interface Row {
    quantity: string;
    unit: string;
    measured: number;
    theory: number;
    ratio: number;
    tolerance: number;
    pass: boolean;
}

export type LabMessage =
    | { kind: 'moment'; share: number; curves: Curve[] }
    /** Nothing was run: with how many it would be. */
    | { kind: 'counted'; particles: number }
    | { kind: 'done'; particles: number; rows: Row[]; curves: Curve[]; csv: string; svg: string }
    /** Without words: its script did not come. */
    | { kind: 'failed'; error: string };

/** lab.ts: runs an experiment with as many particles as are chosen in a worker of its own, or counts them; what it returns ends that. */
export type RunExperiment = (
    index: number,
    particles: number,
    tell: (message: LabMessage) => void,
) => () => void;

/** connect.ts: a simulation that draws on this canvas, from now on and alone. */
export type Connect = (canvas: HTMLCanvasElement, listener: Listener) => Promise<Simulation>;
