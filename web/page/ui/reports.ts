// Reports: what became of what was asked for, as far as a reader is to be told.
import { effect } from '@preact/signals';
import type { Report } from '../simulation/protocol';
import { openScene } from './actions';
import { catalogue, complain, state, toast, world } from './model';
import { _ } from './words';

export function listenToReports(report: Report): void {
    if (report.error) {
        complain(report.error);
        if (!world.value?.name)
            openScene(catalogue.limits.first_scene); // no link, but water all the same
    }
}

let said = -1;

/** Of a recorded game that was played to its end is said whether it went as it went. */
effect(() => {
    const now = state.value;
    if (!now || said === now.worlds[0].opened || !(now.asRecorded || now.mismatch))
        return;
    said = now.worlds[0].opened;
    if (now.asRecorded)
        toast(_('The end: it went exactly as it was recorded'));
    else
        complain(
            _('This replay goes another way than when it was recorded: another version of Skvalp made it, or the file is damaged.'),
        );
});
