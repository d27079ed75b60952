// Probes: the instruments over the picture. Invariant: only their grips take the pointer, all else is
// the water's below; while one is dragged the simulation is told, and what shows is what it says.
import { useRef } from 'preact/hooks';
import type { Probe, Side, WorldState } from '../simulation/protocol';
import { channelOf, gaugeOf } from './instruments';
import { placesOf } from './labels';
import { catalogue, simulation, state } from './model';
import { readingText } from './numbers';
import { _, word } from './words';

/** CSS pixels, of one letter of a reading, the broadest of fonts. */
const LETTER = 8.5;

function Grip(props: { probe: Probe; world: WorldState; side: number; end: 0 | 1; label: string }) {
    const { probe, world, end } = props;
    /** Where the pointer was against this end when it was gripped. */
    const begun = useRef<{ x: number; y: number } | null>(null);
    const { scale, originX, originY } = world.camera;
    const x = originX + scale * (end ? probe.x1 : probe.x0);
    const y = originY - scale * (end ? probe.y1 : probe.y0);

    function onMove(event: PointerEvent): void {
        if (!begun.current)
            return;
        const to = { x: event.clientX - begun.current.x, y: event.clientY - begun.current.y };
        simulation.dragProbe(probe.id, end, (to.x - originX) / scale, (originY - to.y) / scale, props.side as Side);
    }
    return (
        <g
            class="grip"
            transform={`translate(${x} ${y})`}
            onPointerDown={(event) => {
                event.currentTarget.setPointerCapture(event.pointerId);
                begun.current = { x: event.clientX - x, y: event.clientY - y };
            }}
            onPointerMove={onMove}
            onPointerUp={() => (begun.current = null)}
            onPointerCancel={() => (begun.current = null)}
        >
            <circle r={catalogue.limits.grip} class="reach" />
            <circle r="11" class="disc" />
            <text>{props.label}</text>
        </g>
    );
}

function Line({ probe, world }: { probe: Probe; world: WorldState }) {
    const { scale, originX, originY } = world.camera;
    const [x0, x1] = [probe.x0, probe.x1].map((x) => originX + scale * x);
    const [y0, y1] = [probe.y0, probe.y1].map((y) => originY - scale * y);
    const path =
        gaugeOf(probe).box
            ? `M${x0} ${y0}H${x1}V${y1}H${x0}z`
            : `M${x0} ${y0}L${x1} ${y1}`;
    return (
        <>
            <path class="line under" d={path} />
            <path class="line" d={path} />
        </>
    );
}

/** What they read, beside their first ends; with its number, what stands further off. */
function Readings({ world }: { world: WorldState }) {
    const { scale, originX, originY } = world.camera;
    const texts = world.probes.map((probe) => readingText(channelOf(probe)));
    const first = world.probes.map(({ x0, y0 }) => ({ x: originX + scale * x0, y: originY - scale * y0 }));
    const second = world.probes.filter((probe) => gaugeOf(probe).line)
        .map(({ x1, y1 }) => ({ x: originX + scale * x1, y: originY - scale * y1 }));
    const numbers = world.probes.map(({ id }) => `${id}: `);
    const labels = first.map((at, i) => ({ ...at, width: LETTER * (numbers[i] + texts[i]).length }));
    return (
        <>
            {placesOf(labels, [...first, ...second], world.area).map((place, i) => place && (
                <text class="reading numeric" x={place.x} y={place.y} text-anchor={place.ends ? 'end' : 'start'}>
                    {place.y === first[i].y ? texts[i] : numbers[i] + texts[i]}
                </text>
            ))}
        </>
    );
}

/** Readings have their buttons below the picture, which the keyboard reaches; these are for pointers. */
export default function Probes() {
    const worlds = state.value?.worlds ?? [];
    return (
        <svg class="probes" role="img" aria-label={_('Measurements')}>
            <title>{worlds[0].probes.map((probe) => word(gaugeOf(probe).title)).join(', ')}</title>
            {worlds.map((world, side) => [
                ...world.probes.map((probe) => (
                    <g key={`${side}.${probe.id}`}>
                        {gaugeOf(probe).line && (
                            <>
                                <Line probe={probe} world={world} />
                                <Grip probe={probe} world={world} side={side} end={1} label="" />
                            </>
                        )}
                        <Grip probe={probe} world={world} side={side} end={0} label={String(probe.id)} />
                    </g>
                )),
                <Readings key={side} world={world} />,
            ])}
        </svg>
    );
}
