// Labs: experiments as they run. Invariant: one runs at most; what was measured and predicted stays
// until it is measured anew, also while other panels are open.
import { signal } from '@preact/signals';
import { runExperiment } from '../simulation/lab';
import type { LabMessage } from '../simulation/protocol';
import { beginErrand } from './errands';

export interface Run {
    running: boolean;
    share: number;
    latest: LabMessage | null;
}

export const runs = signal<Record<number, Run>>({});
export const predictions = signal<Record<number, string>>({});

let stop: (() => void) | null = null;
let current = -1;

function change(index: number, changes: Partial<Run>): void {
    const before = runs.value[index] ?? { running: false, share: 0, latest: null };
    runs.value = { ...runs.value, [index]: { ...before, ...changes } };
}

export function stopExperiment(): void {
    stop?.();
    stop = null;
    if (current >= 0)
        change(current, { running: false });
}

export function startExperiment(index: number): void {
    stopExperiment();
    current = index;
    change(index, { running: true, share: 0, latest: null });
    const hear = (message: LabMessage) => {
        const ended = message.kind !== 'moment';
        change(index, { running: !ended, share: ended ? 1 : message.share, latest: message });
        if (ended)
            stop = null;
    };
    stop = beginErrand(() => runExperiment(index, {}, hear), (error) => hear({ kind: 'failed', error }));
}
