// Sides: what each of two compared worlds is, and its legend. Invariant: where both have the same legend, one
// shows.
import type { Legend as Scale } from '../simulation/protocol';
import { choice } from './choices';
import { Legend } from './Legend';
import { state } from './model';
import { _ } from './words';

/** CSS pixels: how far below the picture's upper edge the status begins, and how high its first line is. */
const ABOVE = 60;
const LINE = 36;

function isSame(a: Scale | null, b: Scale | null): boolean {
    return a !== null && b !== null && a.label === b.label && a.low === b.low && a.high === b.high;
}

export default function Sides() {
    const worlds = state.value?.worlds ?? [];
    return (
        <>
            {worlds.map(({ area, legend }, side) => (
                <div
                    class="side"
                    style={{ left: `${area.x}px`, top: `${Math.max(LINE, area.y + 8 - ABOVE)}px`, width: `${area.width}px` }}
                >
                    <p class="pill">
                        <span class={`letter world-${side}`}>{'AB'[side]}</span>
                        {side === 0 ? _('As it is') : choice.value}
                    </p>
                    {legend && !(side === 1 && isSame(legend, worlds[0].legend)) && <Legend scale={legend} />}
                </div>
            ))}
        </>
    );
}
