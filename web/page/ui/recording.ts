// Recording: whether the picture is recorded, and since when. What does it is loaded when it is wanted.
import { signal } from '@preact/signals';
import { complain } from './model';
import { _ } from './words';

/** Whole seconds that were recorded so far; null: nothing is. */
export const recorded = signal<number | null>(null);
export const canRecord =
    'MediaRecorder' in window && 'captureStream' in HTMLCanvasElement.prototype;

export function toggleRecording(): void {
    import('./recorder').then(
        (module) => module.toggleRecording(recorded),
        () => complain(_('This could not be loaded: is there a network?')),
    );
}
