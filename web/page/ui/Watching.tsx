// Watching: the sign that a replay plays, and the two things that can be done then. Loaded with the first.
import { useEffect } from 'preact/hooks';
import { showView } from './actions';
import { catalogue, part, simulation, toast } from './model';
import { prefer } from './preferences';
import { _ } from './words';

const withheld = part((s) => s.withheld, 0);
let told = withheld.peek();

/** As whoever shared it saw it, for this visit. */
export function adopt(view: string, overlays: string): void {
    if (showView(view))
        prefer({ overlays: overlays.split(',').filter((name) => catalogue.overlays.some((known) => known.name === name)) }, false);
}

export default function Watching() {
    useEffect(() => {
        if (withheld.value > told)
            toast(_('This is a replay: take it over to play with the water'));
        told = withheld.value;
    }, [withheld.value]);
    return (
        <div class="chips" role="group" aria-label={_('Replay')}>
            <span class="chip">{_('Replay')}</span>
            <button type="button" class="text" onClick={() => simulation.skip()}>
                {_('Skip to the End')}
            </button>
            <button
                type="button"
                class="text suggested"
                onClick={() => {
                    simulation.takeOver();
                    simulation.setPaused(false);
                }}
            >
                {_('Take Over')}
            </button>
        </div>
    );
}
