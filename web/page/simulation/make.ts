// Making a simulation of a module and a canvas, in a worker or on the page.
import { load } from '../../src/browser.js';

import { Painter } from './painter';
import { parts } from './parts';
import type { Listener } from './protocol';
import { Simulator } from './simulation';

/**
 * What takes longest, and can be begun before there is a canvas.
 * @param threads to step each world on, where they can be had
 * @param name of the module: a first one, or 'bodies', which has these, too
 */
export async function loadModule(threads: number, name = 'skvalp') {
    const files = new Map<string, Uint8Array>();
    // Two worlds that are compared have a pool each.
    const library = await load(parts, { workers: 2 * (threads - 1), files, lean: true, name });
    return { library, files, threads: library.workers > 0 ? threads : 1 };
}
export type Loading = ReturnType<typeof loadModule>;

/**
 * @param canvas to draw on, from now on and alone
 * @param grow what is to be opened has bodies, and the module has none
 */
export function make({ library, files, threads }: Awaited<Loading>, canvas: HTMLCanvasElement | OffscreenCanvas,
    listener: Listener, grow?: () => void) {
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
        grow,
    });
    return simulation;
}
