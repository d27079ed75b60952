// Choices: what a world is compared with, as in the app. Invariant: each changes nothing but what its
// label says.
import { computed, signal } from '@preact/signals';
import type { Settings, WorldState } from '../simulation/protocol';
import { simulation, state } from './model';
import { N_, _ } from './words';

interface Choice {
    label: string;
    settings: (world: WorldState) => Settings;
}

function liquid(material: string): Choice['settings'] {
    return () => ({ 'fluid.material': material });
}

function particles(times: number): Choice['settings'] {
    return (world) => ({ particles: String(Math.max(1, Math.round(world.particles * times))) });
}

export const choices: Choice[] = [
    { label: N_('The same, to be changed'), settings: () => ({}) },
    { label: N_('Water'), settings: liquid('water') },
    { label: N_('Oil'), settings: liquid('oil') },
    { label: N_('Honey'), settings: liquid('honey') },
    { label: N_('Mercury'), settings: liquid('mercury') },
    { label: N_('The pressure law as in the thesis'), settings: () => ({ 'fluid.law': 'clavet' }) },
    { label: N_('Four times as many particles'), settings: particles(4) },
    { label: N_('A quarter of the particles'), settings: particles(0.25) },
];

const chosen = signal(0);
/** What the second world is, in words. */
export const choice = computed(() => _(choices[chosen.value].label));

export function compareWith(index: number): void {
    const world = state.value?.worlds[0];
    if (!world)
        return;
    chosen.value = index;
    simulation.compare(choices[index].settings(world));
}
