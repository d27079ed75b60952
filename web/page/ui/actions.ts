// Actions: what buttons and keys do, a small function each. Invariant: what follows from one shows when
// the simulation's next state says so, not before.
import { signal } from '@preact/signals';
import { moreContrast, paletteOf, preferences, prefer, systemLight } from './preferences';
import { catalogue, complain, keyboardHand, showPanel, simulation, state, toast } from './model';
import { signs } from './numbers';
import { _ } from './words';

// Time

export function togglePause(): void {
    simulation.togglePaused();
}

export function step(): void {
    simulation.setPaused(true);
    simulation.stepOnce();
}

// Tools

/** Of the world. */
export function longerSide(): number {
    const world = state.value?.worlds[0];
    return world ? Math.max(world.width, world.height) : 1;
}

export function toggleKeyboardHand(): void {
    keyboardHand.value = !keyboardHand.value;
    simulation.keyboard(0, 0, false);
    if (keyboardHand.value)
        toast(_('Arrow keys move the hand, Return closes and opens it'));
}

// Views

function numberOfView(name: unknown): number {
    return catalogue.views.findIndex((view) => view.name === name);
}

/** @param keeps as in prefer */
export function setView(view: string, keeps = true): void {
    prefer({ view }, keeps);
    simulation.setStyle({ view, range: 0 });
}

/** For this visit, what another than the reader asks for; whether there is such a view. */
export function showView(name: unknown): boolean {
    const isKnown = numberOfView(name) >= 0;
    if (isKnown)
        setView(name as string, false);
    return isKnown;
}

export function nextView(): void {
    const at = numberOfView(preferences.value.view);
    setView(catalogue.views[(at + 1) % catalogue.views.length].name);
}

export function toggleOverlay(name: string): void {
    const shown = preferences.value.overlays;
    const overlays = shown.includes(name) ? shown.filter((other) => other !== name) : [...shown, name];
    prefer({ overlays });
    simulation.setStyle({ overlays });
}

/** All of the picture's style that the reader's preferences say. */
export function applyPreferences(): void {
    const chosen = preferences.value;
    const palette = paletteOf(chosen, systemLight.value, moreContrast.value);
    document.documentElement.dataset.palette = palette;
    const { view, overlays, detail } = chosen;
    simulation.setStyle({ view, overlays, detail, palette, comma: signs().decimal === ',' });
    simulation.setUnits(chosen.si);
    simulation.setTilt(chosen.tilt);
}

export function zoom(steps: number): void {
    const area = state.value?.worlds[0].area;
    if (steps === 0)
        simulation.showAll();
    else if (area)
        simulation.zoom(catalogue.limits.zoom_step ** steps, area.x + area.width / 2, area.y + area.height / 2);
}

// Opening

/** Scenes without walls, which may be as wide and high as the screen. */
const pliable = ['pool', 'dam-break'];
/** The width of such a world on a screen that is upright, in m. */
const NARROW = 0.9;

/** On a phone that is held upright, a scene that may fills the screen. */
export function openScene(name: string): void {
    const stage = document.querySelector('.stage');
    const ratio = stage ? stage.clientHeight / stage.clientWidth : 1;
    const fills = ratio > 1 && pliable.includes(name);
    const size = { 'world.width': String(NARROW), 'world.height': (NARROW * Math.min(2, ratio)).toFixed(2) };
    simulation.open(name, fills ? size : undefined);
    showPanel(null);
}

/** A photo that is to become a scene. */
export const photo = signal<File | null>(null);

const formats = ['json', 'png', 'skv', 'skvr'] as const;

/** A file of ours is opened; another picture becomes one first. */
export async function openFile(file: File): Promise<void> {
    const ending = file.name.slice(file.name.lastIndexOf('.') + 1).toLowerCase();
    const format = formats.find((known) => known === ending);
    if (format) {
        const bytes = await file.arrayBuffer().catch(() => null);
        if (!bytes) {
            complain(_('This file cannot be read.')); // a folder, or it is not there any more
            return;
        }
        simulation.openBytes(new Uint8Array(bytes), format, file.name);
        showPanel(null);
    } else if (file.type.startsWith('image/')) {
        photo.value = file;
        showPanel('photo');
    } else {
        complain(_('This is no scene, picture, state or replay of Skvalp.'));
    }
}
