// Does in node what reference.c, bits_hashes and `skvalp replay` do natively, and prints the same lines.
// Arguments: the folder of the modules, threads, what to do, and its arguments.
import { readFileSync } from 'node:fs';

import { load } from '../../web/src/node.js';
import { makeJobs } from './jobs.js';

const [folder, threads, job, ...rest] = process.argv.slice(2);
const count = Number(threads);
// Experiments have two worlds at once.
const library = await load(folder, {
    workers: (count - 1) * (job === 'lab' ? 2 : 1), name: job === 'bits' ? 'bits' : 'skvalp',
});
makeJobs(library, count, { print: console.log, read: readFileSync })[job](...rest);
await library.end();
