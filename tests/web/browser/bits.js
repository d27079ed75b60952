// Runs jobs of jobs.js in Chromium: isolated with memory that 1, 2 and 3 threads share, on a page that is
// not isolated; the first of them also where something cannot be had, and on the page itself.
// Arguments: the folders of the bundle and the modules, where each run's lines go (one file a run, named
// JOB.WHERE), and the jobs, each with its arguments in one word; files that they name go along.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';

import { run } from './harness.js';

const [bundle, modules, output, ...jobs] = process.argv.slice(2);

/** Where a job is done, and how many workers there have to be in a pool. */
const places = [
    { name: '1', isolated: true, threads: 1, pool: 0 },
    { name: '2', isolated: true, threads: 2, pool: 1 },
    { name: '3', isolated: true, threads: 3, pool: 2 },
    { name: 'plain', isolated: false, threads: 2, pool: 0 },
];
const hardships = [
    { name: 'on-page', isolated: true, threads: 2, pool: 0, onPage: true },
    { name: 'no-workers', isolated: true, threads: 2, pool: 0, without: 'workers' },
    { name: 'no-memory', isolated: true, threads: 2, pool: 0, without: 'memory' },
    { name: 'small-memory', isolated: true, threads: 2, pool: 1, without: 'large memory' },
];

/** In the page: a worker does it, or the page. */
async function work({ onPage, files: list, ...given }) {
    const task = { ...given, files: new Map(list.map(([name, bytes]) => [name, Uint8Array.from(bytes)])) };
    if (onPage) {
        await import('/probe.js');
        return window.perform(task);
    }
    return new Promise((resolve, reject) => {
        const worker = new Worker('/probe.js', { type: 'module' });
        worker.onerror = (event) => reject(new Error(event.message ?? 'the worker did not load'));
        worker.onmessage = ({ data }) => {
            worker.terminate();
            resolve(data);
        };
        worker.postMessage(task);
    });
}

await run([bundle, modules], async (browser) => {
    const plainPage = await browser.open('/empty.html');
    const isolatedPage = await browser.open('/empty.html', { isolated: true });
    for (const [i, words] of jobs.entries()) {
        const [job, ...rest] = words.split(' ');
        const files = rest.filter((word) => existsSync(word)).map((file) => [file, [...readFileSync(file)]]);
        for (const { name, isolated, pool, ...how } of i === 0 ? [...places, ...hardships] : places) {
            const page = isolated ? isolatedPage : plainPage;
            const { lines, workers, error } = await page.evaluate(work, { job, rest, files, ...how });
            if (error) {
                throw new Error(`${words}, ${name}: ${error}`);
            }
            if (workers !== pool * (job === 'lab' ? 2 : 1)) {
                throw new Error(`${words}, ${name}: ${workers} workers compute`);
            }
            writeFileSync(`${output}/${job}.${name}`, lines.map((line) => `${line}\n`).join(''));
            browser.takeTroubles().filter((trouble) => !/missing\.js/.test(trouble)).forEach((trouble) => {
                throw new Error(`${words}, ${name}: ${trouble}`);
            });
        }
    }
});
