// Table: curves over one axis, as uPlot draws them. Invariant: where a curve has no value it has a gap,
// which no line bridges.
import uPlot from 'uplot';
import type { Curve } from '../simulation/protocol';

/** At each place, what each curve has there; null: a gap; undefined: only others have a place there. */
export function tableOf(curves: Pick<Curve, 'x' | 'y'>[]): uPlot.AlignedData {
    const places = curves.map(({ x, y }): uPlot.AlignedData =>
        [x, Array.from(y, (value) => (Number.isFinite(value) ? value : null))]);
    return places.length ? uPlot.join(places, places.map((table) => table.map(() => 2))) : [[]];
}
