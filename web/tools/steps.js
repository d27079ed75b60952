// As `web_reference steps`: what frames cost in WebAssembly, for bench.js. For each line that comes in,
// one frame: its substeps times particles, and what these took together, in seconds: passed, and of
// processors.
//   node steps.js MODULES SCENE LAW PARTICLES THREADS
import { readSync } from 'node:fs';

import { load } from '../src/node.js';

const [modules, name, law, particles, threads] = process.argv.slice(2);
const library = await load(modules, { workers: Number(threads) - 1 });
const { c, instance } = library;
const setting = library.make('skv_setting');
setting.path = instance.allocateText('fluid.law');
setting.value = instance.allocateText(law);
const options = Object.assign(c.skv_default_scene_options(), {
    particles: Number(particles), settings: setting, setting_count: 1,
});
const scene = library.create((out, error) => c.skv_scene_load(name, options, out, error));
const def = Object.assign(c.skv_scene_world_def(scene), { threads: Number(threads), sleep: false });
const world = library.create((out, error) => c.skv_world_create(def, out, error));
library.check((error) => c.skv_scene_fill(scene, world, error));
const line = new Uint8Array(1);
while (readSync(0, line) > 0) {
    const start = performance.now(), busy = process.cpuUsage();
    c.skv_world_step(world, Math.fround(1 / 60), null);
    const passed = performance.now() - start, { user, system } = process.cpuUsage(busy);
    const work = c.skv_world_particle_count(world) * c.skv_world_substeps_per_frame(world);
    console.log(`${work} ${passed / 1e3} ${(user + system) / 1e6}`);
}
await library.end();
