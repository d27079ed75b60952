// PNG files of every form, and damaged ones, sound in all but the damage.
import zlib from 'node:zlib';

const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
const adam7 = [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]];
const channels = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };

/** Node 18 has no crc32 of its own. */
function crc32(bytes) {
    if (zlib.crc32) {
        return zlib.crc32(bytes);
    }
    let crc = ~0;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; bit++) {
            crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
        }
    }
    return ~crc >>> 0;
}

function join(chunks) {
    return Buffer.concat([signature, ...chunks.flatMap(({ name, data, crc }) => {
        const head = Buffer.alloc(8), tail = Buffer.alloc(4);
        head.writeUInt32BE(data.length, 0);
        head.write(name, 4, 'latin1');
        tail.writeUInt32BE(crc ?? crc32(Buffer.concat([head.subarray(4), data])));
        return [head, data, tail];
    })]);
}

function split(bytes) {
    const chunks = [];
    for (let at = 8; at + 12 <= bytes.length;) {
        const size = bytes.readUInt32BE(at);
        chunks.push({ name: bytes.toString('latin1', at + 4, at + 8), data: bytes.subarray(at + 8, at + 8 + size) });
        at += 12 + size;
    }
    return chunks;
}

/** Rows of pixels with their filters; mostly black, white and what water and paint are made of. */
function rows(width, height, depth, type, interlaced, chance) {
    const bytes = [];
    const values = depth === 8 ? [0, 0, 255, 255, 40, 128] : null;
    const passes = interlaced ? adam7 : [[0, 0, 1, 1]];
    const filters = chance.below(2) ? [0] : [0, 1, 2, 3, 4];
    for (const [x, y, dx, dy] of passes) {
        const columns = Math.ceil((width - x) / dx), lines = Math.ceil((height - y) / dy);
        for (let line = 0; columns > 0 && line < lines; line++) {
            bytes.push(chance.pick(filters));
            for (let i = 0; i < Math.ceil((columns * channels[type] * depth) / 8); i++) {
                bytes.push(values && bytes.at(-1) !== undefined && chance.below(4) ? chance.pick(values) : chance.below(256));
            }
        }
    }
    return Buffer.from(bytes);
}

export function makePng(chance) {
    const [type, depths] = chance.pick([
        [0, [1, 2, 4, 8, 16]], [0, [1, 2, 4, 8, 16]], [2, [8, 16]], [3, [1, 2, 4, 8]], [3, [1, 2, 4, 8]], [4, [8, 16]], [6, [8, 16]]]);
    const depth = chance.pick(depths);
    const width = 16 + chance.below(20), height = 16 + chance.below(20), interlaced = chance.below(2);
    const header = Buffer.alloc(13);
    header.writeUInt32BE(width, 0);
    header.writeUInt32BE(height, 4);
    header.set([depth, type, 0, 0, interlaced], 8);
    const chunks = [{ name: 'IHDR', data: header }];
    if (type === 3) {
        const colours = 1 + chance.below(1 << depth);
        const paints = [[0, 0, 0], [255, 255, 255], [0, 0, 255], [0, 255, 0], [255, 0, 0], [90, 90, 90]];
        chunks.push({ name: 'PLTE', data: Buffer.from(Array.from({ length: colours }, () => chance.pick(paints)).flat()) });
    }
    if (chance.below(2) && type <= 3) {
        const size = type === 3 ? 1 + chance.below(chunks[1].data.length / 3) : type === 0 ? 2 : 6;
        chunks.push({ name: 'tRNS', data: Buffer.from(Array.from({ length: size }, () => chance.pick([0, 0, 1, 128, 255]))) });
    }
    const stream = zlib.deflateSync(rows(width, height, depth, type, interlaced, chance), { level: chance.below(10) });
    const cut = chance.below(stream.length);
    chunks.push(...(chance.below(2) ? [stream] : [stream.subarray(0, cut), stream.subarray(cut)])
        .map((data) => ({ name: 'IDAT', data })));
    chunks.push({ name: 'IEND', data: Buffer.alloc(0) });
    return join(chunks);
}

function flip(bytes, chance) {
    const changed = Buffer.from(bytes);
    if (changed.length > 0) {
        changed[chance.below(changed.length)] ^= 1 << chance.below(8);
    }
    return changed;
}

/** The pixels' stream changed in what it holds, and packed again. */
function repack(data, chance) {
    try {
        const plain = zlib.inflateSync(data);
        const changed = [
            () => flip(plain, chance), () => plain.subarray(0, plain.length - 1 - chance.below(5)),
            () => Buffer.concat([plain, Buffer.alloc(1 + chance.below(5))]),
        ];
        return zlib.deflateSync(chance.pick(changed)());
    } catch {
        return flip(data, chance);
    }
}

export function mutatePng(bytes, chance) {
    const chunks = split(bytes);
    const at = chance.below(Math.max(chunks.length, 1));
    const chunk = chunks[at];
    const pixels = chunks.findIndex(({ name }) => name === 'IDAT');
    switch (chunk ? chance.below(12) : 0) {
        case 0: return flip(bytes, chance);
        case 1: return bytes.subarray(0, chance.below(bytes.length));
        case 2: chunk.data = flip(chunk.data, chance); break;
        case 3: chunks.splice(at, 1); break;
        case 4: chunks.splice(chance.below(chunks.length), 0, chunk); break;
        case 5: chunks.splice(chance.below(chunks.length + 1), 0, { name: chance.pick(['tEXt', 'abCd', 'ABCD', 'a1cd', 'PLTE', 'tRNS', 'IDAT', 'gAMA', 'iCCP', 'sBIT']), data: Buffer.from(Array.from({ length: chance.below(9) }, () => chance.below(256))) }); break;
        case 6: chunk.crc = chance.below(1 << 30); break;
        case 7: chunk.data = chunk.data.subarray(0, chance.below(chunk.data.length + 1)); break;
        case 8: return Buffer.concat([bytes, Buffer.from('something')]);
        case 9: chunks[pixels] && (chunks[pixels].data = flip(chunks[pixels].data, chance)); break;
        case 10: chunks[pixels] && (chunks[pixels].data = Buffer.concat([chunks[pixels].data, Buffer.alloc(1 + chance.below(6))])); break;
        default: {
            const stream = Buffer.concat(chunks.filter(({ name }) => name === 'IDAT').map(({ data }) => data));
            const kept = chunks.filter(({ name }, i) => name !== 'IDAT' || i === pixels);
            kept.filter(({ name }) => name === 'IDAT').forEach((piece) => {
                piece.data = repack(stream, chance);
            });
            return join(kept);
        }
    }
    return join(chunks);
}
