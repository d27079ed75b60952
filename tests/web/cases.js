// Packs scenes for `web_reference files` and reference.js: those of the project, what the fuzz targets
// have kept, and mutations of both, always the same ones and none twice. Arguments: their number, the
// output file, and another seed for other mutations.
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';

import { makePng, mutatePng } from './pngs.js';
import { random } from './random.js';

const [count, output, seed = '20261122'] = process.argv.slice(2);
const packed = [];
const known = new Set();

/** False if it is there already. */
function add(format, bytes) {
    const text = bytes.toString('latin1');
    if (known.has(text)) {
        return false;
    }
    known.add(text);
    const head = Buffer.alloc(8);
    head.write(format.padEnd(4), 0, 'latin1');
    head.writeUInt32LE(bytes.length, 4);
    packed.push(head, bytes);
    return true;
}

/** What a folder holds, sorted. */
function read(folder, ending) {
    return readdirSync(folder).sort().filter((name) => name.endsWith(ending))
        .map((name) => readFileSync(`${folder}/${name}`));
}

/** What JSON texts are spoiled with: what parsers are known to differ in. */
const morsels = [
    '1e999', '-1e999', '1e-999', '-0', '-0.0', '01', '1.', '.5', '+1', '1e', '1E+2', '0x10', '-', 'NaN', 'Infinity',
    '-Infinity', '9223372036854775807', '9223372036854775808', '-9223372036854775808', '-9223372036854775809',
    '123456789012345678901234567890', '1e308', '0.1e1', 'null', 'true', 'false', 'True', '"', '"\\u0000"', '"\\ud800"',
    '"\\ud83d\\ude00"', '"\\udc00\\ud800"', '"\\x41"', '"\\/"', '"\t"', '"\n"', '"\x7f"', "'a'", 'a', '{}', '[]',
    '[[]]', '{"a":1}', '{', '}', '[', ']', ',', ':', ',,', '//', '/* */', '#', '\ufeff', '\u00a0', '\u2028', '\v', '\r',
    '\0', '"name":"a"', '"name":"a",', '[1,]', '[,1]', '{"a":1,}', '{"a" 1}', '{1:2}', '{"a":1,"a":2}', '"\u00e4\u{1f30a}"',
    '['.repeat(2047), '['.repeat(2050), `${'['.repeat(2048)}${']'.repeat(2048)}`, '{"a":'.repeat(3000),
].map((text) => Buffer.from(text)).concat([
    [0xff], [0xc0, 0x80], [0xed, 0xa0, 0x80], [0xf4, 0x90, 0x80, 0x80], [0xe2, 0x82], [0xf0, 0x9f], [0x80],
    [0xef, 0xbb, 0xbf], [0xfe, 0xff],
].map((bytes) => Buffer.from(bytes)));

/** Where the tokens of a text begin. */
function tokens(bytes) {
    return [...bytes.toString('latin1').matchAll(/"(?:[^"\\]|\\.)*"|[{}[\],:]|[^\s{}[\],:"]+/g)]
        .map((match) => [match.index, match.index + match[0].length]);
}

function mutateJson(bytes, chance) {
    const places = tokens(bytes);
    const [begin, end] = places.length > 0 ? chance.pick(places) : [0, bytes.length];
    const splice = (from, to, between) => Buffer.concat([bytes.subarray(0, from), between, bytes.subarray(to)]);
    switch (chance.below(7)) {
        case 0: return splice(begin, end, chance.pick(morsels)); // another token
        case 1: return splice(begin, begin, chance.pick(morsels));
        case 2: return splice(begin, end, Buffer.alloc(0));
        case 3: return bytes.subarray(0, chance.below(bytes.length));
        case 4: { // a member twice, perhaps with something between
            const [from, to] = chance.pick(places);
            return splice(begin, begin, Buffer.concat([bytes.subarray(from, to), Buffer.from(chance.pick([' ', ',', '']))]));
        }
        case 5: { // one bit
            const at = chance.below(bytes.length);
            return splice(at, at + 1, Buffer.from([bytes[at] ^ (1 << chance.below(8))]));
        }
        default: // in a text
            return splice(begin + 1, begin + 1, chance.pick(morsels));
    }
}

/** What once was read differently, besides what fuzzing has kept. */
const settled = ['{"name": 01e999}', '{"name": -01e999.5}', '{"name": 1-1e999}'];

const texts = [...read('scenes', '.json'), ...read('tests/fuzz/corpus/json', '')];
const pictures = [...read('scenes/painted', '.png'), ...read('tests/fuzz/corpus/png', '')];
texts.forEach((text) => add('json', text));
settled.forEach((text) => add('json', Buffer.from(text)));
pictures.forEach((picture) => add('png', picture));
morsels.forEach((morsel) => add('json', Buffer.concat([Buffer.from('{"name": '), morsel, Buffer.from('}')])));
const chance = random(Number(seed));
const small = pictures.filter((picture) => picture.length < 4000);
for (let made = 0, i = 0; made < Number(count); i++) {
    if (i % 2 === 0) {
        let text = chance.pick(texts);
        for (let times = 1 + chance.below(2); times > 0; times--) {
            text = mutateJson(text, chance);
        }
        made += add('json', text);
    } else {
        const picture = chance.below(3) > 0 ? makePng(chance) : chance.pick(small);
        made += add('png', chance.below(3) > 0 ? mutatePng(picture, chance) : picture);
    }
}
writeFileSync(output, Buffer.concat(packed));
