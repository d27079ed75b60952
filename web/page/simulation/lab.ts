// Runs an experiment in a worker of its own, or counts its particles there. Throws where there are no workers.
import type { LabMessage, RunExperiment } from './protocol';

const begin = (counts: boolean): RunExperiment => (index, particles, tell) => {
    const worker = new Worker(new URL('./lab.worker.ts', import.meta.url), { type: 'module' });
    worker.onerror = ({ message }) => tell({ kind: 'failed', error: message ?? '' });
    worker.onmessage = ({ data }: MessageEvent<LabMessage>) => {
        tell(data);
        if (data.kind !== 'moment') {
            worker.terminate();
        }
    };
    worker.postMessage({ index, particles, counts });
    return () => worker.terminate();
};
export const runExperiment = begin(false);
/** Of one that comes with the larger module. */
export const countParticles = begin(true);
