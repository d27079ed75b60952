// What comes to the page from outside, and what it saves: links and pictures of all kinds, files that are
// dropped, a full storage; a picture, a video. Arguments: the folder of the built page, a photo of
// 8000x6000, and a link that the native program made.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { crc32, deflateRawSync } from 'node:zlib';

import {
    begin, button, chooseFromMenu, close, complaint, decode, keepMessages, small, stateOf, until, wasTold,
} from './people.js';
import { carryOut } from './trials.js';

const [folder, photo, nativeLink] = process.argv.slice(2);

/** Whether time passes, and of what. */
async function lives(page, what) {
    const { moment } = await stateOf(page);
    await until(page, ([moment]) => {
        const now = window.skvalp.state.value;
        return now.worlds[0].particles > 0 && (now.moment !== moment || now.atRest);
    }, `water after ${what}`, [moment]);
}

/** A PNG of which there is little more than its size. */
function emptyPng(width, height) {
    const chunk = (type, data) => {
        const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
        const ends = Buffer.alloc(8);
        ends.writeUInt32BE(data.length);
        ends.writeUInt32BE(crc32(body), 4);
        return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
    };
    const header = Buffer.alloc(13);
    header.writeUInt32BE(width);
    header.writeUInt32BE(height, 4);
    header.set([8, 6, 0, 0, 0], 8);
    return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header),
        chunk('IDAT', Buffer.from([0x78, 0x9c, 3, 0, 0, 0, 0, 1])), chunk('IEND', Buffer.alloc(0))]);
}

/** Chooses a file as the gallery's button does. */
async function choose(page, name, mimeType, buffer) {
    await button(page, 'Scenes and experiments').click();
    await page.locator('.panel input[type=file]').setInputFiles(buffer ? { name, mimeType, buffer } : name);
}

const drop = (page, name, text) => page.evaluate(([name, text]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    const event = new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true });
    document.querySelector('.water').dispatchEvent(event);
}, [name, text]);

const trials = {
    async 'a link of the native program is played to its end, and meets its hash'(browser) {
        const page = await browser.open(`/index.html#${nativeLink.split(/#|skvalp:/)[1]}`, { ...small, before: keepMessages });
        await until(page, () => window.skvalp?.state.value?.asRecorded, 'it plays what was sent');
        await wasTold(page, 'The end: it went exactly as it was recorded');
        const { asRecorded, mismatch, moment } = await stateOf(page);
        assert.deepEqual([asRecorded, mismatch], [true, false]);
        assert.ok(moment >= 24, `it was over after ${moment} frames`);
    },

    async 'links that are cut, hostile or of another time are refused in words'(browser) {
        const page = await begin(browser, small);
        const bomb = deflateRawSync(Buffer.alloc(64 << 20), { level: 9 }).toString('base64url');
        const links = {
            '1.AAAA': /damaged|cut short/,
            [`1.${bomb}`]: /damaged|more than/,
            [`1.${'A'.repeat(1.5e6)}`]: /more than the \d+ characters/,
            '9.AAAA': /its version is 9.*newer/,
            '1.<img src=x onerror=alert(1)>': /damaged after "1\."/,
        };
        for (const [link, words] of Object.entries(links)) {
            await page.evaluate((hash) => (location.hash = hash), link);
            await complaint(page, words);
            await lives(page, link.slice(0, 20));
        }
    },

    async 'pictures are opened, or refused in words, however large'(browser) {
        const page = await begin(browser, small);
        await choose(page, 'huge.png', 'image/png', emptyPng(20000, 20000));
        await complaint(page, /huge\.png.*20000 x 20000.*allowed/);
        await lives(page, 'a huge picture');
        await choose(page, 'broken.jpg', 'image/jpeg', Buffer.from('this is none'));
        await complaint(page, /cannot be read/);
        await choose(page, photo);
        await page.getByRole('heading', { name: 'A scene from a photo' }).waitFor();
        const before = (await stateOf(page)).worlds[0].opened;
        await button(page, 'Open').click();
        await until(page, ([before]) => window.skvalp.state.value.worlds[0].opened !== before,
            'it is opened', [before]);
        await lives(page, 'a photo');
    },

    async 'files are dropped, and a full storage keeps nothing'(browser) {
        const page = await begin(browser, small);
        await drop(page, 'mine.json', JSON.stringify({
            particles: 321, water: [{ shape: 'box', y1: 0.3 }],
            solid: [{ shape: 'line', points: [[0.2, 0.8], [0.8, 0.85]], thickness: 0.001 }],
        }));
        await until(page, () => window.skvalp.state.value.worlds[0].name.startsWith('mine'),
            'a scene that was dropped');
        await page.locator('.messages', { hasText: 'solid[0] is made 0.003 m thick, the least that holds water' }).waitFor();
        await drop(page, 'notes.txt', 'hello');
        await complaint(page, /no scene, picture, state or replay/);
        await drop(page, 'mine.json', '{ "particles": 1e99 }');
        await complaint(page, /mine\.json/);
        await page.evaluate(() => {
            File.prototype.arrayBuffer = () => Promise.reject(new DOMException('it was moved', 'NotFoundError'));
        });
        await drop(page, 'gone.skv', '');
        await complaint(page, /file cannot be read/);
        await lives(page, 'bad files');

        const full = await page.evaluate(() => {
            for (let length = 1 << 22; length > 0; length >>= 1) {
                try {
                    for (let i = 0; i < 8; i++)
                        localStorage.setItem(`${length} ${i}`, 'x'.repeat(length));
                } catch {}
            }
            try {
                localStorage.setItem('more', 'x'.repeat(1000));
                return false;
            } catch {
                return true;
            }
        });
        assert.ok(full, 'there is still room');
        await chooseFromMenu(page, 'Preferences');
        await page.getByLabel('Colours').selectOption('light');
        await until(page, () => document.documentElement.dataset.palette === 'light', 'light colours');
    },

    async 'a picture is saved'(browser) {
        const page = await begin(browser, small);
        const saved = page.waitForEvent('download');
        await chooseFromMenu(page, 'Save a Picture');
        const { width, height, data } = decode(readFileSync(await (await saved).path()));
        assert.equal(Math.max(width, height), 1280);
        assert.ok(new Set(data).size > 20, 'nothing is in the picture');
    },

    async 'a video is whole, however the page changes meanwhile'(browser) {
        const countCopies = () => {
            const { prototype } = CanvasRenderingContext2D, { drawImage } = prototype;
            window.copies = 0;
            prototype.drawImage = function (...given) {
                window.copies++;
                return drawImage.apply(this, given);
            };
        };
        const onPage = () => delete HTMLCanvasElement.prototype.transferControlToOffscreen;
        for (const [width, height, before] of [[1366, 768], [320, 568], [701, 545, onPage]]) {
            const page = await begin(browser, { width, height, before: [countCopies, before ?? []].flat(), isolated: true }, '?scene=pool');
            const download = page.waitForEvent('download');
            const later = async () => {
                const shown = await page.locator('.recorded').textContent();
                await page.waitForFunction((shown) => document.querySelector('.recorded').textContent !== shown, shown);
            };
            await chooseFromMenu(page, 'Record a video');
            await page.locator('.recorded').waitFor();
            await later();
            await button(page, 'Properties').click();
            await page.locator('.panel-properties').waitFor();
            await later();
            await page.setViewportSize({ width: height, height: width });
            await until(page, ([width]) => innerWidth === width, 'it is turned', [height]);
            await later();
            const { x, width: wide } = await page.locator('.header button').last().boundingBox();
            assert.ok(x + wide <= height, 'the sign pushes the menu off the screen');
            await close(page);
            await page.keyboard.press('m'); // a chip takes of the picture's height
            await page.locator('.chip').waitFor();
            await button(page, 'Pause').click(); // nothing is drawn, and yet there is a picture
            await later();
            await until(page, () => window.copies > 30, 'some pictures go into the video');
            await button(page, 'Stop recording').click();
            await page.locator('.recorded').waitFor({ state: 'detached' });
            const path = await (await download).path();
            const wrong = execFileSync('ffmpeg', ['-v', 'warning', '-xerror', '-i', path, '-f', 'null', '-'],
                { encoding: 'utf8', stdio: ['ignore', 'ignore', 'pipe'] });
            assert.equal(wrong ?? '', '');
            const { packets_and_frames: all } = JSON.parse(execFileSync('ffprobe', ['-v', 'error', '-select_streams', 'v', '-of', 'json',
                '-show_entries', 'frame=width,height:packet=pts_time', path], { encoding: 'utf8', maxBuffer: 1 << 26 }));
            const [frames, packets] = ['frame', 'packet'].map((wanted) => all.filter(({ type }) => type === wanted));
            const [first, last] = [packets[0], packets.at(-1)].map(({ pts_time: time }) => Number(time));
            const sizes = [...new Set(frames.map(({ width, height }) => `${width}x${height}`))];
            assert.equal(sizes.length, 1, `sizes ${sizes}`);
            assert.ok(frames[0].width % 2 === 0 && frames[0].height % 2 === 0, `an odd size ${sizes}`);
            assert.ok(frames[0].width > 0.6 * width && frames[0].height > 0.6 * height, `${sizes} of ${width}x${height}`);
            assert.equal(frames.length, packets.length, 'frames that cannot be decoded');
            // While water ran the sign changed three times: two whole seconds lie between.
            assert.ok(packets.length > 8 && last - first > 2, `${packets.length} frames in ${last - first} s`);
            // All of it shows water.
            const raw = execFileSync('ffmpeg', ['-v', 'error', '-i', path, '-vf', 'scale=64:64', '-f', 'rawvideo',
                '-pix_fmt', 'rgb24', '-'], { maxBuffer: 1 << 26 });
            const bytes = 64 * 64 * 3;
            for (let at = 0; at < raw.length; at += bytes) {
                let water = 0;
                for (let i = at; i < at + bytes; i += 3) {
                    water += raw[i + 2] > 120 && raw[i] < 110;
                }
                assert.ok(water > 10, `no water in picture ${at / bytes} of ${raw.length / bytes}, ${width}x${height}`);
            }
            await page.context().close();
        }
    },

    async 'the bench measures this device, and its figures agree'(browser) {
        const page = await begin(browser, { ...small, touch: true }, '?bench=300');
        await page.evaluate(() => {
            navigator.clipboard.writeText = async (text) => void (window.copied = text);
        });
        await page.getByRole('heading', { name: 'How fast this device is' }).waitFor();
        const panel = page.locator('.panel');
        await Promise.all([button(panel, 'Stop').waitFor(), button(panel, 'Measure').click()]); // it may be over soon
        await button(panel, 'Measure').waitFor();
        await button(panel, 'Copy').click();
        await until(page, () => window.copied, 'a text');
        const report = JSON.parse(await page.evaluate(() => window.copied));
        const cells = await page.locator('.results tbody tr').evaluateAll((rows) =>
            rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
        const threads = [...new Set(report.ns.map((figure) => figure.threads))];
        assert.equal(cells.length, 4 * threads.length);
        report.ns.forEach(({ law, particles, threads, least, median }, i) => {
            assert.deepEqual(cells[i].slice(1, 4), [law, String(particles), String(threads)]);
            const [shownLeast, shownMedian] = cells[i].slice(4).map((text) => Number(text.replace(/\s/g, '')));
            assert.ok(Math.abs(shownLeast / least - 1) < 0.01 && Math.abs(shownMedian / median - 1) < 0.01);
        });
        for (const { scene, particles, frames, least, median } of report.ns) {
            assert.ok(['dam-break', 'pool'].includes(scene) && Math.abs(particles - 300) < 60 && frames >= 5);
            assert.ok(least > 0 && least <= median && median < 1e7, `${least}, ${median}`);
        }
        assert.ok(report.browser.includes('Chrom') && report.cores > 0 && report.showing.frames > 0);
        assert.equal((await stateOf(page)).paused, false);
    },
};

await carryOut([folder], trials, [
    'pictures are opened, or refused in words, however large',
    'files are dropped, and a full storage keeps nothing',
    'a picture is saved',
    'a video is whole, however the page changes meanwhile',
    'the bench measures this device, and its figures agree',
]);
