// Files and links: what is made of a world to be kept or sent.
import type { Library } from '../../src/library.js';
import { made, withBytes } from '../../src/memory.js';

import type { Worlds } from './worlds';

/** The text of a link to a replay, without what stands before it; throws if it would be too long. */
export function linkOf(library: Library, replay: Uint8Array) {
    const { c } = library;
    const link = withBytes(library, replay, (data) => made(library, (write, user, error) =>
        c.skv_link_write(data, replay.length, null, write, user, error)));
    return new TextDecoder().decode(link).replace(/^skvalp:/, '');
}

/** A field of a table: nothing where there was no reading. */
function field(value: number | undefined) {
    return value === undefined || Number.isNaN(value) ? '' : String(value);
}

/**
 * The histories of all instruments as skv_lab_write_csv has them: a row for every moment at which any
 * of them was read.
 */
export function csvOf(library: Library, worlds: Worlds) {
    const { c, instance } = library;
    const probes = () => worlds.first.probes.slice(0, worlds.first.probe_count);
    const unwatched = probes().filter(({ samples }) => samples === 0).map(({ id }) => id);
    unwatched.forEach((id) => c.skv_stage_watch_probe(worlds.stage, id, true));
    worlds.look();
    const head = ['t [s]'];
    const rows = new Map<number, (number | undefined)[]>();
    for (const { def, samples, times, history } of probes()) {
        const read = (address: number) => new Float64Array(instance.copy(address, 8 * samples).buffer);
        for (let i = 0, address; (address = c.skv_instrument_channel(def.kind, i)) !== 0; i++) {
            const { name, unit } = library.view('skv_channel', address);
            const values = samples > 0 ? read(history[i]) : [];
            (samples > 0 ? read(times) : []).forEach((time, row) => {
                const values_ = rows.get(time) ?? [];
                values_[head.length - 1] = values[row];
                rows.set(time, values_);
            });
            head.push(`${def.name} ${name} [${unit}]`);
        }
    }
    unwatched.forEach((id) => c.skv_stage_watch_probe(worlds.stage, id, false));
    const lines = [...rows].sort(([a], [b]) => a - b).map(([time, values]) =>
        [time, ...Array.from({ length: head.length - 1 }, (_, i) => values[i])].map(field).join(','));
    return new TextEncoder().encode([head.join(','), ...lines, ''].join('\n'));
}
