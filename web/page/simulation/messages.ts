// What connect.ts and simulation.worker.ts say to each other.
import type { Report, State, Trouble } from './protocol';

export type ToWorker =
    /** Comes first, before the script is there: the module takes longest. */
    | { kind: 'load'; threads: number }
    | { kind: 'begin'; canvas: OffscreenCanvas }
    /** A method of the simulation; with a number if its answer is wanted. */
    | { kind: 'call'; name: string; given: unknown[]; id: number | null };

export type FromWorker =
    /** The script has been loaded, and waits for the canvas. */
    | { kind: 'hello' }
    | { kind: 'ready' }
    | { kind: 'failed'; error: string }
    | { kind: 'state'; state: State }
    | { kind: 'report'; report: Report }
    | { kind: 'picture'; trouble: Trouble }
    | { kind: 'answer'; id: number; value?: unknown; error?: string };
