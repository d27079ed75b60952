// Stage: the canvas, and what lies over it. Invariant: the canvas is made once and handed to the
// simulation once; it fills the stage, and the simulation is told whenever its size changes.
import { useLayoutEffect, useRef } from 'preact/hooks';
import { Ball } from './Ball';
import { catalogue, controls, measures, measuring, paused, ready, simulation, trouble } from './model';
import { later } from './later';
import { attachPointers } from './pointers';
import { Status } from './Status';
import { spoken } from './spoken';
import { _ } from './words';

const Probes = later(() => import('./Probes'), true);

/** Tells the simulation how large the element is, from now on. */
function watchSize(element: HTMLElement): () => void {
    const tell = () =>
        simulation.setView(element.clientWidth, element.clientHeight, window.devicePixelRatio || 1);
    const observer = new ResizeObserver(tell);
    observer.observe(element);
    tell();
    return () => observer.disconnect();
}

function Trouble() {
    if (!trouble.value)
        return null;
    return (
        <p class="trouble" role="alert">
            {trouble.value === 'lost'
                ? _('The graphics processor was taken away; the picture comes back once it returns.')
                : _('This browser has no WebGL 2, which draws the water: take a newer one, or another.')}
        </p>
    );
}

export function Stage({ canvas }: { canvas: HTMLCanvasElement }) {
    const holder = useRef<HTMLDivElement>(null);
    useLayoutEffect(() => {
        canvas.className = 'canvas';
        holder.current!.prepend(canvas);
    }, [canvas]);
    // Before the browser paints: what is seen can be touched.
    useLayoutEffect(() => {
        if (!ready.value)
            return;
        const endings = [watchSize(holder.current!), attachPointers(holder.current!)];
        return () => endings.forEach((end) => end());
    }, [ready.value]);
    return (
        <div class={`stage ${measuring.value && paused.value ? 'waits' : ''}`}>
            <div
                ref={holder}
                class="water"
                role="application"
                aria-label={_('Water')}
                aria-describedby="spoken"
                tabIndex={0}
            />
            <p id="spoken" class="hidden" aria-live="polite">
                {spoken.value}
            </p>
            <Trouble />
            {ready.value && (
                <>
                    {measures.value && <Probes />}
                    <Status />
                    {controls.value === 'all' && catalogue && <Ball />}
                </>
            )}
        </div>
    );
}
