// Opening: scenes, files, links and experiments; and all of them again with other settings.
//
// Invariant: what is open goes on until what was asked for is there; if that fails, it is reported,
// and what is open is still what it was.
import type { Library } from '../../src/library.js';
import { made, withBytes, withOptions } from '../../src/memory.js';

import type { FileFormat, Settings } from './protocol';

/** What can be opened: by name, as the set-up of an experiment, or as the bytes of a file. */
type Source =
    | { name: string }
    | { experiment: number }
    | { bytes: Uint8Array; format: FileFormat; label: string; cautious: boolean };
interface Wanted {
    source: Source;
    settings: Settings;
}

export class Opening {
    #library;
    #stage;
    #amount;
    /** What is open, and what is to be opened instead. */
    current: Wanted | null = null;
    next: Wanted | null = null;

    /** @param amount the number of particles for a scene or an experiment that is opened without one; 0: its own */
    constructor(library: Library, stage: number, amount: (of: string | number) => number) {
        this.#library = library;
        this.#stage = stage;
        this.#amount = amount;
    }

    scene(name: string, settings: Settings = {}) {
        const amount = 'particles' in settings ? 0 : this.#amount(name);
        const own: Settings = amount ? { particles: String(amount) } : {};
        this.open({ source: { name }, settings: { ...own, ...settings } });
    }

    /** @param cautious asks once more about what takes long: it may be anybody's */
    bytes(bytes: Uint8Array, format: FileFormat, label: string, settings: Settings = {}, cautious = true) {
        this.open({ source: { bytes, format, label, cautious }, settings });
    }

    /** Throws what is wrong with a link. */
    link(text: string) {
        const { c } = this.#library;
        const link = c.skv_link_is(text) ? text : `skvalp:${text}`;
        const bytes = made(this.#library, (write, user, error) => c.skv_link_read(link, write, user, error));
        this.bytes(bytes, 'skvr', 'link');
    }

    /** Throws if there is no such experiment, or if it comes with the larger module. */
    experiment(index: number) {
        const { c } = this.#library;
        this.next = { source: { experiment: index }, settings: {} };
        const text = made(this.#library,
            (write, user, error) => c.skv_experiment_scene(index, write, user, error));
        const { name } = this.#library.view('skv_experiment', c.skv_experiment_info(index));
        this.bytes(text, 'json', name, { particles: String(this.#amount(index)) });
    }

    /** What is open, from its start, with other settings. */
    change(settings: Settings) {
        if (this.current) {
            const { source, settings: before } = this.current;
            this.open({ source, settings: { ...before, ...settings } });
        }
    }

    open(wanted: Wanted) {
        const { c } = this.#library, { source, settings } = wanted;
        if ('experiment' in source) {
            this.experiment(source.experiment);
            return;
        }
        this.next = wanted;
        withOptions(this.#library, settings, (options) => {
            if ('name' in source) {
                c.skv_stage_open(this.#stage, source.name, options);
                return;
            }
            const { bytes, format, label, cautious } = source;
            options.cautious = cautious;
            withBytes(this.#library, bytes, (data) =>
                c.skv_stage_open_memory(this.#stage, data, bytes.length, format, label, options));
        });
    }

    /** What was asked for is there, or is not. */
    done(well: boolean) {
        this.current = well ? this.next : this.current;
        this.next = null;
    }
}
