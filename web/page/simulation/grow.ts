// Growing: what wants bodies goes on in a larger module, on the same canvas.
//
// Invariant: what is open goes on until the larger module is there; if that fails, it is reported.
import type { Library } from '../../src/library.js';

import type { Listener, State } from './protocol';
import type { Simulator } from './simulation';

/** What nothing but the face knows. */
const known = ['setView', 'setUnits', 'setTilt', 'setHidden'];

/** For how long people are let wait until a game has been played again, ms. */
const MOST_AGAIN = 4000;
let loading: Promise<any> | undefined, grown = false, told = -1;

interface From {
    library: Library & { end(): unknown };
    files: Map<string, Uint8Array>;
}

/**
 * @param from which lacks them; `listener` is its own
 * @param asked what was last asked of its methods
 * @param foresees they are not wanted yet: what is open goes on from this moment
 * @param before the tool that was chosen so far, which stays if people are to be told first what they would lose
 * @param load brings the larger module
 * @param make a simulation of it, which is asked from now on
 */
export async function grow<Loaded extends From>(from: Simulator, { library, files }: Loaded, listener: Listener,
    asked: Map<string, unknown[]>, foresees: boolean, before: number | undefined, load: () => Promise<Loaded>,
    make: (larger: Loaded, listener: Listener) => Simulator) {
    const { opening, worlds } = from.playing, { c } = library, { stage } = worlds;
    let reached: number | null = null, own = -1;
    const whole = Number(worlds.first.moment) * worlds.first.step_ms <= MOST_AGAIN;
    /**
     * What is open, from its start. If it would be missed: with all that was done, which can be undone and shared
     * then, or at this moment alone if it takes too long to play again.
     */
    const again = async () => {
        if (!c.skv_control_would_be_missed(stage)) {
            return opening.current;
        }
        const path = whole ? 'kept.skvr' : 'kept';
        await from.playing.settled('save', () => (whole ? c.skv_stage_save : c.skv_stage_save_moment)(stage, path));
        reached = whole ? Number(worlds.first.moment) : null;
        const bytes = files.get(path)!;
        return { source: { bytes, format: 'skvr' as const, label: 'kept', cautious: false }, settings: {} };
    };
    if (foresees && !grown && told !== worlds.first.opened && !whole && c.skv_control_would_be_missed(stage)) {
        told = worlds.first.opened;
        from.setTool(before!);
        listener.report({ kind: 'anew', error: null });
        return;
    }
    loading ??= load();
    try {
        const larger: Loaded = await loading;
        await larger.library.instance.bringCodecs();
        if (foresees && !grown) {
            opening.next ??= await again();
        }
        if (grown || !opening.next) { // something else was opened meanwhile
            return;
        }
        grown = true;
        let quiet = true;
        const { opened } = worlds.first, last = from.end();
        const now = make(larger, {
            ...listener,
            state: (state: State) => {
                state.worlds.forEach((world) => (world.opened += opened));
                if (reached !== null && state.watching) {
                    const to = reached;
                    reached = null; // what is asked for is told of in states, too
                    own = state.worlds[0].opened;
                    now.seek(to);
                    now.takeOver();
                    now.setPaused(last.paused);
                }
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
        quiet = false;
        const { source, settings } = opening.next;
        if ('name' in source) { // how many particles it has here nobody knew without its text
            now.playing.opening.scene(source.name, settings);
        } else {
            now.playing.opening.open(opening.next);
        }
        now.playing.asked();
        void library.end();
    } catch (error) {
        loading = undefined;
        listener.report({ kind: 'open', error: (error as Error).message });
    }
}
