// Status: what is to be said of the picture, in words. Invariant: what changes at every picture is not
// in what screen readers are told unasked.
import { computed } from '@preact/signals';
import type { State, WorldState } from '../simulation/protocol';
import { catalogue, state } from './model';
import { fixed, quantity, short } from './numbers';
import { _, language, ngettext, say, word } from './words';

export function wordsOfPace({ going: { words, times } }: State): string {
    return say(word(words), short(times, 2));
}

export function wordsOfAmount(world: WorldState): string {
    return say(ngettext('%s particle', '%s particles', world.particles), fixed(world.particles, 0));
}

/** How much two gauges of the level differ, in whole cm: of columns that are to be compared. */
function wordsOfLevels(world: WorldState): string {
    const levels = world.probes
        .filter((probe) => catalogue.instruments[probe.kind] === 'level gauge')
        .slice(0, 2)
        .sort((a, b) => a.x0 - b.x0)
        .map((probe) => probe.y0 + probe.channels[0].value);
    if (levels.length < 2 || !levels.every(Number.isFinite))
        return '';
    const difference = Math.round(100 * (levels[0] - levels[1]));
    if (difference === 0)
        return _('both columns equally high');
    return difference > 0
        ? say(_('left column %s higher'), quantity(difference, 0, 'cm'))
        : say(_('right column %s higher'), quantity(-difference, 0, 'cm'));
}

/** What the live region says: it changes when something has happened, not with every picture. */
export const spoken = computed(() => {
    const now = state.value;
    if (!now || !language.value)
        return '';
    const world = now.worlds[0];
    const doing = now.paused ? _('paused') : now.atRest ? _('at rest') : _('playing');
    const view = catalogue.views.find(({ name }) => name === now.style.view);
    return [word(world.title), doing, view && word(view.title), wordsOfLevels(world)].filter(Boolean).join(', ');
});
