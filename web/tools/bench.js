// What a particle and substep costs in WebAssembly beside what it costs natively, on this machine, in
// one run: all take their frames in turn, each time another one first, so that whatever disturbs the
// machine meets all of them, and have the same worlds to the last bit. scripts/bench-web.sh calls it.
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

/** @param {number[]} values */
const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

/** How much longer one takes than the other: the median of what frames say one by one, since a machine
 * changes its speed from second to second, and the same frame of both is taken within one.
 * @param {number[]} one @param {number[]} other */
const ratio = (one, other) => median(one.map((time, frame) => time / other[frame])).toFixed(2);

/** The least, and in brackets the median. @param {number[]} times */
const told = (times) => `${Math.min(...times).toFixed(1)} (${median(times).toFixed(1)})`;

/** @param {string} law @param {number} particles */
async function measure(law, particles) {
    const what = ['dam-break', law, String(particles)];
    const inNative = (threads, set) => new Runner(`${native}/web_reference`, 'steps', ...what, threads, set);
    const inWasm = (folder, threads) => new Runner(process.execPath, steps, folder, ...what, threads);
    /** @type {Record<string, Runner>} */
    const runners = {
        'SSE2': inNative('1', 'sse2'), 'AVX2': inNative('1', 'avx2'), 'wasm': inWasm(modules, '1'),
        ...(values.against && { against: inWasm(values.against, '1') }),
    };
    const row = Object.values(runners);
    for (let i = 0; i < warm + frames; i++) {
        for (let turn = 0; turn < row.length; turn++) {
            await row[(i + turn) % row.length].step();
        }
    }
    /** @type {Record<string, number[]>} */
    const busy = {};
    for (const [name, runner] of Object.entries(runners)) {
        runner.end();
        busy[name] = runner.times.slice(warm).map(([, busy]) => busy);
    }
    return { busy, passed: await measureThreads([1, 2].map((threads) => inWasm(modules, String(threads)))) };
}

/** Time passed, on one thread and on two. Frames come one after the other as they do where water plays, 25 of
 * one and 25 of the other: what has just slept while others had their turns is slow to wake.
 * @param {Runner[]} runners */
async function measureThreads(runners) {
    for (let i = 0; i < warm + frames; i += 25) {
        for (const runner of runners) {
            for (let n = 0; n < 25; n++) {
                await runner.step();
            }
        }
    }
    return runners.map((runner) => {
        runner.end();
        return runner.times.slice(warm).map(([passed]) => passed);
    });
}

console.log(`In node ${process.versions.node} (V8 ${process.versions.v8}):\n`);
console.log('| law | particles | SSE2 | AVX2 | wasm | to SSE2 | to AVX2 | two threads | speed-up |');
console.log('|-----|----------:|-----:|-----:|-----:|--------:|--------:|------------:|---------:|');
for (const [law, particles] of cases) {
    const { busy: { SSE2, AVX2, wasm, against }, passed: [one, two] } = await measure(String(law), Number(particles));
    console.log(`| ${law} | ${particles} | ${told(SSE2)} | ${told(AVX2)} | ${told(wasm)} | ${ratio(wasm, SSE2)} | `
        + `${ratio(wasm, AVX2)} | ${told(two)} | ${ratio(one, two)} |`);
    if (against) {
        console.log(`against: ${told(against)}, ratio ${ratio(wasm, against)}`);
    }
}
