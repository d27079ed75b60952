// The simulation in Chromium as a page has it: in a worker where the page is isolated and where it is
// not, on the page where workers cannot draw, without WebGL, and where a context is lost. Arguments: the
// folder of the bundle.
import assert from 'node:assert/strict';

import { decode, untilSeen } from './people.js';
import { carryOut } from './trials.js';

const [bundle] = process.argv.slice(2);

/** What a browser lacks, before anything of the page runs. */
const lacks = {
    nothing: () => undefined,
    offscreen: () => {
        delete HTMLCanvasElement.prototype.transferControlToOffscreen;
    },
    webgl: () => {
        HTMLCanvasElement.prototype.getContext = OffscreenCanvas.prototype.getContext = () => null;
    },
};

async function open(browser, { isolated = true, lacking = 'nothing', cores = 4 } = {}) {
    const page = await browser.open('/empty.html', { isolated, width: 480, height: 270 });
    await page.evaluate((value) => Object.defineProperty(navigator, 'hardwareConcurrency', { value }), cores);
    await page.evaluate(lacks[lacking]);
    await page.addScriptTag({ type: 'module', url: '/simulation.page.js' });
    await page.waitForFunction('window.ready');
    return page;
}

/** Opens a scene, plays, pauses, and asks for what is answered. */
async function play() {
    const { trial } = window;
    const { simulation, until } = trial;
    simulation.open('u-tube');
    await until((state) => state.worlds[0].name === 'u-tube');
    const later = await until((state) => state.moment >= 5);
    simulation.setPaused(true);
    await until((state) => state.paused);
    const before = trial.states;
    await new Promise((resolve) => setTimeout(resolve, 500));
    const told = trial.states - before;
    const { scenes } = await simulation.catalogue();
    return {
        threads: later.threads, chosen: later.chosen, told, reports: trial.reports,
        scenes: scenes.length, link: await simulation.share(), pictures: trial.pictures,
    };
}

/** The share of a picture that is blue, as water is. */
function waterIn(png) {
    const { data, channels, width, height } = decode(png);
    let blue = 0;
    for (let i = 0; i < data.length; i += channels) {
        blue += data[i + 2] > 150 && data[i] < 110;
    }
    return blue / (width * height);
}

/** Waits for a picture with as much water as it should have: the last one may be on its way. */
const untilWater = (page, isRight, what) =>
    untilSeen(async () => waterIn(await page.screenshot()), isRight, (water) => `${what}: ${water} is water`);

async function testModes(browser) {
    const modes = [
        { isolated: true, lacking: 'nothing', threads: 3 },
        { isolated: false, lacking: 'nothing', threads: 1 },
        { isolated: true, lacking: 'offscreen', threads: 1 },
        { isolated: false, lacking: 'webgl', threads: 1 },
    ];
    for (const { isolated, lacking, threads } of modes) {
        const mode = `isolated ${isolated}, lacking ${lacking}`;
        const page = await open(browser, { isolated, lacking });
        const seen = await page.evaluate(play);
        assert.equal(seen.threads, threads, mode);
        assert.deepEqual(seen.reports, [{ kind: 'open', error: null }], mode);
        assert.deepEqual(seen.pictures, lacking === 'webgl' ? ['unsupported'] : [], mode);
        // What was under way, and its picture; a world that plays has fifteen.
        assert.ok(seen.told <= 2, `${mode}: a paused world is told of ${seen.told} times`);
        assert.ok(seen.chosen >= 500 && seen.chosen <= 5000, mode);
        assert.match(seen.link, /^1\./);
        assert.equal(seen.scenes, 23);
        await untilWater(page, (water) => lacking === 'webgl' ? water === 0 : water > 0.05 && water < 0.5, mode);
        if (threads === 3) {
            const png = await page.evaluate(async () => [...await window.trial.simulation.save('png')]);
            assert.ok(waterIn(Uint8Array.from(png)) > 0.05, mode);
        }
        await page.context().close();
    }
}

/** A context that is lost and comes back: the same picture again, also of a world that stands still. */
async function testLostContext(browser) {
    const page = await open(browser, { lacking: 'offscreen' });
    await page.evaluate(play);
    await page.evaluate(async () => {
        const context = document.querySelector('canvas').getContext('webgl2');
        const extension = context.getExtension('WEBGL_lose_context');
        extension.loseContext();
        while (window.trial.pictures.length === 0) {
            await new Promise((resolve) => setTimeout(resolve, 20));
        }
        window.trial.simulation.stepOnce();
        extension.restoreContext();
    });
    await page.waitForFunction(() => window.trial.pictures.length === 2);
    await untilWater(page, (water) => water > 0.05, 'once a context came back');
    assert.deepEqual(await page.evaluate(() => window.trial.pictures), ['lost', null]);
    await page.context().close();
}

/** Two worlds come and go, each on threads of its own. */
async function testComparing(browser) {
    const page = await open(browser);
    const moments = await page.evaluate(async () => {
        const { simulation, until } = window.trial;
        simulation.open('dam-break', { particles: '300' });
        const seen = [];
        for (let i = 0; i < 3; i++) {
            await until((state) => state.worlds.length === 1 && state.moment >= 3);
            simulation.compare({ 'fluid.material': 'oil' });
            const { worlds } = await until((state) => state.worlds.length === 2 && state.moment >= 3);
            seen.push(worlds.map(({ time }) => time));
            simulation.compare(null);
        }
        return { seen, errors: window.trial.reports.filter(({ error }) => error) };
    });
    assert.deepEqual(moments.errors, []);
    moments.seen.forEach(([a, b]) => assert.equal(a, b));
    await page.context().close();
}

async function testLab(browser) {
    const page = await open(browser, { isolated: false });
    const messages = await page.evaluate(() => window.trial.lab(0, 600));
    assert.equal(messages.at(-1).kind, 'done', messages.at(-1).error);
    assert.ok(messages.at(-1).rows.length > 0 && messages.at(-1).curves.length > 0);
    assert.ok(messages.length > 1, 'nothing is told while it runs');
    await page.context().close();
}

await carryOut([bundle], {
    'in a worker and on the page, isolated or not, with WebGL or without': testModes,
    'a context that is lost and comes back': testLostContext,
    'two worlds that come and go': testComparing,
    'an experiment': testLab,
}, ['in a worker and on the page, isolated or not, with WebGL or without']);
