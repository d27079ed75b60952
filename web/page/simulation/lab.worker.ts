// The worker in which an experiment runs; whoever has had enough of it ends the worker.
import { load } from '../../src/browser.js';
import type { Library } from '../../src/library.js';

import { runExperiment } from './experiment';
import { parts } from './parts';
import type { LabMessage } from './protocol';

onmessage = async ({ data }: MessageEvent<{ index: number; particles: number; counts: boolean }>) => {
    const tell = (message: LabMessage) => postMessage(message);
    try {
        const more = () => load(parts, { lean: true, name: 'bodies' });
        if (data.counts) {
            tell({ kind: 'counted', particles: (await more()).c.skv_experiment_particles(data.index, data.particles) });
            return;
        }
        const run = (library: Library) => runExperiment(library, data.index, data.particles, tell, () => performance.now() / 1000);
        const library = await load(parts, { lean: true });
        try {
            run(library);
        } catch (error) {
            if (!library.instance.exports.skv_wasm_wants_more?.()) {
                throw error;
            }
            run(await more());
        }
    } catch (error) {
        tell({ kind: 'failed', error: error instanceof Error ? error.message : String(error) });
    }
};
