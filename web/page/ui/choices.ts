// Choices: what the world is compared with.
import { computed } from '@preact/signals';
import { catalogue, part } from './model';
import { word } from './words';

const chosen = part((s) => s.choice, '');
/** What the second world is, in words. */
export const choice = computed(() =>
    word((catalogue.choices.find(({ name }) => name === chosen.value) ?? catalogue.choices[0]).title));
