// Two worlds side by side.
import { expect, test } from 'vitest';

import type { skv_pointer_event } from '../../src/interface.js';
import { makeTrial } from './testing';

/** A dam break, and the same of honey beside it. */
async function compare() {
    const trial = makeTrial();
    trial.simulation.setView(640, 360, 1);
    trial.simulation.open('dam-break');
    trial.run(5);
    trial.simulation.compare({ 'fluid.material': 'honey' });
    await Promise.resolve();
    await Promise.resolve();
    trial.run(20);
    return trial;
}

test('both are at one moment, and share time, fingers and instruments', async () => {
    const trial = await compare();
    const { simulation } = trial;
    expect(trial.take().every(({ error }) => error === null)).toBe(true);
    const [a, b] = trial.state.worlds;
    expect(a.time).toBeGreaterThan(0.1);
    expect(b.time).toBeCloseTo(a.time, 9);
    expect(a.parameters['fluid.viscosity']).not.toBe(b.parameters['fluid.viscosity']);
    expect([a.area, b.area]).toEqual([
        { x: 0, y: 0, width: 320, height: 360 }, { x: 320, y: 0, width: 320, height: 360 },
    ]);
    expect(b.camera.originX - a.camera.originX).toBeCloseTo(320, 6);
    const { c } = trial.library, touch = c.skv_stage_touch, touched: number[] = [];
    c.skv_stage_touch = (stage, side, event, tremble) => {
        const { px, py } = event as skv_pointer_event;
        touched.push(side, px, py);
        return touch(stage, side, event, tremble);
    };
    simulation.pointer({
        phase: 'down', device: 'mouse', pointer: 1, x: 400, y: 200, time: 0, pressure: 0, secondary: false,
        straight: false, side: 1,
    });
    expect(touched).toEqual([1, 80, 200]); // in its own area
    simulation.addProbe(0, 0.3, 0.1, 0.3, 0.1);
    trial.run(2);
    expect(trial.state.worlds.map(({ hands }) => hands)).toEqual([1, 1]);
    expect(trial.state.worlds.map(({ probes }) => probes.map(({ id }) => id))).toEqual([[1], [1]]);
    simulation.cancelPointers();
    simulation.setPaused(true);
    simulation.seek(4);
    trial.run(2);
    expect(trial.state.worlds[1].time).toBeCloseTo(trial.state.worlds[0].time, 9);
    expect(trial.state.moment).toBe(4);
    simulation.zoom(2, 100, 100);
    expect(trial.state.worlds.map(({ camera }) => camera.zoom)).toEqual([2, 2]);
});

test('each world may be touched alone', async () => {
    const trial = await compare();
    const { simulation } = trial;
    simulation.setLinked(false);
    simulation.set('fluid.viscosity', '0.05', 1);
    simulation.setGravity(1, 0);
    simulation.keyboard(1, 0, true);
    const [a, b] = trial.state.worlds;
    expect(b.parameters['fluid.viscosity']).toBe('0.05');
    expect(a.parameters['fluid.viscosity']).not.toBe('0.05');
});

test('the second world goes when sent away, when another scene comes, and if it cannot be', async () => {
    const trial = await compare();
    trial.simulation.compare(null);
    expect(trial.state.worlds).toHaveLength(1);
    expect(trial.state.worlds[0].area.width).toBe(640);
    const other = await compare();
    other.take();
    other.simulation.open('no-such-scene');
    expect(other.state.worlds).toHaveLength(2);
    other.simulation.open('pool');
    expect(other.state.worlds).toHaveLength(1);
    other.run(3);
    other.take();
    other.simulation.compare({ 'fluid.material': 'glue' });
    await Promise.resolve();
    await Promise.resolve();
    expect(other.take()[0].error).toMatch(/glue/);
    expect(other.state.worlds).toHaveLength(1);
    const { moment } = other.state;
    other.run(3);
    expect(other.state.moment).toBe(moment + 3);
});
