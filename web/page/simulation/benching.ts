// Runs the bench in a worker of its own.
import type { BenchMessage } from './bench';
import { threadsHere } from './connect';

/** Of worlds of these sizes. What it returns ends it. Throws where there are no workers. */
export function runBench(sizes: number[], tell: (message: BenchMessage) => void): () => void {
    const worker = new Worker(new URL('./bench.worker.ts', import.meta.url), { type: 'module' });
    worker.onerror = ({ message }) => tell({ kind: 'failed', error: message ?? '' });
    worker.onmessage = ({ data }: MessageEvent<BenchMessage>) => {
        tell(data);
        if (data.kind !== 'figure') {
            worker.terminate();
        }
    };
    worker.postMessage({ sizes, threads: threadsHere() });
    return () => worker.terminate();
}
