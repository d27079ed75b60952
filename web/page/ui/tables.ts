// Tables: curves as comma-separated values, which a spreadsheet opens. Invariant: every line has three cells,
// whatever a label holds in the reader's language.
import type { Curve } from '../simulation/protocol';

/** As skv_write_cell writes it. */
const cell = (text: string) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

export function tableOf(curves: Pick<Curve, 'label' | 'x' | 'y'>[], x: string, y: string): string {
    const lines = curves.flatMap(({ label, x: xs, y: ys }) =>
        Array.from(xs, (at, i) => `${cell(label)},${Number(at.toPrecision(7))},${Number(ys[i].toPrecision(7))}`)
            .filter((_line, i) => Number.isFinite(ys[i])),
    );
    return [['series', x, y].map(cell).join(), ...lines, ''].join('\n');
}
