// How many particles a scene begins with here, where neither it, a link nor a person says: measured
// on a world that nobody sees, and never changed in a scene that runs.
import type { Library } from '../../src/library.js';
import { withOptions } from '../../src/memory.js';

/** What a frame may cost, s: half of a display's period. */
const budget = 0.008;
const choices = [5000, 4000, 3000, 2000, 1500, 1000, 500];
/** For which the built-in scenes were made; those that say another number keep their share of it. */
const standard = 3000;

const measured = 2000;
/** The module's code is cold at first: the fastest frame tells, once it has not become faster. */
const leastFrames = 6, unchangedFrames = 4, longest = 0.25;

/** The largest number that keeps the budget. */
export function largestWithin(secondsPerParticle: number) {
    return choices.find((count) => count * secondsPerParticle <= budget) ?? choices.at(-1)!;
}

/** What a frame of a world costs for each of its particles, s. */
function measure(library: Library, threads: number, clock: () => number) {
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
    c.skv_world_destroy(world);
    c.skv_scene_destroy(scene);
    return best / count;
}

export function chooseAmount(library: Library, threads: number, clock: () => number) {
    return largestWithin(measure(library, threads, clock));
}

/** The particles of a built-in scene if 3000 of it are so many; null if there is no such scene. */
export function amountOf(library: Library, name: string, chosen: number) {
    const { c } = library;
    for (let i = 0, address; (address = c.skv_builtin_scene(i)) !== 0; i++) {
        if (library.view('skv_scene_info', address).name === name) {
            const scene = library.create((out, error) => c.skv_scene_load(name, null, out, error));
            const own = c.skv_scene_particles(scene);
            c.skv_scene_destroy(scene);
            return Math.round((own * chosen) / standard);
        }
    }
    return null;
}
