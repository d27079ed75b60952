// Connecting the page with its simulation: in a worker, or on the page where workers cannot draw.
//
// Invariant: the canvas is given away only to a worker that has said that it is there.
import type { FromWorker, ToWorker } from './messages';
import type { Connect, Listener, Simulation } from './protocol';

const mostThreads = 4;

/** The methods that answer; all others only leave a message. */
const answering = new Set(['save', 'keep', 'share', 'catalogue', 'experimentParticles']);

/** One is left to the page. */
export function threadsHere() {
    return Math.min(Math.max((navigator.hardwareConcurrency || 1) - 1, 1), mostThreads);
}

function takesModules() {
    let asked = false;
    const options = {
        get type(): WorkerType {
            asked = true;
            return 'module';
        },
    };
    try {
        new Worker('data:text/javascript,', options).terminate();
    } catch {
        return false;
    }
    return asked;
}

function canDrawInWorkers(canvas: HTMLCanvasElement) {
    return 'transferControlToOffscreen' in canvas && typeof OffscreenCanvas === 'function'
        && new OffscreenCanvas(1, 1).getContext('webgl2') !== null && takesModules();
}

/** A worker that is there; null if its script cannot be had. */
function hire() {
    const worker = new Worker(new URL('./simulation.worker.ts', import.meta.url), { type: 'module' });
    const first: ToWorker = { kind: 'load', threads: threadsHere() };
    worker.postMessage(first);
    return new Promise<Worker | null>((resolve) => {
        worker.onerror = () => resolve(null);
        worker.onmessage = () => resolve(worker);
    });
}

function connectWorker(worker: Worker, canvas: HTMLCanvasElement, listener: Listener) {
    const waiting = new Map<number, { resolve: (value: any) => void; reject: (error: Error) => void }>();
    let last = 0;
    const post = (message: ToWorker, transfer: Transferable[] = []) => worker.postMessage(message, transfer);
    const call = (name: string) => (...given: unknown[]) => {
        if (!answering.has(name)) {
            post({ kind: 'call', name, given, id: null });
            return undefined;
        }
        const id = ++last;
        post({ kind: 'call', name, given, id });
        return new Promise((resolve, reject) => waiting.set(id, { resolve, reject }));
    };
    // Whoever awaits it must not take it for a promise.
    const simulation = new Proxy({}, {
        get: (_, name) => (name === 'then' ? undefined : call(String(name))),
    }) as Simulation;

    return new Promise<Simulation>((resolve, reject) => {
        worker.onerror = ({ message }) => {
            reject(new Error(message));
            const error = `${message}: the simulation has stopped; load the page again`;
            listener.report({ kind: 'step', error });
        };
        worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
            switch (data.kind) {
                case 'ready':
                    resolve(simulation);
                    break;
                case 'failed':
                    reject(new Error(data.error));
                    break;
                case 'state':
                    listener.state(data.state);
                    break;
                case 'report':
                    listener.report(data.report);
                    break;
                case 'picture':
                    listener.picture(data.trouble);
                    break;
                case 'answer': {
                    const asker = waiting.get(data.id);
                    waiting.delete(data.id);
                    if (data.error === undefined) {
                        asker?.resolve(data.value);
                    } else {
                        asker?.reject(new Error(data.error));
                    }
                }
            }
        };
        const offscreen = canvas.transferControlToOffscreen();
        post({ kind: 'begin', canvas: offscreen }, [offscreen]);
    });
}

export const connect: Connect = async (canvas, listener) => {
    const worker = canDrawInWorkers(canvas) ? await hire() : null;
    if (worker) {
        return connectWorker(worker, canvas, listener);
    }
    const { loadModule, start } = await import('./start');
    return start(canvas, loadModule(threadsHere()), listener);
};
