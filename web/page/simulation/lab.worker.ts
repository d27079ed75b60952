// The worker in which an experiment runs; whoever has had enough of it ends the worker.
import { load } from '../../src/browser.js';

import { runExperiment } from './experiment';
import { parts } from './parts';
import type { LabMessage } from './protocol';

onmessage = async ({ data }: MessageEvent<{ index: number; particles: number }>) => {
    const tell = (message: LabMessage) => postMessage(message);
    try {
        const library = await load(parts, { lean: true });
        runExperiment(library, data.index, data.particles, tell, () => performance.now() / 1000);
    } catch (error) {
        tell({ kind: 'failed', error: error instanceof Error ? error.message : String(error) });
    }
};
