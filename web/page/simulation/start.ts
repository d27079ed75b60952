// Starting a simulation where it is to live: in a worker, or on the page.
import { load } from '../../src/browser.js';

import { Painter } from './painter';
import { parts } from './parts';
import type { Listener, Simulation } from './protocol';
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
type Loading = ReturnType<typeof loadModule>;

/**
 * @param canvas to draw on, from now on and alone
 * @param grow bodies are wanted, and the module has none
 */
function make({ library, files, threads }: Awaited<Loading>, canvas: HTMLCanvasElement | OffscreenCanvas,
    listener: Listener, grow?: (foresees: boolean) => void) {
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

/** As make. It stays the same when another module goes on (grow.ts). */
export async function start(canvas: HTMLCanvasElement | OffscreenCanvas, loading: Loading, listener: Listener) {
    const first = await loading;
    /** What was last asked of each method. */
    const asked = new Map<string, unknown[]>();
    const small = make(first, canvas, listener, async (foresees) => {
        const { grow } = await import('./grow');
        await grow(small, first, listener, asked, foresees, () => loadModule(first.threads, 'bodies'),
            (larger, its) => (now = make(larger, canvas, its)));
    });
    let now = small;
    // Whoever awaits it must not take it for a promise.
    return new Proxy({}, {
        get: (_, name: string) => (name === 'then' ? undefined : (...values: unknown[]) => {
            asked.set(name, values);
            return (now as any)[name](...values);
        }),
    }) as Simulation;
}
