// What is measured, and what there is to choose from.
import { execFileSync } from 'node:child_process';

import { expect, test } from 'vitest';

import { runExperiment } from './experiment';
import type { LabMessage } from './protocol';
import { loadLibrary, makeTrial, native } from './testing';

function fromBits(hex: string) {
    const data = new DataView(new ArrayBuffer(8));
    data.setBigUint64(0, BigInt(`0x${hex}`));
    return data.getFloat64(0);
}

test('a probe reads what it reads natively, to the last bit', async () => {
    const [pressure, theory] = execFileSync(`${native}/web_reference`,
        ['probe', 'pool', '300', '30', '0.8', '0.2'], { encoding: 'utf8' }).trim().split(' ').map(fromBits);
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('pool', { particles: '300' });
    simulation.addProbe(0, 0.8, 0.2, 0.8, 0.2);
    simulation.watchProbe(1, true);
    trial.run(30);
    const [probe] = trial.state.worlds[0].probes;
    expect(probe.channels.map(({ value }) => value)).toEqual([pressure, theory]);
    expect(probe.channels.map((channel) => channel.theory)).toEqual([false, true]);
    expect(probe.channels[0]).toMatchObject({ unit: 'cm of water', decimals: 1 });
    expect(probe.times).toHaveLength(31); // the start, and 30 frames
    expect(probe.values![0].at(-1)).toBe(pressure);
    trial.si = true;
    expect(trial.state.worlds[0].probes[0].channels[0]).toMatchObject({ unit: 'Pa m', size: 1, decimals: -1 });
    const table = new TextDecoder().decode(await simulation.save('csv')).trim().split('\n');
    expect(table[0]).toBe('t [s],pressure probe pressure [Pa m],pressure probe density g depth [Pa m]');
    expect(table).toHaveLength(32); // the head, too
    expect(Number(table.at(-1)!.split(',')[1])).toBe(pressure);
    simulation.moveProbe(1, 0.5, 0.1, 0.5, 0.1);
    trial.run(1);
    expect(trial.state.worlds[0].probes[0]).toMatchObject({ x0: 0.5, y0: 0.1 });
    // As a held key does, between two states; also of a world that stands still.
    for (const paused of [false, true]) {
        simulation.setPaused(paused);
        for (let i = 0; i < 5; i++) {
            simulation.shiftProbe(1, -0.01, 0.01);
        }
        simulation.shiftProbe(9, 1, 1); // there is none
        trial.run(1);
    }
    expect(trial.state.worlds[0].probes[0].x0).toBeCloseTo(0.4, 6);
    expect(trial.state.worlds[0].probes[0].y0).toBeCloseTo(0.2, 6);
    expect(trial.state.worlds[0].probes[0].x1).toBeCloseTo(0.4, 6);
    simulation.removeProbe(1);
    expect(trial.state.worlds[0].probes).toEqual([]);
});

test('a legend says what colours mean', () => {
    const trial = makeTrial();
    trial.simulation.open('pool');
    trial.run(2);
    expect(trial.state.worlds[0].legend).toBe(null);
    trial.simulation.setStyle({ view: 'pressure', overlays: ['grid', 'ruler'], range: 2000 });
    const { legend } = trial.state.worlds[0];
    expect(legend).toMatchObject({ label: 'pressure', unit: 'cm of water', high: 2000 });
    expect(legend!.colors).toHaveLength(64);
    expect(legend!.colors[0]).toMatch(/^rgb\(\d+ \d+ \d+\)$/);
    expect(legend!.colors[0]).not.toBe(legend!.colors[63]);
    trial.take();
    trial.simulation.setStyle({ view: 'x-ray' });
    expect(trial.take()).toMatchObject([{ kind: 'edit' }]);
    expect(trial.state.style).toMatchObject({ view: 'pressure', overlays: ['grid', 'ruler'] });
});

test('an experiment tells how it goes, and what came of it', () => {
    const { library } = loadLibrary();
    const messages: LabMessage[] = [];
    let now = 0;
    const keep = (message: LabMessage) => void messages.push(structuredClone(message));
    runExperiment(library, 0, 600, keep, () => now++);
    const last = messages.at(-1)!;
    expect(messages.length).toBeGreaterThan(10);
    expect(messages.slice(0, -1).every(({ kind }) => kind === 'moment')).toBe(true);
    if (last.kind !== 'done') {
        throw new Error('it did not end');
    }
    expect(last.rows.map(({ quantity }) => quantity)).toContain('pressure, layer 1');
    expect(last.curves.map(({ style }) => style)).toContain('theory');
    expect(last.svg).toMatch(/^<svg|^<\?xml/);
    expect(last.csv).toMatch(/^series,depth/);
    expect(last.particles).toBe(600);
    expect(() => runExperiment(library, 99, 0, keep, () => 0)).toThrow(/no experiment/);
});

test('the catalogue is complete, and plain', async () => {
    const { simulation, library } = makeTrial();
    const catalogue = structuredClone(await simulation.catalogue());
    expect(catalogue.version).toBe(library.c.skv_version());
    for (const list of Object.values(catalogue).filter(Array.isArray)) {
        expect(list.length).toBeGreaterThan(0);
    }
    expect(catalogue.limits).toMatchObject({ frames_a_second: 60, first_scene: 'dam-break', usual_amount: 3000 });
    expect(catalogue.amounts).toEqual([500, 1000, 2000, 3000, 5000, 10000, 20000]);
    expect(catalogue.scenes.map(({ name }) => name)).toContain('dam-break');
    expect(catalogue.tools[0]).toMatchObject({ name: 'hand', key: '1' });
    expect(catalogue.dyes[0]).toBe('none');
    expect(catalogue.views.map(({ name }) => name)).toEqual(
        ['water', 'pressure', 'speed', 'density', 'particles', 'fluid']);
    const viscosity = catalogue.parameters.find(({ path }) => path === 'fluid.viscosity');
    expect(viscosity).toMatchObject({ type: 'number' });
    const law = catalogue.sceneFields.find(({ path }) => path === 'fluid.law')!;
    expect(law).toMatchObject({ type: 'choice', choices: ['calibrated', 'clavet'] });
    expect(catalogue.experiments[0].question.length).toBeGreaterThan(10);
});
