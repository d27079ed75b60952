// Photographs: where dark and light part.
import { expect, test } from 'vitest';

import { bestLevel } from './photograph';

function greys(...values: number[]) {
    return Uint8ClampedArray.from(values.flatMap((value) => [value, value, value, 255]));
}

test('the level lies between pencil and paper, however dark the photo is', () => {
    for (const [pencil, paper] of [[40, 220], [20, 90], [150, 250]]) {
        const level = 255 * bestLevel(greys(...Array(20).fill(pencil), ...Array(80).fill(paper)));
        expect(level).toBeGreaterThan(pencil);
        expect(level).toBeLessThan(paper);
    }
});

test('a picture of one lightness has a level, too', () => {
    expect(bestLevel(greys(128, 128, 128))).toBeCloseTo(0.5, 1);
});
