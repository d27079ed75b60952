// Labels: where readings stand beside their grips. Invariant: none lies over another, over a grip or beyond its
// area; one that finds no place is left out.
/** CSS pixels. */
export interface Label {
    /** Of the middle of its grip. */
    x: number;
    y: number;
    width: number;
}
export interface Box {
    x: number;
    y: number;
    width: number;
    height: number;
}
/** Where the text begins, or ends. */
export interface Place {
    x: number;
    y: number;
    ends: boolean;
}

/** CSS pixels: from the middle of a grip to its reading, a grip's radius, and a line's height. */
const BESIDE = 17;
const GRIP = 12;
const HEIGHT = 20;

function overlap(a: Box, b: Box): boolean {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/** Right of its grip or left of it, else up to two lines higher or lower. */
export function placesOf(labels: Label[], grips: { x: number; y: number }[], area: Box): (Place | null)[] {
    const taken = grips.map(({ x, y }): Box => ({ x: x - GRIP, y: y - GRIP, width: 2 * GRIP, height: 2 * GRIP }));
    const isFree = (box: Box) => box.x >= area.x && box.x + box.width <= area.x + area.width
        && box.y >= area.y && box.y + box.height <= area.y + area.height && !taken.some((other) => overlap(box, other));
    return labels.map(({ x, y, width }) => {
        for (const shift of [0, -HEIGHT, HEIGHT, -2 * HEIGHT, 2 * HEIGHT])
            for (const ends of [false, true]) {
                const box = { x: ends ? x - BESIDE - width : x + BESIDE, y: y + shift - HEIGHT / 2, width, height: HEIGHT };
                if (isFree(box)) {
                    taken.push(box);
                    return { x: ends ? x - BESIDE : x + BESIDE, y: y + shift, ends };
                }
            }
        return null;
    });
}
