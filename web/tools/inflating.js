// fflate for the built page, as far as fast-png wants it: of pictures that web/src/png.js has inflated and
// packed again as they are, so in no fewer bytes, and of those that are saved. By pako, which is there anyway.
import { deflate, inflate } from '../src/deflate.js';

/** @param {Uint8Array} packed */
export function unzlibSync(packed) {
    return inflate(packed, packed.length, { raw: false }).bytes;
}

/** Takes pieces of a stream, and gives all of it at the end. */
export class Unzlib {
    /** @type {Uint8Array[]} */
    #pieces = [];
    #give;

    /** @param {(bytes: Uint8Array, final: boolean) => void} give */
    constructor(give) {
        this.#give = give;
    }

    /** @param {Uint8Array} piece @param {boolean} final */
    push(piece, final) {
        this.#pieces.push(piece.slice());
        if (final) {
            const whole = new Uint8Array(this.#pieces.reduce((sum, { length }) => sum + length, 0));
            let at = 0;
            for (const part of this.#pieces) {
                whole.set(part, at);
                at += part.length;
            }
            this.#give(unzlibSync(whole), true);
        }
    }
}

/** Packs as hard as fast-png does. @param {Uint8Array} bytes */
export function zlibSync(bytes) {
    return deflate(bytes, { raw: false, level: 3 });
}
