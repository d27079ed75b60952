// Plot: curves over time or another quantity. Invariant: what theory says is dashed; what was measured is a
// line or points, told apart without colours, too.
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Curve } from '../simulation/protocol';
import { axesOf, wayOf } from './axes';
import { short } from './numbers';

const LEFT = 56, RIGHT = 16, TOP = 12, BOTTOM = 24;
/** In the page's style. */
const COLOURS = 6;

interface PlotProps {
    xLabel: string;
    yLabel: string;
    curves: Curve[];
    name: string;
}

function Way({ curve, at, way }: { curve: Curve; at: number; way: string }) {
    return <path class={curve.style} style={{ stroke: `var(--curve${at % COLOURS})` }} d={way} />;
}

/** What a label belongs to. */
function Key({ curve, at }: { curve: Curve; at: number }) {
    const dots = curve.style === 'dots' || curve.style === 'rings';
    const way = wayOf({ ...curve, x: Float64Array.of(dots ? 16 : 2, 30), y: Float64Array.of(6, dots ? NaN : 6) },
        { ticks: [], place: Number }, { ticks: [], place: Number });
    return (
        <li>
            <svg width="32" height="12">
                <Way curve={curve} at={at} way={way} />
            </svg>
            {curve.label}
        </li>
    );
}

export function Plot({ xLabel, yLabel, curves, name }: PlotProps) {
    const picture = useRef<SVGSVGElement>(null);
    const [{ width, height }, setSize] = useState({ width: 320, height: 216 });
    useLayoutEffect(() => {
        const element = picture.current!;
        const observer = new ResizeObserver(([{ contentRect }]) => setSize(contentRect));
        observer.observe(element);
        return () => observer.disconnect();
    }, []);
    const right = width - RIGHT, bottom = height - BOTTOM;
    const { across, up } = axesOf(curves, LEFT, right, TOP, bottom);
    return (
        <div class="plot">
            <p>{yLabel}</p>
            <svg ref={picture} role="img" aria-label={name}>
                {across.ticks.map((tick) => (
                    <g key={`x${tick}`}>
                        <path class="grid" d={`M${across.place(tick)} ${TOP}V${bottom}`} />
                        <text x={across.place(tick)} y={height - 6} text-anchor="middle">{short(tick, 6)}</text>
                    </g>
                ))}
                {up.ticks.map((tick) => (
                    <g key={`y${tick}`}>
                        <path class="grid" d={`M${LEFT} ${up.place(tick)}H${right}`} />
                        <text x={LEFT - 8} y={up.place(tick) + 5} text-anchor="end">{short(tick, 6)}</text>
                    </g>
                ))}
                {curves.map((curve, i) => (
                    <Way curve={curve} at={i} way={wayOf(curve, across, up)} />
                ))}
            </svg>
            <p class="below">{xLabel}</p>
            {curves.length > 1 && (
                <ul>
                    {curves.map((curve, i) => (
                        <Key curve={curve} at={i} />
                    ))}
                </ul>
            )}
        </div>
    );
}
