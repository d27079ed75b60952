// What the library says, in the language of the reader: a message is compared with the templates that are
// translated (scripts/update-po.sh takes them from the library's sources), and what stands where they have
// %s is filled in. Invariant: what no template fits is as it was; app/said.c does the same. It comes with
// the words of a language, so English readers do not fetch it.
import { shown } from './numbers';

type Words = ReadonlyMap<string, string | string[]>;

function formOf(english: string) {
    const parts = english.split('%s').map((part) => part.replace(/[$()*+.?[\\\]^{|}]/g, '\\$&'));
    return { english, form: new RegExp(`^${parts.join('(.*?)')}$`, 's'), certain: english.replaceAll('%s', '').length };
}

/** Says messages in these words: "a.png: skadad PNG: en kontrollsumma är fel; ...". */
export function sayerOf(words: Words): (english: string) => string {
    // What has no words is a form of anything.
    const templates = [...words.keys()].filter((english) => /[a-z]+ [(]?[a-z]{2,}/.test(english) && english.includes('%s'))
        .map(formOf).sort((a, b) => b.certain - a.certain);
    const exact = (text: string) => {
        const found = words.get(text);
        return typeof found === 'string' ? found : null;
    };
    // "0.25 m": a number, and a unit if there is one.
    const argument = (text: string) => {
        const [, number, unit] = /^(\S+)( \S+)?$/.exec(text) ?? [];
        return /^[-+]?\d+(\.\d+)?(e[-+]?\d+)?$/i.test(number) ? shown(number) + (unit ?? '') : say(text);
    };
    // What text fits as a whole, and by how many characters that are not filled in.
    function fitOf(text: string): { certain: number; told: () => string } | null {
        const told = exact(text);
        if (told !== null)
            return { certain: text.length, told: () => told };
        for (const { english, form, certain } of templates) {
            const found = form.exec(text);
            let next = 1;
            if (found)
                return { certain, told: () => exact(english)!.replace(/%s/g, () => argument(found[next++] ?? '')) };
        }
        return null;
    }
    // By itself, or behind names of files, places and fields: "a.json:2: gravity: is empty". The longest text
    // that fits counts, for a short one takes names for what it is about.
    function whole(text: string): string | null {
        let best = fitOf(text), names = '';
        for (let at = -1; (at = text.indexOf(': ', at + 1)) >= 0;) {
            const fit = fitOf(text.slice(at + 2));
            if (fit && fit.certain > (best?.certain ?? 0))
                [best, names] = [fit, text.slice(0, at)];
        }
        return best && (names ? `${say(names)}: ${best.told()}` : best.told());
    }
    // In two parts, if that helps: "FILE: what is wrong; what to do".
    function parts(text: string, between: string): string | null {
        const at = text.indexOf(between), rest = text.slice(at + between.length);
        if (at < 0)
            return null;
        const said = say(text.slice(0, at)) + between + say(rest);
        return said === text ? null : said;
    }
    // "abc" is not a number: a value, and what is wrong with it.
    function complaint(text: string): string | null {
        const at = text.indexOf(' is '), words = at < 0 ? null : exact(text.slice(at + 1));
        return words && `${argument(text.slice(0, at))} ${words}`;
    }
    function say(text: string): string {
        return whole(text) ?? parts(text, '; ') ?? parts(text, ': ') ?? complaint(text) ?? text;
    }
    return say;
}
