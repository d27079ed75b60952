// The page as a frame of another one, which scrolls. Arguments: the folder of the built page.
import assert from 'node:assert/strict';

import { devtools, stateOf, touch, until, untilSeen } from './people.js';
import { carryOut } from './trials.js';

const [folder] = process.argv.slice(2);

/** A long page with the frame at its top; of the same server, or of another one. */
async function hosted(browser, view, frame) {
    const page = await browser.open('/empty.html', view);
    const other = frame.elsewhere ? await browser.open('/empty.html', { isolated: !view.isolated }) : page;
    const source = new URL(`/index.html?embed=1&scene=pool&paused=1${frame.query ?? ''}`, other.url()).href;
    await page.evaluate(({ source, width, height }) => {
        document.body.style.cssText = 'margin: 0; height: 4000px';
        const element = document.createElement('iframe');
        Object.assign(element, { src: source, width, height, style: 'border: 0; display: block' });
        document.body.append(element);
    }, { source, ...frame });
    const inside = await (await page.locator('iframe').elementHandle()).contentFrame();
    await inside.waitForFunction(() => window.skvalp?.state.value?.worlds[0].particles > 0);
    return { page, inside };
}

async function swipe(page, x, y, dy) {
    await touch(page, 'touchStart', [x, y]);
    for (let i = 1; i <= 8; i++) {
        await touch(page, 'touchMove', [x, y + dy * i / 8]);
    }
    await touch(page, 'touchEnd');
}

const trials = {
    async 'a frame lets the page around it scroll, until somebody plays in it'(browser) {
        const { page, inside } = await hosted(browser, { width: 400, height: 700, touch: true }, { width: 400, height: 600 });
        const scrolled = (over) => until(page, (over) => scrollY > over, `scrolled over ${over} px`, over);
        await swipe(page, 150, 400, -200);
        await scrolled(100);
        await page.evaluate(() => scrollTo(0, 0));
        const focused = () => inside.evaluate(() => document.activeElement.className === 'water');
        await untilSeen(async () => { // the first tap may but end what still scrolls
            await page.evaluate(() => scrollTo(0, 0));
            await page.touchscreen.tap(150, 400);
            return focused();
        }, (isFocused) => isFocused, 'a tap gives it the focus');
        await page.evaluate(() => scrollTo(0, 0));
        await until(page, () => scrollY === 0, 'it stands at its top');
        await inside.evaluate(() => window.skvalp.simulation.setPaused(false));
        await touch(page, 'touchStart', [150, 400]);
        for (let i = 1; i <= 8; i++) {
            await touch(page, 'touchMove', [150, 400 - 20 * i]);
        }
        await until(inside, () => window.skvalp.state.value.worlds[0].hands === 1, 'a finger holds water');
        await touch(page, 'touchEnd');
        assert.equal(await page.evaluate(() => scrollY), 0, 'who plays does not scroll');

        const wheel = async (dy, modifiers = 0) => (await devtools(page)).send('Input.dispatchMouseEvent',
            { type: 'mouseWheel', x: 150, y: 300, deltaX: 0, deltaY: dy, modifiers });
        const { zoom } = (await stateOf(inside)).worlds[0].camera;
        await wheel(-100, 2);
        await until(inside, (zoom) => window.skvalp.state.value.worlds[0].camera.zoom > 1.2 * zoom, 'the wheel with Ctrl zooms', zoom);
        const { zoom: near } = (await stateOf(inside)).worlds[0].camera;
        await wheel(300);
        await scrolled(100);
        assert.equal((await stateOf(inside)).worlds[0].camera.zoom, near);
    },

    async 'a small frame overflows nowhere, speaks of nothing that it has not, and asks for nothing forbidden'(browser) {
        for (const [width, height] of [[320, 180], [200, 300], [260, 400], [480, 240]]) {
            for (const controls of ['all', 'play']) {
                const said = [];
                const { page, inside } = await hosted(browser, { width: 600, height: 600 },
                    { width, height, query: `&controls=${controls}&lang=en`, elsewhere: true });
                page.on('console', (message) => said.push(message.text()));
                const where = `${width}x${height}, ${controls}`;
                const found = await inside.evaluate(() => {
                    const names = [...document.querySelectorAll('button, input, .ball, .clock')].filter((element) => {
                        const box = element.getBoundingClientRect();
                        return box.width > 0 && (box.left < -1 || box.top < -1 || box.right > innerWidth + 1 || box.bottom > innerHeight + 1);
                    }).map((element) => element.ariaLabel ?? element.className);
                    const { width, height } = document.querySelector('.canvas').getBoundingClientRect();
                    return { names, share: width * height / (innerWidth * innerHeight), text: document.body.innerText,
                        ball: document.querySelector('.ball') !== null };
                });
                assert.deepEqual(found.names, [], where);
                assert.ok(found.share > 0.5, `${where}: ${found.share} of it is water`);
                assert.ok(found.ball || !found.text.includes('white ball'), `${where}: there is no ball`);
                await inside.evaluate(() => window.skvalp.simulation.setPaused(false));
                await until(inside, () => window.skvalp.state.value.moment > 3, 'it plays');
                assert.deepEqual(said, [], where);
                await page.context().close();
            }
        }
    },
};

await carryOut([folder], trials, Object.keys(trials).slice(1));
