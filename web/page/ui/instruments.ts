// Probes: which instruments there are, where a new one goes, and what is read of it. Invariant: where
// an instrument is, is the simulation's; here is only what it is called and how it is handled.
import type { Probe } from '../simulation/protocol';
import { catalogue, simulation, state } from './model';
import { N_ } from './words';

/** What can be chosen: by one point, or two if it is a line; and the channel that it is read for. */
export const kinds = [
    { name: 'pressure probe', title: N_('Pressure'), line: false, channel: 0 },
    { name: 'velocity probe', title: N_('Speed'), line: false, channel: 2 },
    { name: 'level gauge', title: N_('Water level'), line: true, channel: 0 },
    { name: 'ruler', title: N_('Ruler'), line: true, channel: 0 },
    { name: 'flow gate', title: N_('Flow through a gate'), line: true, channel: 0 },
    { name: 'force meter', title: N_('Force on walls'), line: true, channel: 1 },
];

/** Those of them that the library has. */
export function offered() {
    return kinds.filter((kind) => catalogue.instruments.some((known) => known.name === kind.name));
}

export function kindOf(number: number) {
    const name = catalogue.instruments.find((known) => known.kind === number)?.name ?? '';
    return kinds.find((kind) => kind.name === name) ?? { name, title: name, line: false, channel: 0 };
}

export function channelOf(probe: Probe) {
    return probe.channels[kindOf(probe.kind).channel] ?? probe.channels[0];
}

/** Puts one into the middle of what is seen, beside those before, low, where water is. */
export function addProbe(name: string): void {
    const known = catalogue.instruments.find((instrument) => instrument.name === name);
    const world = state.value?.worlds[0];
    if (!known || !world)
        return;
    const { camera, area } = world;
    const clamp = (value: number, most: number): number => Math.min(most, Math.max(0, value));
    const middleX = (area.x + area.width / 2 - camera.originX) / camera.scale;
    const middleY = (camera.originY - area.y - area.height / 2) / camera.scale;
    const reach = (0.15 * Math.min(world.width, world.height)) / camera.zoom;
    const x = middleX + 0.05 * world.width * ((world.probes.length % 8) - 3);
    const y = middleY - (0.2 * world.height) / camera.zoom;
    let [x1, y1] = [x, y];
    if (name === 'level gauge')
        y1 = middleY + (0.4 * world.height) / camera.zoom;
    else if (name === 'flow gate')
        y1 += 2 * reach;
    else if (kindOf(known.kind).line)
        [x1, y1] = [x + 2 * reach, y + (name === 'force meter' ? reach : 0)];
    simulation.addProbe(
        known.kind,
        clamp(x, world.width),
        clamp(y, world.height),
        clamp(x1, world.width),
        clamp(y1, world.height),
    );
}

export function moveProbe(probe: Probe, dx: number, dy: number): void {
    simulation.moveProbe(probe.id, probe.x0 + dx, probe.y0 + dy, probe.x1 + dx, probe.y1 + dy);
}
