// The pictures that the renderer draws by WebGL in Chromium, on a worker's canvas, beside those that it
// draws natively, which are given as PNG files of one size, named SCENE.VIEW.OVERLAYS.PALETTE.DETAIL.png.
// Then the canvas itself: parts of it, a context that is lost, browsers without WebGL.
// Arguments: the folders of the bundle and the modules, particles, and the PNG files.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename } from 'node:path';
import { pathToFileURL } from 'node:url';

import { run } from './harness.js';
import { openPainter } from './painter.js';

const fromWeb = createRequire(new URL('../../../web/package.json', import.meta.url));
const { decode } = await import(pathToFileURL(fromWeb.resolve('fast-png')).href);

/**
 * Decibels at least. Drivers round what they blend in half floats each in their way, which moves isobars
 * by parts of a pixel where the pressure hardly changes. They also take derivatives for each pixel of a
 * square of four or once for all of them, so lines differ where surfaces bend sharply: what is compared
 * are the squares' means. Of 288 pictures the least like had 49.6 dB (pixel by pixel 44.9), half of them
 * more than 54; an outline 0.3 pixels wider gives 45.
 */
const least = 47;

const [bundle, modules, particles, ...files] = process.argv.slice(2);
const pictures = files.map((file) => {
    const name = basename(file, '.png');
    const [scene, view, overlay, palette, detail] = name.split('.');
    const style = { view, overlay, palette, detail };
    return { name, what: { scene, particles: Number(particles), style }, png: decode(readFileSync(file)) };
});
const { width, height } = pictures[0].png;
const { what } = pictures[0];

function fail(message) {
    throw new Error(message);
}

/** Peak signal to noise between the means over pixels two by two of RGB and RGBA, of even sizes. */
function decibels(rgb, rgba) {
    let sum = 0;
    for (let y = 0; y < height; y += 2) {
        for (let i = y * width; i < (y + 1) * width; i += 2) {
            for (let j = 0; j < 3; j++) {
                const four = [i, i + 1, i + width, i + width + 1]
                    .map((pixel) => rgb[3 * pixel + j] - rgba[4 * pixel + j]);
                sum += ((four[0] + four[1] + four[2] + four[3]) / 4) ** 2;
            }
        }
    }
    return 10 * Math.log10(255 ** 2 / (sum / (3 * (width / 2) * (height / 2))));
}

/** Those of the native renderer. */
async function comparePictures({ ask }) {
    const bad = [];
    for (const { name, what, png } of pictures) {
        const likeness = decibels(png.data, await ask('picture', what));
        console.log(`${name}: ${likeness.toFixed(1)} dB`);
        if (!(likeness >= least)) {
            bad.push(name);
        }
    }
    if (bad.length > 0) {
        fail(`other pictures than natively: ${bad.join(', ')}`);
    }
}

async function same(what, asked, picture) {
    if (!(await asked)?.equals(picture)) {
        fail(`another picture ${what}`);
    }
}

/** On the canvas itself, on a part of a larger one, and in the context after one that was lost. */
async function tryCanvas({ ask }, picture) {
    await same('on the canvas', ask('draw', { what }), picture);
    await ask('resize', { width: 2 * width + 7, height: height + 9 });
    const place = { x: width + 7, y: 4, width, height };
    await same('on a part of the canvas', ask('draw', { what, place }), picture);
    await ask('resize', { width, height });
    for (let times = 0; times < 2; times++) {
        const lost = await ask('lose', { back: false });
        const drawn = await ask('draw', { what }) ?? await ask('picture', what);
        if (lost.join() !== 'lost' || drawn !== null) {
            fail(`a lost context is told as ${lost}`);
        }
        const back = await ask('lose', { back: true });
        if (back.length !== 1 || back[0] !== null) {
            fail(`a context that is back is told as ${back}`);
        }
        await same('after the context was lost', ask('draw', { what }), picture);
        await same('of its own after the context was lost', ask('picture', what), picture);
    }
}

/** What a picture asks of the browser: the walls go in one call, and a later picture's calls are few. */
async function countCalls({ ask }) {
    const { first, later, milliseconds } = await ask('count', { what, frames: 5 });
    const sum = (calls) => Object.values(calls).reduce((sum, count) => sum + count, 0);
    console.log(`${sum(first)} calls for the first picture, ${sum(later)} for a later one in`
        + ` ${milliseconds.toFixed(2)} ms (${what.scene}, drawn in software)`);
    if (first.texSubImage2D !== 1 || later.texSubImage2D || later.getUniformLocation || sum(later) > 100) {
        fail(`too many calls: ${JSON.stringify({ first, later })}`);
    }
}

await run([bundle, modules], async (browser) => {
    const open = async (options) => {
        const painter = await openPainter(browser, { width, height, ...options });
        if (painter.begun.workers !== (options.isolated ? options.threads - 1 : 0) || painter.begun.trouble) {
            fail(`it did not begin: ${JSON.stringify(painter.begun)}`);
        }
        return painter;
    };
    const painter = await open({ isolated: true, threads: 2 });
    await countCalls(painter);
    await comparePictures(painter);
    const picture = await painter.ask('picture', what);
    await tryCanvas(painter, picture);
    browser.takeTroubles().forEach((trouble) => /CONTEXT_LOST/.test(trouble) || fail(trouble));
    await painter.close();
    for (const options of [{ isolated: true, threads: 2, refusing: true }, { isolated: false, threads: 1 }]) {
        const other = await open(options);
        await same(`with ${JSON.stringify(options)}`, other.ask('picture', what), picture);
        await other.close();
    }
});
await run([bundle, modules], async (browser) => {
    const { begun } = await openPainter(browser, { width, height, threads: 1 });
    if (begun.trouble !== 'unsupported' || !/WebGL 2/.test(begun.reason)) {
        fail(`no WebGL is told as ${JSON.stringify(begun)}`);
    }
}, { flags: ['--use-gl=disabled'] });
