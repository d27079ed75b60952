// Probes: what an instrument is called, and what is read of it.
import type { Probe } from '../simulation/protocol';
import { catalogue } from './model';

/** One of those that people choose; an experiment may have others. */
export function gaugeOf({ kind }: Probe) {
    const other = { kind, title: catalogue.instruments[kind], line: false, box: false, channel: 0 };
    return catalogue.gauges.find((gauge) => gauge.kind === kind) ?? other;
}

export function channelOf(probe: Probe) {
    return probe.channels[gaugeOf(probe).channel] ?? probe.channels[0];
}
