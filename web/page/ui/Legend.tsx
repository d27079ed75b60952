// Legend: the scale with which a world is drawn. Invariant: where two worlds have the same, one shows.
import type { Legend as Scale } from '../simulation/protocol';
import { compared, part, simulation, state } from './model';
import { short } from './numbers';
import { _, word } from './words';

const fixed = part((s) => s.style.range > 0, false);

function isSame(a: Scale | null, b: Scale | null): boolean {
    return a !== null && b !== null && a.label === b.label && a.low === b.low && a.high === b.high;
}

function Legend({ scale, right, top }: { scale: Scale; right: number; top: number }) {
    const figures = [0, 0.5, 1].map((at) => (scale.low + (scale.high - scale.low) * at) / scale.size);
    const unit = scale.unit ? `, ${word(scale.unit)}` : '';
    const title = `${word(scale.label)}${unit}${fixed.value ? _(' (fixed)') : ''}`;
    return (
        <button
            type="button"
            class="legend"
            style={{ right: `${right}px`, top: `${top}px` }}
            title={_('Keep this range, or let it follow the water')}
            aria-pressed={fixed.value}
            onClick={() => simulation.setStyle({ range: fixed.value ? 0 : scale.high })}
        >
            <span class="hidden">{`${_('Legend')}: `}</span>
            <span>{title}</span>
            <span class="colours" style={{ background: `linear-gradient(to right, ${scale.colors.join(', ')})` }} />
            <span class="figures numeric">
                {figures.map((figure) => (
                    <span>{short(figure, 4)}</span>
                ))}
            </span>
        </button>
    );
}

export function Legends() {
    const worlds = state.value?.worlds ?? [];
    const whole = worlds.reduce((most, { area }) => Math.max(most, area.x + area.width), 0);
    return (
        <>
            {worlds.map(({ legend, area }, side) => {
                if (!legend || (side === 1 && isSame(legend, worlds[0].legend)))
                    return null;
                const top = compared.value && side === 1 && area.y > 0 ? area.y + 8 : 64;
                return <Legend scale={legend} right={whole - area.x - area.width + 8} top={top} />;
            })}
        </>
    );
}
