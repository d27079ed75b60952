// What a finger does on the page, as a touch screen tells it: all that can be dragged goes the full way.
// Arguments: the folder of the built page.
import assert from 'node:assert/strict';

import { begin, button, chooseFromMenu, close, phone, settled, stateOf, touch, until } from './people.js';
import { carryOut } from './trials.js';

const [folder] = process.argv.slice(2);

/** Drags what lies at a place, by a finger that moves as one does: in steps, each told by itself. */
async function drag(page, [x, y], [dx, dy]) {
    const steps = 6;
    await touch(page, 'touchStart', [x, y]);
    for (let i = 1; i <= steps; i++) {
        await touch(page, 'touchMove', [x + dx * i / steps, y + dy * i / steps]);
    }
    await touch(page, 'touchEnd');
}

async function middleOf(element) {
    const { x, y, width, height } = await element.boundingBox();
    return [x + width / 2, y + height / 2];
}

/** The place that both must have, in CSS pixels, to one. */
function same([x, y], [wantedX, wantedY], what) {
    assert.ok(Math.hypot(x - wantedX, y - wantedY) < 2,
        `${what} went to ${[x, y].map(Math.round)}, the finger to ${[wantedX, wantedY].map(Math.round)}`);
}

const trials = {
    async 'all that can be dragged follows a finger the full way'(browser) {
        const page = await begin(browser, phone, '?scene=pool&paused=1');
        await page.evaluate(() => (window.cancelled = 0, addEventListener('pointercancel', () => window.cancelled++)));
        const whole = async (what) => assert.equal(await page.evaluate(() => window.cancelled), 0, `${what}: the browser took it`);

        const kinds = await page.evaluate(async () => (await window.skvalp.simulation.catalogue()).gauges.map(({ kind }) => kind));
        assert.ok(kinds.length > 3);
        const add = (kind, x, y) => page.evaluate(([kind, x, y]) => {
            const { worlds: [{ width, height }] } = window.skvalp.state.value;
            window.skvalp.simulation.addProbe(kind, x * width, y * height, (x + 0.3) * width, (y + 0.2) * height);
        }, [kind, x, y]);
        await add(kinds[0], 0.1, 0.9); // stays, and with it the room for chips
        await settled(page, 1);
        for (const kind of kinds) {
            await add(kind, 0.4, 0.3);
            const grips = page.locator('.grip .disc');
            await settled(page, 2);
            const ends = await grips.count();
            for (let end = 1; end < ends; end++) {
                await settled(page, 2);
                const before = await middleOf(grips.nth(end));
                const way = [-70, 96];
                await drag(page, before, way);
                const wanted = [before[0] + way[0], before[1] + way[1]];
                await page.waitForFunction(([end, x, y]) => {
                    const box = document.querySelectorAll('.grip .disc')[end].getBoundingClientRect();
                    return Math.hypot(box.x + box.width / 2 - x, box.y + box.height / 2 - y) < 2;
                }, [end, ...wanted]).catch(() => undefined);
                same(await middleOf(grips.nth(end)), wanted, `instrument ${kind}, grip ${end} of ${ends - 1}`);
                await whole(`instrument ${kind}`);
            }
            const { probes: [, { id }] } = (await stateOf(page)).worlds[0];
            await page.evaluate((id) => window.skvalp.simulation.removeProbe(id), id);
            await grips.nth(1).waitFor({ state: 'detached' });
        }

        await drag(page, await middleOf(page.locator('.ball')), [32, 0]); // to the rim: twice as strong
        await until(page, () => Math.abs(window.skvalp.state.value.gravity.x - 2) < 0.05, 'the ball at its rim');
        await whole('the ball');

        await button(page, 'Play').click();
        await until(page, () => window.skvalp.state.value.moment > 40, 'time to go back over');
        await button(page, 'Pause').click();
        await until(page, () => window.skvalp.state.value.paused, 'it waits');
        const bar = page.getByRole('slider', { name: 'Rewind' });
        const { x, y, width, height } = await bar.boundingBox();
        const { end } = await stateOf(page);
        // A finger that slants is not the browser's.
        await drag(page, [x + width - 8, y + height / 2], [-width / 2, -height]);
        await until(page, (end) => Math.abs(window.skvalp.state.value.moment - end / 2) < 0.1 * end, 'the bar at half of its way', end);
        await whole('the bar');

        await button(page, 'Size of the tool').click();
        const size = page.getByRole('slider', { name: 'Size of the tool' });
        await size.waitFor();
        await until(page, () => document.getAnimations().length === 0, 'the sheet has risen');
        const slider = await size.boundingBox();
        const { brush: first } = await stateOf(page);
        await drag(page, [slider.x + 12, slider.y + slider.height / 2], [0, 0]);
        await until(page, (first) => window.skvalp.state.value.brush < first / 2, 'the size near its least', first);
        const { brush } = await stateOf(page);
        await drag(page, [slider.x + 12, slider.y + slider.height / 2], [slider.width - 24, 0]);
        await until(page, (brush) => window.skvalp.state.value.brush > 3 * brush, 'the size from its least to its largest', brush);
        await close(page);

        await chooseFromMenu(page, 'Preferences');
        const strength = page.locator('.panel input[type=range]');
        await strength.scrollIntoViewIfNeeded();
        await until(page, () => document.getAnimations().length === 0, 'the preferences have risen');
        const range = await strength.boundingBox();
        await drag(page, [range.x + range.width / 2, range.y + range.height / 2], [range.width / 2, 0]);
        await until(page, () => JSON.parse(localStorage.skvalp).tilt === 2, 'the strength at its largest');
        await close(page);

        await button(page, 'Wall').click();
        await drag(page, [60, 300], [120, 40]);
        await until(page, () => window.skvalp.state.value.canUndo, 'a wall from a finger');
        await whole('the wall');

        // Over what does not move a finger moves nothing: it does not go back in the browser's history.
        await chooseFromMenu(page, 'About Skvalp');
        await page.locator('.panel-about h2').waitFor();
        await until(page, () => document.getAnimations().length === 0, 'it has risen');
        const text = await page.locator('.panel-about h2').boundingBox();
        await drag(page, [28, text.y + text.height / 2], [300, 0]);
        await drag(page, [28, y - 2], [300, 0]);
        await close(page);

        // A sheet longer than its room follows a finger, too.
        await chooseFromMenu(page, 'Keyboard Shortcuts');
        await page.locator('.panel .keys').first().waitFor();
        await until(page, () => document.getAnimations().length === 0, 'this sheet has risen, too');
        const sheet = page.locator('.panel');
        const box = await sheet.boundingBox();
        await drag(page, [180, box.y + box.height - 40], [0, -160]);
        await page.waitForFunction(() => document.querySelector('.panel').scrollTop > 100
            || document.querySelector('.panel-body').scrollTop > 100);
    },
};

await carryOut([folder], trials, ['all that can be dragged follows a finger the full way']);
