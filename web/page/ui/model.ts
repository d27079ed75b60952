// Model: what the page knows, as signals. Invariant: what the simulation says is in `state` alone; what
// only the page knows (which panel is open, what is said to the reader) is in the other signals.
import { computed, signal } from '@preact/signals';
import type { Catalogue, Simulation, State, Trouble, WorldState } from '../simulation/protocol';
import { said } from './words';

/** What everything is asked of; it is there before anything of the page can be used. */
export let simulation: Simulation;
/** All that there is to choose from; likewise. */
export let catalogue: Catalogue;
/** Whether both are there. */
export const ready = signal(false);

export function begin(with_: Simulation, choices: Catalogue): void {
    simulation = with_;
    catalogue = choices;
    FRAMES = choices.limits.frames_a_second;
    ready.value = true;
}

export const state = signal<State | null>(null);

/** A part of the state: what reads it is drawn again only when it differs. */
export function part<T>(read: (state: State) => T, otherwise: T) {
    return computed(() => (state.value ? read(state.value) : otherwise));
}

export const world = computed<WorldState | null>(() => state.value?.worlds[0] ?? null);
export const paused = part((s) => s.paused, true);
export const tool = part((s) => s.tool, 0);
export const dye = part((s) => s.dye, 0);
/** Whether there is a choice of what to pour. */
export const fluids = part((s) => s.worlds[0].fluids.length > 1, false);
/** Whether there are instruments. */
export const measures = part((s) => s.worlds.some(({ probes }) => probes.length > 0), false);
export const compared = part((s) => s.worlds.length > 1, false);

/** Frames a second of simulated time. */
export let FRAMES = 0;

/** Panels, one of which may be open: a sheet on phones, beside the water on wide screens. */
export type Panel =
    | 'scenes' | 'experiment' | 'views' | 'properties' | 'measure' | 'probe' | 'compare' | 'menu'
    | 'size' | 'pace' | 'share' | 'settings' | 'keys' | 'about' | 'bench' | 'photo';
export const panel = signal<Panel | null>(null);
/** Which experiment or instrument an open panel is of. */
export const subject = signal(0);

export function showPanel(which: Panel | null, of = 0): void {
    subject.value = of;
    panel.value = which;
}

export function togglePanel(which: Panel): void {
    showPanel(panel.value === which ? null : which);
}

/** What is said to the reader: a fault stays until it is closed. */
export interface Message {
    text: string;
    fault: boolean;
    /** What can be done about it. */
    offer?: { name: string; act: () => void };
    /** What there is to say of the scene meanwhile. */
    notes?: string[];
}
export const message = signal<Message | null>(null);
let fading = 0;

function tell(said: Message, milliseconds: number): void {
    clearTimeout(fading);
    message.value = said;
    fading = window.setTimeout(() => (message.value = null), milliseconds);
}

/** @param notes that are to be read */
export function toast(text: string, notes = 1): void {
    tell({ text, fault: false }, 6000 * notes);
}

/** With a button, for which there is more time, as in the app. */
export function propose(text: string, name: string, act: () => void): void {
    tell({ text, fault: false, offer: { name, act } }, 20_000);
}

/** What there is to say of a scene: a message with a button takes it up, and stays. */
export function remark(notes: string[]): void {
    const told = message.peek();
    if (told?.offer)
        tell({ ...told, notes }, 20_000);
    else if (notes.length > 0)
        toast(notes.join('; '), notes.length);
}

/** What is wrong, as the page or the library says it. */
export function complain(text: string): void {
    clearTimeout(fading);
    message.value = { text: said(text), fault: true };
}

export function dismiss(): void {
    clearTimeout(fading);
    message.value = null;
}

/** In a frame of another page, which scrolls; not in tests, where there is no window. */
export const framed = typeof window !== 'undefined' && window.parent !== window;
/** Embedded in another page: fewer controls. */
export const embedded = signal(false);
/** Which controls show: all, or what an embedding page chose. */
export const controls = signal<'all' | 'play' | 'none'>('all');
/** Arrow keys move a hand. */
export const keyboardHand = signal(false);
/** The experiment that is being measured, and how much of it is done. */
export const measuring = signal<{ index: number; share: number } | null>(null);
/** The picture can't be drawn. */
export const trouble = signal<Trouble>(null);
