// Stopwatch: what it reads, in words.
import { computed } from '@preact/signals';
import { FRAMES, part } from './model';
import { quantity } from './numbers';

export const reading = part((s) => s.stopwatch, { used: false, running: false, frames: 0, laps: 0, lap: 0 });

export const readingWords = computed(() => {
    const { frames, laps, lap } = reading.value;
    const time = quantity(frames / FRAMES, 2, 's');
    return laps === 0 ? time : `${time} (${laps}: ${quantity(lap / FRAMES, 2, 's')})`;
});
