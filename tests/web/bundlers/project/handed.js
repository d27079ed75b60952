// A project as esbuild builds it, whose loader gives addresses of files: the page hands them in.
import { open } from 'skvalp';
import wasm from 'skvalp/lib/skvalp.wasm';

import { play } from './play.js';

window.seen = { page: play(await open({ parts: { module: () => fetch(wasm) } })) };
