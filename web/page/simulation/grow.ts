// Growing: what could not be opened for want of bodies goes on in a larger module, on the same canvas.
//
// Invariant: what is open goes on until the larger module is there; if that fails, it is reported.
import { type Loading, loadModule, make } from './make';
import type { Listener, State } from './protocol';
import type { Simulator } from './simulation';

/** What nothing but the face knows. */
const known = ['setView', 'setUnits', 'setTilt', 'setHidden'];
let loading: Loading | undefined;

/**
 * @param from which could not open it
 * @param asked what was last asked of its methods
 * @param take the larger one from now on
 */
export async function grow(from: Simulator, { library, threads }: Awaited<Loading>,
    canvas: HTMLCanvasElement | OffscreenCanvas, listener: Listener, asked: Map<string, unknown[]>,
    take: (larger: Simulator) => void) {
    const { state: tell, report } = listener;
    loading ??= loadModule(threads, 'bodies');
    try {
        const larger = await loading;
        if (library.instance.hasCodecs) {
            await larger.library.instance.bringCodecs();
        }
        if (!from.waits) { // something else was opened meanwhile
            return;
        }
        let quiet = true;
        const { state: last, opened } = from.giveWay();
        const simulation = make(larger, canvas, {
            ...listener,
            state: (state: State) => {
                state.worlds.forEach((world) => (world.opened += opened));
                if (!quiet) {
                    tell(state);
                }
            },
        });
        take(simulation);
        known.filter((name) => asked.has(name)).forEach((name) => (simulation as any)[name](...asked.get(name)!));
        simulation.setStyle(last.style);
        simulation.setParticles(last.chosen ?? 0);
        simulation.setTool(last.tool);
        simulation.setDye(last.dye);
        simulation.setLinked(last.linked);
        simulation.setSpeed(last.speed);
        simulation.setPaused(last.paused);
        quiet = false;
        simulation.goOn(from);
        void library.end();
    } catch (error) {
        loading = undefined;
        report({ kind: 'open', error: (error as Error).message });
    }
}
