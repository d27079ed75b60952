// Readings that stand beside each other's grips.
import { expect, test } from 'vitest';
import { placesOf } from './labels';

const area = { x: 0, y: 0, width: 360, height: 400 };
const width = 130;

function boxOf({ x, y, ends }: { x: number; y: number; ends: boolean }) {
    return { left: ends ? x - width : x, right: ends ? x : x + width, top: y - 10, bottom: y + 10 };
}

test('a reading stands to the right of its grip, at the right edge to the left', () => {
    expect(placesOf([{ x: 50, y: 200, width }], [{ x: 50, y: 200 }], area)).toEqual([{ x: 67, y: 200, ends: false }]);
    expect(placesOf([{ x: 330, y: 200, width }], [{ x: 330, y: 200 }], area)).toEqual([{ x: 313, y: 200, ends: true }]);
});

test('readings of grips near each other lie apart, and one without a place is left out', () => {
    const grips = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => ({ x: 140 + 5 * i, y: 200 + 3 * i }));
    const places = placesOf(grips.map((grip) => ({ ...grip, width })), grips, area);
    const boxes = places.flatMap((place) => (place ? [boxOf(place)] : []));
    expect(boxes.length).toBeGreaterThan(2);
    expect(places).toContain(null);
    boxes.forEach((a, i) => {
        expect(a.left >= 0 && a.right <= area.width).toBe(true);
        for (const b of boxes.slice(0, i))
            expect(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top).toBe(true);
        for (const { x, y } of grips)
            expect(a.right <= x - 12 || x + 12 <= a.left || a.bottom <= y - 12 || y + 12 <= a.top).toBe(true);
    });
});
