// Starting a simulation where it is to live: in a worker, or on the page.
import { load } from '../../src/browser.js';

import { Painter } from './painter';
import { parts } from './parts';
import type { Listener } from './protocol';
import { Simulator } from './simulation';

/**
 * What takes longest, and can be begun before there is a canvas.
 * @param threads to step each world on, where they can be had
 */
export async function loadModule(threads: number) {
    const files = new Map<string, Uint8Array>();
    // Two worlds that are compared have a pool each.
    const library = await load(parts, { workers: 2 * (threads - 1), files, lean: true });
    return { library, files, threads: library.workers > 0 ? threads : 1 };
}

/** @param canvas to draw on, from now on and alone */
export async function start(canvas: HTMLCanvasElement | OffscreenCanvas,
    loading: ReturnType<typeof loadModule>, listener: Listener) {
    const { library, files, threads } = await loading;
    let simulation: Simulator | null = null;
    const painter = new Painter(library, canvas, (trouble) => {
        listener.picture(trouble);
        simulation?.setStyle({}); // nothing else, but it is drawn
    });
    simulation = new Simulator({
        library,
        threads,
        files,
        listener,
        painter,
        nextFrame: (callback) => requestAnimationFrame(callback),
        clock: () => performance.now() / 1000,
        particles: null,
        reversed: /^(Mac|iP)/.test(navigator.platform),
    });
    return simulation;
}
