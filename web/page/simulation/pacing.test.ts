// How many particles, how sharp, and what a sensor does.
import { expect, test } from 'vitest';

import { amountsOf, largestWithin } from './amount';
import { Sharpness } from './pacing';
import { loadLibrary, makeTrial } from './testing';

const frames = (sharpness: Sharpness, count: number, seconds: number, stepping: number, drawing: number) => {
    for (let i = 0; i < count; i++) {
        sharpness.tell(seconds, stepping, drawing);
    }
    return sharpness.limit;
};

test('the number of particles is the largest that leaves half of a frame, and a quarter after drawing', () => {
    const { library } = loadLibrary();
    const largest = (seconds: number, drawing = 0) => largestWithin(amountsOf(library), seconds, drawing);
    expect(largest(1e-9)).toBe(20000);
    expect(largest(0.008 / 3000)).toBe(3000);
    expect(largest(0.008 / 2999)).toBe(2000);
    expect(largest(1)).toBe(500);
    expect(largest(1e-6, 0.004)).toBe(5000);
    expect(largest(1e-6, 0.008)).toBe(3000);
    expect(largest(1e-9, 0.013)).toBe(500);
});

test('it is measured once, is said, and is left alone where somebody says another', () => {
    const trial = makeTrial({ particles: null, tick: 0.04 });
    const { simulation } = trial;
    simulation.open('dam-break', { particles: '400' });
    expect(trial.state.chosen).toBe(null);
    simulation.open('dam-break');
    expect(trial.state.chosen).toBe(500);
    expect(Math.abs(trial.state.worlds[0].particles - 500)).toBeLessThan(50);
    simulation.open('ink'); // has 4000 where others have 3000
    expect(Math.abs(trial.state.worlds[0].particles - 667)).toBeLessThan(70);
    simulation.setParticles(1000);
    simulation.open('dam-break');
    expect(trial.state.chosen).toBe(1000);
    expect(Math.abs(trial.state.worlds[0].particles - 1000)).toBeLessThan(100);
});

/** s a particle and frame on the development machine; telephones are some four times as slow. */
const usual = 3.3e-6;

/** Plays for two seconds: frames a second, and what is said of them. */
function playFor(trial: ReturnType<typeof makeTrial>) {
    const from = { now: trial.now, moment: trial.state.moment };
    while (trial.now < from.now + 2) {
        trial.run(1);
    }
    const { moment, pace, chosen, worlds: [{ particles }], going } = trial.state;
    return { rate: (moment - from.moment) / (trial.now - from.now), pace, chosen, particles, going };
}

test('a device that is four times as slow begins with fewer particles, and keeps 60 frames a second', () => {
    for (const [times, chosen] of [[1, 2000], [4, 500]]) {
        const trial = makeTrial({ particles: null, cost: times * usual });
        trial.simulation.open('dam-break');
        const seen = playFor(trial);
        expect(seen).toMatchObject({ chosen, pace: 1 });
        expect(Math.abs(seen.particles - chosen)).toBeLessThan(0.1 * chosen);
        expect(seen.rate).toBeCloseTo(60, 0);
        expect(seen.going.slow).toBe(false);
    }
});

test('with more particles than the device can step it says how slow it is', () => {
    const trial = makeTrial({ particles: null, cost: 4 * usual });
    trial.simulation.open('dam-break', { particles: '3000' });
    const { rate, pace, particles, going } = playFor(trial);
    expect(particles).toBeGreaterThan(2700);
    expect(rate).toBeCloseTo(60 / Math.ceil(60 * 4 * usual * particles), 0); // a step for each picture
    expect(pace).toBeCloseTo(rate / 60, 1);
    expect(going).toMatchObject({ words: '%s× of real time', slow: true });
    expect(going.times).toBeCloseTo(0.33, 2);
});

test('pictures get less sharp where drawing is slow, step by step', () => {
    const sharpness = new Sharpness();
    expect(frames(sharpness, 180, 1 / 60, 0.004, 0.001)).toBe(2);
    expect(frames(sharpness, 25, 1 / 25, 0.004, 0.001)).toBe(1.5);
    expect(frames(sharpness, 40, 1 / 40, 0.004, 0.001)).toBe(1);
    expect(frames(sharpness, 200, 1 / 60, 0.004, 0.001)).toBe(1);
});

test('where a processor draws, pictures are coarse within a second or two', () => {
    expect(frames(new Sharpness(), 6, 0.2, 0.01, 0.15)).toBe(1);
});

test('pictures stay sharp where it is not drawing that is slow', () => {
    const stepping = new Sharpness();
    expect(frames(stepping, 200, 1 / 20, 0.045, 0.001)).toBe(2);
    const thirty = new Sharpness(); // a display of 30 Hz
    expect(frames(thirty, 31, 1 / 30, 0.004, 0.001)).toBe(1.5);
    expect(frames(thirty, 31, 1 / 30, 0.004, 0.001)).toBe(2);
    expect(frames(thirty, 500, 1 / 30, 0.004, 0.001)).toBe(2);
});

test('a sensor turns gravity, and shakes', () => {
    for (const reversed of [false, true]) {
        const sign = reversed ? -1 : 1;
        const trial = makeTrial({ reversed });
        const { simulation } = trial;
        simulation.open('pool');
        trial.run(2);
        const upright = { 0: [0, 9.81], 90: [9.81, 0], 180: [0, -9.81], 270: [-9.81, 0] };
        let time = 0;
        for (const [angle, [x, y]] of Object.entries(upright)) {
            for (let i = 0; i < 60; i++) {
                simulation.motion(sign * x, sign * y, 0, Number(angle), time += 1 / 60);
            }
            trial.run(2);
            expect(trial.state.gravity.x).toBeCloseTo(0, 1);
            expect(trial.state.gravity.y).toBeCloseTo(-1, 1);
        }
        simulation.motion(0, sign * 9.81, 0, 0, time += 1 / 60);
        trial.run(1);
        simulation.setPaused(true);
        simulation.motion(sign * 9.81, 0, 0, 0, time += 1);
        trial.run(1);
        expect(trial.state.gravity.y).toBeCloseTo(-1, 1);
    }
});

test('a sensor is as strong as it is set', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('pool');
    trial.run(2);
    let time = 0;
    for (const [strength, held, felt] of [[0.5, 9.81, -0.5], [2, 4.9, -1], [1e9, 9.81, -2], [0, 9.81, 0]]) {
        simulation.setTilt(strength);
        for (let i = 0; i < 60; i++) {
            simulation.motion(0, held, 0, 0, time += 1 / 60);
        }
        trial.run(2);
        expect(trial.state.gravity.y).toBeCloseTo(felt, 1);
    }
});

test('a shake is as strong as the sensor is set', () => {
    const shake = (strength: number) => {
        const { simulation } = makeTrial();
        const pushes: number[] = [];
        simulation.push = (vx) => pushes.push(vx);
        simulation.open('pool');
        simulation.setTilt(strength);
        for (let i = 1; i <= 20; i++) {
            simulation.motion(i % 4 < 2 ? 30 : -30, 9.81, 0, 0, i / 60);
        }
        return pushes;
    };
    const once = shake(1);
    expect(once.length).toBeGreaterThan(0);
    expect(shake(2)).toEqual(once.map((push) => 2 * push));
});

test('nothing that is no number reaches the library', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('pool');
    simulation.setGravity(NaN, 1e99);
    simulation.push(Infinity, NaN);
    simulation.setSpeed(NaN);
    simulation.seek(-5.5);
    simulation.zoom(NaN, 0, 0);
    simulation.zoom(2, NaN, 0);
    simulation.pan(Infinity, 0);
    simulation.setTool(99);
    simulation.setTool(-1);
    simulation.setDye(7.5);
    simulation.setBrush(-1);
    simulation.addProbe(99, 0, 0, 0, 0);
    simulation.addProbe(0, NaN, 0, 0, 0);
    simulation.moveProbe(7, 0, 0, 0, 0);
    simulation.motion(NaN, 0, 0, NaN, NaN);
    simulation.set('no.such', 'x'.repeat(5000));
    simulation.setView(NaN, -1, Infinity);
    simulation.keyboard(NaN, 5, true);
    trial.run(3);
    const { worlds: [world], speed } = trial.state;
    expect(world.particles).toBeGreaterThan(100);
    expect(speed).toBe(1);
    expect([...Object.values(world.camera), ...Object.values(world.area)].every(Number.isFinite)).toBe(true);
});
