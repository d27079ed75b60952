// A project as vite and webpack build it: on the page and in a worker.
import { open } from 'skvalp';

import { play } from './play.js';

const worker = new Worker(new URL('./compute.js', import.meta.url), { type: 'module' });
const answer = new Promise((resolve, reject) => {
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = ({ message }) => reject(new Error(message));
});
const page = play(await open());
window.seen = { page, worker: await answer };
