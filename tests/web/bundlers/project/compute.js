// The project's worker, which may have threads.
import { open } from 'skvalp';

import { play } from './play.js';

open({ threads: 2 }).then((skvalp) => postMessage({ hash: play(skvalp), workers: skvalp.library.workers }));
