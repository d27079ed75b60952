// JSON as the library wants it read: by jsonc-parser, and as strictly as jansson does it natively.
//
// What the two leave open is decided here: a key given twice in an object, \u0000, half a surrogate
// pair, a whole number beyond 64 bits and a real one beyond a double, more than 2048 levels, bytes
// that are no UTF-8, and a root that is neither an object nor a list are refused; -0 is 0.
//
// Invariant: what is told is the first fault in the text.
import * as jsonc from 'jsonc-parser';

import { entryKinds } from './entries.js';
/** @import { Event, Failure } from './entries.js' */

/** In node the package is a CommonJS module. */
const { visit, ParseErrorCode } = /** @type {typeof jsonc} */ (
    'visit' in jsonc ? jsonc : /** @type {any} */ (jsonc).default);

/** skv_json_fault */
const faults = /** @type {const} */ ({
    other: 0, twice: 1, tooLarge: 2, tooDeep: 3, notUtf8: 4, nul: 5, endsEarly: 6, goesOn: 7,
});

const mostLevels = 2048;
const mostWhole = 2n ** 63n;

class Fault extends Error {
    /** @param {number} fault @param {number} offset of the end of what is wrong @param {string} words */
    constructor(fault, offset, words) {
        super(words);
        this.fault = fault;
        this.offset = offset;
    }
}

/** What jsonc-parser finds wrong, in words. @param {number} code */
function complaint(code) {
    switch (code) {
        case ParseErrorCode.CommaExpected: return 'a comma is expected';
        case ParseErrorCode.ColonExpected: return 'a colon is expected';
        case ParseErrorCode.PropertyNameExpected: return 'a name in quotes is expected';
        case ParseErrorCode.ValueExpected: return 'a value is expected';
        case ParseErrorCode.CloseBraceExpected: return 'a } is expected';
        case ParseErrorCode.CloseBracketExpected: return 'a ] is expected';
        case ParseErrorCode.InvalidCommentToken: return 'a comment has no place here';
        case ParseErrorCode.InvalidEscapeCharacter:
        case ParseErrorCode.InvalidUnicode: return 'an escape is none';
        default: return 'something is not understood';
    }
}

/** Whether bytes are UTF-8. @param {Uint8Array} bytes @param {boolean} cut a last character may be */
function isUtf8(bytes, cut) {
    try {
        new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes, { stream: cut });
        return true;
    } catch {
        return false;
    }
}

/** How many bytes at the beginning are UTF-8. @param {Uint8Array} bytes */
function validLength(bytes) {
    let low = 0, high = bytes.length;
    if (isUtf8(bytes, false)) {
        return high;
    }
    while (low < high) {
        const middle = Math.ceil((low + high) / 2);
        if (isUtf8(bytes.subarray(0, middle), true)) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    while (!isUtf8(bytes.subarray(0, low), false)) {
        low--;
    }
    return low;
}

/** @param {string} token @param {number} end */
function checkNumber(token, end) {
    const whole = !/[.eE]/.test(token);
    const large = whole && token.length > 18 && (BigInt(token) >= mostWhole || BigInt(token) < -mostWhole);
    if (large || !Number.isFinite(Number(token))) {
        throw new Fault(faults.tooLarge, end, 'too large');
    }
    return whole ? Number(token) + 0 : Number(token);
}

/** @param {string} text @param {number} end */
function checkText(text, end) {
    if (/\p{Surrogate}/u.test(text)) {
        throw new Fault(faults.other, end, 'half a surrogate pair is no character');
    }
    if (text.includes('\0')) {
        throw new Fault(faults.nul, end, 'the character \\u0000');
    }
}

/** @param {string} text @returns {Event[]} */
function readEvents(text) {
    /** @type {Event[]} */
    const events = [];
    /** @type {(Set<string> | null)[]} */
    const open = [];
    const enter = (/** @type {number} */ end) => {
        if (open.length + 1 > mostLevels) {
            throw new Fault(faults.tooDeep, end, 'too deep');
        }
    };
    const begin = (/** @type {number} */ kind, /** @type {number} */ end) => {
        enter(end);
        open.push(kind === entryKinds.object ? new Set() : null);
        events.push({ kind, value: '', number: 0 });
    };
    const close = () => {
        open.pop();
        events.push({ kind: 'close', value: '', number: 0 });
    };
    visit(text, {
        onObjectBegin: (offset, length) => begin(entryKinds.object, offset + length),
        onArrayBegin: (offset, length) => begin(entryKinds.list, offset + length),
        onObjectEnd: close,
        onArrayEnd: close,
        onObjectProperty: (key, offset, length) => {
            const keys = /** @type {Set<string>} */ (open.at(-1));
            checkText(key, offset + length);
            if (keys.has(key)) {
                throw new Fault(faults.twice, offset + length, 'given twice');
            }
            keys.add(key);
            events.push({ kind: 'key', value: key, number: 0 });
        },
        onLiteralValue: (value, offset, length) => {
            const end = offset + length;
            enter(end);
            if (typeof value === 'string') {
                checkText(value, end);
                events.push({ kind: entryKinds.text, value, number: 0 });
            } else if (typeof value === 'number') {
                const number = checkNumber(text.slice(offset, end), end);
                events.push({ kind: entryKinds.number, value: '', number });
            } else {
                const kind = value === null ? entryKinds.null : entryKinds.boolean;
                events.push({ kind, value: '', number: Number(value) });
            }
            if (open.length === 0) {
                throw new Fault(faults.other, end, `a { is expected near '${text.slice(offset, end)}'`);
            }
        },
        onError: (code, offset, length) => {
            const end = offset + length;
            // A number is looked at before its place is; what follows a leading zero is none (01e999).
            const begins = !/^\d\d$/.test(text.slice(offset - 1, offset + 1));
            if (begins && /^-?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$/.test(text.slice(offset, end))) {
                checkNumber(text.slice(offset, end), end);
            }
            const token = text.slice(offset, end).slice(0, 20);
            if (code === ParseErrorCode.EndOfFileExpected) {
                throw new Fault(faults.goesOn, end, 'something follows');
            }
            if (offset >= text.trimEnd().length || code === ParseErrorCode.UnexpectedEndOfString && end >= text.length) {
                throw new Fault(faults.endsEarly, end, 'it ends too early');
            }
            throw new Fault(faults.other, end, `${complaint(code)} near '${token}'`);
        },
    }, { disallowComments: true, allowTrailingComma: false, allowEmptyContent: false });
    return events;
}

/**
 * Parses a text: what it holds, in its order, or what is wrong with it.
 * @param {Uint8Array} bytes
 * @returns {{ events: Event[] } | Failure}
 */
export function parseJson(bytes) {
    const length = validLength(bytes);
    const text = new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes.subarray(0, length));
    try {
        const events = readEvents(text);
        if (length === bytes.length) {
            return { events };
        }
        throw new Fault(faults.notUtf8, text.length, 'no UTF-8');
    } catch (error) {
        if (!(error instanceof Fault)) {
            throw error;
        }
        const cut = length < bytes.length && error.fault === faults.endsEarly;
        const before = text.slice(0, error.offset);
        return {
            fault: cut ? faults.notUtf8 : error.fault,
            line: before.split('\n').length,
            position: new TextEncoder().encode(before).length,
            words: error.message,
        };
    }
}
