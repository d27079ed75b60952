// Refusal: why a field does not take what was typed. Invariant: it is what skv_field_refusal says, filled;
// words.test.ts sets the two against each other.
import type { Field } from '../simulation/protocol';
import { catalogue } from './model';
import { shown } from './numbers';
import { say, word } from './words';

/** In a sentence; null if it is taken. `plain` is as the library reads it. */
export function refusalOf({ type, minimum, maximum }: Pick<Field, 'type' | 'minimum' | 'maximum'>, plain: string): string | null {
    if (type !== 'number' && type !== 'integer')
        return null;
    const value = /^[-+]?\d+(\.\d+)?(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
    const [given, least, most] = [value, minimum, maximum].map(Math.fround);
    const taken = given >= least && given <= most && (type === 'number' || Number.isInteger(value));
    const words = catalogue.refusals[Number(type === 'integer')];
    return taken ? null : say(word(words), shown(String(minimum)), shown(String(maximum)));
}
