// How the page is laid out, on phones, in frames' sizes and enlarged: what is in sight, what lies over what, and what
// stays where it is. Arguments: the folder of the built page.
import assert from 'node:assert/strict';

import { begin, button, chooseFromMenu, close, desk, phone, resize, small, until, water } from './people.js';
import { carryOut } from './trials.js';

const [folder] = process.argv.slice(2);

/** Waits until panels and messages are where they stay. */
const still = (page) => until(page, () => document.getAnimations().every((one) => one.playState === 'finished'), 'all stands still');

/** Of the first of what each selector finds, at one moment. */
const boxesOf = (page, ...selectors) => page.evaluate((selectors) => selectors.map((selector) => {
    const { left, top, right, bottom } = document.querySelector(selector).getBoundingClientRect();
    return { left, top, right, bottom };
}), selectors);

/** Pairs of what these selectors find that lie over each other. */
const overlapping = (page, selectors) => page.evaluate((selectors) => {
    const all = selectors.flatMap((selector) => [...document.querySelectorAll(selector)])
        .map((element) => ({ text: element.className.baseVal ?? element.className, box: element.getBoundingClientRect() }));
    return all.flatMap(({ text, box: a }, i) => all.slice(0, i).filter(({ box: b }) => a.width && b.width &&
        a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1)
        .map((other) => `${text} and ${other.text}`));
}, selectors);

/** What of the header is cut off by the picture's edges. */
const cutOff = (page) => page.evaluate(() => {
    const main = document.querySelector('.main').getBoundingClientRect();
    return [...document.querySelectorAll('.header button')].filter((part) => {
        const { left, right, top, bottom } = part.getBoundingClientRect();
        return left < main.left || right > main.right || top < main.top || bottom > main.bottom;
    }).map((part) => part.ariaLabel ?? part.textContent);
});

/** How wide the bar is while this is said beside it, and nothing that the simulation has told meanwhile. */
const barBeside = (page, going, moment) => page.evaluate(async ([going, moment]) => {
    const { state } = window.skvalp;
    const drawn = () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    for (;;) {
        state.value = { ...state.value, going, moment };
        await drawn();
        const { width } = document.querySelector('.bar').getBoundingClientRect();
        if (state.value.going === going) {
            return width;
        }
    }
}, [going, moment]);

const trials = {
    async 'the picture has the room that an open sheet leaves'(browser) {
        const page = await begin(browser, phone, '?scene=pool&paused=1');
        for (const [width, height] of [[360, 740], [320, 568]]) {
            await page.setViewportSize({ width, height });
            for (const name of ['Views', 'Properties', 'Measure', 'Main menu']) {
                await button(page, name).click();
                await until(page, () => {
                    const { clientHeight } = document.querySelector('.stage');
                    const panel = document.querySelector('.panel');
                    return panel && !panel.textContent.includes('Loading…') && clientHeight < innerHeight - 100 && window.skvalp.state.value.worlds[0].area.height === clientHeight;
                }, `${name}: the picture is as high as the stage`);
                await still(page);
                const [stage, panel] = await boxesOf(page, '.stage', '.panel');
                assert.ok(stage.bottom <= panel.top + 1, `${name} lies over the picture: ${panel.top} < ${stage.bottom}`);
                assert.ok(stage.bottom - stage.top > 0.4 * height, `${name} leaves ${stage.bottom - stage.top} px of ${height}`);
                assert.ok(Math.abs(panel.bottom - height) < 1 && panel.right - panel.left === width, name);
                await close(page);
                await page.locator('.panel').waitFor({ state: 'detached' });
            }
        }
        await button(page, 'Views').click();
        await page.getByRole('radio', { name: 'Pressure' }).click();
        await page.locator('.legend').waitFor();
        assert.deepEqual(await cutOff(page), []);
    },

    async 'what lies over the picture lies over nothing else there'(browser) {
        const page = await begin(browser, phone, '?scene=pool&paused=1&view=pressure');
        const lying = ['.header button', '.pill', '.legend', '.ball', '.message'];
        const hint = await page.locator('.hint').textContent();
        assert.match(hint, /finger/);
        assert.doesNotMatch(hint, /mouse/);
        await page.locator('.legend').waitFor();
        // Motion that is refused ends in advice on the ball.
        await page.evaluate(() => (DeviceMotionEvent.requestPermission = async () => 'denied'));
        await chooseFromMenu(page, 'Tilt by the Sensor');
        const message = page.locator('.message').filter({ hasText: 'ball' });
        await message.waitFor();
        assert.doesNotMatch(await message.textContent(), /key/);
        await still(page);
        assert.deepEqual(await overlapping(page, lying), []);

        await page.evaluate(() => {
            const { simulation, state: { value: { worlds: [{ width, height }] } } } = window.skvalp;
            for (const [x, y] of [[0.3, 0.2], [0.34, 0.2], [0.4, 0.22], [0.45, 0.24], [0.9, 0.2]]) {
                simulation.addProbe(0, x * width, y * height, x * width, y * height);
            }
        });
        await until(page, () => document.querySelectorAll('.chip').length === 5 && document.querySelectorAll('.reading').length > 1
            && window.skvalp.state.value.worlds[0].area.height === document.querySelector('.stage').clientHeight, 'readings');
        assert.deepEqual((await overlapping(page, ['.reading', '.disc'])).filter((pair) => pair.includes('reading')), []);
    },

    async 'the legends of two worlds lie each within its own half'(browser) {
        const page = await begin(browser, phone, '?scene=pool&view=pressure');
        await page.evaluate(() => window.skvalp.simulation.compareWith('honey'));
        await until(page, () => document.querySelectorAll('.side > .legend').length === 2, 'a legend each');
        for (const [width, height] of [[360, 740], [320, 568]]) {
            await page.setViewportSize({ width, height });
            await until(page, () => window.skvalp.state.value.worlds[1].area.x + window.skvalp.state.value.worlds[1].area.width === innerWidth, 'room');
            const [a, b] = await page.locator('.side > .legend').evaluateAll((legends) => legends.map((one) => one.getBoundingClientRect().toJSON()));
            assert.ok(a.left >= 0 && a.right <= b.left && b.right <= width, `${width}: to ${a.right}, and ${b.left} to ${b.right}`);
        }
    },

    async 'the bar stays as wide as it is, whatever is said beside it'(browser) {
        const page = await begin(browser, phone, '?scene=pool&particles=500');
        await until(page, () => window.skvalp.state.value.moment > 10, 'time passes');
        await page.keyboard.press(' ');
        await until(page, () => window.skvalp.state.value.paused, 'it stands still');
        for (const [width, height] of [[360, 740], [568, 320], [1366, 768]]) {
            await resize(page, width, height);
            const widths = [];
            for (const [words, times, slow, moment] of
                [['real time', 1, false, 10], ['%s× of real time', 0.25, true, 10], ['at rest', 1, false, 4], ['paused', 1, false, 0]]) {
                widths.push(await barBeside(page, { words, times, slow }, moment));
            }
            assert.ok(widths[0] > 120 && widths.every((one) => one === widths[0]), `${width}x${height}: ${widths}`);
            assert.deepEqual(await overlapping(page, ['.bar', '.clock', '.pace']), []);
        }
    },

    async 'a page that is enlarged four times has all that others have'(browser) {
        const page = await begin(browser, small, '?scene=pool&paused=1');
        for (const [width, height] of [[341, 192], [320, 256], [480, 270], [683, 384], [568, 320], [280, 653]]) {
            const size = `${width}x${height}`;
            await resize(page, width, height);
            assert.deepEqual(await cutOff(page), [], size);
            for (const name of ['Hand', 'Size of the tool', 'Undo', 'Stopwatch']) {
                const part = button(page, name);
                await part.scrollIntoViewIfNeeded();
                const { x, y, width: wide, height: high } = await part.boundingBox();
                assert.ok(wide >= 24 && high >= 24 && x >= 0 && y >= 0 && x + wide <= width && y + high <= height,
                    `${size}: ${name} at ${[x, y, wide, high]}`);
            }
            await page.evaluate(() => scrollTo(0, 0));
            await button(page, 'Main menu').click();
            const last = button(page, 'About Skvalp');
            await last.waitFor();
            await still(page); // it rises from below
            await last.scrollIntoViewIfNeeded();
            const [{ left, right, bottom }] = await boxesOf(page, '.panel');
            assert.ok(left >= 0 && right <= width && bottom <= height + 1, `${size}: the menu from ${left} to ${right}`);
            const { x, width: wide } = await last.boundingBox();
            assert.ok(x >= left && x + wide <= right && wide > 180, `${size}: an item of ${wide} px at ${x}`);
            assert.deepEqual(await cutOff(page), [], `${size} with the menu`);
            await close(page);
            await page.locator('.panel').waitFor({ state: 'detached' });
            assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), size);
        }
    },

    async 'a page in light colours is light from its first picture on'(browser) {
        const look = () => {
            window.grounds = new Set();
            const note = () => {
                if (document.body) {
                    window.grounds.add(getComputedStyle(document.body).backgroundColor);
                }
                requestAnimationFrame(note);
            };
            note();
        };
        const dark = () => {
            localStorage.setItem('skvalp', '{"scheme":"light"}');
        };
        for (const [colorScheme, before] of [['light', null], ['dark', dark]]) {
            const page = await browser.open('/empty.html', { ...small, more: { colorScheme } });
            if (before) {
                await page.evaluate(before);
            }
            await page.addInitScript(look);
            await page.goto(new URL('/index.html?paused=1', page.url()).href);
            await water(page);
            const grounds = await page.evaluate(() => [...window.grounds].filter((ground) => ground !== 'rgba(0, 0, 0, 0)'));
            assert.deepEqual(grounds, ['rgb(230, 237, 244)'], `${colorScheme} system`);
        }
    },

    async 'an experiment says that it runs, what stands beside it waits, and its plot is in sight'(browser) {
        for (const view of [phone, { ...phone, width: 740, height: 360 }, { ...phone, width: 320, height: 568 }, { ...desk, width: 1366, height: 768 }]) {
            const page = await begin(browser, view, '?scene=pool&particles=500');
            await until(page, () => !window.skvalp.state.value.paused, 'it plays');
            await button(page, 'Scenes and experiments').click();
            await page.locator('.panel .list button').first().click();
            await page.locator('.measurement').getByRole('button', { name: 'Measure' }).click();
            const told = page.locator('.status button').filter({ hasText: /“.+” is being measured: \d+\s%\. The water here waits\./ });
            await told.waitFor({ state: 'attached' }); // beside a panel there may be no room for it
            await until(page, () => window.skvalp.state.value.paused, 'what stands beside it waits');
            await page.locator('.plot').waitFor();
            const [plot, panel, head, stop, share] = await boxesOf(page, '.plot', '.panel', '.panel-head', '.measurement .suggested', 'progress');
            const parts = [head, stop, share, plot, { top: panel.bottom + 1 }];
            assert.ok(parts.every(({ bottom }, i) => i === 4 || bottom <= parts[i + 1].top + 1),
                `${view.width}x${view.height}: how far it is, Stop and the plot are in sight: ${JSON.stringify(parts)}`);
            await close(page);
            await told.click(); // in sight again
            await page.locator('.panel-experiment').waitFor();
            await button(page, 'Stop').click();
            await told.waitFor({ state: 'detached' });
            await until(page, () => !window.skvalp.state.value.paused, 'it goes on');
        }
    },

    async 'what an experiment is compared with is in sight once it ends'(browser) {
        const page = await begin(browser, phone, '?scene=pool&particles=500');
        await button(page, 'Scenes and experiments').click();
        await page.locator('.panel .list button').first().click();
        await page.getByText('It is measured with 4\u00a0000 particles.').waitFor();
        // As a person chose, not as the address says for this visit.
        await page.evaluate(() => localStorage.setItem('skvalp', JSON.stringify({ particles: 1000 })));
        await page.reload();
        await button(page, 'Scenes and experiments').click();
        await page.locator('.panel .list button').first().click();
        await page.getByText('It is measured with 1\u00a0000 particles.').waitFor();
        // One that comes with the larger module says it as well.
        await close(page);
        await button(page, 'Scenes and experiments').click();
        await page.locator('.panel .list button', { hasText: 'Diving bells' }).click();
        await page.getByText(/^It is measured with [\d\u00a0]+ particles\.$/).waitFor();
        await close(page);
        await button(page, 'Scenes and experiments').click();
        await page.locator('.panel .list button').first().click();
        await page.locator('.measurement').getByRole('button', { name: 'Measure' }).click();
        const compare = page.getByRole('heading', { name: '4. Compare' });
        const inSight = () => page.waitForFunction(() => {
            const box = (part) => part?.getBoundingClientRect();
            const heading = box([...document.querySelectorAll('h3')].find((part) => part.textContent === '4. Compare'));
            const table = box(document.querySelector('.results tbody tr')), body = box(document.querySelector('.panel'));
            // Not below what stays at the panel's top.
            return heading?.top >= box(document.querySelector('.panel-head')).bottom - 1 && table?.bottom <= body.bottom + 1;
        });
        await compare.waitFor();
        await page.getByText('Measured with 1\u00a0000 particles', { exact: true }).waitFor();
        await inSight();
        // Opened again, it begins with the question.
        await close(page);
        await compare.waitFor({ state: 'detached' });
        await button(page, 'Scenes and experiments').click();
        await page.locator('.panel .list button').first().click();
        await compare.waitFor();
        const [title, body] = await boxesOf(page, '.panel h3.title', '.panel');
        assert.ok(title.bottom > body.top, `the title ends at ${title.bottom}, above ${body.top}`);
    },

    async 'an experiment that comes with the larger module is measured and played with'(browser) {
        const page = await begin(browser, desk, '?scene=pool&particles=500');
        const list = async () => {
            await button(page, 'Scenes and experiments').click();
            await page.locator('.panel .list button').filter({ hasText: 'Three holes' }).click();
        };
        await list();
        await page.locator('.measurement').getByRole('button', { name: 'Measure' }).click();
        await page.locator('.plot').waitFor();
        await button(page, 'Stop').click();
        await until(page, () => !window.skvalp.state.value.paused, 'the pool goes on');
        await button(page, 'Play with the set-up').click();
        await until(page, () => window.skvalp.state.value.worlds[0].particles >= 5000, 'the set-up comes');
        await until(page, () => window.skvalp.state.value.moment > 0 && !window.skvalp.state.value.paused, 'it plays');
    },

    async 'a set-up whose gravity is tilted says so'(browser) {
        const page = await begin(browser, desk, '?scene=pool&paused=1');
        const index = await page.evaluate(async () =>
            (await window.skvalp.simulation.catalogue()).experiments.findIndex(({ name }) => name === 'slosh'));
        await button(page, 'Scenes and experiments').click();
        await page.locator('.panel .list button').nth(index).click();
        await button(page, 'Play with the set-up').click();
        await until(page, () => window.skvalp.state.value.gravity.x !== 0, 'gravity as the experiment begins');
        await page.locator('.status').getByText('Gravity is tilted').waitFor();
    },

    async 'a change of the view is spoken'(browser) {
        const page = await begin(browser, desk, '?scene=pool&paused=1');
        const told = page.locator('[aria-live]');
        await told.filter({ hasText: 'Water' }).waitFor({ state: 'attached' });
        await page.keyboard.press('v');
        const { name, title } = await page.evaluate(async () => (await window.skvalp.simulation.catalogue()).views[1]);
        await until(page, (name) => window.skvalp.state.value.style.view === name, 'the view', name);
        await told.filter({ hasText: title }).waitFor({ state: 'attached' });
    },
};

await carryOut([folder], trials, [
    'a page that is enlarged four times has all that others have',
    'a page in light colours is light from its first picture on',
    'an experiment says that it runs, what stands beside it waits, and its plot is in sight',
    'what an experiment is compared with is in sight once it ends',
    'a set-up whose gravity is tilted says so',
    'a change of the view is spoken',
]);
