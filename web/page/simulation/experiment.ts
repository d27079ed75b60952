// An experiment, from its beginning to its report, and what it tells meanwhile.
import type { Library } from '../../src/library.js';
import type { skv_curve } from '../../src/interface.js';
import { made, table, using } from '../../src/memory.js';

import { unitOf } from './catalogue';
import type { Curve, LabMessage, Row } from './protocol';

/** Between two messages, s. */
const period = 1 / 12;
const styles = ['dots', 'rings', 'line', 'theory'] as const;

/** Runs it, which takes seconds to a minute. Throws where there is none. */
export function runExperiment(library: Library, index: number, particles: number,
    tell: (message: LabMessage) => void, clock: () => number) {
    const { c, instance } = library;
    const floats = (address: number, count: number) =>
        new Float64Array(instance.copy(address, 8 * count).buffer);
    const read = ({ label, style, count, x, y }: skv_curve): Curve =>
        ({ label, style: styles[style], x: floats(x, count), y: floats(y, count) });

    let last = -Infinity;
    const observe = (address: number) => {
        if (clock() - last < period) {
            return;
        }
        const moment = library.view('skv_lab_moment', address);
        const size = library.size('skv_curve');
        const curves = Array.from({ length: moment.curve_count },
            (_, i) => read(library.view('skv_curve', moment.curves + i * size)));
        tell({ kind: 'moment', share: moment.share, curves });
        last = clock(); // so that as much time goes into stepping
    };

    const report = using(library, c.skv_default_lab_options(), (options) => instance.lend(observe, (user: number) => {
        options.particles = particles;
        options.observe = instance.exports.skv_wasm_observe();
        options.user = user;
        return library.create((out, error) => c.skv_experiment_run(index, options, out, error));
    }));
    const rows: Row[] = table(library, 'skv_lab_row', (i) => c.skv_report_row(report, i))
        .map(({ quantity, unit, measured, theory, ratio, tolerance, pass }) =>
            ({ quantity, unit: unitOf(library, unit), measured, theory, ratio, tolerance, pass }));
    const curves: Curve[] = [];
    using(library, library.make('skv_curve'), (curve) => {
        for (let i = 0; c.skv_report_curve(report, i, curve); i++) {
            curves.push(read(curve));
        }
    });
    const text = (write: (report: number, write: number, user: number, error: any) => number) =>
        new TextDecoder().decode(made(library, (to, user, error) => write(report, to, user, error)));
    tell({ kind: 'done', particles: c.skv_experiment_particles(index, particles), rows, curves, csv: text(c.skv_report_csv), svg: text(c.skv_report_plot) });
    c.skv_report_destroy(report);
}
