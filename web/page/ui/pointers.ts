// Pointers: fingers, pens and the mouse on the picture become the simulation's pointers. Invariant:
// every pointer that went down goes up or leaves; what they mean is decided by the simulation.
import type { PointerMessage, Side, State } from '../simulation/protocol';
import { framed, simulation, state } from './model';

const MIDDLE = 1;
const SECONDARY = 2;
const ERASER_BUTTON = 32; // of PointerEvent.buttons

function deviceOf(event: PointerEvent): PointerMessage['device'] {
    if (event.pointerType === 'touch')
        return 'finger';
    if (event.pointerType === 'pen')
        return event.buttons & ERASER_BUTTON || event.button === 5 ? 'eraser' : 'pen';
    return 'mouse';
}

/** Which of two worlds a place on the canvas is of. */
export function sideAt(now: State | null, x: number, y: number): Side {
    const area = now?.worlds[1]?.area;
    const inside =
        area && x >= area.x && y >= area.y && x < area.x + area.width && y < area.y + area.height;
    return inside ? 1 : 0;
}

/** Takes what happens to the element; what it returns ends that. */
export function attachPointers(element: HTMLElement): () => void {
    const ending = new AbortController();
    /** What each pointer that is down began with. */
    const down = new Map<number, { device: PointerMessage['device']; secondary: boolean; side: Side }>();
    let panning: { id: number; x: number; y: number; side: Side } | null = null;

    function placeOf(event: MouseEvent): { x: number; y: number } {
        const box = element.getBoundingClientRect();
        return { x: event.clientX - box.left, y: event.clientY - box.top };
    }

    function send(event: PointerEvent, phase: PointerMessage['phase']): void {
        const place = placeOf(event);
        const begun = down.get(event.pointerId);
        simulation.pointer({
            phase,
            ...place,
            device: begun?.device ?? deviceOf(event),
            pointer: event.pointerId,
            time: event.timeStamp / 1000,
            pressure: event.pressure,
            secondary: begun?.secondary ?? false,
            straight: event.shiftKey,
            side: begun?.side ?? sideAt(state.value, place.x, place.y),
        });
    }

    function onDown(event: PointerEvent): void {
        const place = placeOf(event);
        const side = sideAt(state.value, place.x, place.y);
        element.setPointerCapture(event.pointerId);
        if (event.pointerType === 'mouse' && event.button === MIDDLE) {
            panning = { id: event.pointerId, ...place, side };
            event.preventDefault(); // no scrolling by the middle button
            return;
        }
        const secondary = event.pointerType === 'mouse' && event.button === SECONDARY;
        down.set(event.pointerId, { device: deviceOf(event), secondary, side });
        send(event, 'down');
    }

    function onMove(event: PointerEvent): void {
        if (panning?.id === event.pointerId) {
            const place = placeOf(event);
            simulation.pan(place.x - panning.x, place.y - panning.y, panning.side);
            panning = { ...panning, ...place };
            return;
        }
        const samples = event.getCoalescedEvents?.() ?? [];
        for (const sample of samples.length ? samples : [event])
            send(sample, 'move');
    }

    function onUp(event: PointerEvent): void {
        if (panning?.id === event.pointerId)
            panning = null;
        if (!down.has(event.pointerId))
            return;
        send(event, 'up');
        down.delete(event.pointerId);
    }

    function onCancel(event: PointerEvent): void {
        panning = panning?.id === event.pointerId ? null : panning;
        if (down.has(event.pointerId) || event.type === 'pointerleave')
            send(event, 'leave');
        down.delete(event.pointerId);
    }

    /**
     * The wheel zooms, with Shift it sets the brush; a touch pad's pinch comes with Ctrl, in small steps. In a frame
     * the wheel alone is the page's around it.
     */
    function onWheel(event: WheelEvent): void {
        if (framed && !event.ctrlKey && !event.shiftKey && !document.fullscreenElement)
            return;
        event.preventDefault();
        const delta = event.deltaY || event.deltaX; // Shift turns the wheel sideways
        const notches = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? delta / 100 : delta / 3;
        const factor = 1.15 ** -(event.ctrlKey ? 6 * notches : notches);
        const { x, y } = placeOf(event);
        if (event.shiftKey)
            simulation.scaleBrush(factor);
        else
            simulation.zoom(factor, x, y, sideAt(state.value, x, y));
    }

    /** What the browser takes from us: everything is let go. */
    function onLost(): void {
        down.clear();
        panning = null;
        simulation.cancelPointers();
    }

    const { signal } = ending;
    element.addEventListener('pointerdown', onDown, { signal });
    element.addEventListener('pointermove', onMove, { signal });
    element.addEventListener('pointerup', onUp, { signal });
    element.addEventListener('pointercancel', onCancel, { signal });
    element.addEventListener('pointerleave', onCancel, { signal });
    element.addEventListener('wheel', onWheel, { signal, passive: false });
    element.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    // WebKit selects what lies around that which is dragged, also the ball, and takes a later drag for the selection's.
    element.parentElement!.addEventListener('selectstart', (event) => event.preventDefault(), { signal });
    window.addEventListener('blur', onLost, { signal });
    return () => ending.abort();
}
