// Reports: what became of what was asked for, as far as a reader is to be told.
import { effect } from '@preact/signals';
import type { Report } from '../simulation/protocol';
import { openScene } from './actions';
import { catalogue, complain, remark, state, toast, world } from './model';
import { _, said } from './words';

/** Who waits for what becomes of what was opened. */
const waiting: ((error: string | null) => void)[] = [];

/** When what was asked for last is open; fails if it can't be. */
export function opened(): Promise<void> {
    return new Promise((resolve, reject) =>
        waiting.push((error) => (error === null ? resolve() : reject(new Error(error)))));
}

export function listenToReports(report: Report): void {
    if (report.kind === 'open')
        waiting.splice(0).forEach((tell) => tell(report.error));
    if (report.error) {
        complain(report.error);
        if (!world.value?.name)
            openScene(catalogue.limits.first_scene); // no link, but water all the same
    }
}

let ended = -1, shown = 0;

/** What was shared is seen as it was; what there is to say of a scene is said once. */
effect(() => {
    const { opened = 0, view, overlays = '', notes = [] } = world.value ?? {};
    if (shown === opened)
        return;
    shown = opened;
    if (view)
        void import('./Watching').then(({ adopt }) => adopt(view, overlays));
    remark(notes.map(said));
});

/** Of a recorded game that was played to its end is said whether it went as it went. */
effect(() => {
    const now = state.value;
    if (!now || ended === now.worlds[0].opened || !(now.asRecorded || now.mismatch))
        return;
    ended = now.worlds[0].opened;
    if (now.asRecorded)
        toast(_('The end: it went exactly as it was recorded'));
    else
        complain(
            _('This replay goes another way than when it was recorded: another version of Skvalp made it, or the file is damaged.'),
        );
});
