// Growing in node: what a game keeps when the larger module goes on with it.
import { expect, test, vi } from 'vitest';

import { loadLarger, makeTrial } from './testing';
import type { Listener } from './protocol';

/** Of 300 particles a frame's step takes 30 ms here, and 140 of them more than people are let wait, s. */
const COST = 1e-4;

/** A game that can grow. */
async function play(frames: number) {
    vi.resetModules(); // a page grows once
    const { grow } = await import('./grow'), of = await loadLarger();
    const growing: Promise<void>[] = [];
    let told: Listener | undefined;
    const ending = <Trial extends ReturnType<typeof makeTrial>>(trial: Trial) =>
        ({ files: trial.files, library: Object.assign(trial.library, { end: () => undefined }) });
    const larger = makeTrial({ of, cost: COST, hears: (state) => told?.state(state) });
    const small: ReturnType<typeof makeTrial> = makeTrial({
        lean: true, cost: COST,
        grow: (foresees, before) => growing.push(grow(small.simulation, ending(small), small.listener, new Map(), foresees,
            before, async () => ending(larger), (_, listener) => {
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
    simulation.set('fluid.viscosity', '0.01');
    small.run(frames);
    const choose = async () => {
        simulation.chooseTool(bodies);
        await Promise.all(growing);
        void larger.state; // which is told, and where it was is sought
        larger.run(2 * frames);
    };
    return { small, larger, bodies, choose };
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

test('of a long game is said what would be lost, before it is', async () => {
    const { small, larger, bodies, choose } = await play(200);
    const { tool } = small.state;
    small.take();
    await choose();
    expect(small.take()).toEqual([{ kind: 'anew', error: null }]);
    expect(small.state).toMatchObject({ tool, canUndo: true });
    expect(larger.state.worlds[0].name).toBe('');
    await choose();
    expect(larger.state).toMatchObject({ tool: bodies, canUndo: false });
    expect(larger.state.worlds[0].particles).toBe(small.state.worlds[0].particles);
});
