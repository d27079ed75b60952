// Tilting: gravity as the device is held. Invariant: where there is no sensor, or it may not be read, it is said
// why, and what to do instead.
import { signal } from '@preact/signals';
import { complain, ready, simulation } from './model';
import { touch } from './preferences';
import { _ } from './words';

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
