// Words: formats, figures and translations as people read them.
import { expect, test } from 'vitest';

import { readPo } from '../../tools/words.js';
import { countText, general, ngettext, readingText, say, speak, titleOfPath, word } from './words';

test('formats are filled as printf does', () => {
    expect(say('%.1f s (−%.1f)', 12.34, 0.26)).toBe('12.3 s (−0.3)');
    expect(say('%.2g× of real time', 0.4321)).toBe('0.43× of real time');
    expect(say('%s: %d, %g, 100 %%', 'a', 3, 0.5)).toBe('a: 3, 0.5, 100 %');
    expect(say('%s', '%s')).toBe('%s');
});

test('large counts are in groups', () => {
    expect(countText(2960)).toBe('2960');
    expect(countText(12960)).toBe('12\u202f960');
    expect(countText(1234567)).toBe('1\u202f234\u202f567');
});

test('parameters are named as the app names them', () => {
    expect(titleOfPath('fluid.radius_ratio')).toBe('Radius ratio');
    expect(titleOfPath('particles')).toBe('Particles');
});

test('Swedish comes from po/, with its decimals and plurals', async () => {
    await speak('sv');
    expect(word('Pause')).toBe('Pausa');
    expect(word('a text that nobody translates')).toBe('a text that nobody translates');
    expect(word('constructor')).toBe('constructor');
    expect(readingText('2.5 cm of water')).toMatch(/^2,5 \S+/);
    expect(general(0.123456, 3)).toBe('0,123');
    expect(say(ngettext('%s particle', '%s particles', 2), '2')).toBe('2 partiklar');
    await speak('en');
    expect(say(ngettext('%s particle', '%s particles', 1), '1')).toBe('1 particle');
});

test('texts over several lines, quoted signs and plurals are read', () => {
    const entries = readPo([
        'msgid ""\nmsgstr "Language: sv\\n"',
        '#. dye\nmsgid ""\n"a \\"b\\"\\n"\n"c"\nmsgstr "d"',
        '#, c-format\nmsgid "%s e"\nmsgid_plural "%s es"\nmsgstr[0] "f"\nmsgstr[1] "g"',
        'msgid "untranslated"\nmsgstr ""',
    ].join('\n\n'));
    expect(entries).toEqual([
        { id: 'a "b"\nc', forms: ['d'], fromTable: true },
        { id: '%s e', forms: ['f', 'g'], fromTable: false },
    ]);
});
