// Numbers as people read and type them. Invariant: each is written and read as skvalp/numbers.h has it,
// with the signs of its table; words.test.ts sets the two against each other.
import type { Channel } from '../simulation/protocol';
import { catalogue } from './model';
import { language, word } from './words';

export function signs() {
    const { numerals } = catalogue;
    return numerals.find((known) => known.language === language.value) ?? numerals[0];
}

/** With so many decimals, or as many of them as are not 0 at the end. */
export function fixed(value: number, decimals: number, trimmed = false): string {
    const size = Math.abs(value);
    if (!(size < 1e15))
        return '–';
    const { decimal, group, minus } = signs();
    const [whole, part = ''] = size.toFixed(decimals).split('.');
    const kept = trimmed ? part.replace(/0+$/, '') : part;
    const sign = value < 0 && /[1-9]/.test(whole + kept) ? minus : '';
    return `${sign}${whole.replace(/\B(?=(\d{3})+$)/g, group)}${kept && decimal + kept}`;
}

/** With so many significant digits; whole ones are never rounded away. */
export function short(value: number, digits: number): string {
    const size = Math.abs(value);
    let decimals = digits - 1;
    for (let power = 10; decimals > 0 && size >= power; power *= 10)
        decimals--;
    for (let power = 1; decimals < 9 && size < power; power /= 10)
        decimals++;
    return fixed(value, decimals, true);
}

/** "2,4 s": with a unit. */
export function quantity(value: number, decimals: number, unit: string): string {
    return withUnit(fixed(value, decimals), unit);
}

export function withUnit(number: string, unit: string): string {
    return unit && number !== '–' ? `${number}${signs().group}${word(unit)}` : number;
}

/** A reading, "2,5 cm vatten", or why there is none. */
export function readingText({ value, lack, unit, size, decimals }: Channel): string {
    if (lack)
        return word(lack);
    const shown = value / size;
    return withUnit(decimals < 0 ? short(shown, 4) : fixed(shown, decimals), unit);
}

/** What was typed, as the library takes it: "-9.81". */
export function typed(text: string): string {
    const plain = text.replace(/\s/g, '').replaceAll('−', '-');
    const parts = signs().decimal === '.' && /,\d{3}$/.test(plain);
    const read = parts ? plain : plain.replaceAll(',', '.');
    return /^[-+]?\d+(\.\d+)?(e[-+]?\d+)?$/i.test(read) ? read : text;
}

/** The reverse for a field: "−9,81". */
export function shown(plain: string): string {
    return /^-?\d+(\.\d+)?(e[-+]?\d+)?$/.test(plain) ? short(Number(plain), 9) : plain;
}
