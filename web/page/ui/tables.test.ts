// Tables: what would part a cell is quoted, and what has no value has no line.
import { expect, test } from 'vitest';

import { tableOf } from './tables';

test('labels keep their commas and quotes in one cell', () => {
    const curve = (label: string, ...y: number[]) => ({ label, x: Float64Array.from(y.keys()), y: Float64Array.from(y) });
    expect(tableOf([curve('theory, B', 0.5, NaN, 1 / 3), curve('a 3" pipe', 2)], 'time (s)', 'x, y')).toBe(
        'series,time (s),"x, y"\n"theory, B",0,0.5\n"theory, B",2,0.3333333\n"a 3"" pipe",0,2\n');
});
