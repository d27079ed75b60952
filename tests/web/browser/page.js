// The page in Chromium, as people use it. Arguments: the folder of the built page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

import {
    begin, beginAfter, button, chooseFromMenu, close, desk, keepMessages, phone, settled, small, stateOf, touch,
    until, untilSeen, wasTold, water,
} from './people.js';
import { carryOut } from './trials.js';

const [folder] = process.argv.slice(2);
const axe = createRequire(new URL('../../../web/package.json', import.meta.url)).resolve('axe-core/axe.min.js');

/** What axe-core finds wrong with what shows now; and what can be read only by scrolling sideways. */
async function faults(page, what) {
    if (!(await page.evaluate(() => 'axe' in window))) {
        await page.addScriptTag({ path: axe });
    }
    const found = await page.evaluate(async () => {
        const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
        const { violations } = await window.axe.run(document, { runOnly: tags });
        return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160)).join(' | ')}`);
    });
    const wide = await page.locator('.panel-body').evaluateAll((bodies) => bodies
        .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth + 1)
        .map(({ scrollWidth, clientWidth }) => `${scrollWidth} px wide in ${clientWidth}`));
    return [...found, ...wide].map((fault) => `${what}: ${fault}`);
}

/** Waits until a part of the picture is no longer what it was: the simulation draws when it has time. */
const changed = (look, before, what) => untilSeen(look, (now) => !before.equals(now), what);

const trials = {
    async 'water moves, and rests while paused'(browser) {
        const page = await begin(browser, desk);
        await until(page, () => window.skvalp.state.value.moment > 20, 'time passes');
        const first = await page.locator('canvas').first().screenshot();
        const { moment: then } = await stateOf(page);
        await until(page, (then) => window.skvalp.state.value.moment > then + 10, 'more of it', then);
        await page.keyboard.down(' ');
        await page.keyboard.down(' '); // held
        await page.keyboard.up(' ');
        await until(page, () => window.skvalp.state.value.paused, 'Space pauses');
        await button(page, 'Play').waitFor();
        await changed(() => page.locator('canvas').first().screenshot(), first, 'the picture has not changed');
        assert.match(await page.locator('canvas.canvas').evaluate((canvas) => getComputedStyle(canvas).objectFit),
            /contain|scale-down/, 'a picture that is not drawn in its new size yet is stretched');
        const { moment } = await stateOf(page);
        await page.keyboard.press('.');
        await page.waitForFunction((before) => window.skvalp.state.value.moment === before + 1, moment);
    },

    async 'two fingers hold water'(browser) {
        const page = await begin(browser, phone);
        await touch(page, 'touchStart', [90, 520]);
        await until(page, () => window.skvalp.state.value.worlds[0].hands === 1, 'a hand');
        await touch(page, 'touchStart', [90, 520], [150, 540]);
        await touch(page, 'touchMove', [95, 480], [155, 500]);
        await until(page, () => window.skvalp.state.value.worlds[0].hands === 2, 'two hands');
        await touch(page, 'touchEnd');
        await until(page, () => window.skvalp.state.value.worlds[0].hands === 0, 'no hand');
        assert.equal(await page.evaluate(() => scrollY + document.documentElement.scrollTop), 0);
    },

    async 'what is poured is chosen'(browser) {
        const page = await begin(browser, phone, '?scene=oil&paused=1');
        const chip = (name) => page.getByRole('group', { name: 'What is poured' }).getByRole('button', { name });
        const chosen = (fluid, tool) => until(page, ([fluid, tool]) =>
            window.skvalp.state.value.fluid === fluid && window.skvalp.state.value.tool === tool, `fluid ${fluid}`, [fluid, tool]);
        await chip('oil').click(); // and the tool that pours
        await chosen(1, 2);
        await untilSeen(() => chip('oil').getAttribute('aria-pressed'), (pressed) => pressed === 'true', 'its chip says so');
        const colors = await page.locator('.drop').evaluateAll((drops) => drops.map((drop) => getComputedStyle(drop).backgroundColor));
        const { worlds: [{ fluids, particles, camera }] } = await stateOf(page);
        const canvas = await page.locator('canvas.canvas').boundingBox();
        assert.deepEqual(fluids.map(({ name }) => name), ['water', 'oil']);
        assert.notEqual(...colors);
        await touch(page, 'touchStart', [
            canvas.x + camera.originX + 0.8 * camera.scale, canvas.y + camera.originY - 0.75 * camera.scale,
        ]);
        await until(page, (before) => window.skvalp.state.value.worlds[0].particles > before, 'oil is poured', particles);
        await touch(page, 'touchEnd');
        await page.keyboard.press('n');
        await chosen(0, 2);
        await page.keyboard.press('n');
        await chosen(1, 2);
        assert.deepEqual(await faults(page, 'chips'), []);
        const other = await begin(browser, phone, '?scene=pool');
        assert.equal(await other.locator('.drop').count(), 0, 'a choice of one fluid');
    },

    async 'bodies come with a larger module, are drawn, float, and can be thrown'(browser) {
        const page = await begin(browser, desk, '?paused=1&view=pressure');
        const modules = [];
        page.context().on('request', (request) => modules.push(request.url().replace(/.*\//, '')));
        await page.evaluate(() => window.skvalp.simulation.setDye(2));
        const { worlds: [{ opened }], threads } = await stateOf(page);
        const duck = readFileSync(new URL('../../../examples/duck.json', import.meta.url), 'utf8');
        await page.evaluate((text) => window.skvalp.simulation.openBytes(
            new TextEncoder().encode(text), 'json', 'duck.json', { particles: '1500' }), duck);
        await until(page, () => window.skvalp.state.value.worlds[0].title === 'Duck', 'the duck is there');
        assert.ok(modules.some((file) => /^bodies(-threads)?-/.test(file)), `of ${modules.join()} none has bodies`);
        const state = await stateOf(page);
        assert.ok(state.worlds[0].opened > opened, 'nothing else was opened');
        assert.deepEqual([state.paused, state.moment, state.style.view, state.dye, state.threads, state.worlds[0].particles > 1400],
            [true, 0, 'pressure', 2, threads, true], 'what was chosen is lost');
        const { camera } = state.worlds[0];
        const canvas = await page.locator('canvas.canvas').boundingBox();
        const at = (x, y) => [canvas.x + camera.originX + camera.scale * x, canvas.y + camera.originY - camera.scale * y];
        /** Around a place of the world. */
        const look = async (x, y) => {
            const [left, top] = at(x, y);
            return page.screenshot({ clip: { x: Math.round(left) - 3, y: Math.round(top) - 3, width: 6, height: 6 } });
        };
        const air = await look(0.9, 0.8);
        await changed(() => look(0.42, 0.58), air, 'no duck is drawn');
        const head = await look(0.42, 0.58);
        await page.evaluate(() => window.skvalp.simulation.setPaused(false));
        await until(page, () => window.skvalp.state.value.moment > 90, 'time passes');
        await changed(() => look(0.42, 0.58), head, 'the duck hovers');

        /* By hand into the air. */
        await page.mouse.move(...at(0.48, 0.38));
        await page.mouse.down();
        await page.mouse.move(...at(0.48, 0.7), { steps: 12 });
        await until(page, () => window.skvalp.state.value.worlds[0].hands === 1, 'a hand');
        await changed(() => look(0.44, 0.69), air, 'the duck is not lifted'); // beside the hand's own mark
        await page.mouse.up();

        /* What has none is still opened, and so are links. */
        await page.evaluate(() => window.skvalp.simulation.open('pool'));
        await until(page, () => window.skvalp.state.value.worlds[0].name === 'pool', 'the pool is there');
    },

    async 'scenes with bodies or jelly come by an address, from the gallery and by a link'(browser) {
        const page = await begin(browser, desk, '?scene=duck&particles=600');
        await until(page, () => window.skvalp.state.value.worlds[0].name === 'duck', 'the duck is there');
        assert.deepEqual([await page.getByRole('alert').count(), (await stateOf(page)).worlds[0].opened], [0, 1], 'it comes at once');
        await until(page, () => window.skvalp.state.value.moment > 20, 'time passes');
        const { particles } = (await stateOf(page)).worlds[0]; // five sixths of them, and what has flowed
        assert.ok(particles >= 480 && particles < 700, `${particles} particles`);
        const other = await begin(browser, desk, '?scene=pool&particles=600');
        await button(other, 'Scenes and experiments').click();
        await other.locator('.card', { hasText: 'Jelly on a slide' }).click();
        await until(other, () => window.skvalp.state.value.worlds[0].name === 'jelly', 'the jelly is there');
        const { worlds: [jelly] } = await stateOf(other);
        assert.deepEqual([jelly.particles, jelly.fluids.length], [600, 4]);
        const link = await other.evaluate(() => window.skvalp.simulation.share());
        const third = await begin(browser, desk, '?paused=1');
        await third.evaluate((link) => window.skvalp.simulation.openLink(link), link.replace(/.*#/, ''));
        await until(third, () => window.skvalp.state.value.worlds[0].name === 'jelly', 'the link opens');
        assert.equal((await stateOf(third)).worlds[0].particles, 600);
    },

    async 'the tool that drops bodies brings what they take, and links have them'(browser) {
        const page = await begin(browser, desk, '?scene=pool&particles=500');
        await until(page, () => window.skvalp.state.value.moment > 20, 'time passes');
        const { worlds: [{ opened, camera: seen }], tool } = await stateOf(page);
        const stop = () => page.evaluate(() => window.skvalp.simulation.setPaused(true));
        await button(page, 'Water').click();
        const pane = await page.locator('canvas.canvas').boundingBox();
        await page.mouse.click(pane.x + seen.originX + 0.4 * seen.scale, pane.y + seen.originY - 0.8 * seen.scale);
        await until(page, () => window.skvalp.state.value.worlds[0].particles > 500 && window.skvalp.state.value.canUndo, 'water is poured');
        const { moment, worlds: [{ particles }] } = await stateOf(page);
        await button(page, 'Body').click();
        await until(page, (before) => window.skvalp.state.value.worlds[0].opened > before, 'the larger module goes on', opened);
        // With all that was done, which can still be undone.
        await until(page, (before) => window.skvalp.state.value.moment > before && !window.skvalp.state.value.watching, 'it goes on where it was', moment);
        const state = await stateOf(page);
        assert.notEqual(state.tool, tool);
        assert.deepEqual([state.worlds[0].name, state.paused], ['pool', false]);
        assert.ok(state.worlds[0].particles >= particles, 'what was poured is gone');
        assert.equal(state.asRecorded, false, 'one\'s own game is told of as a recorded one');
        await button(page, 'Undo').click();
        await until(page, () => window.skvalp.state.value.worlds[0].particles === 500, 'what was done before is undone');
        await stop();
        await until(page, () => window.skvalp.state.value.paused, 'it stands still');
        const { camera } = state.worlds[0];
        const canvas = await page.locator('canvas.canvas').boundingBox();
        const x = canvas.x + camera.originX + 0.8 * camera.scale, y = canvas.y + camera.originY - 0.7 * camera.scale;
        const look = () => page.screenshot({ clip: { x: Math.round(x) - 3, y: Math.round(y) - 3, width: 6, height: 6 } });
        await page.mouse.move(x + 200, y);
        const air = await look();
        await page.mouse.click(x, y);
        await until(page, () => window.skvalp.state.value.canUndo, 'a body is dropped');
        await page.mouse.move(x + 200, y);
        await changed(look, air, 'no body is drawn');
        await page.evaluate(() => window.skvalp.simulation.setPaused(false));
        const from = (await stateOf(page)).moment;
        await until(page, (from) => window.skvalp.state.value.moment > from + 20, 'it falls', from);
        await stop();
        const link = await page.evaluate(() => window.skvalp.simulation.share());
        const other = await begin(browser, desk, '?paused=1');
        await other.evaluate((link) => window.skvalp.simulation.openLink(link), link.replace(/.*#/, ''));
        await until(other, () => window.skvalp.state.value.worlds[0].name === 'pool', 'the link opens');
        await other.evaluate(() => window.skvalp.simulation.setPaused(false));
        await until(other, () => window.skvalp.state.value.asRecorded, 'it goes as it was recorded');
    },

    async 'jelly and air come with the larger module and move'(browser) {
        for (const [name, title] of [['jelly', 'Jelly, clay and goo'], ['air', 'A glass, a bottle and their air']]) {
            const page = await begin(browser, desk);
            const scene = readFileSync(new URL(`../../../examples/${name}.json`, import.meta.url), 'utf8');
            await page.evaluate(([text, name]) => window.skvalp.simulation.openBytes(
                new TextEncoder().encode(text), 'json', `${name}.json`, { particles: '800' }), [scene, name]);
            await until(page, (title) => window.skvalp.state.value.worlds[0].title === title, `the ${name} is there`, title);
            await until(page, () => window.skvalp.state.value.moment > 20, 'time passes');
        }
    },

    async 'a wall is drawn and undone'(browser) {
        const page = await begin(browser, desk);
        await button(page, 'Wall').click();
        await page.mouse.move(400, 150);
        await page.mouse.down();
        await page.mouse.move(600, 200, { steps: 5 });
        await page.mouse.up();
        await until(page, () => window.skvalp.state.value.canUndo, 'a wall can be undone');
        await button(page, 'Undo').click();
        await until(page, () => window.skvalp.state.value.canRedo, 'and redone');
        await page.keyboard.press('Control+Shift+z');
        await until(page, () => window.skvalp.state.value.canUndo, 'it is back');
        const zoomed = (times) => until(page, (times) =>
            Math.abs(window.skvalp.state.value.worlds[0].camera.zoom - times) < 1e-3, `${times} times as large`, times);
        await page.mouse.move(600, 200);
        await page.mouse.wheel(0, -100);
        await zoomed(1.15);
        const { limits } = await page.evaluate(() => window.skvalp.simulation.catalogue());
        await page.keyboard.press('Control++');
        await zoomed(1.15 * limits.zoom_step);
        await page.keyboard.press('Control+0');
        await zoomed(1);
    },

    async 'a probe reads, moves and shows its curve'(browser) {
        const page = await begin(browser, desk, '?scene=pool');
        await page.keyboard.press('m');
        const chip = page.locator('.chip');
        await chip.filter({ hasText: /Pressure.*\d+\.\d\scm of water/ }).waitFor();
        const beside = page.locator('.probes .reading');
        await beside.filter({ hasText: /^\d+\.\d\scm of water$/ }).waitFor();
        const before = (await stateOf(page)).worlds[0].probes[0].x0;
        await chip.focus();
        await page.evaluate(() => { // a held key, between two states
            for (const repeat of [false, true, true, true, true]) {
                const event = new KeyboardEvent('keydown', { key: 'ArrowRight', repeat, bubbles: true });
                document.activeElement.dispatchEvent(event);
            }
        });
        await until(page, (x) => Math.abs(window.skvalp.state.value.worlds[0].probes[0].x0 - x) < 1e-6,
            'each step of a held key counts', before + 0.05);
        await chip.press('Shift+ArrowLeft');
        await until(page, (x) => Math.abs(window.skvalp.state.value.worlds[0].probes[0].x0 - x) < 1e-6,
            'with Shift it is a millimetre', before + 0.049);
        await settled(page, 1);
        const { probes: [{ x0 }], camera: { scale } } = (await stateOf(page)).worlds[0];
        const { x, y, width, height } = await page.locator('.grip .disc').boundingBox();
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down();
        await page.mouse.move(x + width / 2 + 120, y + height / 2, { steps: 24 });
        await page.mouse.up();
        await until(page, (place) => Math.abs(window.skvalp.state.value.worlds[0].probes[0].x0 - place) < 0.01,
            'the probe is where it was dragged', x0 + 120 / scale);
        assert.deepEqual(await page.evaluate(() => ['.grip .disc', '.ball circle', '.status', '.canvas'].filter((name) =>
            document.querySelector(name).dispatchEvent(new Event('selectstart', { bubbles: true, cancelable: true })))),
        [], 'what is dragged selects text, as WebKit does it');
        // Paused, and under the mouse: another one reads at once, and says why it reads nothing.
        await page.keyboard.press(' ');
        await until(page, () => window.skvalp.state.value.paused, 'it is paused');
        const { left, top, wide } = await page.locator('.canvas').evaluate((canvas) => {
            const { x, y, width } = canvas.getBoundingClientRect();
            return { left: x, top: y, wide: width };
        });
        await page.mouse.move(left + wide * 0.7, top + 60);
        await page.keyboard.press('m');
        await beside.filter({ hasText: /^no water here$/ }).waitFor();
        const { probes: [, dry], camera } = (await stateOf(page)).worlds[0];
        assert.ok(Math.abs(camera.originX + camera.scale * dry.x0 - wide * 0.7) < 2, 'it is not under the mouse');
        await page.evaluate((id) => window.skvalp.simulation.removeProbe(id), dry.id);
        await page.keyboard.press(' ');
        await page.evaluate(() => window.skvalp.simulation.compare({ 'gravity.y': '-5' }));
        await page.waitForFunction(() => {
            const [, a, b] = document.querySelector('.chip')?.textContent.match(/A: (.*?)  B: (.*)/) ?? [];
            return a && a !== b;
        });
        await page.evaluate(() => window.skvalp.simulation.compare(null));
        await chip.click();
        await page.locator('.plot [role=img]').waitFor();
        await button(page, 'Remove').click();
        await chip.waitFor({ state: 'detached' });
        await page.locator('dialog').waitFor({ state: 'detached' });
        // Of ten, each new one's chip is in sight.
        for (let count = 1; count <= 10; count++) {
            await page.keyboard.press('m');
            await until(page, (count) => {
                const chips = document.querySelectorAll('.chip'), last = chips[count - 1]?.getBoundingClientRect();
                return chips.length === count && last.left >= 0 && last.right <= innerWidth;
            }, 'the new chip is in sight', count);
        }
    },

    async 'numbers are read and typed as Swedish has them'(browser) {
        const page = await begin(browser, desk, '?scene=waves&lang=sv');
        await page.keyboard.press('m');
        await page.locator('.chip').filter({ hasText: /\d,\d\scm vatten/ }).waitFor();
        assert.match(await page.locator('.clock').textContent(), /^\d+,\d\u00a0s/);
        const { particles } = (await stateOf(page)).worlds[0];
        const grouped = String(particles).replace(/\B(?=(\d{3})+$)/g, '\u00a0');
        assert.equal(await page.locator('.amount').textContent(), `${grouped} partiklar`);
        await page.keyboard.press('p');
        const field = page.locator('[id="field-gravity.y"]');
        await until(page, () => document.getElementById('field-gravity.y')?.value === '\u22129,81', 'a minus and a comma');
        await field.fill(' \u22123,71');
        await field.press('Enter');
        await until(page, () => window.skvalp.state.value.worlds[0].parameters['gravity.y'] === '-3.71', 'it was read');
        await untilSeen(() => field.inputValue(), (value) => value === '\u22123,71', 'it shows as it was read');
        assert.equal((await stateOf(page)).style.comma, true);

        // What is refused stays as it was typed, with the reason below it, until something else is.
        const wrong = page.getByRole('alert').filter({ hasText: /från \u2212\d/ });
        for (const text of ['tre', '9000', '']) {
            await field.fill(text);
            const { moment } = await stateOf(page); // what comes meanwhile takes nothing of it away
            await until(page, (moment) => window.skvalp.state.value.moment > moment + 3, 'time passes', moment);
            await field.press('Enter');
            await wrong.filter({ hasText: 'Ange ett tal' }).waitFor();
            assert.deepEqual([await field.inputValue(), await field.getAttribute('aria-invalid')], [text, 'true']);
            const described = (await field.getAttribute('aria-describedby')).split(' ')[0];
            assert.equal(described, await wrong.getAttribute('id'));
        }
        assert.equal(await page.locator('.messages').textContent(), '');
        assert.equal((await stateOf(page)).worlds[0].parameters['gravity.y'], '-3.71');
        await field.fill('\u22121,62');
        await field.press('Enter');
        await wrong.waitFor({ state: 'detached' });
        await until(page, () => window.skvalp.state.value.worlds[0].parameters['gravity.y'] === '-1.62', 'it was taken');
        await untilSeen(async () => [await field.inputValue(), await field.getAttribute('aria-invalid')].join(),
            (value) => value === '\u22121,62,false', 'it shows as it was taken');
    },

    async 'a browser whose language is none has plots'(browser) {
        const noLanguage = () => Object.defineProperties(Navigator.prototype, {
            language: { get: () => 'C' }, languages: { get: () => ['C'] },
        });
        const page = await begin(browser, { ...desk, before: noLanguage });
        await page.keyboard.press('m');
        await page.locator('.chip').click();
        await page.locator('.plot [role=img]').waitFor();
    },

    async 'what was done goes on after the page was left, and what is damaged is refused in words'(browser) {
        // It is kept when it is left alone: what is kept every ten seconds would be the newest, whenever that was.
        const keepsNothingByItself = () => {
            const { setInterval } = window;
            window.setInterval = (act, ms, ...given) => ms >= 5000 ? 0 : setInterval(act, ms, ...given);
        };
        const page = await begin(browser, { ...small, before: keepsNothingByItself }, '?scene=pool&particles=500');
        const build = async (page) => {
            await page.keyboard.press('2');
            await page.mouse.move(150, 150);
            await page.mouse.down();
            await page.mouse.move(250, 160, { steps: 4 });
            await page.mouse.up();
            await until(page, () => window.skvalp.state.value.canUndo, 'a wall');
        };
        const inStore = (mode, text) => page.evaluate(([mode, text]) => new Promise((resolve) => {
            const opening = indexedDB.open('skvalp');
            opening.onupgradeneeded = () => opening.result.createObjectStore('kept');
            opening.onsuccess = () => {
                const transaction = opening.result.transaction('kept', mode), store = transaction.objectStore('kept');
                if (text !== null)
                    store.clear();
                const asked = text === null ? store.openCursor(null, 'prev') // the newest
                    : store.put({ title: '', bytes: new TextEncoder().encode(text) }, 'kept');
                transaction.oncomplete = () => {
                    opening.result.close();
                    resolve(asked.result?.value?.title ?? '');
                };
            };
        }), [mode, text]);
        await page.keyboard.press('m');
        await page.locator('.chip').waitFor();
        await build(page);
        await page.keyboard.press(' ');
        await until(page, () => window.skvalp.state.value.paused, 'it waits');
        const { time } = (await stateOf(page)).worlds[0];
        for (let i = 0; i < 2; i++) { // the first may end what was being kept before it stood still
            await inStore('readwrite', '');
            await page.evaluate(() => window.dispatchEvent(new Event('pagehide')));
            while (await inStore('readonly', null) !== 'Pool') {
                await page.waitForTimeout(50);
            }
        }

        // Another tab, which is left later, keeps its own world beside it.
        const other = await page.context().newPage();
        await other.addInitScript(keepsNothingByItself);
        await other.goto(page.url().replace(/\?.*/, '?scene=fountain&particles=500'));
        await water(other);
        await build(other);
        await other.evaluate(() => window.dispatchEvent(new Event('pagehide')));
        while (await inStore('readonly', null) !== 'Fountain') {
            await page.waitForTimeout(50);
        }
        await other.close();

        await page.goto(page.url().replace(/\?.*/, ''));
        await water(page);
        await page.getByText('Kept: Fountain').waitFor();
        await button(page, 'Go On There').click();
        await until(page, () => window.skvalp.state.value.worlds[0].name === 'fountain', 'the newest goes on');
        await chooseFromMenu(page, 'Go On Where You Were');
        await until(page, ([time]) => {
            const { worlds: [world], paused, moment } = window.skvalp.state.value;
            return world.name === 'pool' && world.time === time && world.probes.length === 1 && paused && moment === 0;
        }, 'it goes on where it was', [time]);
        await button(page, 'Go On There').waitFor({ state: 'detached' });

        // Whoever closed the message finds it in the menu; it may be anything by then.
        await inStore('readwrite', 'no world');
        await page.reload();
        await water(page);
        await page.getByText('Your last world was kept').waitFor();
        // What there is to say of a scene that is opened meanwhile stands beside the offer.
        await page.evaluate(() => window.skvalp.simulation.open('funnel', { particles: '300' }));
        await page.getByText(/^Your last world was kept; 1 green area emits fluid/).waitFor();
        await button(page, 'Go On There').waitFor();
        await button(page, 'Close this message').click();
        await chooseFromMenu(page, 'Go On Where You Were');
        await page.getByText('What was kept from last time is damaged; it is gone.').waitFor();
        assert.equal(await page.getByRole('alert').count(), 0);
        assert.equal((await stateOf(page)).worlds[0].name, 'funnel');
        while (await inStore('readonly', null) !== '') {
            await page.waitForTimeout(50);
        }
        await page.reload();
        await water(page);
        await button(page, 'Main menu').click();
        await button(page, 'About Skvalp').waitFor();
        assert.equal(await button(page, 'Go On Where You Were').count(), 0);
    },

    async 'time goes back'(browser) {
        const page = await begin(browser, small);
        await until(page, () => window.skvalp.state.value.moment > 35, 'time passes');
        await page.keyboard.press('Shift+ArrowLeft');
        await until(page, () => {
            const { moment, end, paused, seeking } = window.skvalp.state.value;
            return paused && !seeking && moment <= end - 30;
        }, 'a second back');
        const bar = page.getByRole('slider', { name: 'Rewind' });
        await bar.focus();
        const { moment } = await stateOf(page);
        await page.keyboard.press('ArrowRight');
        await page.waitForFunction((before) => window.skvalp.state.value.moment === before + 1, moment);
    },

    async 'a link opens the same game, as it was seen'(browser) {
        const page = await begin(browser, small, '?scene=splash&particles=500');
        await page.keyboard.press('v');
        await page.keyboard.press('m');
        await page.evaluate(() => window.skvalp.simulation.compareWith('honey'));
        await until(page, () => window.skvalp.state.value.worlds.length === 2, 'another world');
        await until(page, () => window.skvalp.state.value.moment > 10, 'it plays');
        await page.mouse.move(200, 150);
        await page.mouse.down();
        await page.mouse.move(230, 100, { steps: 4 });
        await page.mouse.up();
        await page.keyboard.press(' ');
        await until(page, () => window.skvalp.state.value.paused, 'it stands still');
        await button(page, 'Main menu').click();
        await button(page, 'Share').click();
        const field = page.getByRole('textbox', { name: 'Link' });
        await page.waitForFunction(() => document.querySelector('textarea.link')?.value.includes('#1.'));
        await page.locator('svg.qr').waitFor();
        const link = new URL(await field.inputValue());
        const other = await browser.open(`/index.html${link.hash}`, { ...small, before: keepMessages });
        await until(other, () => window.skvalp?.state.value?.asRecorded, 'it goes as it was sent');
        await wasTold(other, 'exactly as it was recorded');
        await until(other, () => window.skvalp.state.value.worlds.length === 2, 'beside the other');
        await until(other, () => window.skvalp.state.value.paused, 'it waits where the other did');
        await until(other, () => window.skvalp.state.value.style.view === 'pressure', 'it shows what the other showed');
        const seen = async (page) => {
            const { worlds, style, choice, moment } = await stateOf(page);
            const probes = worlds.map(({ probes }) => probes.map(({ kind, x0, y0 }) => [kind, x0, y0]));
            return [style.view, probes, choice, moment, worlds.map(({ particles }) => particles)];
        };
        assert.deepEqual(await seen(other), await seen(page));
        const [view, probes, choice] = await seen(other);
        assert.deepEqual([view, probes[1].length, choice], ['pressure', 1, 'honey']);
    },

    async 'who opens a link watches until they take over'(browser) {
        const page = await begin(browser, small, '?scene=pool&particles=500');
        await until(page, () => window.skvalp.state.value.moment > 60, 'it plays');
        const link = await page.evaluate(() => window.skvalp.simulation.share());
        await page.evaluate(() => window.skvalp.simulation.setSpeed(0.1));
        await page.evaluate((link) => { // however slow it is played, it would be over once it is looked at
            const { simulation, state } = window.skvalp;
            const end = state.subscribe(({ watching }) => watching && (simulation.setPaused(true), setTimeout(() => end())));
            location.hash = link;
        }, link);
        await button(page, 'Take Over').waitFor();
        await until(page, () => window.skvalp.state.value.paused && window.skvalp.state.value.watching, 'it waits on the way');
        const { end } = await stateOf(page);
        await page.mouse.move(200, 150);
        await page.mouse.down();
        await page.getByText('This is a replay').waitFor();
        await page.mouse.up();
        assert.equal((await stateOf(page)).end, end);
        await button(page, 'Take Over').click();
        await until(page, (end) => window.skvalp.state.value.end < end && !window.skvalp.state.value.watching,
            'what was to come is cut off', end);
        await button(page, 'Take Over').waitFor({ state: 'detached' });
        await page.keyboard.press('Control+Shift+Z');
        await until(page, (end) => window.skvalp.state.value.end >= end, 'and had again', end);
        await page.evaluate(() => {
            window.skvalp.simulation.replay();
            window.skvalp.simulation.setPaused(true);
        });
        await button(page, 'Skip to the End').click();
        await until(page, (end) => window.skvalp.state.value.moment >= end && !window.skvalp.state.value.watching,
            'it is over', end);
    },

    async 'back closes a panel, and leads from a link to what was open before'(browser) {
        const page = await begin(browser, small, '?scene=pool');
        const entries = () => page.evaluate(() => history.length);
        const first = await entries();
        await button(page, 'Views').click();
        await page.locator('.panel-views').waitFor();
        await until(page, (first) => history.length === first + 1, 'an entry of its own', first);
        await page.evaluate(() => history.back());
        await page.locator('.panel').waitFor({ state: 'detached' });
        for (let i = 0; i < 3; i++) { // those that are closed by hand leave none
            await button(page, 'Properties').click();
            await until(page, () => history.state?.panel === true, 'it is entered');
            await close(page);
            await until(page, () => history.state?.panel !== true, 'its entry is gone');
        }
        await chooseFromMenu(page, 'About Skvalp'); // one panel takes another's place
        await page.locator('.panel-about').waitFor();
        await until(page, () => history.state?.panel === true, 'it is entered');
        assert.equal(await entries(), first + 1);
        await page.evaluate(() => history.back());
        await page.locator('.panel').waitFor({ state: 'detached' });
        const { opened, name } = (await stateOf(page)).worlds[0];
        assert.equal(name, 'pool');

        const link = await page.evaluate(() => window.skvalp.simulation.share());
        const another = (opened, what) => until(page, (opened) => window.skvalp.state.value.worlds[0].opened !== opened, what, opened);
        await page.evaluate((link) => (location.hash = link), link);
        await another(opened, 'the link');
        const { opened: then } = (await stateOf(page)).worlds[0];
        await page.evaluate(() => history.back());
        await another(then, 'what the address says without it');
        assert.equal((await stateOf(page)).worlds[0].name, 'pool');
    },

    async 'a page that is loaded anew stays, though a panel was entered last'(browser) {
        const page = await begin(browser, small);
        await page.evaluate(() => history.replaceState({ panel: true }, '')); // nothing of the page's lies behind
        await page.reload();
        await water(page);
        await until(page, () => history.state?.panel !== true, 'nothing is entered');
        assert.equal(new URL(page.url()).pathname, '/index.html');
    },

    async 'a damaged link is refused in words'(browser) {
        const page = await browser.open('/index.html#1.AAAA', desk);
        await page.getByRole('alert').filter({ hasText: /damaged|cut short/ }).waitFor();
        await until(page, () => window.skvalp?.state.value?.worlds[0].particles > 0, 'water all the same');
        assert.match(await page.getByRole('alert').textContent(), /copy all of it/);
    },

    async 'it speaks Swedish'(browser) {
        const page = await begin(browser, { ...phone, more: { locale: 'sv-SE' } });
        await button(page, 'Pausa').waitFor();
        assert.equal(await page.evaluate(() => document.documentElement.lang), 'sv');
        await button(page, 'Scener och försök').click();
        await page.getByRole('heading', { name: 'Försök', exact: true }).waitFor();
        assert.equal(await page.locator('.panel').getByText(/water/i).count(), 0, 'English in between');
        await page.evaluate(() => localStorage.setItem('skvalp', JSON.stringify({ language: 'en' })));
        await page.reload();
        await button(page, 'Pause').waitFor();
    },

    async 'a page around it steers it'(browser) {
        const page = await browser.open('/empty.html', desk);
        const seen = await page.evaluate(async () => {
            const frame = document.createElement('iframe');
            frame.src = '/index.html?embed=1&controls=play&scene=pool';
            frame.width = '640';
            frame.height = '400';
            const got = [];
            const next = (name) => new Promise((resolve) => {
                addEventListener('message', function hear({ data }) {
                    if (data.skvalp === name) {
                        removeEventListener('message', hear);
                        resolve(data);
                    }
                });
            });
            document.body.append(frame);
            got.push((await next('ready')).scenes.includes('pool'));
            got.push((await next('state')).scene);
            frame.contentWindow.postMessage({ skvalp: 'pause', id: 7 }, '*');
            const { id, error } = await next('answer');
            got.push(id, error);
            while (!(await next('state')).paused);
            frame.contentWindow.postMessage({ skvalp: 'constructor', id: 8 }, '*');
            got.push((await next('answer')).error);
            return got;
        });
        assert.deepEqual(seen, [true, 'pool', 7, undefined, "there is no request 'constructor'"]);
        const inside = page.frameLocator('iframe');
        await inside.getByRole('button', { name: 'Play', exact: true }).waitFor();
        assert.equal(await inside.getByRole('toolbar').count(), 0);
    },

    async 'the address says how it begins'(browser) {
        const still = { ...small, more: { reducedMotion: 'reduce' } };
        const plays = (page, what) => until(page, () => window.skvalp.state.value.moment > 5, `${what}: it plays`);
        let page;
        const begun = async (view, query) => {
            await page?.context().close();
            return begin(browser, view, query);
        };

        page = await begun(small, '');
        await plays(page, 'nothing');
        assert.equal((await stateOf(page)).worlds[0].name, 'dam-break');

        // What is asked for after the scene comes late, as from a page that has no processor for a while.
        const slow = () => {
            const { postMessage } = Worker.prototype, held = [];
            let holds = false;
            Worker.prototype.postMessage = function (...message) {
                holds ? held.push(() => postMessage.apply(this, message)) : postMessage.apply(this, message);
                holds ||= message[0].name === 'open';
            };
            const free = () => {
                Worker.prototype.postMessage = postMessage;
                held.forEach((post) => post());
            };
            const look = () => window.skvalp?.state.value?.worlds[0].particles > 0 ? setTimeout(free, 500) : requestAnimationFrame(look);
            look();
        };
        page = await begun({ ...small, before: slow }, '?paused=1&scene=splash&view=pressure&lang=sv');
        await button(page, 'Spela').waitFor();
        await until(page, () => window.skvalp.state.value.style.view === 'pressure', 'the view');
        await page.waitForTimeout(500);
        const { moment, paused, worlds: [{ name }] } = await stateOf(page);
        assert.deepEqual([moment, paused, name], [0, true, 'splash']);
        const kept = (changes) => page.evaluate((changes) => {
            localStorage.skvalp = JSON.stringify({ ...JSON.parse(localStorage.skvalp), ...changes });
            return JSON.parse(localStorage.skvalp);
        }, changes);
        await kept({ si: true }); // as another tab does
        await page.keyboard.press('t'); // which is kept, and nothing with it
        await until(page, () => window.skvalp.state.value.style.overlays.includes('tracers'), 'what was chosen');
        await page.goto(page.url().replace(/\?.*/, ''));
        await water(page);
        await plays(page, 'another visit');
        await button(page, 'Pause').waitFor();
        const { style: { view, overlays }, worlds: [{ name: scene }] } = await stateOf(page);
        assert.deepEqual([view, overlays, scene], ['water', ['tracers'], 'dam-break']);
        assert.ok((await kept({})).si, 'what another tab had kept is lost');

        page = await begun(small, '?scene=nowhere');
        await page.getByRole('alert').filter({ hasText: /scene=nowhere: .*dam-break, / }).waitFor();
        await plays(page, 'an unknown scene');
        assert.equal((await stateOf(page)).worlds[0].name, 'dam-break');

        const wrong = { view: 'nothing', lang: 'xx', controls: 'some', paused: 'yes', embed: 'true', particles: '1e9', bench: '7' };
        page = await begun(small, `?${new URLSearchParams(wrong)}`);
        const alert = page.getByRole('alert').filter({ hasText: 'particles=1e9: ' });
        await alert.waitFor();
        for (const [name, value] of Object.entries(wrong))
            assert.match(await alert.textContent(), new RegExp(`${name}=${value}: `));
        assert.match(await alert.textContent(), /view=nothing: there is none; there is .*pressure.*lang=xx: .*en, .*sv/);
        assert.match(await alert.textContent(), /particles=1e9: give a whole number from \d+ to [\d\s]+; bench=/);
        page = await begun(small, '?view=nothing#1.damaged');
        await page.getByRole('alert').filter({ hasText: /link: .* copy .*\. .*view=nothing: / }).waitFor();
        page = await begun(small, '?view=pressure&lang=en&controls=play&paused=0&embed=0&particles=600&else=7');
        await plays(page, 'what can be had');
        assert.equal(await page.getByRole('alert').count(), 0);

        page = await begun(still, '?paused=0');
        await plays(page, 'less motion, but asked for');

        page = await begun(still, '?controls=none&scene=pool');
        await plays(page, 'less motion, and nobody could tell it to');
        assert.equal(await page.locator('button:visible').count(), 0);
        await page.mouse.move(200, 300);
        await page.mouse.down();
        await page.mouse.move(210, 280);
        await until(page, () => window.skvalp.state.value.worlds[0].hands === 1, 'a hand');
    },

    async 'a page around it can ask for all that a player can, and nobody else'(browser) {
        const page = await browser.open('/empty.html', desk);
        await page.evaluate(async () => {
            const frame = document.createElement('iframe');
            frame.src = '/index.html?embed=1&scene=pool&paused=1';
            Object.assign(frame, { width: 640, height: 400 });
            window.told = [];
            let last = 0;
            const answers = new Map();
            const ready = new Promise((resolve) => addEventListener('message', ({ data }) => {
                window.told.push(data);
                answers.get(data.id)?.(data);
                if (data.skvalp === 'ready') {
                    resolve();
                }
            }));
            window.ask = (skvalp, more) => new Promise((resolve) => {
                answers.set(++last, ({ result, error }) => resolve(error ?? result));
                frame.contentWindow.postMessage({ skvalp, id: last, ...more }, '*');
            });
            window.frame = frame;
            document.body.append(frame);
            await ready;
            await window.ask('set', { path: 'fluid.material', value: 'oil' }); // at once
        });
        const inside = page.frames()[1];
        const ask = (name, more) => page.evaluate(([name, more]) => window.ask(name, more), [name, more]);
        const holds = (test, what) => inside.waitForFunction(test).catch(() => assert.fail(`in vain: ${what}`));
        const does = async (name, more, test) => {
            assert.equal(await ask(name, more), null, name);
            await holds(test, name);
        };
        await holds(() => window.skvalp?.state.value?.worlds[0].name === 'pool', 'the scene of the address');
        await holds(() => window.skvalp.state.value.canUndo, 'what was asked for at once');
        await does('step', {}, () => window.skvalp.state.value.moment === 1);
        await does('seek', { frame: 0 }, () => window.skvalp.state.value.moment === 0);
        await does('speed', { speed: 0.5 }, () => window.skvalp.state.value.speed === 0.5);
        await does('gravity', { x: 0.6, y: -0.8 }, () => Math.abs(window.skvalp.state.value.gravity.x - 0.6) < 1e-3);
        await does('view', { view: 'speed' }, () => window.skvalp.state.value.style.view === 'speed');
        assert.match(await ask('view', { view: 'nonsense' }), /no view 'nonsense'/);
        assert.equal(await inside.evaluate(() => JSON.parse(localStorage.getItem('skvalp') ?? '{"view":"water"}').view), 'water',
            'what nobody chose is kept');
        await does('set', { path: 'fluid.material', value: 'honey' },
            () => window.skvalp.state.value.canUndo);
        await does('play', {}, () => window.skvalp.state.value.moment > 10);
        const [before, after, seconds] = await page.evaluate(async () => {
            const before = window.told.length, begun = performance.now();
            while (window.told.length === before || performance.now() - begun < 2000) {
                await new Promise((resolve) => setTimeout(resolve, 100));
            }
            return [before, window.told.length, (performance.now() - begun) / 1000];
        });
        assert.ok(after - before < 6 * seconds, `${after - before} states in ${seconds} s`);
        await does('pause', {}, () => window.skvalp.state.value.paused);
        await does('seek', { frame: 1e9 }, () => window.skvalp.state.value.moment === window.skvalp.state.value.end);
        await does('gravity', { x: 9, y: 0 }, () => Math.abs(window.skvalp.state.value.gravity.x - 2) < 1e-3);
        const link = await ask('share');
        assert.match(link, /^1\./);
        await does('open', { scene: 'waves' }, () => window.skvalp.state.value.worlds[0].name === 'waves');
        await does('link', { link }, () => window.skvalp.state.value.worlds[0].name === 'pool');
        await does('pause', {}, () => window.skvalp.state.value.paused);
        await does('reset', {}, () => window.skvalp.state.value.moment === 0);
        assert.match(await ask('nonsense'), /no request 'nonsense'/);
        const unchanged = JSON.stringify((await stateOf(inside)).worlds[0].parameters);
        for (const [name, more, error] of [
            ['open', { scene: 'nosuch' }, /no scene 'nosuch'/],
            ['open', {}, /no scene/],
            ['link', { link: 'garbage' }, /link/],
            ['link', { link: 'https://example.org/#1.AAAA' }, /damaged|cut short|link/],
            ['set', { path: 'fluid.nosuch', value: 1 }, /no parameter 'fluid.nosuch'/],
            ['set', { path: 'gravity.y', value: 'up' }, /'gravity.y' does not take 'up'/],
            ['set', { path: 'gravity.y', value: 1e9 }, /does not take/],
            ['set', { path: 'gravity.y', value: '0x10' }, /does not take '0x10'/],
            ['set', { path: 'gravity.y', value: ' -5' }, /does not take ' -5'/],
            ['set', { path: 'fluid.material', value: 'gold' }, /does not take 'gold'.*honey/],
            ['gravity', { y: -1 }, /'x' takes a number/],
            ['gravity', { x: 0, y: NaN }, /'y' takes a number/],
            ['speed', { speed: 99 }, /from 0.1 to 2/],
            ['speed', { speed: 'fast' }, /from 0.1 to 2/],
            ['seek', { frame: -1 }, /'frame' takes a number/],
            ['seek', {}, /'frame' takes a number/],
        ]) {
            assert.match(String(await ask(name, more)), error, `${name} ${JSON.stringify(more)}`);
        }
        const { worlds: [{ name: still, parameters }], speed } = await stateOf(inside);
        assert.deepEqual([still, JSON.stringify(parameters), speed], ['pool', unchanged, 0.5]);

        await until(page, () => {
            const { moment, paused } = window.told.findLast(({ skvalp }) => skvalp === 'state');
            return paused && moment === 0;
        }, 'it is told that it is back');
        const told = await page.evaluate(() => window.told.filter(({ skvalp }) => skvalp === 'state'));
        const { scene, title, time, paused, particles, readings } = told.at(-1);
        assert.deepEqual([scene, time, paused, readings], ['pool', 0, true, []]);
        assert.ok(title.length > 0 && particles > 100);

        // What the frame itself, or another one, says to it is not heard.
        await inside.evaluate(() => window.postMessage({ skvalp: 'step', id: 1 }, '*'));
        await page.evaluate(async () => {
            const other = document.createElement('iframe');
            document.body.append(other);
            other.contentWindow.eval('parent.frame.contentWindow.postMessage({ skvalp: "step", id: 1 }, "*")');
        });
        await ask('speed', { speed: 1 });
        await page.waitForTimeout(300);
        assert.equal(await inside.evaluate(() => window.skvalp.state.value.moment), 0, 'a stranger steps it');
    },

    async 'a slow device says what it chose, and how slow it is'(browser) {
        // Between two looks at this clock 10 ms pass, which is what a step and a picture then take; and three
        // of four pictures of the display are missed. So a frame has time for half of the steps it wants.
        const slow = `let now = 0;
            performance.now = () => now += 10;
            const next = requestAnimationFrame;
            self.requestAnimationFrame = (callback) => next(() => next(() => next(() => next(callback))));`;
        const page = await beginAfter(browser, slow, { ...small, ratio: 2 }, '?paused=1');
        assert.equal((await stateOf(page)).chosen, 500); // drawing takes 10 ms, too
        const { particles } = (await stateOf(page)).worlds[0];
        assert.ok(Math.abs(particles - 500) < 50, `${particles} particles`);
        await page.locator('.pace').click();
        await page.getByText(/Scenes made for 3\s000 particles begin with 500 on this device/).waitFor();
        assert.equal(await page.getByText('Slow motion').count(), 0);
        await page.evaluate(() => window.skvalp.simulation.setPaused(false));
        await page.getByText('Slow motion: this device cannot compute').waitFor();
        await page.getByText('pictures are coarser').waitFor();
        await page.locator('.pace').filter({ hasText: /0\.\d× of real time/ }).waitFor({ state: 'attached' });
    },

    async 'who wants less motion sees none that nobody asked for'(browser) {
        const watch = () => {
            window.moved = [];
            for (const kind of ['animationstart', 'transitionrun'])
                addEventListener(kind, ({ target }) => window.moved.push(target.role || target.className), true);
        };
        for (const reducedMotion of ['no-preference', 'reduce']) {
            const page = await begin(browser, { ...phone, before: [watch, keepMessages], more: { reducedMotion } });
            await chooseFromMenu(page, 'Preferences');
            await page.getByRole('switch', { name: 'Gravity ball' }).click();
            await page.locator('.ball').waitFor({ state: 'detached' });
            if (reducedMotion !== 'reduce') {
                await until(page, () => ['panel', 'switch'].every((name) => `${window.moved}`.includes(name)),
                    'what moves elsewhere');
                continue;
            }
            await page.waitForTimeout(300);
            await button(page, 'Close').click();
            assert.deepEqual(await page.evaluate(() => window.moved), []);
            await wasTold(page, 'asks for less motion');
            const { moment, paused } = await stateOf(page);
            assert.deepEqual([moment, paused], [0, true]);
            await button(page, 'Play').click();
            await until(page, () => window.skvalp.state.value.moment > 3, 'it plays once it is told to');
        }
    },

    async 'colours of the system show what is chosen, too'(browser) {
        const page = await begin(browser, { ...small, more: { forcedColors: 'active' } });
        const ground = (name) => button(page, name).evaluate((element) => getComputedStyle(element).backgroundColor);
        assert.notEqual(await ground('Hand'), await ground('Wall'));
        assert.equal((await stateOf(page)).style.palette, 'contrast');
    },

    async 'what is chosen shows under the mouse, too'(browser) {
        const page = await begin(browser, small);
        const ground = (name) => button(page, name).evaluate((element) => getComputedStyle(element).backgroundColor);
        const chosen = await ground('Hand');
        await button(page, 'Hand').hover();
        assert.equal(await ground('Hand'), chosen);
        const plays = await ground('Pause');
        await button(page, 'Pause').hover();
        assert.equal(await ground('Pause'), plays);
    },

    async 'all tools and all of the playback are in sight on small screens'(browser) {
        const page = await begin(browser, small);
        await button(page, 'Stopwatch').click();
        for (const [width, height, panel] of
            [[320, 568], [360, 640], [390, 844], [568, 320], [667, 375], [844, 390], [844, 390, true], [1024, 600, true]]) {
            await page.setViewportSize({ width, height });
            if (panel) {
                await button(page, 'Properties').click();
            }
            await untilSeen(() => page.evaluate(() => {
                const parts = '.header button, .tools button, .transport button, .transport input, .clock, .stopwatch';
                const boxes = [...document.querySelectorAll(parts)].map((part) => ({
                    part, box: part.getBoundingClientRect(), strip: part.closest('.scroller')?.getBoundingClientRect(),
                }));
                const outside = ({ box, strip }) => box.width === 0 || box.left < 0 || box.right > innerWidth ||
                    box.top < 0 || box.bottom > innerHeight ||
                    strip && (box.right > strip.right + 1 || box.bottom > strip.bottom + 1);
                const over = ({ box: a }, { box: b }) => a.left < b.right - 1 && b.left < a.right - 1 &&
                    a.top < b.bottom - 1 && b.top < a.bottom - 1;
                const names = (found) => found.map(({ part }) => part.outerHTML.slice(0, 90));
                const apart = boxes.filter(({ part }) => !part.closest('.stopwatch'));
                return names([
                    ...boxes.filter(outside),
                    ...apart.filter((one, i) => apart.slice(0, i).some((other) => over(one, other))),
                ]);
            }), (hidden) => hidden.length === 0, (hidden) => `${width}x${height}: ${hidden}`);
            if (panel) {
                await close(page);
            }
        }
    },

    async 'the keyboard reaches all'(browser) {
        const page = await begin(browser, desk);
        await page.keyboard.press('m');
        await page.locator('.chip').waitFor();
        const paused = (wanted) => until(page, ([wanted]) => window.skvalp.state.value.paused === wanted,
            `paused: ${wanted}`, [wanted]);
        await paused(false); // it begins when it is there
        await page.keyboard.press(' ');
        await paused(true);
        const wanted = await page.evaluate(() =>
            [...document.querySelectorAll('button:not(:disabled), input:not(:disabled), [tabindex="0"]')].length);
        const reached = new Set();
        for (let i = 0; i < wanted + 2; i++) {
            await page.keyboard.press('Tab');
            reached.add(await page.evaluate(() => {
                const { activeElement } = document;
                activeElement.dataset.number ??= String(document.querySelectorAll('[data-number]').length);
                return activeElement === document.body ? '' : activeElement.dataset.number;
            }));
        }
        reached.delete('');
        assert.equal(reached.size, wanted);
        await button(page, 'Properties').focus();
        await page.keyboard.press('Enter');
        await page.getByRole('heading', { name: 'Properties' }).waitFor();
        await close(page);
        await page.locator('dialog').waitFor({ state: 'detached' });
        assert.equal(await page.evaluate(() => document.activeElement.ariaLabel), 'Properties');
        await page.evaluate(() => document.activeElement.blur()); // Return is the hand's
        await page.keyboard.press(' ');
        await paused(false);
        const hands = (count) => until(page, ([count]) => window.skvalp.state.value.worlds[0].hands === count,
            `${count} hands that hold`, [count]);
        await page.keyboard.press('k');
        await page.keyboard.press('Enter');
        await hands(1);
        await page.keyboard.press('k');
        await hands(0);
        await page.keyboard.press('k'); // it was put away closed, and is open now
        await page.keyboard.press('ArrowRight');
        const { moment } = await stateOf(page);
        await until(page, ([moment]) => window.skvalp.state.value.moment > moment + 20, 'time goes on', [moment]);
        assert.equal((await stateOf(page)).worlds[0].hands, 0);
    },

    async 'held keys tilt and step, and what is switched is switched once'(browser) {
        const page = await begin(browser, desk, '?paused=1');
        const pulls = (x, y) => until(page, ([x, y]) => {
            const { gravity } = window.skvalp.state.value;
            return Math.hypot(gravity.x - x, gravity.y - y) < 1e-3;
        }, `gravity (${x}, ${y})`, [x, y]);
        await page.keyboard.down('ArrowRight');
        await pulls(1, 0);
        await page.keyboard.down('ArrowUp');
        await pulls(Math.SQRT1_2, Math.SQRT1_2);
        await page.keyboard.up('ArrowRight');
        await pulls(0, 1);
        await page.keyboard.up('ArrowUp');
        await page.keyboard.down('ArrowLeft');
        await pulls(-1, 0);
        await page.evaluate(() => window.dispatchEvent(new Event('blur'))); // let go where nobody sees it
        await page.keyboard.down('ArrowDown');
        await pulls(0, -1);
        await page.keyboard.up('ArrowDown');
        await page.getByRole('slider', { name: 'Gravity' }).press('ArrowRight'); // it turns by 5 degrees
        await pulls(Math.sin(Math.PI / 36), -Math.cos(Math.PI / 36));
        await page.evaluate(() => document.activeElement.blur());
        await page.keyboard.press('0');
        await pulls(0, 0);

        const hold = async (key, times) => {
            for (let i = 0; i < times; i++) {
                await page.keyboard.down(key);
            }
            await page.keyboard.up(key);
        };
        const { moment, brush } = await stateOf(page);
        await hold('.', 3);
        await until(page, (moment) => window.skvalp.state.value.moment === moment, 'three steps', moment + 3);
        for (const times of [1, 2]) {
            await page.keyboard.down(']');
            await until(page, (brush) => Math.abs(window.skvalp.state.value.brush / brush - 1) < 1e-3,
                `the tool grows, time ${times}`, brush * 1.25 ** times);
        }
        await page.keyboard.up(']');
        await hold('w', 2);
        await hold('.', 6);
        await page.locator('.stopwatch').filter({ hasText: /0\.10\ss/ }).waitFor();
        await hold('p', 3);
        await page.locator('.panel-properties').waitFor();
        await close(page);

        await chooseFromMenu(page, 'Preferences');
        await page.getByRole('switch', { name: 'Keys without Ctrl' }).click();
        await close(page);
        await page.evaluate(() => document.activeElement.blur());
        await page.keyboard.press('.');
        await page.keyboard.press('ArrowRight'); // arrows are nobody's shortcut
        await pulls(1, 0);
        assert.equal((await stateOf(page)).moment, moment + 9, 'a key that is switched off steps');
    },

    async 'of keys that come faster than states each counts'(browser) {
        const page = await begin(browser, desk, '?paused=1');
        const pressed = (text) => page.evaluate((keys) => {
            for (const key of keys) {
                document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
            }
        }, [...text]);
        const told = (member, value, what) => until(page, ([member, value]) =>
            Math.abs(window.skvalp.state.value[member] / value - 1) < 1e-3, what, [member, value]);
        const { brush } = await stateOf(page);
        await pressed('[[[[[]]');
        await told('brush', brush * 0.8 ** 5 * 1.25 ** 2, 'the size of the tool');
        await pressed('--');
        await told('speed', 0.25, 'twice slower');
        await pressed('++++');
        await told('speed', 2, 'faster, as far as it goes');
        await pressed('.'.repeat(40));
        await told('moment', 40, '40 steps');
        await pressed(',,,,,');
        await told('moment', 35, 'five steps back');
        const { views, tools, dyes } = await page.evaluate(() => window.skvalp.simulation.catalogue());
        await pressed('vvv');
        await until(page, (name) => window.skvalp.state.value.style.view === name, 'the view', views[3].name);
        const dyeing = tools.find((tool) => tool.dyes);
        await pressed(dyeing.key);
        const dyed = (dye) => until(page, ([tool, dye]) =>
            window.skvalp.state.value.tool === tool && window.skvalp.state.value.dye === dye, `dye ${dye}`,
        [tools.indexOf(dyeing), dye]);
        const { dye } = await stateOf(page);
        await dyed(dye);
        await pressed(dyeing.key.repeat(3));
        await dyed((dye + 3) % dyes.length);
        await pressed('   ');
        await until(page, () => !window.skvalp.state.value.paused, 'it plays after three times Space');
    },

    async 'every screen is accessible'(browser) {
        const found = [];
        const still = { reducedMotion: 'reduce' };
        for (const [screen, colorScheme] of [[phone, 'light'], [phone, 'dark'], [desk, 'light'], [desk, 'dark']]) {
            const view = { ...screen, more: { ...still, colorScheme } };
            const page = await begin(browser, view, '?view=pressure&scene=pool');
            await page.keyboard.press('m');
            await page.locator('.chip').waitFor();
            await page.keyboard.press('w');
            found.push(...await faults(page, 'the page'));
            for (const panel of ['scenes', 'views', 'properties', 'measure', 'menu']) {
                await page.locator('.header button').nth(['scenes', 'measure', 'views', 'properties', 'menu'].indexOf(panel)).click();
                await page.locator(`.panel-${panel}`).waitFor();
                await page.getByText('Loading…').waitFor({ state: 'detached' });
                found.push(...await faults(page, panel));
                await close(page);
            }
            for (const panel of ['Share', 'Compare Two Worlds', 'Preferences', 'Keyboard Shortcuts', 'About Skvalp']) {
                await button(page, 'Main menu').click();
                await button(page, panel).click();
                await page.getByRole('heading', { name: panel }).waitFor();
                await page.getByText('Loading…').waitFor({ state: 'detached' });
                found.push(...await faults(page, panel));
                await close(page);
            }
            await button(page, 'Size of the tool').click();
            found.push(...await faults(page, 'size'));
            await close(page);
            await page.locator('.chip').click();
            await page.locator('.plot [role=img]').waitFor();
            found.push(...await faults(page, 'a probe'));
            await button(page, 'Scenes and experiments').click();
            await page.locator('.panel .list button').first().click();
            await page.getByRole('heading', { name: '1. Question' }).waitFor();
            found.push(...await faults(page, 'an experiment'));
        }
        assert.deepEqual(found, []);
    },
};

await carryOut([folder], trials, [
    'numbers are read and typed as Swedish has them',
    'of keys that come faster than states each counts',
    'a slow device says what it chose, and how slow it is',
    'a browser whose language is none has plots',
    'the address says how it begins',
    'a page around it can ask for all that a player can, and nobody else',
    'who wants less motion sees none that nobody asked for',
    'colours of the system show what is chosen, too',
    'what is chosen shows under the mouse, too',
    'every screen is accessible',
]);
