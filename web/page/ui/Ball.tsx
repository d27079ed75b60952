// The gravity ball: a disc whose middle is weightlessness and whose ring is the scene's own strength;
// the rim is twice that. Invariant: it shows what the state says, never what the finger said last.
import { computed } from '@preact/signals';
import { simulation, state } from './model';
import { preferences } from './preferences';
import { fixed } from './numbers';
import { _, say } from './words';

const RADIUS = 32; // of the rim, in CSS pixels
const STRONGEST = 2; // times the scene's own strength, at the rim
const SNAP = 0.12; // of the strength: so near to the middle or to the ring it catches

const x = computed(() => state.value?.gravity.x ?? 0);
const y = computed(() => state.value?.gravity.y ?? -1);

function onDrag(event: PointerEvent & { currentTarget: HTMLElement }): void {
    if (event.type === 'pointerdown')
        event.currentTarget.setPointerCapture(event.pointerId);
    else if (!event.currentTarget.hasPointerCapture(event.pointerId))
        return;
    const box = event.currentTarget.getBoundingClientRect();
    const dx = ((event.clientX - box.left - box.width / 2) / RADIUS) * STRONGEST;
    const dy = ((box.top + box.height / 2 - event.clientY) / RADIUS) * STRONGEST;
    const length = Math.hypot(dx, dy);
    let wanted = Math.min(length, STRONGEST);
    if (wanted < SNAP)
        wanted = 0;
    else if (Math.abs(wanted - 1) < SNAP)
        wanted = 1;
    const factor = length > 0 ? wanted / length : 0;
    simulation.setGravity(dx * factor, dy * factor);
}

/** Arrows turn it: 5 degrees left and right, a tenth stronger and weaker up and down. */
function onKey(event: KeyboardEvent): void {
    const turn = { ArrowLeft: -1, ArrowRight: 1 }[event.key] ?? 0;
    const more = { ArrowUp: 0.1, ArrowDown: -0.1 }[event.key] ?? 0;
    if (!turn && !more)
        return;
    event.preventDefault();
    event.stopPropagation();
    const angle = Math.atan2(y.value, x.value) + (turn * 5 * Math.PI) / 180;
    const strength = Math.min(STRONGEST, Math.max(0, Math.hypot(x.value, y.value) + more));
    simulation.setGravity(strength * Math.cos(angle), strength * Math.sin(angle));
}

export function Ball() {
    if (!preferences.value.ball)
        return null;
    const strength = say(_('%s times as strong as the scene\'s'), fixed(Math.hypot(x.value, y.value), 1));
    const scale = RADIUS / STRONGEST;
    return (
        <div
            class="ball"
            role="slider"
            tabIndex={0}
            data-arrows
            aria-label={_('Gravity')}
            aria-valuemin={-180}
            aria-valuemax={180}
            aria-valuenow={Math.round((Math.atan2(x.value, -y.value) * 180) / Math.PI)}
            aria-valuetext={strength}
            title={_('Gravity: drag the ball to where down is (arrow keys)')}
            onPointerDown={onDrag}
            onPointerMove={onDrag}
            onKeyDown={onKey}
        >
            <svg viewBox="-36 -36 72 72" aria-hidden="true">
                <circle r={RADIUS} class="ring" />
                <circle r={scale} class="ring" />
                <circle r="1.500" class="dot" />
                <circle r="7" class="dot" cx={x.value * scale} cy={-y.value * scale} />
            </svg>
        </div>
    );
}
