// Runs an experiment in a worker of its own. Throws where there are no workers.
import type { LabMessage, RunExperiment } from './protocol';

export const runExperiment: RunExperiment = (index, particles, tell) => {
    const worker = new Worker(new URL('./lab.worker.ts', import.meta.url), { type: 'module' });
    worker.onerror = ({ message }) => tell({ kind: 'failed', error: message ?? '' });
    worker.onmessage = ({ data }: MessageEvent<LabMessage>) => {
        tell(data);
        if (data.kind !== 'moment') {
            worker.terminate();
        }
    };
    worker.postMessage({ index, particles });
    return () => worker.terminate();
};
