// For tests: a simulation in node, without a picture and on one thread, whose time the test lets pass.
import { readFileSync } from 'node:fs';

import * as codecs from '../../src/codecs.js';
import { Instance } from '../../src/instance.js';
import { Library } from '../../src/library.js';

import type { Listener, Report, State } from './protocol';
import { Simulator } from './simulation';

/** Where the native programs are. */
export const native = process.env.SKV_NATIVE ?? new URL('../../../build/release', import.meta.url).pathname;

const folder = process.env.SKV_MODULES ?? new URL('../../../build/web', import.meta.url).pathname;
const load = async (folder: string) => ({
    module: await WebAssembly.compile(readFileSync(`${folder}/skvalp.wasm`)),
    description: await import(/* @vite-ignore */ `${folder}/interface.js?whole`), // no alias (tools/modules.js)
});
const { module, description } = await load(`${folder}/page`);

/** The page's larger module. */
export const loadLarger = () => WebAssembly.compile(readFileSync(`${folder}/page/bodies.wasm`));

/** A library with every public function, not those alone that the page calls. */
export async function loadWhole() {
    const { module, description } = await load(folder);
    return new Library(new Instance(module, {}), description);
}

/**
 * A library, and what it has saved. Its sessions look at the clock before and after each step.
 * @param lean the codecs come once they are wanted
 * @param of the page's first module, or its larger one
 */
export function loadLibrary(clock?: () => number, lean = false, of = module) {
    const files = new Map<string, Uint8Array>();
    const instance = new Instance(of, {
        readFile: (path: string) => files.get(path),
        writeFile: (path: string, bytes: Uint8Array) => !!files.set(path, bytes),
        clock,
        codecs: lean ? undefined : codecs,
    });
    return { library: new Library(instance, description), files };
}

/**
 * @param tick s that pass whenever the simulation looks at the clock
 * @param cost s that a frame's step takes here for each particle
 * @param grow bodies are wanted, and the module has none
 * @param hears states, too
 */
export function makeTrial({ particles = 300 as number | null, reversed = false, tick = 0, cost = 0, lean = false, of = module,
    grow = undefined as ((foresees: boolean) => void) | undefined,
    hears = undefined as Listener['state'] | undefined } = {}) {
    const states: State[] = [], reports: Report[] = [], frames: ((ms: number) => void)[] = [];
    let now = 0, waited = 0, steps = false;
    const { library, files } = loadLibrary(() => {
        steps = !steps;
        now += steps ? 0 : cost * states.at(-1)!.worlds[0].particles;
        return now;
    }, lean, of);
    const { c } = library, step = c.skv_world_step;
    // How a world that has no session is stepped: the one that is measured by.
    c.skv_world_step = (world, ...given) => {
        now += cost * c.skv_world_particle_count(world);
        return step(world, ...given);
    };
    const listener: Listener = {
        state: (state) => {
            states.push(structuredClone(state));
            hears?.(state);
        },
        report: (report) => reports.push(report),
        picture: () => undefined,
    };
    const simulation = new Simulator({
        library, files, threads: 1, painter: null, particles, reversed, listener, grow,
        nextFrame: (callback) => frames.push(callback),
        clock: () => now + (waited += tick),
    });
    return {
        simulation, library, files, listener,
        /** Reports since they were taken. */
        take: () => reports.splice(0),
        si: false,
        /** What a call tells that changes nothing, a second later. */
        get state() {
            waited += 1;
            simulation.setUnits(this.si);
            return states.at(-1)!;
        },
        /** Whether a frame is wanted. */
        get wants() {
            return frames.length > 0;
        },
        /** s since it began. */
        get now() {
            return now;
        },
        /** Lets so many pictures of a display of 60 Hz pass, the next after what is done, if any is wanted. */
        run(count: number) {
            for (let i = 0; i < count; i++) {
                now = (Math.floor(60 * now + 1e-6) + 1) / 60;
                frames.splice(0).forEach((frame) => frame(1000 * now));
            }
        },
    };
}
