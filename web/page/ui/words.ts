// Words: what the page says, in the reader's language. Invariant: every
// text that people see went through _() or word(); the translations are the app's, from po/.
import { signal } from '@preact/signals';
import { languages } from 'virtual:words';

/** The language that is spoken. */
export const language = signal('en');
let words = new Map<string, string | string[]>();
let sayer: ((english: string) => string) | null = null;

/** Languages that there are: 'en', and those of po/. */
export const known = ['en', ...Object.keys(languages)];

/** The first language that is known of those that the reader's browser prefers. */
export function preferred(): string {
    return navigator.languages.map((tag) => tag.split('-')[0]).find((tag) => known.includes(tag)) ?? 'en';
}

export async function speak(tag: string): Promise<void> {
    const load = Object.hasOwn(languages, tag) ? languages[tag] : undefined;
    const loaded = await load?.();
    words = new Map(loaded && Object.entries(loaded.default));
    sayer = loaded ? loaded.sayerOf(words) : null;
    language.value = load ? tag : 'en';
}

/** A text of the library's tables. */
export function word(text: string): string {
    void language.value; // what shows it follows the language
    const found = words.get(text);
    return (typeof found === 'string' ? found : found?.[0]) ?? text;
}

/** A message of the library, its units as people write them: "to 1000 m/s²". */
export const said = (text: string): string => (sayer?.(text) ?? text).replace(/( (?:kg\/)?m(?:\/s)?)\^2/g, '$1²');

/** A text of the page's own: xgettext finds these. */
export const _ = word;

/** Marks a text for xgettext where it can't be translated yet. */
export const N_ = (text: string): string => text;

export function ngettext(one: string, many: string, count: number): string {
    const found = language.value && words.get(one);
    const forms = Array.isArray(found) ? found : [one, many];
    return count === 1 ? forms[0] : forms[1];
}

/** The text with its printf formats filled: %s, %c, %d, %%. */
export function say(text: string, ...values: (string | number)[]): string {
    let next = 0;
    return text.replace(/%[%scd]/g, (format) => (format === '%%' ? '%' : String(values[next++])));
}

/** "Radius ratio" of fluid.radius_ratio, as the app names a parameter. */
export function titleOfPath(path: string): string {
    const name = path.slice(path.lastIndexOf('.') + 1).replaceAll('_', ' ');
    return word(name.charAt(0).toUpperCase() + name.slice(1));
}

/** "pressure (cm of water)". */
export function quantityText(name: string, unit: string): string {
    return unit ? `${word(name)} (${word(unit)})` : word(name);
}
