// What a particle and substep costs in WebAssembly beside what it costs natively, on this machine, in
// one run: all take their frames in turn, so that whatever disturbs the machine meets all of them,
// and have the same worlds to the last bit. scripts/bench-web.sh calls it.
//   node bench.js NATIVE-BUILD MODULES [--frames N] [--against MODULES]
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

const { values, positionals: [native, modules] } = parseArgs({
    allowPositionals: true,
    options: { frames: { type: 'string', default: '150' }, against: { type: 'string' } },
});
const frames = Number(values.frames);
const warm = 40; // frames before: engines compile, and the fluid begins to move
const cases = [['calibrated', 3000], ['clavet', 3000], ['calibrated', 10000]];
const steps = fileURLToPath(new URL('steps.js', import.meta.url));

/** A process that takes a frame when it is told to. */
class Runner {
    #lines;
    #process;
    /** @type {number[][]} of each frame, ns a particle and substep: passed, and of processors */
    times = [];

    /** @param {string} program @param {string[]} given */
    constructor(program, ...given) {
        this.#process = spawn(program, given, { stdio: ['pipe', 'pipe', 'inherit'] });
        this.#lines = createInterface({ input: this.#process.stdout })[Symbol.asyncIterator]();
    }

    async step() {
        this.#process.stdin.write('\n');
        const { value, done } = await this.#lines.next();
        if (done) {
            throw new Error('a program that is measured has ended');
        }
        const [work, passed, busy] = value.split(' ').map(Number);
        this.times.push([1e9 * passed / work, 1e9 * busy / work]);
    }

    end() {
        this.#process.stdin.end();
    }
}

/** The shortest and the median. @param {number[]} values */
function summary(values) {
    const sorted = values.toSorted((a, b) => a - b);
    return { least: sorted[0], median: sorted[sorted.length >> 1] };
}

/** @param {string} law @param {number} particles */
async function measure(law, particles) {
    const what = ['dam-break', law, String(particles)];
    const inNative = (threads, set) => new Runner(`${native}/web_reference`, 'steps', ...what, threads, set);
    const inWasm = (folder, threads) => new Runner(process.execPath, steps, folder, ...what, threads);
    /** @type {Record<string, Runner>} */
    const runners = {
        'SSE2': inNative('1', 'sse2'), 'AVX2': inNative('1', 'avx2'), 'wasm': inWasm(modules, '1'),
        'wasm, threads': inWasm(modules, '2'),
        ...(values.against && { against: inWasm(values.against, '1') }),
    };
    for (let i = 0; i < warm + frames; i++) {
        for (const runner of Object.values(runners)) {
            await runner.step();
        }
    }
    const result = {};
    for (const [name, runner] of Object.entries(runners)) {
        runner.end();
        const kept = runner.times.slice(warm);
        result[name] = { passed: summary(kept.map(([passed]) => passed)), busy: summary(kept.map(([, busy]) => busy)) };
    }
    return result;
}

console.log('| law | particles | SSE2 | AVX2 | wasm | to SSE2 | to AVX2 | two threads | speed-up |');
console.log('|-----|----------:|-----:|-----:|-----:|--------:|--------:|------------:|---------:|');
for (const [law, particles] of cases) {
    const all = await measure(String(law), Number(particles));
    const pair = ({ least, median }) => `${least.toFixed(1)} (${median.toFixed(1)})`;
    const { SSE2, AVX2, wasm, 'wasm, threads': two, against } = all;
    const ratio = (other) => (wasm.busy.least / other.busy.least).toFixed(2);
    console.log(`| ${law} | ${particles} | ${pair(SSE2.busy)} | ${pair(AVX2.busy)} | ${pair(wasm.busy)} | ${ratio(SSE2)} | `
        + `${ratio(AVX2)} | ${pair(two.passed)} | ${(wasm.passed.least / two.passed.least).toFixed(2)} |`);
    if (against) {
        console.log(`against: ${pair(against.busy)}, ratio ${ratio(against)}`);
    }
}
