// Growing: what wants bodies goes on in a larger module, on the same canvas.
//
// Invariant: what is open goes on until the larger module is there; if that fails, it is reported.
import type { Library } from '../../src/library.js';
import { withBytes, written } from '../../src/memory.js';

import type { Listener, State } from './protocol';
import type { Simulator } from './simulation';

/** What nothing but the face knows. */
const known = ['setView', 'setUnits', 'setTilt', 'setHidden'];

let loading: Promise<any> | undefined, grown = false;

interface From {
    library: Library & { end(): unknown };
    files: Map<string, Uint8Array>;
}

/**
 * @param from which lacks them; `listener` is its own
 * @param asked what was last asked of its methods
 * @param foresees they are not wanted yet: what is open goes on from this moment
 * @param load brings the larger module
 * @param make a simulation of it, which is asked from now on
 */
export async function grow<Loaded extends From>(from: Simulator, { library, files }: Loaded, listener: Listener,
    asked: Map<string, unknown[]>, foresees: boolean, load: () => Promise<Loaded>,
    make: (larger: Loaded, listener: Listener) => Simulator) {
    const { opening, worlds } = from.playing, { c } = library, { stage } = worlds;
    /** Of each world what replays do not have: key frames, without the first, and what was undone. */
    let keys: Uint8Array[][] = [], branches: Uint8Array[][] = [];
    /** What the module hands out of each world by one of its functions, from a number on. */
    const handedOut = (write: string, first: number) => worlds.all.map((_, side) => {
        const list = [];
        for (let i = first, one; (one = written(library, (add, user) =>
            library.instance.exports[write](stage, side, i, add, user))).length > 0; i++) {
            list.push(one);
        }
        return list;
    });
    /** What is open, from its start; if it would be missed with all that was done, which can be undone and shared then. */
    const again = async () => {
        if (!c.skv_control_would_be_missed(stage)) {
            return opening.current;
        }
        await from.playing.settled('save', () => c.skv_stage_save_moment(stage, 'kept'));
        await from.playing.settled('save', () => c.skv_stage_save(stage, 'kept.skvr'));
        keys = handedOut('skv_wasm_write_key', 1);
        branches = handedOut('skv_wasm_write_branch', 0);
        return kept('kept.skvr');
    };
    const kept = (path: string) =>
        ({ source: { bytes: files.get(path)!, format: 'skvr' as const, label: 'kept', cautious: false }, settings: {} });
    loading ??= load();
    try {
        const larger: Loaded = await loading;
        await larger.library.instance.bringCodecs();
        while (foresees && !grown && opening.current && !opening.next) {
            const before = worlds.first.opened, here = await again();
            if (!opening.next && worlds.first.opened === before) {
                opening.next = here;
            } else { // something else was opened meanwhile, which goes on
                keys = [];
            }
        }
        if (grown || !opening.next) {
            return;
        }
        grown = true;
        let quiet = true, own = -1;
        const { opened, moment } = worlds.first, last = from.end();
        const now = make(larger, {
            ...listener,
            state: (state: State) => {
                state.worlds.forEach((world) => (world.opened += opened));
                state.asRecorded &&= state.worlds[0].opened !== own; // nobody has recorded it
                if (!quiet) {
                    listener.state(state);
                }
            },
        });
        known.filter((name) => asked.has(name)).forEach((name) => (now as any)[name](...asked.get(name)!));
        now.setStyle(last.style);
        now.setParticles(last.chosen ?? 0);
        now.setTool(last.tool);
        now.setDye(last.dye);
        now.setLinked(last.linked);
        now.setSpeed(last.speed);
        now.setPaused(last.paused);
        const { source, settings } = opening.next;
        if ('name' in source) { // how many particles it has here nobody knew without its text
            now.playing.opening.scene(source.name, settings);
        } else {
            now.playing.opening.open(opening.next);
        }
        now.playing.asked();
        const { first, stage: its, all } = now.playing.worlds;
        if (keys.length && first.opened) {
            const handIn = (take: string, handed: Uint8Array[][]) => all.forEach((_, side) => handed[side].forEach((one) =>
                withBytes(larger.library, one, (data) => larger.library.instance.exports[take](its, side, data))));
            handIn('skv_wasm_take_key', keys);
            handIn('skv_wasm_take_branch', branches);
            own = first.opened + opened;
            now.seek(Number(moment));
            now.takeOver();
            now.setPaused(last.paused);
        } else if (keys.length) { // more was done than is read, or there is no memory for it
            now.playing.opening.open(kept('kept'));
        }
        quiet = false;
        now.playing.asked();
        void library.end();
    } catch (error) {
        loading = undefined;
        listener.report({ kind: 'open', error: (error as Error).message });
    }
}
