// Deflate as zlib has it, whose port pako 2 is: the same bytes out, the same streams refused. pako 3 finds
// other matches, so that its links would not be those of the app and the command line.
import { Deflate, Inflate } from 'pako';

const chunk = 65536;

/**
 * Deflates, without a head and as small as it can if nothing else is said.
 * @param {Uint8Array} data
 * @param {{ raw: boolean, level: 0 | 3 | 9 }} [how]
 */
export function deflate(data, { raw, level } = { raw: true, level: 9 }) {
    const stream = new Deflate({ raw, level, memLevel: 9, windowBits: 15 });
    stream.push(data, true);
    return /** @type {Uint8Array} */ (stream.result);
}

/**
 * Inflates any bytes, to `most` at most. It is whole if the stream has ended with nothing wrong; what
 * follows it are `rest` bytes.
 * @param {Uint8Array} packed
 * @param {number} most
 * @param {{ raw: boolean }} how without a head, or with zlib's
 */
export function inflate(packed, most, { raw }) {
    const bytes = new Uint8Array(most);
    let used = 0, ended = false;
    const stream = new Inflate({ raw, chunkSize: chunk, windowBits: 15 });
    stream.onData = (data) => {
        const part = /** @type {Uint8Array} */ (data);
        const room = part.subarray(0, most - used);
        bytes.set(room, used);
        used += room.length;
        if (room.length < part.length) {
            throw new RangeError('more than is wanted');
        }
    };
    stream.onEnd = (status) => {
        ended = status === 0;
    };
    let whole = true;
    try {
        stream.push(packed, true);
    } catch {
        whole = false;
    }
    const state = /** @type {any} */ (stream).strm;
    return { bytes: bytes.subarray(0, used), whole: whole && ended, rest: state.avail_in };
}
