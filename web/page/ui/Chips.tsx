// Chips: readings in a row below the picture; each opens the card with its plot.
import type { Probe } from '../simulation/protocol';
import { channelOf, gaugeOf } from './instruments';
import { panel, showPanel, simulation, state, subject } from './model';
import { readingText } from './numbers';
import { _, word } from './words';

/** 1 cm, with Shift 1 mm. */
function onKey(event: KeyboardEvent, probe: Probe): void {
    const distance = event.shiftKey ? 0.001 : 0.01;
    const dx = Number(event.key === 'ArrowRight') - Number(event.key === 'ArrowLeft');
    const dy = Number(event.key === 'ArrowUp') - Number(event.key === 'ArrowDown');
    if (event.key === 'Delete')
        simulation.removeProbe(probe.id);
    else if (dx || dy)
        simulation.shiftProbe(probe.id, dx * distance, dy * distance);
    else
        return;
    event.preventDefault();
    event.stopPropagation();
}

/** A new one comes last, in a row that may be wider than the page. */
const comeIntoSight = (chip: HTMLElement | null) => chip?.scrollIntoView({ block: 'nearest', inline: 'nearest' });

export default function Chips() {
    const [first, second] = state.value?.worlds ?? [];
    if (!first)
        return null;
    return (
        <div class="chips" role="group" aria-label={_('Measurements')}>
            {first.probes.map((probe) => {
                const beside = second?.probes.find((other) => other.id === probe.id);
                const reading = readingText(channelOf(probe));
                const open = panel.value === 'probe' && subject.value === probe.id;
                return (
                    <button
                        type="button"
                        key={probe.id}
                        ref={comeIntoSight}
                        class="chip"
                        data-arrows
                        aria-expanded={open}
                        title={_('Plot; arrow keys move it, Delete takes it away')}
                        onClick={() => showPanel(open ? null : 'probe', probe.id)}
                        onKeyDown={(event) => onKey(event, probe)}
                    >
                        <span class="letter">{probe.id}</span>
                        {word(gaugeOf(probe).title)}
                        <strong class="numeric">
                            {beside
                                ? `A: ${reading}  B: ${readingText(channelOf(beside))}`
                                : reading}
                        </strong>
                    </button>
                );
            })}
        </div>
    );
}
