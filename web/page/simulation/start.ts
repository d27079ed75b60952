// Starting a simulation where it is to live: in a worker, or on the page.
import { type Loading, make } from './make';
import type { Listener, Simulation } from './protocol';

/** As make. It stays the same when another module goes on (grow.ts). */
export async function start(canvas: HTMLCanvasElement | OffscreenCanvas, loading: Loading, listener: Listener) {
    const first = await loading;
    /** What was last asked of each method. */
    const asked = new Map<string, unknown[]>();
    const small = make(first, canvas, listener, async () => {
        const { grow } = await import('./grow');
        await grow(small, first, canvas, listener, asked, (larger) => (now = larger));
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
