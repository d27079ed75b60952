// Device: what a phone or a computer can do besides drawing. Invariant: what is missing or refused is
// said or passed over; nothing here throws.
import { signal } from '@preact/signals';
import { complain, ready, simulation, toast } from './model';
import { preferences, touch } from './preferences';
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

// Tilt

export type Tilt = 'off' | 'asking' | 'on';
export const tilt = signal<Tilt>('off');
/** Longer than any sensor takes to say its first word. */
const SILENCE = 2000;

/** iOS asks the reader, after a tap alone. */
type Asking = typeof DeviceMotionEvent & { requestPermission?: () => Promise<PermissionState> };

export const canTilt = 'DeviceMotionEvent' in window && window.isSecureContext;

function onMotion(event: DeviceMotionEvent): void {
    const felt = event.accelerationIncludingGravity;
    if (felt?.x == null || felt.y == null || felt.z == null || !ready.value)
        return; // the first event of some browsers is empty
    tilt.value = 'on';
    const angle = screen.orientation?.angle ?? 0;
    simulation.motion(felt.x, felt.y, felt.z, angle, event.timeStamp / 1000);
}

export function endTilt(): void {
    window.removeEventListener('devicemotion', onMotion);
    tilt.value = 'off';
}

/** Says why there is none, and what to do instead. */
function giveUp(reason: string): void {
    endTilt();
    const instead = touch.value ? _('Drag the gravity ball instead.') : _('Drag the gravity ball instead, or press the arrow keys.');
    complain(`${reason} ${instead}`);
}

export async function beginTilt(): Promise<void> {
    if (!canTilt) {
        giveUp(_('This browser tells pages nothing of how the device is held.'));
        return;
    }
    tilt.value = 'asking';
    try {
        const answer = await (DeviceMotionEvent as Asking).requestPermission?.();
        if (answer === 'denied') {
            giveUp(_('The page may not know how the device is held: allow motion in the browser’s settings.'));
            return;
        }
    } catch {
        giveUp(_('The browser did not ask: tap the button once more.'));
        return;
    }
    window.addEventListener('devicemotion', onMotion);
    setTimeout(() => {
        if (tilt.value !== 'asking')
            return;
        giveUp(
            window.top === window
                ? _('This device has no sensor that says how it is held.')
                : _('No sensor speaks to a page inside of another one: open it in a tab of its own.'),
        );
    }, SILENCE);
}
