// The bench: what a particle and substep costs on this device.
//
// Invariant: what is measured is a world that moves, after its first frames: engines compile in those.
import type { Library } from '../../src/library.js';
import { withOptions } from '../../src/memory.js';

export interface Case {
    scene: string;
    law: string;
    particles: number;
    threads: number;
}

/** Nanoseconds that pass for a particle and substep: in the shortest frame, and in half of all. */
export interface Figure extends Case {
    frames: number;
    least: number;
    median: number;
}

export type BenchMessage =
    | { kind: 'figure'; figure: Figure; share: number }
    | { kind: 'done' }
    | { kind: 'failed'; error: string };

const warm = 10, mostFrames = 40, leastFrames = 5, longest = 1.5;

/** Of a world that does not sleep. Throws if it cannot be made. */
export function measureCase(library: Library, wanted: Case, clock: () => number): Figure {
    const { c } = library;
    const settings = {
        particles: String(wanted.particles), 'fluid.law': wanted.law, settle: 'false', sleep: 'false',
    };
    const scene = withOptions(library, settings, (options) =>
        library.create((out, error) => c.skv_scene_load(wanted.scene, options, out, error)));
    const world = library.create((out, error) => c.skv_scene_create_world(scene, wanted.threads, out, error));
    const particles = c.skv_world_particle_count(world);
    const times: number[] = [];
    for (let i = 0, begun = 0; i < warm + mostFrames; i++) {
        const before = clock();
        begun = i === warm ? before : begun;
        library.check((error) => c.skv_world_step(world, Math.fround(1 / 60), error));
        const now = clock(), work = particles * c.skv_world_substeps_per_frame(world);
        if (i >= warm) {
            times.push((1e9 * (now - before)) / work);
        }
        if (times.length >= leastFrames && now - begun > longest) {
            break;
        }
    }
    c.skv_world_destroy(world);
    c.skv_scene_destroy(scene);
    times.sort((a, b) => a - b);
    return { ...wanted, particles, frames: times.length, least: times[0], median: times[times.length >> 1] };
}

/** All cases, on one thread and on all. */
export function casesOf(sizes: number[], threads: number): Case[] {
    const cases: Case[] = [];
    for (const particles of sizes)
        for (const scene of ['dam-break', 'pool'])
            for (const law of ['calibrated', 'clavet'])
                for (const count of new Set([1, threads]))
                    cases.push({ scene, law, particles, threads: count });
    return cases;
}
