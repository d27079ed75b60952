// What people do with the page and what they see of it, for page.js, device.js and files.js.
//
// Invariant: each trial opens pages of its own, and looks at what a person would see or hear; what the
// simulation holds is asked for only where it does not show.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';

import { longest } from './harness.js';

const fromWeb = createRequire(new URL('../../../web/package.json', import.meta.url));
export const { decode } = await import(fromWeb.resolve('fast-png'));

export const phone = { width: 360, height: 740, touch: true, isolated: true };
export const desk = { width: 960, height: 600, isolated: true };
/** Drawn fast where a processor draws. */
export const small = { width: 400, height: 400, isolated: true };

/** What the simulation has told last. */
export const stateOf = (page) => page.evaluate(() => window.skvalp.state.value);

/** Waits until something holds of the state. */
export async function until(page, holds, what, given) {
    await page.waitForFunction(holds, given).catch(() => assert.fail(`in vain: ${what}`));
}

/** Gives the page another size, and waits until it has it. */
export async function resize(page, width, height) {
    await page.setViewportSize({ width, height });
    await until(page, ([width, height]) => innerWidth === width && innerHeight === height, `it is ${width}x${height}`, [width, height]);
}

/** Waits until water is there. */
export async function water(page) {
    await until(page, () => window.skvalp?.state.value?.worlds[0].particles > 0, 'water comes');
    return page;
}

/** Of a device that was here before: a measurement takes a while, and gives less beside other tests. */
const measuredBefore = () => void (localStorage.skvalp ??= '{"measured":1000}');

/** Opens the page, unless `isNew` on a device that was measured before, and waits until water is there. */
export async function begin(browser, { isNew = false, ...view }, query = '') {
    const before = [isNew ? [] : measuredBefore, view.before ?? []].flat();
    return water(await browser.open(`/index.html${query}`, { ...view, before }));
}

/** Opens the page, where a script goes before that of the simulation's worker, and waits until water is there. */
export async function beginAfter(browser, script, view, query = '') {
    const page = await browser.open('/empty.html', view);
    let put = false;
    // Of the context, for a page's own routes miss a worker that is hired at once.
    await page.context().route('**/simulation.worker-*.js', async (route) => {
        put = true;
        const response = await route.fetch();
        await route.fulfill({ response, body: `${script}\n${await response.text()}` });
    });
    await page.goto(new URL(`/index.html${query}`, page.url()).href);
    await water(page);
    assert.ok(put, 'the worker began without the script');
    return page;
}

export const button = (page, name) => page.getByRole('button', { name, exact: true });
export const close = (page) => page.keyboard.press('Escape');

export async function chooseFromMenu(page, name) {
    await button(page, 'Main menu').click();
    await button(page, name).click();
}

/** What is said to be wrong, which is then closed. */
export async function complaint(page, words) {
    const alert = page.getByRole('alert').filter({ hasText: words });
    await alert.waitFor();
    const text = await alert.textContent();
    await button(page, 'Close this message').click();
    await alert.waitFor({ state: 'detached' });
    return text;
}

/** The browser's own tools, of this page. */
export async function devtools(page) {
    return page.devtools ??= await page.context().newCDPSession(page);
}

/** Waits until the picture has the room that chips leave, and the last grip lies where the state says. */
export const settled = (page, count) => until(page, (count) => {
    const { area, camera: { scale, originX, originY }, probes } = window.skvalp.state.value.worlds[0];
    const stage = document.querySelector('.stage').getBoundingClientRect();
    const grip = [...document.querySelectorAll('.grip .disc')].at(-1)?.getBoundingClientRect();
    const probe = probes[count - 1];
    return probes.length === count && document.querySelectorAll('.chip').length === count
        && area.height === stage.height
        && Math.abs(grip.x + grip.width / 2 - stage.x - originX - scale * probe.x0) < 1
        && Math.abs(grip.y + grip.height / 2 - stage.y - originY + scale * probe.y0) < 1;
}, 'an instrument lies where the state says', count);

/** Before a page begins: keeps in `window.said` what it tells, for messages go by themselves. */
export function keepMessages() {
    window.said = '';
    new MutationObserver(() => (window.said += document.querySelector('.messages')?.textContent))
        .observe(document, { childList: true, characterData: true, subtree: true });
}

/** Waits until such words were told, though they may have gone; of a page that began with keepMessages. */
export const wasTold = (page, words) => until(page, (words) => window.said.includes(words), `it tells: ${words}`, words);

/** Fingers as a touch screen has them: [x, y] each. */
export async function touch(page, type, ...points) {
    const touchPoints = points.map(([x, y], id) => ({ x, y, id }));
    await (await devtools(page)).send('Input.dispatchTouchEvent', { type, touchPoints });
}

/**
 * What is blue in the picture, or in a part of it, as water is: its share of it, and its middle, in shares
 * of the width and height from the upper left corner.
 */
export async function blue(page, part) {
    const clip = { ...part ?? await page.locator('canvas.canvas').boundingBox(), scale: 1 };
    // Playwright's own screenshots turn an emulated screen back.
    const shot = await (await devtools(page)).send('Page.captureScreenshot', { clip });
    const { data, channels, width, height } = decode(Buffer.from(shot.data, 'base64'));
    let count = 0, x = 0, y = 0;
    for (let i = 0; i < width * height; i++) {
        if (data[i * channels + 2] > 150 && data[i * channels] < 110) {
            count++;
            x += (i % width + 0.5) / width;
            y += (Math.floor(i / width) + 0.5) / height;
        }
    }
    return { share: count / (width * height), x: x / count, y: y / count };
}

/** Waits until something holds of what `look` gives, which is then given. */
export async function untilSeen(look, holds, what) {
    const end = Date.now() + longest;
    for (;;) {
        const now = await look();
        if (holds(now)) {
            return now;
        }
        assert.ok(Date.now() < end, `in vain: ${typeof what === 'string' ? what : what(now)}`);
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
}

/** Waits until what is blue stays as it is, for the last picture may be on its way; gives that. */
export async function stillBlue(page) {
    let last;
    return untilSeen(() => blue(page), (now) => {
        const before = last;
        last = now;
        return before?.x === now.x && before.y === now.y && before.share === now.share;
    }, 'the picture stands still');
}

/** Waits until something holds of what is blue, or of a part of it. */
export const untilBlue = (page, holds, what, part) =>
    untilSeen(() => blue(page, part), holds, (now) => `${what}, at last ${JSON.stringify(now)}`);
