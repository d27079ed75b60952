// Stopwatch: the times between its presses, in frames of simulated time, as skvalp/stopwatch.h has it.
// Invariant: what it shows depends on its presses and the moment alone, so it goes back in time, too.
import { computed, effect, signal } from '@preact/signals';
import { FRAMES, state } from './model';
import { quantity } from './numbers';

interface Press {
    moment: number;
    lap: boolean;
}

const presses = signal<Press[]>([]);
let opened = -1;

/** What went another way than when it was pressed has not been pressed. */
effect(() => {
    const now = state.value;
    if (!now)
        return;
    const same = now.worlds[0].opened === opened;
    const kept = same ? presses.peek().filter((press) => press.moment <= now.end) : [];
    opened = now.worlds[0].opened;
    if (kept.length < presses.peek().length)
        presses.value = kept;
});

function read(list: Press[], moment: number) {
    let shown = { running: false, frames: 0, laps: 0, lap: 0 };
    let start = 0;
    let lapStart = 0;
    for (const press of list.filter((press) => press.moment <= moment)) {
        if (press.lap) {
            shown.laps++;
            shown.lap = press.moment - lapStart;
            lapStart = press.moment;
        } else if (shown.running) {
            shown.running = false;
            shown.frames = press.moment - start;
        } else {
            shown = { running: true, frames: 0, laps: 0, lap: 0 };
            start = lapStart = press.moment;
        }
    }
    if (shown.running)
        shown.frames = moment - start;
    return shown;
}

export const reading = computed(() => read(presses.value, state.value?.moment ?? 0));
export const used = computed(() => presses.value.length > 0);

/** Starts, stops, or takes a lap. */
export function pressStopwatch(lap: boolean): void {
    const moment = state.value?.moment ?? 0;
    const before = presses.value.filter((press) => press.moment <= moment);
    if (!lap || read(before, moment).running)
        presses.value = [...before, { moment, lap }];
}

export const readingWords = computed(() => {
    const { frames, laps, lap } = reading.value;
    const time = quantity(frames / FRAMES, 2, 's');
    return laps === 0 ? time : `${time} (${laps}: ${quantity(lap / FRAMES, 2, 's')})`;
});
