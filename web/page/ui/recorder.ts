// Recorder: the picture as it moves, as a video that the browser makes.
//
// Invariant: what is recorded has one size from the first frame to the last, whatever becomes of the picture
// meanwhile; encoders that are told of another size in between leave files that nobody decodes.
import type { Signal } from '@preact/signals';
import { download, fileName } from './files';
import { complain, simulation, state, toast } from './model';
import { _ } from './words';

/** The browser's choice comes last. */
const types = ['video/mp4;codecs=avc1', 'video/webm;codecs=vp9', 'video/webm'];
/** Pictures a second; pixels of the longer side; bits a second. */
const RATE = 30, LONGEST = 1920, BITS = 8e6;
let recorder: MediaRecorder | null = null;

/** A surface as the picture's place has it, which may have grown just now: encoders want even sizes. */
function surfaceLike({ clientWidth, clientHeight }: HTMLCanvasElement): HTMLCanvasElement {
    const ratio = state.value?.ratio ?? 1;
    const [width, height] = [clientWidth * ratio, clientHeight * ratio];
    const scale = Math.min(1, LONGEST / Math.max(width, height));
    const even = (length: number) => Math.max(2, 2 * Math.round((length * scale) / 2));
    return Object.assign(document.createElement('canvas'), { width: even(width), height: even(height) });
}

/** All of the picture, as large as it fits, in the middle. */
function copy(from: HTMLCanvasElement, to: CanvasRenderingContext2D): void {
    const { width, height } = to.canvas;
    const scale = Math.min(width / from.width, height / from.height);
    const [wide, high] = [from.width * scale, from.height * scale];
    to.fillStyle = getComputedStyle(document.body).backgroundColor;
    to.fillRect(0, 0, width, height);
    to.drawImage(from, (width - wide) / 2, (height - high) / 2, wide, high);
}

/**
 * Calls back in the next frame, after the picture was drawn in it: where no worker draws, a picture that was not
 * drawn in the same frame is empty.
 */
function afterPicture(call: (now: number) => void): number {
    simulation.setStyle({}); // nothing else, but it is drawn
    return requestAnimationFrame(call);
}

async function begin(picture: HTMLCanvasElement, recorded: Signal<number | null>): Promise<void> {
    await new Promise(afterPicture);
    const surface = surfaceLike(picture).getContext('2d', { alpha: false })!;
    copy(picture, surface);
    const stream = surface.canvas.captureStream(RATE);
    const type = types.find((known) => MediaRecorder.isTypeSupported(known));
    const making = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BITS });
    const parts: Blob[] = [];
    const begun = performance.now();
    let asked = 0, last = -Infinity;
    function follow(now: number): void {
        asked = afterPicture(follow);
        if (now - last < 900 / RATE)
            return; // a display may be a little faster than twice the rate
        last = now;
        copy(picture, surface);
        recorded.value = Math.floor((now - begun) / 1000);
    }
    const end = () => {
        cancelAnimationFrame(asked);
        stream.getTracks().forEach((track) => track.stop());
        recorded.value = null;
        recorder = null;
    };
    making.ondataavailable = (event) => parts.push(event.data);
    making.onerror = () => complain(_('This browser cannot record the picture.'));
    making.onstop = () => {
        const made = making.mimeType || 'video/webm';
        end();
        if (!parts.some((part) => part.size > 0)) {
            complain(_('This browser cannot record the picture.'));
            return;
        }
        download(new Blob(parts), made, fileName(made.includes('mp4') ? 'mp4' : 'webm'));
        toast(_('The video was saved'));
    };
    making.start(1000);
    recorder = making;
    recorded.value = 0;
    asked = afterPicture(follow);
}

/** @param recorded is told how many seconds there are, null: nothing is recorded */
export async function toggleRecording(recorded: Signal<number | null>): Promise<void> {
    try {
        if (recorder)
            recorder.stop();
        else
            await begin(document.querySelector<HTMLCanvasElement>('canvas.canvas')!, recorded);
    } catch {
        recorded.value = null;
        recorder = null;
        complain(_('This browser cannot record the picture.'));
    }
}
