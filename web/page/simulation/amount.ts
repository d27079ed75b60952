// How many particles a scene begins with here, where neither it, a link nor a person says: measured
// on a world that nobody sees, stepped and drawn, and never changed in a scene that runs.
import type { Library } from '../../src/library.js';
import type { skv_frame } from '../../src/interface.js';
import { using, withOptions } from '../../src/memory.js';

/** s: half of a display's period is for stepping, three quarters are for that and drawing. */
const forStepping = 0.008, forBoth = 0.0125;

const measured = 2000;
/** The module's code is cold at first: the fastest frame tells, once it has not become faster. */
const leastFrames = 6, unchangedFrames = 4, longest = 0.25;

/** Few and far apart: a device that is measured twice gets the same one. */
export function amountsOf({ c }: Library) {
    const all: number[] = [];
    for (let amount; (amount = c.skv_amount_at(all.length)) > 0;) {
        all.push(amount);
    }
    return all;
}

/** The largest of them that a frame has time for. */
export function largestWithin(amounts: number[], secondsPerParticle: number, drawing = 0) {
    const budget = Math.min(forStepping, forBoth - drawing);
    return amounts.findLast((count) => count * secondsPerParticle <= budget) ?? amounts[0];
}

/**
 * As many as a frame has time for.
 * @param draw what it takes to draw a world, s
 */
export function chooseAmount(library: Library, threads: number, clock: () => number, draw: (frame: skv_frame) => number) {
    const { c } = library;
    const settings = { particles: String(measured), settle: 'false' }; // which would take longer
    const scene = withOptions(library, settings, (options) =>
        library.create((out, error) => c.skv_scene_load('dam-break', options, out, error)));
    const world = library.create((out, error) => c.skv_scene_create_world(scene, threads, out, error));
    const frame = Math.fround(1 / 60), begun = clock();
    let best = Infinity;
    for (let i = 0, unchanged = 0, before = begun; ; i++) {
        library.check((error) => c.skv_world_step(world, frame, error));
        const now = clock(), taken = now - before;
        unchanged = taken < 0.95 * best ? 0 : unchanged + 1;
        best = Math.min(best, taken);
        before = now;
        if ((i >= leastFrames && unchanged >= unchangedFrames) || now - begun > longest) {
            break;
        }
    }
    const count = c.skv_world_particle_count(world);
    const drawing = using(library, c.skv_world_frame(world), draw);
    c.skv_world_destroy(world);
    c.skv_scene_destroy(scene);
    return largestWithin(amountsOf(library), best / count, drawing);
}
