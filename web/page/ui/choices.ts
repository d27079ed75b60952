// Choices: what the world is compared with.
import { computed, signal } from '@preact/signals';
import { catalogue, simulation } from './model';
import { word } from './words';

const chosen = signal('same');
/** What the second world is, in words. */
export const choice = computed(() => word(catalogue.choices.find(({ name }) => name === chosen.value)!.title));

export function compareWith(name: string): void {
    chosen.value = name;
    simulation.compareWith(name);
}
