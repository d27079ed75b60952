// Address: what it says of how the page begins (docs/embed.md). Invariant: it counts for this visit alone.
import { openScene, showView } from './actions';
import { beginAmounts } from './amounts';
import { catalogue, complain, controls, embedded, framed, showPanel, simulation, toast } from './model';
import { lessMotion } from './preferences';
import { payloadOf } from './links';
import { _, known } from './words';

export function readAddress() {
    const asked = new URLSearchParams(location.search);
    embedded.value = asked.get('embed') === '1';
    document.documentElement.classList.toggle('framed', framed);
    const wanted = asked.get('controls');
    controls.value = wanted === 'none' || wanted === 'play' ? wanted : 'all';

    function openHash(): boolean {
        const payload = location.hash ? payloadOf(location.href) : null;
        if (payload)
            simulation.openLink(payload);
        else if (location.hash.length > 1)
            complain(_('This link is damaged or cut short: copy all of it.'));
        return payload !== null;
    }

    function openAsked(): void {
        const scene = asked.get('scene') ?? catalogue.limits.first_scene;
        const isKnown = catalogue.scenes.some(({ name }) => name === scene);
        if (!openHash())
            openScene(isKnown ? scene : catalogue.limits.first_scene);
        if (!isKnown)
            complain(`${_('There is no scene of this name.')} (${scene})`);
    }

    /** After the address has changed: another link, or the way back from one. */
    function openAnew(): void {
        if (location.hash.length > 1)
            openHash();
        else
            openAsked();
    }

    function open(): void {
        beginAmounts(Number(asked.get('particles')) || 0);
        const waits = asked.get('paused') === '1';
        const rests = !waits && lessMotion.value && controls.value !== 'none' && asked.get('paused') !== '0';
        if (waits || rests)
            simulation.setPaused(true); // before there is water, or it moves until it hears of this
        openAsked();
        showView(asked.get('view'));
        if (asked.has('bench'))
            showPanel('bench');
        if (rests)
            toast(_('The system asks for less motion: the water waits until you press Play.'));
    }

    const language = asked.get('lang') ?? '';
    return { language: known.includes(language) ? language : '', open, openAnew };
}
