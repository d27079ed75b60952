// Axes: gaps stay gaps, ticks are round, and every point lies between the first and the last.
import { expect, test } from 'vitest';

import { axesOf, wayOf } from './axes';

const line = (x: number[], y: number[]) => ({ x: Float64Array.from(x), y: Float64Array.from(y), style: 'line' as const });
const box = [50, 350, 10, 200] as const;

test('a gap stays a gap, a lone point is a dot, and marks are not joined', () => {
    const dry = line([0, 1, 2, 3, 4, 5], [0, 1, NaN, 1, NaN, 0]);
    const { across, up } = axesOf([dry], ...box);
    const way = wayOf(dry, across, up);
    expect(way.split('M').length - 1).toBe(3);
    expect(way.split('L').length - 1).toBe(1);
    expect(way.match(/h0/g)).toHaveLength(3);
    expect(wayOf({ ...dry, style: 'dots' }, across, up)).not.toContain('L');
    expect(wayOf({ ...dry, style: 'rings' }, across, up).match(/a/g)).toHaveLength(8);
});

test('ticks are round and every point lies within', () => {
    const curve = line([0.3, 7.9], [-13, 42]);
    const { across, up } = axesOf([curve, line([3], [NaN])], ...box);
    expect(across.ticks).toEqual([0, 2, 4, 6, 8]);
    expect(up.ticks).toEqual([-20, 0, 20, 40, 60]);
    expect([across.place(0), across.place(8), up.place(-20), up.place(60)]).toEqual([50, 350, 200, 10]);
});

test('what hardly changes looks like that, and what does not change, or is not there, has axes', () => {
    const { up } = axesOf([line([0, 1], [100, 100.001])], ...box);
    expect(up.ticks.at(-1)! - up.ticks[0]).toBeGreaterThanOrEqual(5);
    // Round a lone zero, labels are short: the first moment of a plot over time.
    expect(axesOf([line([0], [0])], ...box).across.ticks).toEqual([-0.5, 0, 0.5]);
    for (const [x, y] of [[[1e6], [0]], [[0], [1e-7]], [[], []], [[NaN], [-5]]]) {
        const { across, up } = axesOf([line(x, y)], ...box);
        for (const { ticks, place } of [across, up]) {
            expect(ticks.length).toBeGreaterThan(1);
            expect(ticks.length).toBeLessThan(10);
            expect(ticks.every((tick, i) => Number.isFinite(place(tick)) && (i === 0 || tick > ticks[i - 1]))).toBe(true);
        }
    }
});
