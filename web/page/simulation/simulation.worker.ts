// The worker in which a simulation lives: it owns the module, the worlds, the renderer and the canvas,
// and may block.
//
// Invariant: calls are carried out in the order in which they came, also those that came before the
// simulation was there.
import type { Simulation } from './protocol';
import type { FromWorker, ToWorker } from './messages';
import { loadModule, start } from './start';

const tell = (message: FromWorker) => postMessage(message);
const words = (error: unknown) => (error instanceof Error ? error.message : String(error));

let loading: ReturnType<typeof loadModule>;

function begin(canvas: OffscreenCanvas) {
    return start(canvas, loading, {
        state: (state) => tell({ kind: 'state', state }),
        report: (report) => tell({ kind: 'report', report }),
        picture: (trouble) => tell({ kind: 'picture', trouble }),
    });
}

let simulation: Promise<Simulation>;

async function carryOut({ name, given, id }: Extract<ToWorker, { kind: 'call' }>) {
    const target = (await simulation) as unknown as Record<string, (...given: unknown[]) => unknown>;
    try {
        const value = await target[name](...given);
        if (id !== null) {
            tell({ kind: 'answer', id, value });
        }
    } catch (error) {
        if (id === null) {
            reportError(error); // nobody waits for it: it is the worker's own
        } else {
            tell({ kind: 'answer', id, error: words(error) });
        }
    }
}

onmessage = ({ data }: MessageEvent<ToWorker>) => {
    if (data.kind === 'call') {
        void carryOut(data);
        return;
    }
    if (data.kind === 'load') {
        loading = loadModule(data.threads);
        loading.catch(() => undefined); // it is told to whoever begins
        return;
    }
    simulation = begin(data.canvas);
    simulation.then(() => tell({ kind: 'ready' }),
        (error: unknown) => tell({ kind: 'failed', error: words(error) }));
};
tell({ kind: 'hello' });
