// Device: what a phone or a computer can do besides drawing. Invariant: what is missing or refused is
// said or passed over; nothing here throws.
import { signal } from '@preact/signals';
import { toast } from './model';
import { preferences } from './preferences';
import { _ } from './words';

// Full screen

export const fullscreen = signal(false);
export const canFullscreen = document.fullscreenEnabled ?? false;
document.addEventListener('fullscreenchange', () => (fullscreen.value = document.fullscreenElement !== null));

export function toggleFullscreen(): void {
    const done = fullscreen.value ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
    done?.catch(() => toast(_('This browser does not allow full screen here.')));
}

/** What a page around this one forbids is not even tried: browsers speak of that in the console. */
function allowed(feature: string): boolean {
    const { featurePolicy } = document as Document & { featurePolicy?: { allowsFeature(name: string): boolean } };
    return featurePolicy?.allowsFeature(feature) ?? true;
}

// Awake while it plays

let lock: WakeLockSentinel | null = null;
let awake = false;
let asking = false;

/** One question at a time: an answer may come when it is no longer wanted. */
export async function keepAwake(wanted: boolean): Promise<void> {
    awake = wanted;
    if (asking || !navigator.wakeLock || !allowed('screen-wake-lock'))
        return;
    asking = true;
    try {
        while (awake !== (lock !== null && !lock.released)) {
            if (awake) {
                lock = await navigator.wakeLock.request('screen');
            } else {
                await lock?.release();
                lock = null;
            }
        }
    } catch {
        // A low battery may forbid it; the water flows all the same.
    } finally {
        asking = false;
    }
}

/** A short knock that fingers feel. */
export function knock(): void {
    if (preferences.value.vibrate)
        navigator.vibrate?.(8);
}
