// Probes: the instruments over the picture. Invariant: only their grips take the pointer, all else is
// the water's below; while one is dragged the simulation is told, and what shows is what it says.
import { useRef } from 'preact/hooks';
import type { Probe, WorldState } from '../simulation/protocol';
import { kindOf, moveProbe } from './instruments';
import { simulation, state } from './model';
import { _, word } from './words';

function Grip(props: { probe: Probe; world: WorldState; end: 0 | 1; label: string }) {
    const { probe, world, end } = props;
    /** Where the pointer and the probe were when it was gripped. */
    const begun = useRef<{ x: number; y: number; probe: Probe } | null>(null);
    const { scale, originX, originY } = world.camera;
    const x = originX + scale * (end ? probe.x1 : probe.x0);
    const y = originY - scale * (end ? probe.y1 : probe.y0);

    /** By all of the way so far: the state may not know the last steps of it. */
    function onMove(event: PointerEvent): void {
        if (!begun.current)
            return;
        const from = begun.current.probe;
        const dx = (event.clientX - begun.current.x) / scale;
        const dy = (begun.current.y - event.clientY) / scale;
        if (end)
            simulation.moveProbe(from.id, from.x0, from.y0, from.x1 + dx, from.y1 + dy);
        else
            moveProbe(from, dx, dy); // the first point of a line takes the second with it
    }
    function onUp(event: PointerEvent): void {
        begun.current = null;
        const box = (event.currentTarget as SVGElement).ownerSVGElement!.getBoundingClientRect();
        const outside =
            event.clientX < box.left || event.clientX > box.right ||
            event.clientY < box.top || event.clientY > box.bottom;
        if (outside)
            simulation.removeProbe(probe.id);
    }
    return (
        <g
            class="grip"
            transform={`translate(${x} ${y})`}
            onPointerDown={(event) => {
                event.currentTarget.setPointerCapture(event.pointerId);
                begun.current = { x: event.clientX, y: event.clientY, probe };
            }}
            onPointerMove={onMove}
            onPointerUp={onUp}
            onPointerCancel={() => (begun.current = null)}
        >
            <circle r="22" class="reach" />
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
        kindOf(probe.kind).name === 'force meter'
            ? `M${x0} ${y0}H${x1}V${y1}H${x0}z`
            : `M${x0} ${y0}L${x1} ${y1}`;
    return (
        <>
            <path class="line under" d={path} />
            <path class="line" d={path} />
        </>
    );
}

/** Readings have their buttons below the picture, which the keyboard reaches; these are for pointers. */
export function Probes() {
    const worlds = state.value?.worlds ?? [];
    if (!worlds.some((world) => world.probes.length > 0))
        return null;
    return (
        <svg class="probes" role="img" aria-label={_('Measurements')}>
            <title>{worlds[0].probes.map((probe) => word(kindOf(probe.kind).title)).join(', ')}</title>
            {worlds.map((world, side) =>
                world.probes.map((probe) => (
                    <g key={`${side}.${probe.id}`}>
                        {kindOf(probe.kind).line && (
                            <>
                                <Line probe={probe} world={world} />
                                <Grip probe={probe} world={world} end={1} label="" />
                            </>
                        )}
                        <Grip probe={probe} world={world} end={0} label={String(probe.id)} />
                    </g>
                )),
            )}
        </svg>
    );
}
