// Probe card: one instrument's readings, its plot with what theory says, and what else can be done.
// Invariant: its history is kept while the card is open.
import { useEffect, useLayoutEffect } from 'preact/hooks';
import type { Curve, Probe } from '../simulation/protocol';
import { download } from './files';
import { channelOf, gaugeOf } from './instruments';
import { Icon } from './Icon';
import { showPanel, simulation, state, subject } from './model';
import { Plot } from './Plot';
import { readingText } from './numbers';
import { tableOf } from './tables';
import { _, quantityText, say, word } from './words';

function curveOf(probe: Probe, channel: number, label: string, style: Curve['style']): Curve {
    const { size } = probe.channels[channel];
    const values = probe.values?.[channel] ?? new Float64Array();
    return { label, style, x: probe.times ?? new Float64Array(), y: values.map((value) => value / size) };
}

/** Both worlds' curves, and over them what theory says. */
function curvesOf(probe: Probe, beside: Probe | undefined): Curve[] {
    const main = gaugeOf(probe).channel;
    const name = word(probe.channels[main].name);
    const curves = [curveOf(probe, main, beside ? _('World A') : name, 'line')];
    if (beside)
        curves.push(curveOf(beside, main, _('World B'), 'dots'));
    const theory = probe.channels[main + 1];
    if (theory?.theory) {
        curves.push(curveOf(probe, main + 1, say(_('theory: %s'), word(theory.name)), 'theory'));
        if (beside)
            curves.push(curveOf(beside, main + 1, _('theory, B'), 'theory'));
    }
    return curves;
}

export default function ProbeCard() {
    const id = subject.value;
    const worlds = state.value?.worlds ?? [];
    const probe = worlds[0]?.probes.find((one) => one.id === id);
    const beside = worlds[1]?.probes.find((one) => one.id === id);
    useEffect(() => {
        simulation.watchProbe(id, true);
        return () => simulation.watchProbe(id, false);
    }, [id]);
    useLayoutEffect(() => {
        if (!probe)
            showPanel(null); // it was taken away
    }, [probe === undefined]);
    if (!probe)
        return null;
    const title = word(gaugeOf(probe).title);
    const main = channelOf(probe);
    const yLabel = quantityText(main.name, main.unit);
    const curves = curvesOf(probe, beside);
    const save = () => download(tableOf(curves, _('time (s)'), yLabel), 'text/csv', 'readings.csv');
    return (
        <>
            <h3>{`${id}  ${title}`}</h3>
            <Plot xLabel={_('time (s)')} yLabel={yLabel} curves={curves} name={`${title}: ${readingText(main)}`} />
            <dl class="readings numeric">
                {probe.channels.map((channel, i) => (
                    <div key={channel.name}>
                        <dt>{word(channel.name)}</dt>
                        <dd>
                            {readingText(channel)}
                            {beside && ` · B: ${readingText(beside.channels[i])}`}
                        </dd>
                    </div>
                ))}
            </dl>
            <div class="row">
                <button type="button" class="text" onClick={save}>
                    <Icon name="save" />
                    CSV
                </button>
                <button type="button" class="text" onClick={() => simulation.removeProbe(id)}>
                    {_('Remove')}
                </button>
            </div>
        </>
    );
}
