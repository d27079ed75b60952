// Growing in node: what a game keeps when the larger module goes on with it.
import { expect, test, vi } from 'vitest';

import { loadLarger, makeTrial } from './testing';
import type { Listener } from './protocol';

/** Frames from a key frame to the next. */
const BETWEEN = 15;

/** A game that can grow. */
async function play(frames: number) {
    vi.resetModules(); // a page grows once
    const { grow } = await import('./grow'), of = await loadLarger();
    const growing: Promise<void>[] = [];
    let told: Listener | undefined;
    const ending = <Trial extends ReturnType<typeof makeTrial>>(trial: Trial) =>
        ({ files: trial.files, library: Object.assign(trial.library, { end: () => undefined }) });
    const larger = makeTrial({ of, hears: (state) => told?.state(state) });
    const { instance } = larger.library, { skv_wasm_take_key: take } = instance.exports;
    /** Of each world the moments of which it has taken the state. */
    const taken: number[][] = [[], []];
    instance.exports = { ...instance.exports, skv_wasm_take_key: (stage: number, side: number, key: number) => {
        taken[side].push(take(stage, side, key) ? Number(instance.data().getBigInt64(key, true)) : NaN);
    } };
    const small: ReturnType<typeof makeTrial> = makeTrial({
        lean: true,
        grow: (foresees) => growing.push(grow(small.simulation, ending(small), small.listener, new Map(), foresees,
            async () => ending(larger), (_, listener) => {
                told = listener;
                return larger.simulation;
            })),
    });
    const { simulation } = small;
    const { c } = small.library;
    let bodies = 0;
    while (!small.library.view('skv_tool', c.skv_tool_info(bodies)).drops)
        bodies++;
    simulation.open('pool');
    simulation.setStyle({}); // of which the stage hears, as of a page's
    simulation.set('fluid.viscosity', '0.01');
    small.run(frames);
    const choose = async () => {
        simulation.chooseTool(bodies);
        await Promise.all(growing);
    };
    return { small, larger, bodies, choose, taken };
}

/** Of key frames of a game that has come so far, after the start, and where it is. */
function moments(moment: number) {
    const whole = Array.from({ length: Math.floor(moment / BETWEEN) }, (_, i) => BETWEEN * (i + 1));
    return whole.at(-1) === moment ? whole : [...whole, moment];
}

test('a short game goes on whole', async () => {
    const { larger, bodies, choose } = await play(30);
    await choose();
    expect(larger.state).toMatchObject({ tool: bodies, canUndo: true, watching: false });
    expect(larger.state.end).toBeGreaterThanOrEqual(30);
});

test('a game that was rewound goes on whole, where it was', async () => {
    const { small, larger, choose } = await play(30);
    small.simulation.setPaused(true);
    small.simulation.seek(10);
    small.run(1);
    await choose();
    expect(larger.state).toMatchObject({ moment: 10, end: 30, paused: true, canUndo: true, watching: false });
});

test('a long game goes on whole at once, and what was done is undone at once', async () => {
    const { small, larger, bodies, choose, taken } = await play(100);
    small.simulation.set('fluid.viscosity', '0.02');
    small.run(100);
    const { moment } = small.state, kept = await small.simulation.keep();
    const viscosity = () => larger.state.worlds[0].parameters['fluid.viscosity'];
    await choose();
    expect(larger.state).toMatchObject({ tool: bodies, moment, end: moment, canUndo: true, watching: false, mismatch: false });
    expect(await larger.simulation.keep()).toEqual(kept);
    expect(taken).toEqual([moments(moment), []]);
    expect(viscosity()).toBe('0.02');
    larger.simulation.undo();
    expect(viscosity()).toBe('0.01');
    larger.simulation.undo();
    expect(larger.state).toMatchObject({ moment: 0, canUndo: false, mismatch: false });
    expect(small.take().concat(larger.take()).filter(({ error }) => error)).toEqual([]);
});

test('what was undone in a long game is redone at once', async () => {
    const { small, larger, choose } = await play(100);
    small.simulation.set('fluid.viscosity', '0.02');
    small.run(40);
    small.simulation.set('fluid.viscosity', '0.03');
    small.run(40);
    const { moment } = small.state, kept = await small.simulation.keep();
    small.simulation.undo();
    small.simulation.undo();
    small.run(20);
    await choose();
    const viscosity = () => larger.state.worlds[0].parameters['fluid.viscosity'];
    expect(larger.state).toMatchObject({ canUndo: true, canRedo: true, mismatch: false });
    expect(viscosity()).toBe('0.01');
    larger.simulation.redo();
    expect(viscosity()).toBe('0.02');
    larger.simulation.redo();
    expect(viscosity()).toBe('0.03');
    expect(larger.state).toMatchObject({ moment, end: moment, canRedo: false, mismatch: false });
    expect(await larger.simulation.keep()).toEqual(kept);
});

test('two worlds that are compared go on whole at once', async () => {
    const { small, larger, choose, taken } = await play(2 * BETWEEN);
    small.simulation.compare({ 'fluid.viscosity': '0.04' });
    small.run(100);
    small.simulation.set('fluid.viscosity', '0.02', 1);
    small.run(100);
    const { moment, end } = small.state, kept = await small.simulation.keep();
    await choose();
    expect(larger.state).toMatchObject({ moment, end, canUndo: true, watching: false, mismatch: false });
    expect(await larger.simulation.keep()).toEqual(kept);
    expect(taken).toEqual([moments(moment), moments(moment)]);
});

test('a game that cannot be opened again goes on from where it was', async () => {
    const { small, larger, bodies, choose } = await play(100);
    const { moment } = small.state, { set } = small.files;
    expect(moment).toBeGreaterThan(0);
    small.files.set = (path, bytes) => set.call(small.files, path, path === 'kept.skvr' ? bytes.fill(0) : bytes);
    await choose();
    expect(larger.state).toMatchObject({ tool: bodies, moment: 0, canUndo: false });
    expect(larger.state.worlds[0].time).toBe(small.state.worlds[0].time);
});

test('what is opened while a game is handed over goes on instead of it', async () => {
    const { small, larger, bodies, choose, taken } = await play(100);
    const { set } = small.files;
    small.files.set = (path, bytes) => {
        if (path === 'kept.skvr')
            queueMicrotask(() => small.simulation.open('funnel'));
        return set.call(small.files, path, bytes);
    };
    await choose();
    expect(larger.state).toMatchObject({ tool: bodies, moment: 0, canUndo: false });
    expect(larger.state.worlds[0].name).toBe('funnel');
    expect(taken).toEqual([[], []]);
});
