// Does in WebAssembly what hashes.c does elsewhere. Arguments: the wasm file, threads, frames;
// without the last two it prints the instruction set in use.
import { readFileSync } from 'node:fs';

const [file, threads, frames] = process.argv.slice(2);
// No imports: the module needs nothing of its host.
const { instance } = await WebAssembly.instantiate(readFileSync(file), {});
const { memory, bits_count, bits_name, bits_hash, bits_instruction_set } = instance.exports;

function text(address) {
    const bytes = new Uint8Array(memory.buffer, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

if (threads === undefined) {
    console.log(text(bits_instruction_set()));
} else {
    for (let i = 0; i < bits_count(); i++) {
        const hash = BigInt.asUintN(64, bits_hash(i, Number(threads), Number(frames)));
        console.log(`${text(bits_name(i))} ${frames} ${hash.toString(16).padStart(16, '0')}`);
    }
    // The memory of worlds that are gone serves again.
    const held = memory.buffer.byteLength;
    for (let i = 0; i < 2 * bits_count(); i++) {
        bits_hash(i % bits_count(), 1, 1);
    }
    if (memory.buffer.byteLength > held) {
        console.log(`memory leaks: ${held} bytes have become ${memory.buffer.byteLength}`);
    }
}
