// The worker in which the bench runs; whoever has had enough of it ends the worker.
import { load } from '../../src/browser.js';

import { casesOf, measureCase, type BenchMessage } from './bench';
import { parts } from './parts';

onmessage = async ({ data }: MessageEvent<{ sizes: number[]; threads: number }>) => {
    const tell = (message: BenchMessage) => postMessage(message);
    try {
        const library = await load(parts, { workers: data.threads - 1 });
        const cases = casesOf(data.sizes, library.workers + 1);
        cases.forEach((wanted, i) => tell({
            kind: 'figure', share: (i + 1) / cases.length,
            figure: measureCase(library, wanted, () => performance.now() / 1000),
        }));
        tell({ kind: 'done' });
    } catch (error) {
        tell({ kind: 'failed', error: error instanceof Error ? error.message : String(error) });
    }
};
