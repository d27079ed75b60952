// Axes: where a plot's values lie, and the ways of its curves. Invariant: every finite point lies within the
// axes; where a curve has no value it has a gap, which no line bridges.
import type { Curve } from '../simulation/protocol';

/** Of the greatest value, upwards: what hardly changes looks like that. As in the app. */
const LEAST_SPAN = 0.05;

export interface Axis {
    /** Round values, from its first to its last. */
    ticks: number[];
    /** Pixels. */
    place: (value: number) => number;
}

/** 1, 2 or 5 times a power of ten, at least so large. */
function roundStep(least: number): number {
    const power = 10 ** Math.floor(Math.log10(least));
    return power * ([1, 2, 5].find((times) => times * power >= least) ?? 10);
}

/** @param apart pixels from tick to tick, at least */
export function axisOf(lists: Float64Array[], from: number, to: number, apart: number, leastSpan = 0): Axis {
    let low = Infinity, high = -Infinity;
    for (const value of lists.flatMap((list) => Array.from(list)).filter(Number.isFinite)) {
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    if (low > high)
        [low, high] = [0, 1];
    const size = Math.max(-low, high), span = high - low;
    const pad = Math.max((span > 1e-9 * size ? leastSpan * size : size / 10 || 1) - span, 0) / 2;
    const step = roundStep(((span + 2 * pad) * apart) / Math.abs(to - from));
    const first = Math.floor((low - pad) / step + 1e-9), last = Math.ceil((high + pad) / step - 1e-9);
    const ticks = Array.from({ length: last - first + 1 }, (_, i) => (first + i) * step);
    return { ticks, place: (value) => from + ((value / step - first) / (last - first)) * (to - from) };
}

/** Both axes of curves, in a box with y downwards. */
export function axesOf(curves: Pick<Curve, 'x' | 'y'>[], left: number, right: number, top: number, bottom: number) {
    return {
        across: axisOf(curves.map(({ x }) => x), left, right, 64),
        up: axisOf(curves.map(({ y }) => y), bottom, top, 40, LEAST_SPAN),
    };
}

/** What follows a point that is drawn as such, in a path. */
const marks = { dots: 'h0', rings: 'm-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0' };

/** A path; a point between two gaps is a dot. */
export function wayOf({ x, y, style }: Omit<Curve, 'label'>, across: Axis, up: Axis): string {
    const mark = style === 'dots' || style === 'rings' ? marks[style] : null;
    let way = '', joins = false;
    x.forEach((at, i) => {
        const isThere = Number.isFinite(at) && Number.isFinite(y[i]);
        if (isThere) {
            const point = `${across.place(at).toFixed(1)} ${up.place(y[i]).toFixed(1)}`;
            way += joins ? `L${point}` : `M${point}${mark ?? 'h0'}`;
        }
        joins = isThere && mark === null;
    });
    return way;
}
