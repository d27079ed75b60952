// Legend: the scale with which a world is drawn. Invariant: it is what the state says of the picture.
import type { Legend as Scale } from '../simulation/protocol';
import { part, simulation } from './model';
import { short } from './numbers';
import { _, word } from './words';

const fixed = part((s) => s.style.range > 0, false);

export function Legend({ scale }: { scale: Scale }) {
    const figures = [0, 0.5, 1].map((at) => (scale.low + (scale.high - scale.low) * at) / scale.size);
    const unit = scale.unit ? `, ${word(scale.unit)}` : '';
    const title = `${word(scale.label)}${unit}${fixed.value ? _(' (fixed)') : ''}`;
    return (
        <button
            type="button"
            class="legend"
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
