// PNG as the library wants it decoded: by fast-png, and as strictly as libpng does it natively.
//
// src/scene/read/png_chunks.c has looked at the chunks: what comes here has a sound header, one palette
// and one transparency at most, pixels, an end, and nothing else. What is left is decided here: the
// pixels' stream must be sound to its checksum and hold just what the header says, which also bounds
// what is inflated (after it there may be more chunks, which libpng passes over); a row's filter must be one; a colour beyond the palette is black.
//
// fast-png gets each pass of an interlaced picture as a picture of its own: it does not know passes
// of pixels smaller than a byte.
import { decode } from 'fast-png';

import { deflate, inflate } from './deflate.js';
import { joined } from './memory.js';

const channelsOf = /** @type {Record<number, number>} */ ({ 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 });
const adam7 = [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]];
const signature = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];

/**
 * A pass over the picture: every dx-th column from x on, and every dy-th row from y on.
 * @typedef {{ x: number, y: number, dx: number, dy: number, columns: number, rows: number, size: number }} Pass
 *
 * What a file consists of: its header's numbers, and its chunks.
 * @typedef {{ width: number, height: number, depth: number, type: number, interlaced: boolean,
 *     chunks: { name: string, data: Uint8Array }[] }} File
 */

/** @param {Uint8Array} bytes @returns {File} */
function takeApart(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const chunks = [];
    for (let at = signature.length; at < bytes.length; at += 12 + view.getUint32(at)) {
        const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
        chunks.push({ name, data: bytes.subarray(at + 8, at + 8 + view.getUint32(at)) });
    }
    return {
        width: view.getUint32(16), height: view.getUint32(20), depth: bytes[24], type: bytes[25],
        interlaced: bytes[28] === 1, chunks,
    };
}

/** Chunks of a name. @param {File} file @param {string} name */
function pick(file, name) {
    return file.chunks.filter((chunk) => chunk.name === name).map((chunk) => chunk.data);
}

/** Whether so many bytes are whole chunks at the end. @param {Uint8Array[]} pieces @param {number} size */
function isTail(pieces, size) {
    let sum = 0;
    for (let i = pieces.length - 1; i >= 0 && sum < size; i--) {
        sum += pieces[i].length;
    }
    return sum === size;
}

/** The passes that have pixels, and how many bytes of the stream are theirs. @param {File} file @returns {Pass[]} */
function passesOf({ width, height, depth, type, interlaced }) {
    return (interlaced ? adam7 : [[0, 0, 1, 1]])
        .map(([x, y, dx, dy]) => {
            const columns = Math.ceil((width - x) / dx), rows = Math.ceil((height - y) / dy);
            const stride = 1 + Math.ceil((columns * channelsOf[type] * depth) / 8);
            return { x, y, dx, dy, columns, rows, size: rows * stride };
        })
        .filter(({ columns, rows }) => columns > 0 && rows > 0);
}

/** A pass as a picture of its own. @param {File} file @param {Pass} pass @param {Uint8Array} rows */
function asPicture(file, { columns, rows: height }, rows) {
    const header = new Uint8Array(13);
    const view = new DataView(header.buffer);
    view.setUint32(0, columns);
    view.setUint32(4, height);
    header.set([file.depth, file.type, 0, 0, 0], 8);
    const palette = file.type === 3 ? ['PLTE', 'tRNS'].flatMap((name) => pick(file, name).map((data) => ({ name, data }))) : [];
    const chunks = [
        { name: 'IHDR', data: header }, ...palette,
        { name: 'IDAT', data: deflate(rows, { raw: false, level: 0 }) }, { name: 'IEND', data: new Uint8Array(0) },
    ];
    return joined([new Uint8Array(signature), ...chunks.flatMap(({ name, data }) => {
        const head = new Uint8Array(8);
        new DataView(head.buffer).setUint32(0, data.length);
        head.set([...name].map((letter) => letter.charCodeAt(0)), 4);
        return [head, data, new Uint8Array(4)]; // the checksum is not looked at
    })]);
}

/**
 * Samples of 1, 2 or 4 bits, one a byte. @param {import('fast-png').PngDataArray} data @param {number} width
 * @param {number} height @param {number} depth
 */
function spread(data, width, height, depth) {
    const samples = new Uint8Array(width * height);
    const stride = Math.ceil((width * depth) / 8), mask = (1 << depth) - 1;
    for (let y = 0, at = 0; y < height; y++) {
        for (let x = 0; x < width; x++, at++) {
            samples[at] = (data[y * stride + ((x * depth) >> 3)] >> (8 - depth - ((x * depth) & 7))) & mask;
        }
    }
    return samples;
}

/**
 * Red, green, blue and alpha of every pixel, 8 bits each, of 16 the nearest. `clear` is the colour that
 * is transparent, if one is.
 * @param {import('fast-png').DecodedPng} image
 * @param {number[] | undefined} clear
 */
function expand({ width, height, channels, depth, data, palette }, clear) {
    const pixels = new Uint8Array(4 * width * height);
    const samples = depth < 8 ? spread(data, width, height, depth) : data;
    const most = 2 ** depth - 1;
    const to8 = depth === 16 ? (/** @type {number} */ value) => (value * 255 + 32895) >> 16
        : (/** @type {number} */ value) => value * (255 / most);
    for (let i = 0, from = 0, to = 0; i < width * height; i++, from += channels, to += 4) {
        if (palette) {
            const [red, green, blue, alpha = 255] = palette[samples[from]] ?? [0, 0, 0];
            pixels.set([red, green, blue, alpha], to);
            continue;
        }
        for (let c = 0; c < 3; c++) {
            pixels[to + c] = to8(samples[channels < 3 ? from : from + c]);
        }
        pixels[to + 3] = channels % 2 === 0 ? to8(samples[from + channels - 1])
            : clear?.every((value, c) => (value & most) === samples[from + c]) ? 0 : 255;
    }
    return pixels;
}

/** The transparent colour of a picture without palette. @param {File} file */
function clearColour(file) {
    const [data] = file.type === 3 ? [] : pick(file, 'tRNS');
    return data && Array.from({ length: data.length / 2 }, (_, i) => 256 * data[2 * i] + data[2 * i + 1]);
}

/**
 * The pixels of a PNG, or what is wrong with it.
 * @param {Uint8Array} bytes
 * @returns {Uint8Array | string}
 */
export function decodePng(bytes) {
    const file = takeApart(bytes);
    const passes = passesOf(file);
    const size = passes.reduce((sum, pass) => sum + pass.size, 0);
    const pieces = pick(file, 'IDAT');
    const { bytes: rows, whole, rest } = inflate(joined(pieces), size + 1, { raw: false });
    if (!whole || rows.length !== size || !isTail(pieces, rest)) {
        return rows.length > size ? 'it has too many pixels' : 'its pixels are damaged or cut short';
    }
    const pixels = new Uint32Array(file.width * file.height);
    const clear = clearColour(file);
    let at = 0;
    for (const pass of passes) {
        const own = rows.subarray(at, at += pass.size);
        for (let row = 0; row < pass.rows; row++) {
            if (own[(row * pass.size) / pass.rows] > 4) {
                return 'a row has an unknown filter';
            }
        }
        const colours = new Uint32Array(expand(decode(asPicture(file, pass, own)), clear).buffer);
        for (let row = 0, i = 0; row < pass.rows; row++) {
            for (let column = 0; column < pass.columns; column++, i++) {
                pixels[(pass.y + row * pass.dy) * file.width + pass.x + column * pass.dx] = colours[i];
            }
        }
    }
    return new Uint8Array(pixels.buffer);
}
