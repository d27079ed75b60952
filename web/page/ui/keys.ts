// Keys: the app's keys on the page. Invariant: what has the focus and needs a key gets it: texts and
// choices all of them, buttons Space and Return, sliders the arrows; a reader can switch off those
// that are pressed without Ctrl.
import { effect } from '@preact/signals';
import {
    nextView, step, toggleKeyboardHand, toggleOverlay,
    togglePause, zoom,
} from './actions';
import { catalogue, compared, dismiss, keyboardHand, message, panel, showPanel, simulation } from './model';
import { FRAMES, ready, togglePanel } from './model';
import { preferences } from './preferences';
import { saveFile } from './files';
import { toggleFullscreen } from './device';

/** What a key does: the actions of the library's table that the page has. */
export const actions: Record<string, ((argument: string) => void) | null> = {
    pause: togglePause,
    step,
    go: (frames) => simulation.seekBy(Number(frames)),
    reset: () => simulation.reset(),
    'change-speed': (direction) => simulation.shiftSpeed(Number(direction)),
    undo: () => simulation.undo(),
    redo: () => simulation.redo(),
    stopwatch: (lap) => simulation.pressStopwatch(lap === 'true'),
    'next-fluid': () => simulation.nextFluid(),
    brush: (factor) => simulation.scaleBrush(Number(factor)),
    measure: (kind) => simulation.addGauge(Number(kind)),
    'keyboard-hand': toggleKeyboardHand,
    weightless: () => simulation.setGravity(0, 0),
    'next-view': nextView,
    'overlay-tracers': () => toggleOverlay('tracers'),
    zoom: (steps) => zoom(Number(steps)),
    fullscreen: toggleFullscreen,
    gallery: () => togglePanel('scenes'),
    properties: () => togglePanel('properties'),
    open: () => showPanel('scenes'),
    save: () => void saveFile('skvr'),
    screenshot: () => void saveFile('png'),
    'toggle-compare': () => (compared.value ? simulation.compare(null) : showPanel('compare')),
    share: () => void import('./sharing').then(({ shareLink }) => shareLink()),
    paste: null, // the browser does it: onPaste
    dismiss: leave,
    'show-help-overlay': () => togglePanel('keys'),
};

const arrows: Record<string, [number, number]> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
};
const held = new Set<string>();
/** The keyboard's hand: it opens when it is put away. */
let closed = false;
effect(() => {
    if (!keyboardHand.value)
        closed = false;
});

/** As the library's table names it: "Space", "Ctrl+Shift+z". */
function nameOf({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): string {
    const letter = /^[a-z]$/i.test(key);
    const name = letter ? key.toLowerCase() : key === ' ' ? 'Space' : key;
    return `${ctrlKey || metaKey ? 'Ctrl+' : ''}${letter && shiftKey ? 'Shift+' : ''}${name}`;
}

/** Does what a key is for. */
function act(event: KeyboardEvent): void {
    const name = nameOf(event);
    const known = catalogue.keys.find(({ key, action }) => key === name && action && actions[action]);
    if (!known)
        return;
    event.preventDefault();
    if (!event.repeat || known.repeats)
        actions[known.action]!(known.argument);
}

/** The hand moves while arrows are held; gravity points where they point, and stays there. */
function applyArrows(): void {
    let x = 0;
    let y = 0;
    for (const key of held) {
        x += arrows[key][0];
        y += arrows[key][1];
    }
    const length = Math.hypot(x, y);
    if (keyboardHand.value)
        simulation.keyboard(x, y, closed);
    else if (length > 0)
        simulation.setGravity(x / length, y / length);
}

/** Esc leaves what was entered last: a message, a panel, the keyboard's hand. */
function leave(): void {
    if (message.value)
        dismiss();
    else if (panel.value)
        showPanel(null);
    else if (keyboardHand.value)
        toggleKeyboardHand();
}

/** Whether what has the focus takes this key for itself. */
function isTaken(event: KeyboardEvent): boolean {
    const focus = event.target as HTMLElement;
    if (focus.closest('input:not([type=range], [type=checkbox], [type=radio]), textarea, select'))
        return true;
    if (focus.closest('button, summary, a') && (event.key === ' ' || event.key === 'Enter'))
        return true;
    if (focus.closest('input') && event.key === ' ')
        return true;
    return event.key in arrows && focus.closest('input, [data-arrows]') !== null;
}

function onArrow(event: KeyboardEvent): void {
    event.preventDefault();
    if (event.shiftKey && arrows[event.key][0]) {
        simulation.seekBy(arrows[event.key][0] * FRAMES);
        return;
    }
    held.add(event.key);
    applyArrows();
}

function onPlain(event: KeyboardEvent): void {
    if (keyboardHand.value && event.key === 'Enter') {
        closed = !closed;
        applyArrows();
        return;
    }
    if (event.key in arrows) {
        onArrow(event);
        return;
    }
    const tool = catalogue.tools.findIndex((known) => known.key === event.key);
    if (tool >= 0 && !event.repeat)
        simulation.chooseTool(tool);
    act(event);
}

function onDown(event: KeyboardEvent): void {
    if (!ready.value || document.querySelector('dialog:modal'))
        return;
    if (event.key === 'Escape') {
        leave();
        return;
    }
    if (isTaken(event) || event.altKey)
        return;
    if (event.ctrlKey || event.metaKey) {
        act(event);
        return;
    }
    if (preferences.value.keys || event.key in arrows)
        onPlain(event);
}

function onUp(event: KeyboardEvent): void {
    if (held.delete(event.key))
        applyArrows();
}

export function attachKeys(): void {
    window.addEventListener('keydown', onDown);
    window.addEventListener('keyup', onUp);
    window.addEventListener('blur', () => {
        held.clear();
        if (ready.value && keyboardHand.value)
            applyArrows();
    });
    window.addEventListener('paste', (event) => {
        const text = event.clipboardData?.getData('text') ?? '';
        if (ready.value && !(event.target as HTMLElement).closest?.('input, textarea') && text)
            void import('./links').then((module) => module.openLinkText(text));
    });
}
