// The page and the device that it runs on: how that is held, its screen, its fingers and pens, and what
// it takes away. Arguments: the folder of the built page.
import assert from 'node:assert/strict';

import {
    begin, beginAfter, blue, button, chooseFromMenu, complaint, devtools, phone, small, stateOf, stillBlue,
    touch, until, untilBlue, untilSeen, water,
} from './people.js';
import { carryOut } from './trials.js';

const [folder] = process.argv.slice(2);

/** Screens that may be turned: their names, in the order of their angles. */
const held = ['portraitPrimary', 'landscapePrimary', 'portraitSecondary', 'landscapeSecondary'];

/** The screen's size, and by how many quarters it is turned against the device. */
async function turn(page, width, height, quarters) {
    await (await devtools(page)).send('Emulation.setDeviceMetricsOverride', {
        width, height, deviceScaleFactor: 1, mobile: true,
        screenOrientation: { type: held[quarters], angle: 90 * quarters },
    });
}

/** What holds the device up, m/s^2 along its own axes: the sensors' readings from now on. */
async function hold(page, x, y) {
    const session = await devtools(page);
    const still = { 'accelerometer': { x, y, z: 0 }, 'linear-acceleration': { x: 0, y: 0, z: 0 },
        'gyroscope': { x: 0, y: 0, z: 0 } };
    for (const [type, xyz] of Object.entries(still)) {
        if (!page.hasSensors) {
            await session.send('Emulation.setSensorOverrideEnabled', { enabled: true, type });
        }
        await session.send('Emulation.setSensorOverrideReadings', { type, reading: { xyz } });
    }
    page.hasSensors = true;
}

/** Waits until gravity points there, as the screen shows it. */
const pulls = (page, x, y) => until(page, ([x, y]) => {
    const { gravity } = window.skvalp.state.value;
    return Math.hypot(gravity.x - x, gravity.y - y) < 0.1;
}, `gravity (${x}, ${y})`, [x, y]);

/** Whether all of the world, and of the named controls, is on the screen and not below something else. */
const fits = (page) => page.evaluate(() => {
    const { area, camera, width, height } = window.skvalp.state.value.worlds[0];
    const stage = document.querySelector('.water').getBoundingClientRect();
    const inside = Math.abs(area.width - stage.width) < 1 && Math.abs(area.height - stage.height) < 1
        && camera.originX >= -1 && camera.originX + camera.scale * width <= stage.width + 1
        && camera.originY - camera.scale * height >= -1 && camera.originY <= stage.height + 1;
    const reached = (element) => {
        element.scrollIntoView({ block: 'nearest', inline: 'nearest' });
        const { left, top, width, height } = element.getBoundingClientRect();
        return element.contains(document.elementFromPoint(left + width / 2, top + height / 2));
    };
    const hidden = [...document.querySelectorAll('.header button, .dock button, .ball')]
        .filter((element) => !reached(element)).map((element) => element.ariaLabel ?? element.textContent);
    return { inside, hidden };
});

const allFits = (page) => untilSeen(() => fits(page), ({ inside, hidden }) => inside && hidden.length === 0,
    (now) => `all is in sight: ${JSON.stringify(now)}`);

/** As a browser hides a tab that nobody looks at. */
const hide = (page, hidden) => page.evaluate((hidden) => {
    Object.defineProperty(document, 'hidden', { value: hidden, configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
}, hidden);

/** What this browser has not, or would not let be seen, before the page begins. */
const devices = {
    /** An iPhone: asks before it tells of motion, whose signs are its own; draws on the page. */
    phone: () => {
        delete HTMLCanvasElement.prototype.transferControlToOffscreen;
        Object.defineProperty(navigator, 'platform', { value: 'iPhone' });
        window.asked = [];
        window.answer = 'denied';
        DeviceMotionEvent.requestPermission = async () => {
            window.asked.push(navigator.userActivation.isActive);
            return window.answer;
        };
    },
    /** Locks that come when `late` does, and are counted. */
    awake: () => {
        window.locks = { asked: 0, came: 0, held: 0, late: Promise.resolve() };
        const request = async () => {
            window.locks.asked++;
            await window.locks.late;
            window.locks.came++;
            window.locks.held++;
            return { released: false, async release() {
                window.locks.held--;
                this.released = true;
            } };
        };
        Object.defineProperty(navigator, 'wakeLock', { value: { request } });
    },
};

const trials = {
    async 'water runs to the side that is down'(browser) {
        const page = await begin(browser, { ...small, touch: true }, '?scene=pool');
        await hold(page, 0, 9.81);
        await chooseFromMenu(page, 'Tilt by the Sensor');
        // The device stands upright; its screen shows the page turned, as if it were locked.
        const sides = [['y', 1], ['x', 1], ['y', -1], ['x', -1]];
        for (const [quarters, [axis, sign]] of sides.entries()) {
            await turn(page, 400, 400, quarters);
            await pulls(page, axis === 'x' ? sign : 0, axis === 'y' ? -sign : 0);
            await untilBlue(page, (middle) => sign * (middle[axis] - 0.5) >= 0.1, `water runs, quarters ${quarters}`);
        }
        await turn(page, 400, 400, 0);
        await hold(page, 0, 4.9);
        await pulls(page, 0, -0.5);
        await chooseFromMenu(page, 'Tilt by the Sensor');
        await hold(page, 9.81, 0);
        await page.waitForTimeout(300);
        await pulls(page, 0, -0.5);
    },

    async 'a device has one number of particles, which people choose'(browser) {
        const amounts = async (page) => {
            const { chosen, worlds: [{ particles }] } = await stateOf(page);
            assert.ok(Math.abs(particles / chosen - 1) < 0.1, `${particles} of ${chosen}`);
            return [chosen, await page.evaluate(() => JSON.parse(localStorage.getItem('skvalp') ?? '{}'))];
        };
        const again = async (page, query) => {
            await page.goto(new URL(`/index.html${query}`, page.url()).href);
            await water(page);
            return amounts(page);
        };
        const page = await begin(browser, { ...small, isNew: true }, '?scene=pool');
        const [measured, { measured: kept }] = await amounts(page);
        assert.equal(kept, measured, 'what was measured is kept');
        // As on another device: it is what is kept that counts, not how fast it is by chance.
        await page.evaluate(() => localStorage.setItem('skvalp', JSON.stringify({ measured: 3000 })));
        assert.equal((await again(page, '?scene=pool'))[0], 3000);
        await until(page, () => new URL(location.href).searchParams.get('particles') === '3000', 'who copies the address has as many');
        const [asked, { measured: still, particles: none }] = await again(page, '?scene=pool&particles=2000');
        assert.deepEqual([asked, still, none], [2000, 3000, undefined], 'the address is for one visit');
        // The way back from the panel's entry may take longer than the scene does to begin anew.
        await page.evaluate(() => {
            const back = history.back.bind(history);
            const isAnew = () => window.skvalp.state.value.chosen === 1000;
            history.back = () => isAnew() ? back() : setTimeout(history.back, 20);
        });
        await page.locator('.pace').click();
        await until(page, () => history.state?.panel === true, 'the panel is entered');
        await page.getByLabel('Particles', { exact: true }).selectOption({ label: '1\u00a0000' });
        await until(page, () => window.skvalp.state.value.chosen === 1000
            && Math.abs(window.skvalp.state.value.worlds[0].particles - 1000) < 100, 'the scene begins anew with 1000');
        await until(page, () => history.state?.panel !== true, 'the panel is left');
        await until(page, () => location.search === '?scene=pool&particles=1000', 'the address says so');
        assert.equal((await again(page, '?scene=pool'))[0], 1000);
        await page.locator('.pace').click();
        await page.getByLabel('Particles', { exact: true }).selectOption({ label: 'As measured: 3\u00a0000' });
        await until(page, () => window.skvalp.state.value.chosen === 3000, 'as it was measured');
    },

    async 'a turned screen keeps water that is in the air'(browser) {
        const page = await begin(browser, phone);
        await until(page, () => window.skvalp.state.value.moment > 25, 'water falls');
        const { particles, opened } = (await stateOf(page)).worlds[0];
        await turn(page, 740, 360, 1);
        await until(page, () => innerWidth === 740 && window.skvalp.state.value.worlds[0].area.width > 400
            && !window.skvalp.state.value.atRest, 'it lies');
        const { worlds: [after], moment } = await stateOf(page);
        assert.deepEqual([after.particles, after.opened], [particles, opened]);
        await allFits(page);
        await untilBlue(page, ({ share }) => share > 0.02, 'water shows');
        await turn(page, 360, 740, 0);
        await until(page, ([moment]) => innerWidth === 360 && window.skvalp.state.value.moment > moment
            && window.skvalp.state.value.worlds[0].area.width <= 360, 'it stands', [moment]);
        await allFits(page);
    },

    async 'a newcomer holds water with two fingers and tilts the tank'(browser) {
        const begun = Date.now();
        const page = await begin(browser, phone);
        const came = Date.now() - begun;
        await page.getByText('Drag the white ball').waitFor();
        await until(page, () => window.skvalp.state.value.moment > 30, 'water lies below');
        const { x, y } = await blue(page);
        const [left, top] = [360 * x, (await page.locator('canvas.canvas').boundingBox()).height * y];
        await touch(page, 'touchStart', [left - 30, top]);
        await until(page, () => window.skvalp.state.value.worlds[0].hands === 1, 'a hand');
        await touch(page, 'touchStart', [left - 30, top], [left + 30, top]);
        for (let i = 1; i <= 10; i++) {
            await touch(page, 'touchMove', [left - 30, top - 20 * i], [left + 30, top - 20 * i]);
        }
        await until(page, () => window.skvalp.state.value.worlds[0].hands === 2, 'two hands');
        const between = { x: left - 40, y: top - 220, width: 80, height: 40 };
        await untilBlue(page, ({ share }) => share >= 0.2, 'water comes with the fingers', between);
        await touch(page, 'touchEnd');
        const ball = await page.getByRole('slider', { name: 'Gravity' }).boundingBox();
        const middle = [ball.x + ball.width / 2, ball.y + ball.height / 2];
        await touch(page, 'touchStart', [middle[0], middle[1] + ball.height / 4]);
        await touch(page, 'touchMove', [middle[0] + ball.width / 4, middle[1] + 4]);
        await touch(page, 'touchEnd');
        await until(page, () => window.skvalp.state.value.gravity.x > 0.7, 'the tank is tilted');
        console.log(`water after ${came} ms; two fingers and one drag later, ${Date.now() - begun} ms after `
            + 'opening, it was held and tilted');
        assert.equal(await page.locator('dialog').count(), 0);
    },

    async 'who is asked for the sensor may say no'(browser) {
        const page = await begin(browser, { ...small, touch: true, before: devices.phone });
        assert.deepEqual(await page.evaluate(() => window.asked), [], 'asked without a tap');
        await chooseFromMenu(page, 'Tilt by the Sensor');
        await complaint(page, /allow motion.*gravity ball/);
        assert.deepEqual(await page.evaluate(() => window.asked), [true], 'asked without a tap');
        const ball = page.getByRole('slider', { name: 'Gravity' });
        await ball.click({ position: { x: 48, y: 32 } });
        await until(page, () => window.skvalp.state.value.gravity.x > 0.7, 'the ball tilts');
        // And another time yes. It says what pulls, where others say what holds.
        await page.evaluate(() => (window.answer = 'granted'));
        await chooseFromMenu(page, 'Tilt by the Sensor');
        await until(page, () => {
            const accelerationIncludingGravity = { x: -9.81, y: 0, z: 0 };
            window.dispatchEvent(new DeviceMotionEvent('devicemotion', { accelerationIncludingGravity }));
            return window.skvalp.state.value.gravity.x < -0.9;
        }, 'gravity to the left');
    },

    async 'a page that nobody sees waits, and goes on where it was'(browser) {
        const page = await begin(browser, { ...small, before: devices.awake });
        const locks = (asked, held) => until(page, ([asked, held]) => {
            const now = window.locks;
            return now.asked === asked && now.came === asked && now.held === held;
        }, `${held} of ${asked} locks`, [asked, held]);
        await locks(1, 1);
        await hide(page, true);
        await locks(1, 0);
        await page.evaluate(() => window.skvalp.simulation.catalogue()); // what was under way has been told
        const drawn = await stillBlue(page);
        const { moment } = await stateOf(page);
        await page.waitForTimeout(700);
        const later = [(await stateOf(page)).moment, await blue(page)];
        assert.deepEqual(later, [moment, drawn], 'it goes on hidden');
        await page.evaluate(() => {
            window.later = [];
            window.skvalp.state.subscribe(({ moment }) => window.later.push(moment));
        });
        await hide(page, false);
        await until(page, ([moment]) => window.later.at(-1) > moment, 'it goes on', [moment]);
        const next = (await page.evaluate(() => window.later)).find((later) => later > moment);
        assert.ok(next <= moment + 10, `${next - moment} frames were made up for`);
        await locks(2, 1);
        await page.keyboard.press(' ');
        await locks(2, 0);
        // What is asked for and comes when it is no longer wanted is given back.
        await page.evaluate(() => {
            window.locks.late = new Promise((resolve) => (window.locks.come = resolve));
        });
        await page.keyboard.press(' ');
        await until(page, () => window.locks.asked === 3, 'a lock is asked for');
        await page.keyboard.press(' ');
        await until(page, () => window.skvalp.state.value.paused, 'it stands still');
        await page.evaluate(() => window.locks.come());
        await locks(3, 0);
    },

    async 'two fingers at once zoom, a pen draws, a touch knocks, and the screen is full'(browser) {
        const page = await begin(browser, { ...small, touch: true, before: () => {
            window.knocks = 0;
            navigator.vibrate = () => ++window.knocks;
        } });
        await touch(page, 'touchStart', [180, 150], [220, 150]);
        for (const reach of [30, 40, 60, 80]) {
            await touch(page, 'touchMove', [200 - reach, 150], [200 + reach, 150]);
        }
        await until(page, () => window.skvalp.state.value.worlds[0].camera.zoom > 2, 'larger');
        assert.equal((await stateOf(page)).worlds[0].hands, 0);
        await touch(page, 'touchEnd');
        assert.equal(await page.evaluate(() => visualViewport.scale), 1);

        await button(page, 'Wall').click();
        assert.equal(await page.evaluate(() => window.knocks), 1);
        const pen = async (type, x, y, buttons) => (await devtools(page)).send('Input.dispatchMouseEvent', {
            type, x, y, buttons, button: 'left', clickCount: 1, pointerType: 'pen', force: 0.4,
        });
        await pen('mousePressed', 250, 100, 1);
        await pen('mouseMoved', 300, 120, 1);
        await pen('mouseReleased', 300, 120, 0);
        await until(page, () => window.skvalp.state.value.canUndo, 'a wall that can be undone');

        await chooseFromMenu(page, 'Preferences');
        await page.getByRole('switch', { name: 'Vibrate at a touch' }).click();
        await button(page, 'Close').click();
        await button(page, 'Hand').click();
        assert.equal(await page.evaluate(() => window.knocks), 1);

        await chooseFromMenu(page, 'Full Screen');
        await until(page, () => document.fullscreenElement !== null, 'full screen');
        await chooseFromMenu(page, 'Full Screen');
        await until(page, () => document.fullscreenElement === null, 'no full screen');
        await page.evaluate(() => {
            document.documentElement.requestFullscreen = () => Promise.reject(new TypeError('not here'));
        });
        await chooseFromMenu(page, 'Full Screen');
        await page.getByRole('status').filter({ hasText: 'does not allow full screen' }).waitFor();
    },

    async 'a graphics processor that is taken away comes back'(browser) {
        const page = await beginAfter(browser, `const { getContext } = OffscreenCanvas.prototype;
            OffscreenCanvas.prototype.getContext = function (...wanted) {
                return self.context = getContext.apply(this, wanted);
            };`, small, '?scene=pool&paused=1');
        // It stands still, so that nothing but its return draws it anew.
        await until(page, () => window.skvalp.state.value.paused, 'it stands still');
        await untilBlue(page, ({ share }) => share >= 0.2, 'water shows');
        const before = await stillBlue(page);
        const worker = page.workers().find((other) => other.url().includes('simulation.worker'));
        await worker.evaluate(() => {
            self.extension = self.context.getExtension('WEBGL_lose_context');
            self.extension.loseContext();
        });
        const said = page.getByRole('alert').filter({ hasText: 'graphics processor was taken away' });
        await said.waitFor();
        await worker.evaluate(() => self.extension.restoreContext());
        await said.waitFor({ state: 'detached' });
        await untilBlue(page, ({ share }) => share === before.share, `as much water as before, ${before.share}`);
    },

    async 'a process of graphics that dies is no limit of the device'(browser) {
        const page = await begin(browser, small, '?scene=dam-break');
        await until(page, () => window.skvalp.state.value.moment > 5, 'it plays');
        await page.evaluate(() => {
            window.alerts = [];
            const note = () => document.querySelectorAll('[role=alert]').forEach((alert) => {
                if (alert.textContent && window.alerts.at(-1) !== alert.textContent) {
                    window.alerts.push(alert.textContent);
                }
            });
            new MutationObserver(note).observe(document, { childList: true, characterData: true, subtree: true });
        });
        const session = await page.context().browser().newBrowserCDPSession();
        await session.send('Browser.crashGpuProcess').catch(() => undefined); // it may take its answer along
        await until(page, () => window.alerts.length > 0, 'it says that the processor was taken away');
        await until(page, () => [...document.querySelectorAll('[role=alert]')].every((alert) => !alert.textContent),
            'the alert goes');
        await untilBlue(page, ({ share }) => share >= 0.05, 'water shows once it is back');
        const alerts = await page.evaluate(() => window.alerts);
        assert.deepEqual(alerts.filter((text) => !/taken away/.test(text)), []);
    },
};

await carryOut([folder], trials, [
    'a newcomer holds water with two fingers and tilts the tank',
    'a device has one number of particles, which people choose',
    'a turned screen keeps water that is in the air',
    'who is asked for the sensor may say no',
    'a page that nobody sees waits, and goes on where it was',
    'two fingers at once zoom, a pen draws, a touch knocks, and the screen is full',
    'a graphics processor that is taken away comes back',
    'a process of graphics that dies is no limit of the device',
], { composited: true, whole: true }); // a page that is not composited is said to crash with that process
