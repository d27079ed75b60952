// Labs: experiments as they run. Invariant: one runs at most; what was measured and predicted stays
// until it is measured anew, also while other panels are open. The water beside it waits meanwhile, and goes on then.
import { signal } from '@preact/signals';
import { runExperiment } from '../simulation/lab';
import type { LabMessage } from '../simulation/protocol';
import { beginErrand } from './errands';
import { measuring, paused, simulation } from './model';
import { preferences } from './preferences';

export interface Run {
    running: boolean;
    share: number;
    latest: LabMessage | null;
}

export const runs = signal<Record<number, Run>>({});
export const predictions = signal<Record<number, string>>({});

let stop: (() => void) | null = null;
let current = -1;
/** Whether the water beside it goes on afterwards. */
let resumes = false;

function change(index: number, changes: Partial<Run>): void {
    const before = runs.value[index] ?? { running: false, share: 0, latest: null };
    runs.value = { ...runs.value, [index]: { ...before, ...changes } };
}

/** It is over, one way or another. */
function end(): void {
    stop = null;
    if (measuring.value && resumes)
        simulation.setPaused(false);
    measuring.value = null;
}

export function stopExperiment(): void {
    stop?.();
    if (current >= 0)
        change(current, { running: false });
    end();
}

export function startExperiment(index: number): void {
    resumes = measuring.value ? resumes : !paused.value;
    stop?.();
    if (current >= 0)
        change(current, { running: false });
    simulation.setPaused(true);
    measuring.value = { index, share: 0 };
    current = index;
    change(index, { running: true, share: 0, latest: null });
    const hear = (message: LabMessage) => {
        const ended = message.kind !== 'moment';
        change(index, { running: !ended, share: ended ? 1 : message.share, latest: message });
        if (ended)
            end();
        else
            measuring.value = { index, share: message.share };
    };
    const { particles } = preferences.value;
    stop = beginErrand(() => runExperiment(index, particles, hear), (error) => hear({ kind: 'failed', error }));
}
