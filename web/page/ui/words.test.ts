// Words: formats, numbers and translations as people read them.
import { beforeAll, expect, test } from 'vitest';

import { makeCatalogue } from '../simulation/catalogue';
import { loadLibrary, loadWhole } from '../simulation/testing';
import { readPo } from '../../tools/words.js';
import { begin } from './model';
import { fixed, quantity, readingText, short, shown, typed } from './numbers';
import { refusalOf } from './refusal';
import { known, language, ngettext, said, say, speak, titleOfPath, word } from './words';

const reading = { name: '', lack: '', theory: false };

beforeAll(() => begin(null as never, makeCatalogue(loadLibrary().library)));

test('formats are filled as printf does', () => {
    expect(say('%s (%s)', 12.3, '−0.3')).toBe('12.3 (−0.3)');
    expect(say('%s: %d, 100 %%', 'a', 3)).toBe('a: 3, 100 %');
    expect(say('%s', '%s')).toBe('%s');
});

test('numbers are written and read as the library does, in every language', async () => {
    const library = await loadWhole(), { c } = library;
    const text = (digits: { text: string; address: number }) => {
        const { text: written } = digits;
        library.release(digits);
        return written;
    };
    const room = library.instance.allocate(64);
    let random = 1;
    for (const tag of known) {
        await speak(tag);
        expect(language.value).toBe(tag);
        const numerals = c.skv_numerals_of(tag);
        expect(library.view('skv_numerals', numerals).language).toBe(tag); // it has a row of its own
        const values = [0, -0.004, -0.005, 0.25, 2.5, 999.95, 1200, -9.81, 1e-6, 1e15, NaN, Infinity];
        for (let i = 0; i < 500; i++) {
            random = (random * 16807) % 2147483647;
            values.push((random - 1073741823) * 2 ** (-40 + (i % 50)));
        }
        for (const [i, value] of values.entries()) {
            expect(fixed(value, i % 10)).toBe(text(c.skv_number(value, i % 10, numerals)));
            const written = short(value, 1 + (i % 9));
            expect(written).toBe(text(c.skv_number_short(value, 1 + (i % 9), numerals)));
            const plain = String(value);
            expect(shown(plain)).toBe(text(c.skv_number_shown(plain, numerals)));
            for (const said of [written, plain, '1,200', '1,25', '1,2,3', 'honey', '12 honeys', '', '1e-3', ' 1 200 ']) {
                c.skv_number_read(said, numerals, room, 64);
                expect(typed(said)).toBe(library.instance.text(room));
            }
        }
        for (const [si, plain] of [['Pa m', true], ['Pa m', false], ['m', true], ['', true], ['1/s', true]] as const) {
            const unit = c.skv_unit_of(si, plain);
            const { name, size, decimals } = unit;
            const number = text(c.skv_number_in(2403.45, unit as never, numerals));
            expect(readingText({ ...reading, value: 2403.45, unit: name, size, decimals }))
                .toBe(name ? `${number}\u00a0${word(name)}` : number);
        }
    }
});

test('numbers are as Swedish has them', async () => {
    await speak('sv');
    expect(quantity(19.3, 1, 'cm')).toBe('19,3\u00a0cm');
    expect(quantity(NaN, 1, 'cm')).toBe('–');
    expect(shown('-9.81')).toBe('−9,81');
    expect(shown('1e-06')).toBe('0,000001');
    expect(fixed(1200, 0)).toBe('1\u00a0200');
    expect(typed('−9,81')).toBe('-9.81');
    await speak('en');
});

test('a refused number is told as the library tells it', async () => {
    const library = await loadWhole(), { c } = library;
    const texts = ['', 'abc', '1,5', '0', '-0', '1.5', '-1', '7', '1e9', '-1e9', '0.05', '1e-7', '1 000', '0x10', 'nan'];
    const { parameters, sceneFields } = makeCatalogue(library);
    const fields = new Map<string, number>();
    for (const at of [c.skv_world_field, c.skv_scene_field])
        for (let i = 0, field; (field = at(i)) !== 0; i++)
            fields.set(library.view('skv_field', field).path, field);
    let refused = 0;
    for (const field of [...parameters, ...sceneFields])
        for (const text of texts.concat(shown(String(field.minimum)), String(field.maximum))) {
            const words = c.skv_field_refusal(fields.get(field.path)!, text);
            const told = words && say(words, shown(String(field.minimum)), shown(String(field.maximum)));
            expect(refusalOf(field, text), `${field.path}=${text}`).toBe(told);
            refused += Number(told !== null);
        }
    expect(refused).toBeGreaterThan(50);
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
    expect(readingText({ ...reading, value: 245, unit: 'cm of water', size: 98.1, decimals: 1 })).toMatch(/^2,5\u00a0\S+/);
    expect(readingText({ ...reading, value: NaN, lack: 'no water here', unit: 'cm', size: 1, decimals: 1 }))
        .toBe('inget vatten här');
    expect(say(ngettext('%s particle', '%s particles', 2), '2')).toBe('2 partiklar');
    await speak('en');
    expect(say(ngettext('%s particle', '%s particles', 1), '1')).toBe('1 particle');
});

test('what the library says of files and links is said in Swedish', async () => {
    await speak('sv');
    const pairs = [
        ['a.png: damaged PNG: a checksum is wrong; save it again, or fetch another copy',
            'a.png: skadad PNG: en kontrollsumma är fel; spara den igen eller hämta ett annat exemplar'],
        ['a.png: the picture has 9000 x 40 pixels; allowed are 16 to 8192 each way',
            'a.png: bilden har 9\u00a0000 x 40 bildpunkter; tillåtet är 16 till 8\u00a0192 åt vardera hållet'],
        ['a.json:1: gravty: unknown field; did you mean gravity?', 'a.json:1: gravty: okänt fält; menade du gravity?'],
        ['a.json:2: gravity.y: "a: b; c" is not a number; allowed is a number from -0.5 to 1000 m/s^2',
            'a.json:2: gravity.y: "a: b; c" är inget tal; tillåtet är ett tal från −0,5 till 1\u00a0000 m/s²'],
        ['a.json:2: world: it is empty; allowed is { "name": value, ... }',
            'a.json:2: world: det är tomt; tillåtet är { "namn": värde, ... }'],
        ['link: it is damaged or cut short; copy all of it', 'länk: den är skadad eller avklippt; kopiera hela'],
        ['a.skvr: replay: its start: snapshot: it is damaged; take another copy',
            'a.skvr: repris: dess början: läge: den är skadad; ta ett annat exemplar'],
        ['a.skv: it begins with 400000 particles; open it once more if that is wanted',
            'a.skv: den börjar med 400\u00a0000 partiklar; öppna den en gång till om det är det du vill'],
        ['a.png: is not a PNG picture; open it in a painting program and export it as PNG',
            'a.png: är inte någon PNG-bild; öppna den i ett ritprogram och exportera den som PNG'],
        ['a.skv: snapshot: fluids[1].density: is 5 kg/m^2; allowed is 0.01 to 20 times that of the first fluid, 10..20000 kg/m^2',
            'a.skv: läge: fluids[1].density: är 5 kg/m²; tillåtet är 0,01 till 20 gånger den första vätskans, 10..20\u00a0000 kg/m²'],
        ['emitter 0: its mouth is 20 m wide; allowed are 1000 spacings, 5 m, so make it narrower or choose fewer particles',
            'kran 0: dess mynning är 20 m bred; tillåtet är 1\u00a0000 avstånd, 5 m, så gör den smalare eller välj färre partiklar'],
        ['a (2).png: something that nobody has translated', 'a (2).png: something that nobody has translated'],
    ];
    for (const [english, swedish] of pairs)
        expect(said(english)).toBe(swedish);
    await speak('en');
    expect(said(pairs[0][0])).toBe(pairs[0][0]);
    expect(said('a^2.json: fluid.viscosity: it is empty; allowed is a number from 0 to 0.05 m^2/s')).toBe(
        'a^2.json: fluid.viscosity: it is empty; allowed is a number from 0 to 0.05 m²/s');
});

// No list of files or of messages: whatever a scene, a snapshot of one or its world can be refused for.
test('why a scene is refused is said in Swedish, whichever part of the library says it', async () => {
    const library = await loadWhole(), { c } = library;
    const body = { shape: 'box', x0: 0.5, y0: 0.1, x1: 0.7, y1: 0.3 }, fluid = { name: 'oil' };
    const square = [[0.1, 0.1], [0.5, 0.5], [0.5, 0.1], [0.1, 0.5]];
    const scenes: object[] = [
        { bodies: [{ ...body, pin: [0.5] }] }, { bodies: [{ ...body, motor: { speed: 3 } }] },
        { bodies: [{ ...body, motor: { speed: 3, torque: 2 } }] }, { bodies: [{ ...body, material: 'gold' }] },
        { bodies: [{ shape: 'polygon', points: square }] }, { bodies: [{ shape: 'circle', x: 0.5, y: 0.5, radius: 0.001 }] },
        { bodies: [{ shape: 'line', points: square, thickness: 0.1 }] }, { bodies: [{ x0: 0.5 }] }, { bodies: 3 },
        { bodies: [{ shape: 'circle', x: 50, y: 0.5, radius: 0.1 }] }, { bodies: [{ ...body, density: 1 }] },
        { fluids: [{ density: 900 }] }, { fluids: [{ ...fluid, color: 'green' }] }, { fluids: [fluid, fluid] },
        { fluids: [{ name: 'water' }] }, { fluids: [{ ...fluid, density: 1 }] }, { fluids: [{ ...fluid, cohesion: 1e3 }] },
        { fluids: [{ ...fluid, plasticity: 3 }] }, { fluids: [{ ...fluid, shear_modulus: 1e9 }] },
        { fluids: [{ name: 'a name as long as none may be, and a word more' }] }, { fluids: fluid }, { air: { pressure: -3 } },
        { air: { presure: 3 } }, { drains: [{ shape: 'circle', x: 0.5, y: 0.2, radius: 0.1, rate: -1 }] },
        { emitters: [{ x: 0.5 }] }, { emitters: [{ x: 0.5, y: 0.5, vx: 100 }] }, { world: { pixel: 0.0001 } },
        { fluid: { spacing: 0.01 }, particles: 300 }, { water: [{ shape: 'box', fluid: 'olie' }], fluids: [fluid] },
        { solid: [{ shape: 'polygon', points: [[0, 0], [1, 1]] }] }, { solid: [{ shape: 'box', x0: 1e9 }] },
        { forces: [{ shape: 'box', gx: 1e9 }] }, { forces: [{ shape: 'box', spin: 1e9 }] },
    ];
    await speak('sv');
    for (const scene of scenes) {
        const text = JSON.stringify({ particles: 300, water: [{ shape: 'box', y1: 0.3 }], ...scene });
        const data = library.instance.allocateBytes(new TextEncoder().encode(text));
        let refused = '';
        try {
            const loaded = library.create((out, error) => c.skv_scene_load_memory(
                data, text.length, 'json', 'a.json', c.skv_default_scene_options() as never, out, error));
            library.create((out, error) => c.skv_scene_create_world(loaded as never, 1, out, error));
        } catch (error) {
            refused = (error as Error).message;
        }
        expect(refused, text).not.toBe('');
        // What is quoted, a field's name and a list of words to choose from are as files have them.
        const told = said(refused).replace(/"[^"]*"/g, '').replace(/^a\.json(:\d+)?: [\w.[\]]+: /, '');
        expect(told, refused).not.toMatch(/\b(a|is|are|allowed|the|its|it|of|needs|lacks|out|too|from|and|has)\b/);
        expect(told, refused).not.toMatch(/\^2|\d\.\d(?!\d* *\])/);
    }
    await speak('en');
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
