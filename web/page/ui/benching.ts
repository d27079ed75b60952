// Benching: the bench as it runs, and what it has found, as a text to be passed on. Invariant: the water
// stands still while it runs, and goes on after it if it went before.
import { computed, signal } from '@preact/signals';
import type { BenchMessage, Figure } from '../simulation/bench';
import { runBench } from '../simulation/benching';
import { beginErrand, wordsOfFailure } from './errands';
import { catalogue, complain, FRAMES, simulation, state } from './model';
import { copyText } from './sharing';
import { _ } from './words';

/** Of water as it is shown: pictures of the display and frames of the simulation a second, and ms each. */
export interface Showing {
    pictures: number;
    frames: number;
    stepMs: number;
    drawMs: number;
}

export const running = signal(false);
export const share = signal(0);
export const figures = signal<Figure[]>([]);
export const showing = signal<Showing | null>(null);

/** Particles; one size that the address names (?bench=300) in place of these. */
const SIZES = [1000, 3000, 8000];
export const SMALLEST = 100, LARGEST = 100_000;
const WATCHED = 2000; // ms

let end: (() => void) | null = null;
let wasPaused = false;

function sizes(): number[] {
    const asked = Number(new URLSearchParams(location.search).get('bench'));
    return asked >= SMALLEST ? [Math.min(Math.round(asked), LARGEST)] : SIZES;
}

/** Watches the water play for a while. */
function watch(): Promise<Showing> {
    const begun = performance.now();
    const from = state.value?.moment ?? 0;
    return new Promise((resolve) => {
        let pictures = 0;
        requestAnimationFrame(function count() {
            pictures++;
            const seconds = (performance.now() - begun) / 1000;
            if (running.value && 1000 * seconds < WATCHED) {
                requestAnimationFrame(count);
                return;
            }
            const now = state.value;
            const frames = Math.max(0, (now?.moment ?? 0) - from) / seconds;
            resolve({ pictures: pictures / seconds, frames, stepMs: now?.stepMs ?? 0, drawMs: now?.drawMs ?? 0 });
        });
    });
}

export function stopBench(): void {
    if (!running.value)
        return;
    end?.();
    end = null;
    running.value = false;
    simulation.setPaused(wasPaused);
}

function hear(data: BenchMessage): void {
    if (data.kind === 'figure') {
        figures.value = [...figures.value, data.figure];
        share.value = data.share;
        return;
    }
    stopBench();
    if (data.kind === 'failed')
        complain(wordsOfFailure(data.error));
}

export async function startBench(): Promise<void> {
    wasPaused = state.value?.paused ?? false;
    running.value = true;
    share.value = 0;
    figures.value = [];
    showing.value = null;
    simulation.setPaused(false);
    const seen = await watch();
    if (!running.value)
        return;
    showing.value = seen;
    simulation.setPaused(true);
    end = beginErrand(() => runBench(sizes(), hear), (error) => hear({ kind: 'failed', error }));
}

/** What the browser says of the device. */
export const device = {
    browser: navigator.userAgent,
    cores: navigator.hardwareConcurrency,
    memory: (navigator as { deviceMemory?: number }).deviceMemory ?? null,
    screen: `${screen.width}x${screen.height}@${devicePixelRatio}`,
    isolated: window.crossOriginIsolated,
};

/** All that was found, as JSON. */
export const report = computed(() => JSON.stringify({
    skvalp: catalogue.version, ...device, full: FRAMES, showing: showing.value, ns: figures.value,
}, (_name, value) => (typeof value === 'number' ? Number(value.toPrecision(4)) : value), 1));

export function copyReport(): Promise<void> {
    return copyText(report.value, _('The figures were copied'),
        _('The browser does not let the page write to the clipboard.'));
}
