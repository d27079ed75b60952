// The simulation as the page uses it, in node.
import { expect, test } from 'vitest';

import { makeTrial } from './testing';

const pointer = {
    device: 'finger', pointer: 1, pressure: 0, secondary: false, straight: false, side: 0,
} as const;

test('opens, plays, pauses, seeks and undoes', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('dam-break');
    expect(trial.take()).toEqual([{ kind: 'open', error: null }]);
    expect(trial.state.worlds[0].name).toBe('dam-break');
    expect(trial.state.worlds[0].particles).toBeGreaterThan(250);
    expect(trial.state.worlds[0].particles).toBeLessThan(350);
    trial.run(30);
    expect(trial.state.moment).toBe(30);
    simulation.setPaused(true);
    trial.run(5);
    expect(trial.state).toMatchObject({ moment: 30, paused: true });
    simulation.stepOnce();
    expect(trial.state.moment).toBe(31);
    simulation.seek(10);
    trial.run(1);
    expect(trial.state).toMatchObject({ moment: 10, end: 31 });
    simulation.set('fluid.viscosity', '0.01');
    expect(trial.state.worlds[0].parameters['fluid.viscosity']).toBe('0.01');
    expect(trial.state.canUndo).toBe(true);
    simulation.undo();
    expect(trial.state).toMatchObject({ moment: 10, canUndo: false, canRedo: true });
    expect(trial.state.worlds[0].parameters['fluid.viscosity']).not.toBe('0.01');
});

test('asks for no frame while paused, hidden or at rest', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('dam-break');
    expect(trial.wants).toBe(true);
    trial.run(3);
    expect(trial.wants).toBe(true);
    simulation.setPaused(true);
    trial.run(2);
    expect(trial.wants).toBe(false);
    simulation.setPaused(false);
    trial.run(2);
    expect(trial.wants).toBe(true);
    simulation.setHidden(true);
    trial.run(600); // ten seconds, for which nothing makes up
    expect(trial.wants).toBe(false);
    const { moment } = trial.state;
    simulation.setHidden(false);
    trial.run(2);
    expect(trial.state.moment).toBe(moment + 2);
});

test('a stopwatch that is started at rest runs', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('pool', { particles: '200' });
    for (let i = 0; i < 60 && !trial.state.atRest; i++) {
        trial.run(60);
    }
    expect(trial.state.atRest).toBe(true);
    trial.run(2);
    expect(trial.wants).toBe(false);
    simulation.pressStopwatch(false);
    trial.run(30);
    expect(trial.state.stopwatch).toMatchObject({ used: true, running: true });
    expect(trial.state.stopwatch.frames).toBeGreaterThan(25);
    simulation.pressStopwatch(false);
    trial.run(10);
    expect(trial.wants).toBe(false);
});

test('the stopwatch forgets presses that are cut off, and those of another scene', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('dam-break');
    trial.run(10);
    simulation.pressStopwatch(false);
    trial.run(5);
    expect(trial.state.stopwatch).toMatchObject({ used: true, running: true, frames: 5 });
    simulation.setPaused(true);
    simulation.seek(4);
    trial.run(2);
    simulation.setPaused(false); // what came after is cut off
    trial.run(2);
    expect(trial.state.stopwatch).toMatchObject({ used: false, running: false, frames: 0 });
    simulation.pressStopwatch(false);
    trial.run(2);
    simulation.open('pool');
    expect(trial.state.stopwatch.used).toBe(false);
});

test('a finger picks water up', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.setView(640, 360, 2);
    simulation.open('dam-break');
    trial.run(2);
    simulation.pointer({ ...pointer, phase: 'down', x: 60, y: 300, time: 0 });
    for (let i = 1; i <= 40; i++) {
        simulation.pointer({ ...pointer, phase: 'move', x: 60 + 4 * i, y: 300 - 4 * i, time: i / 60 });
        trial.run(1);
    }
    expect(trial.state.worlds[0].hands).toBe(1);
    simulation.pointer({ ...pointer, phase: 'up', x: 220, y: 140, time: 41 / 60 });
    trial.run(1);
    expect(trial.state.worlds[0].hands).toBe(0);
});

test('two fingers that come together zoom, and no hand does anything', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.setView(640, 360, 1);
    simulation.open('dam-break');
    const tell = (phase: 'down' | 'move' | 'up', finger: number, x: number, time: number) =>
        simulation.pointer({ ...pointer, phase, pointer: finger, x, y: 180, time });
    tell('down', 1, 300, 0);
    tell('down', 2, 340, 0.05);
    tell('move', 1, 200, 0.1);
    tell('move', 2, 440, 0.1);
    trial.run(1);
    expect(trial.state.worlds[0].camera.zoom).toBeGreaterThan(2);
    expect(trial.state.worlds[0].hands).toBe(0);
    simulation.showAll();
    expect(trial.state.worlds[0].camera.zoom).toBe(1);
});

test('what is asked for again and again leaves nothing behind in the memory', () => {
    const trial = makeTrial();
    const { simulation, library: { instance } } = trial;
    simulation.open('pool');
    simulation.setStyle({ view: 'pressure' });
    simulation.addProbe(0, 0.8, 0.2, 0.8, 0.2);
    simulation.setPaused(true);
    const ask = (times: number) => {
        for (let i = 0; i < times; i++) {
            const place = { x: i % 600, y: 200, time: i / 60 };
            simulation.pointer({ ...pointer, ...place, device: 'mouse', phase: 'move' });
            simulation.motion(0, 9.81, 0, 0, i / 60);
            simulation.zoom(i % 2 ? 2 : 0.5, 300, 200);
            simulation.setView(600 + (i % 2), 300, 2);
            simulation.compare(i % 10 === 0 ? { 'no.such': '1' } : null);
            expect(trial.state.worlds).toHaveLength(1);
        }
    };
    ask(10);
    const held = new Set<number>();
    const allocate = instance.allocate.bind(instance), release = instance.release.bind(instance);
    instance.allocate = (size) => {
        const pointer = allocate(size);
        held.add(pointer);
        return pointer;
    };
    instance.release = (pointer) => {
        held.delete(pointer);
        release(pointer);
    };
    ask(20);
    expect(held.size).toBe(0);
});
