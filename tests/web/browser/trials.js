// Trials: the parts of a test in the browser, one after the other, each with a name.
//
// Invariant: every trial ends, well or by name, and none touches the next: it has pages of its own, which
// are closed after it, and as long as it may take.
import assert from 'node:assert/strict';
import { availableParallelism, loadavg } from 'node:os';

import { run } from './harness.js';

/** s: trials take 1 to 60, several times that on a slow machine, and nothing in a page is waited for longer than 180. */
const longest = 600;

/** s, now: where more wants to run than there are cores, all takes longer; twice it is the end of patience. */
const allowed = () => longest * Math.min(2, Math.max(1, loadavg()[0] / availableParallelism()));

/** Where in its trial an error comes from: the last step that it was at. */
function placeOf(error) {
    const frames = error.stack?.split('\n').filter((line) => line.includes(`${process.argv[1]}:`)) ?? [];
    const within = frames.filter((line) => line.includes('(')); // in a function
    return within.at(-1)?.match(/[^/]+\.js:\d+/)?.[0] ?? 'at an unknown step';
}

/**
 * Ends as the trial does, or after too long: then its pages are closed, which ends what it waits for.
 * What it throws says where, and isLate.
 */
async function carryOutOne(browser, trial) {
    const begun = Date.now();
    let overdue, isLate = false;
    const tooLong = new Promise((_, reject) => {
        overdue = setInterval(async () => {
            if (isLate || Date.now() - begun < 1000 * allowed()) {
                return;
            }
            isLate = true;
            await browser.closePages();
            setTimeout(() => reject(new Error('nor with its pages closed')), 1000);
        }, 1000);
    });
    try {
        await Promise.race([trial(browser), tooLong]);
        assert.deepEqual(browser.takeTroubles(), []);
    } catch (error) {
        const late = isLate ? `not over after ${Math.round((Date.now() - begun) / 1000)} s: ` : '';
        const cause = new Error(`${late}${error.message} (${placeOf(error)})`, { cause: error });
        throw Object.assign(cause, { isLate });
    } finally {
        clearInterval(overdue);
    }
}

/** Carries out trials in one browser as long as that can be trusted: those that are left. */
async function carryOutSome(browser, left, failures) {
    while (left.length > 0) {
        const [name, trial] = left.shift();
        const begun = Date.now();
        try {
            await carryOutOne(browser, trial);
            await browser.closePages();
            browser.takeTroubles(); // of what was under way when they were closed: none is the next trial's
            console.log(`${name} (${((Date.now() - begun) / 1000).toFixed(1)} s)`);
        } catch (error) {
            failures.push(name);
            console.error([`${name}: ${error.message}`, ...browser.takeTroubles()].join('\n'));
            if (process.env.SKV_VERBOSE) {
                console.error(error.cause);
            }
            if (error.isLate) {
                return; // a page that computes for ever holds up all that the browser does
            }
            await browser.closePages();
        }
    }
}

/** The status of a program that has no trial of the name that was asked for; see lib.sh. */
const noTrial = 64;

/**
 * Carries out trials, by their names, all of them though some fail; SKV_TRIAL=words those alone whose
 * names have these words, one at least.
 * @param {string[]} folders that the browser sees
 * @param {Record<string, (browser: Awaited<ReturnType<import('./harness.js').launch>>) => Promise<void>>} trials
 * @param {string[]} long names of those that are left to SKV_LONG_TESTS=1, or asked for by SKV_TRIAL
 * @param {Parameters<typeof run>[2]} [options]
 */
export async function carryOut(folders, trials, long = [], options) {
    const only = process.env.SKV_TRIAL ?? '';
    const all = only !== '' || process.env.SKV_LONG_TESTS === '1';
    const left = Object.entries(trials).filter(([name]) => name.includes(only) && (all || !long.includes(name)));
    const failures = [];
    if (left.length === 0) {
        process.exitCode = noTrial;
    }
    while (left.length > 0 && process.exitCode !== 1) {
        await run(folders, (browser) => carryOutSome(browser, left, failures), options);
    }
    if (failures.length > 0) {
        console.error(`failed: ${failures.join('; ')}`);
        process.exitCode = 1;
    }
}
