// Address: what it says of how the page begins (docs/embed.md). Invariant: it counts for this visit alone.
import { openScene, showView } from './actions';
import { beginAmounts } from './amounts';
import { catalogue, controls, embedded, framed, simulation, toast } from './model';
import { lessMotion } from './preferences';
import { opened } from './reports';
import { _, known } from './words';

export function readAddress() {
    const asked = new URLSearchParams(location.search);
    embedded.value = asked.get('embed') === '1';
    document.documentElement.classList.toggle('framed', framed);
    const wanted = asked.get('controls');
    controls.value = wanted === 'none' || wanted === 'play' ? wanted : 'all';

    /** Also after the address has changed: another link, or the way back from one. */
    function openAsked(): void {
        const scene = asked.get('scene'), isKnown = catalogue.scenes.some(({ name }) => name === scene);
        if (location.hash.length > 1)
            simulation.openLink(location.hash.slice(1));
        else
            openScene(isKnown ? scene! : catalogue.limits.first_scene);
    }

    function open(): void {
        if (location.search) {
            const first = opened().catch(() => undefined);
            void import('./asked').then((module) => first.then(() => module.answer(asked)));
        }
        beginAmounts(Number(asked.get('particles')) || 0);
        const waits = asked.get('paused') === '1';
        const rests = !waits && lessMotion.value && controls.value !== 'none' && asked.get('paused') !== '0';
        if (waits || rests)
            simulation.setPaused(true); // before there is water, or it moves until it hears of this
        openAsked();
        showView(asked.get('view'));
        if (rests)
            toast(_('The system asks for less motion: the water waits until you press Play.'));
    }

    const language = asked.get('lang') ?? '';
    return { language: known.includes(language) ? language : '', open, openAsked };
}
