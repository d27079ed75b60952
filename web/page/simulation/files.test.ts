// Files and links: what is made elsewhere opens here, and the other way round; what is broken does not,
// and what is open goes on.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';

import { decode } from 'fast-png';
import { afterAll, expect, test, vi } from 'vitest';

import { readOwn } from '../../src/entries.js';
import { parseJson } from '../../src/json.js';
import { paintedPicture, threshold } from './photo';
import { loadLarger, makeTrial, native } from './testing';

const folder = mkdtempSync(`${tmpdir()}/replays-`);
execFileSync(`${native}/write_replays`, [folder]);
afterAll(() => rmSync(folder, { recursive: true }));
const skvalp = (...given: string[]) => execFileSync(`${native}/skvalp`, given, { encoding: 'utf8' }).trim();

/** What the native program says of a link's end. */
function playNatively(link: string) {
    return JSON.parse(skvalp('replay', link, '--json')) as { frames: number; hash: string; same: boolean };
}

test('a link made natively plays to its end, with the same hash', () => {
    const trial = makeTrial();
    const link = skvalp('share', `${folder}/wind.skvr`);
    trial.simulation.openLink(link.replace('skvalp:', ''));
    expect(trial.take()).toEqual([{ kind: 'open', error: null }]);
    expect(trial.state).toMatchObject({ following: true, moment: 0, end: playNatively(link).frames });
    trial.run(40);
    expect(trial.take()).toEqual([]);
    expect(trial.state).toMatchObject({ asRecorded: true, mismatch: false });
});

test('a link made here plays natively, with the same hash', async () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('u-tube');
    trial.run(10);
    simulation.setGravity(0.5, -0.8);
    trial.run(10);
    simulation.set('fluid.viscosity', '0.001');
    trial.run(10);
    const text = await simulation.share();
    expect(text).toMatch(/^1\.[\w-]+$/);
    expect(playNatively(`skvalp:${text}`)).toMatchObject({ frames: 30, same: true });
    const other = makeTrial();
    other.simulation.openLink(`https://example.org/water/#${text}`);
    other.run(40);
    expect(other.state).toMatchObject({ asRecorded: true, mismatch: false });
    expect(other.state.worlds[0].parameters['fluid.viscosity']).toBe('0.001');
});

test('what went another way when it was recorded is known to', () => {
    const trial = makeTrial();
    trial.simulation.openBytes(readFileSync(`${folder}/skewed.skvr`), 'skvr', 'skewed.skvr');
    trial.run(40);
    expect(trial.state).toMatchObject({ asRecorded: false, mismatch: true });
});

test('what is broken is reported in one line, and what is open goes on', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('dam-break');
    trial.run(5);
    trial.take();
    const link = skvalp('share', 'dam-break');
    const game = readFileSync(`${folder}/game.skvr`);
    const attempts = [
        () => simulation.openLink(link.slice(0, -9)),
        () => simulation.openLink('2.AAAA'),
        () => simulation.openLink(''),
        () => simulation.openLink(`1.${'A'.repeat(40000)}`),
        () => simulation.openLink('javascript:alert(1)'),
        () => simulation.open('no-such-scene'),
        () => simulation.open('dam-break', { particles: 'many' }),
        () => simulation.open('dam-break', { 'no.such': '1' }),
        () => simulation.openBytes(new Uint8Array(0), 'json', 'empty.json'),
        () => simulation.openBytes(new TextEncoder().encode('{"world": '), 'json', 'cut.json'),
        () => simulation.openBytes(game.subarray(0, 99), 'skvr', 'cut.skvr'),
        () => simulation.openBytes(new Uint8Array(100), 'skv', 'zeros.skv'),
        () => simulation.openBytes(new Uint8Array(100), 'png', 'zeros.png'),
        () => simulation.openExperiment(99),
    ];
    for (const attempt of attempts) {
        const { moment } = trial.state;
        attempt();
        const reports = trial.take();
        expect(reports).toHaveLength(1);
        expect(reports[0].kind).toBe('open');
        expect(reports[0].error).toMatch(/^.+$/);
        trial.run(1);
        expect(trial.state.moment).toBe(moment + 1);
        expect(trial.state.worlds[0].name).toBe('dam-break');
    }
});

test('states and replays are saved and open again', async () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('dam-break');
    trial.run(12);
    simulation.setPaused(true);
    const { time } = trial.state.worlds[0];
    const state = await simulation.save('skv'), replay = await simulation.save('skvr');
    simulation.openBytes(state, 'skv', 'mine.skv');
    expect(trial.state.worlds[0].time).toBeCloseTo(time, 6);
    await expect(simulation.share()).rejects.toThrow(/began with a state/)
    simulation.openBytes(replay, 'skvr', 'mine.skvr');
    expect(trial.state).toMatchObject({ moment: 0, end: 12, following: true });
    await expect(simulation.save('png')).rejects.toThrow();
});

test('what the library says of a scene is there while it is open', () => {
    const trial = makeTrial();
    const thin = '{"particles": 321, "water": [{"shape": "box", "y1": 0.3}], ' +
        '"solid": [{"shape": "line", "points": [[0.2, 0.8], [0.8, 0.85]], "thickness": 0.001}]}';
    trial.simulation.openBytes(new TextEncoder().encode(thin), 'json', 'thin.json');
    expect(trial.state.worlds[0].notes).toEqual(['solid[0] is made 0.003 m thick, the least that holds water']);
    trial.simulation.open('pool');
    expect(trial.state.worlds[0].notes).toEqual([]);
});

test('a scene begins again with other settings', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('dam-break', { 'fluid.material': 'honey' });
    simulation.change({ particles: '600' });
    expect(trial.state.worlds[0].particles).toBeGreaterThan(500);
    expect(Number(trial.state.worlds[0].parameters['fluid.viscosity'])).toBeGreaterThan(0.001);
    simulation.openExperiment(0);
    expect(trial.take().every(({ error }) => error === null)).toBe(true);
    expect(trial.state.worlds[0].particles).toBe(500); // 300 are chosen, and its narrowest passage needs more
});

test('after one that cannot be opened, what begins again is what is open', () => {
    const trial = makeTrial();
    const { simulation } = trial;
    simulation.open('dam-break');
    simulation.open('no-such-scene');
    trial.take();
    simulation.change({ particles: '600' });
    expect(trial.take()).toEqual([{ kind: 'open', error: null }]);
    expect(trial.state.worlds[0].name).toBe('dam-break');
});

test('a fault in a file is told with its line', () => {
    const trial = makeTrial();
    trial.simulation.openBytes(new TextEncoder().encode('{\n"world": ]\n}'), 'json', 'wrong.json');
    expect(trial.take()[0].error).toMatch(/wrong\.json:2\b/);
});

test('a photo becomes walls where it is dark', () => {
    const width = 64, height = 36;
    const photo = Uint8ClampedArray.from({ length: 4 * width * height },
        (_, i) => (i % 4 === 3 ? 255 : (i >> 2) % width < 20 ? 40 : 200));
    const painted = threshold(photo, { level: 0.5, inverted: false });
    const png = decode(paintedPicture(painted, width, height));
    expect([png.width, png.height]).toEqual([width, height]);
    const trial = makeTrial();
    trial.simulation.openBytes(paintedPicture(painted, width, height), 'png', 'photo.png');
    expect(trial.take()).toEqual([{ kind: 'open', error: null }]);
});

test('built-in scenes read the same before the strict reader has come', () => {
    const scenes = '../scenes';
    const files = readdirSync(scenes).filter((name) => name.endsWith('.json'));
    expect(files.length).toBeGreaterThan(5);
    for (const name of files) {
        const text = readFileSync(`${scenes}/${name}`);
        expect(readOwn(text)).toEqual(parseJson(text));
    }
    const text = new TextEncoder().encode('{ "a": [null, true, false, "b", -1.5e3, {}, []] }');
    expect(readOwn(text)).toEqual(parseJson(text));
    expect(readOwn(new TextEncoder().encode('{ // no'))).toMatchObject({ words: 'its reader has not come' });
});

test('a painted scene opens though the reader of pictures comes only then', async () => {
    const trial = makeTrial({ lean: true, of: await loadLarger() });
    trial.simulation.open('dam-break');
    trial.simulation.open('funnel');
    expect(trial.state.worlds[0].name).toBe('dam-break');
    await vi.waitUntil(() => trial.state.worlds[0].name === 'funnel');
    expect(trial.state.worlds[0].particles).toBe(300);
    expect(trial.take().every(({ error }) => error === null)).toBe(true);
});
