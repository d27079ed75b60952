// Preferences: what a reader chose, kept in the browser where it may be. Invariant: a choice acts at
// once, and a browser that keeps nothing (private, full, forbidden) does not hinder the page.
import { signal } from '@preact/signals';

const KEY = 'skvalp';

export interface Preferences {
    /** '' follows the browser. */
    language: string;
    scheme: 'system' | 'light' | 'dark';
    detail: string;
    view: string;
    overlays: string[];
    si: boolean;
    ball: boolean;
    /** Of the sensor, against the scene's own gravity: 0..2. */
    tilt: number;
    /** Keys without Ctrl do something. */
    keys: boolean;
    vibrate: boolean;
    /** Of scenes that would have 3000; 0: as measured. */
    particles: number;
    /** What this device was found to be good for; 0: it has not been measured. */
    measured: number;
}

const standard: Preferences = {
    language: '',
    scheme: 'system',
    detail: 'auto',
    view: 'water',
    overlays: [],
    si: false,
    ball: true,
    tilt: 1,
    keys: true,
    vibrate: true,
    particles: 0,
    measured: 0,
};

/** What was kept, as far as it is of the kind that it should be. */
function load(): Preferences {
    const loaded: Record<string, unknown> = { ...standard };
    try {
        const kept = JSON.parse(localStorage.getItem(KEY) ?? '{}');
        for (const [name, value] of Object.entries(standard))
            if (typeof kept[name] === typeof value && Array.isArray(kept[name]) === Array.isArray(value))
                loaded[name] = kept[name];
    } catch {
        // Nothing is kept: the standard is as good.
    }
    return loaded as unknown as Preferences;
}

/** What counts now: what was kept, but for what was said for this visit alone. */
export const preferences = signal(load());

/** @param keeps whether it outlives the visit: what the address or a page around this one says does not */
export function prefer(changes: Partial<Preferences>, keeps = true): void {
    preferences.value = { ...preferences.value, ...changes };
    if (!keeps)
        return;
    try {
        // Another tab may have kept something meanwhile.
        localStorage.setItem(KEY, JSON.stringify({ ...load(), ...changes }));
    } catch {
        // It holds until the page is left.
    }
}

function query(text: string) {
    const media = matchMedia(text);
    const matches = signal(media.matches);
    media.addEventListener('change', () => (matches.value = media.matches));
    return matches;
}

export const systemLight = query('(prefers-color-scheme: light)');
/** Also where the system's own colours take the place of the page's. */
export const moreContrast = query('(prefers-contrast: more), (forced-colors: active)');
export const lessMotion = query('(prefers-reduced-motion: reduce)');
/** Fingers are all there is. */
export const touch = query('(pointer: coarse) and (hover: none)');

/** The renderer's palette that goes with the page's colours. */
export function paletteOf(chosen: Preferences, light: boolean, contrast: boolean): string {
    if (contrast)
        return 'contrast';
    const scheme = chosen.scheme === 'system' ? (light ? 'light' : 'dark') : chosen.scheme;
    return scheme;
}
