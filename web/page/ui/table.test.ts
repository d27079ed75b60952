// Table: gaps stay gaps, whatever else is drawn over the same axis.
import { expect, test } from 'vitest';

import { tableOf } from './table';

test('a gap stays a gap, and another curve makes none', () => {
    const dry = { x: Float64Array.of(0, 1, 2, 3), y: Float64Array.of(5, NaN, NaN, 6) };
    const other = { x: Float64Array.of(0.5, 3), y: Float64Array.of(1, 2) };
    expect(Array.from(tableOf([dry])[1])).toEqual([5, null, null, 6]);
    const [places, first, second] = tableOf([dry, other]).map((column) => Array.from(column));
    expect(places).toEqual([0, 0.5, 1, 2, 3]);
    expect(first.slice(2)).toEqual([null, null, 6]);
    expect(second).toEqual([undefined, 1, undefined, undefined, 2]);
    expect(tableOf([])).toEqual([[]]);
});
