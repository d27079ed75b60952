// What a first visit to the page costs, in Chromium with nothing cached: for scripts/bench-web.sh, no test.
// Prints a Markdown table: of each visit the seconds from its start until the simulation is there and
// until water is, and how far the first second after it keeps up with real time; then the bytes that went
// over the network, brotli, until water is there and with an experiment and a plot open.
// Arguments: the folder of the built page, how many visits.
import { kilo, measure, prepare, serve, total } from './arrival.js';
import { launch } from './harness.js';

const [folder, count = '5'] = process.argv.slice(2);

/** Runs in the page before anything else: looks, frame by frame, how far it is. */
function watch() {
    const seen = window.seen = {};
    const look = () => {
        const now = performance.now() / 1000, state = window.skvalp?.state.value;
        seen.there ??= window.skvalp ? now : undefined;
        if (state?.worlds[0].particles > 0) {
            seen.water ??= { now, moment: state.moment };
            if (now - seen.water.now >= 1) {
                seen.pace = (state.moment - seen.water.moment) / 60 / (now - seen.water.now);
                return;
            }
        }
        requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
}

const { home, sent, close } = await serve(folder);
const browser = await launch([folder], { whole: true });
console.log('| visit | simulation, s | water, s | pace of the first second |\n|--:|--:|--:|--:|');
for (let i = 0; i <= Number(count); i++) {
    sent.clear();
    const page = await prepare(browser);
    await page.addInitScript(watch);
    await page.goto(home);
    await page.waitForFunction(() => window.seen.water);
    const first = total(sent);
    await page.waitForFunction(() => window.seen.pace !== undefined);
    const { there, water, pace } = await page.evaluate(() => window.seen);
    if (i > 0) { // the one before has made the browser itself ready, and packed the files
        console.log(`| ${i} | ${there.toFixed(2)} | ${water.now.toFixed(2)} | ${pace.toFixed(2)} |`);
    }
    if (i === Number(count)) {
        const early = new Set(sent.keys());
        await measure(page);
        console.log(`\nUntil water is there ${kilo(first)}; with an experiment and its plot ${kilo(total(sent))}.\n`);
        for (const [path, size] of [...sent].sort(([, a], [, b]) => b - a)) {
            console.log(`    ${kilo(size).padStart(9)} ${early.has(path) ? ' ' : '+'} ${path.slice(1)}`);
        }
    }
    await page.context().close();
}
await browser.close();
close();
