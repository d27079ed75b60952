// Recorder: the picture as it moves, as a video that the browser makes.
import { signal } from '@preact/signals';
import { download, fileName } from './files';
import { complain, toast } from './model';
import { _ } from './words';

export const recording = signal(false);
export const canRecord =
    'MediaRecorder' in window && 'captureStream' in HTMLCanvasElement.prototype;

/** The browser's choice comes last. */
const types = ['video/mp4;codecs=avc1', 'video/webm;codecs=vp9', 'video/webm'];
let recorder: MediaRecorder | null = null;

function begin(canvas: HTMLCanvasElement): void {
    const type = types.find((known) => MediaRecorder.isTypeSupported(known));
    const parts: Blob[] = [];
    const stream = canvas.captureStream(30);
    recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 8e6 });
    recorder.ondataavailable = (event) => parts.push(event.data);
    recorder.onstop = () => {
        stream.getTracks().forEach((track) => track.stop());
        const made = recorder?.mimeType || 'video/webm';
        recording.value = false;
        recorder = null;
        download(new Blob(parts), made, fileName(made.includes('mp4') ? 'mp4' : 'webm'));
        toast(_('The video was saved'));
    };
    recorder.start(1000);
    recording.value = true;
}

export function toggleRecording(): void {
    try {
        if (recorder)
            recorder.stop();
        else
            begin(document.querySelector<HTMLCanvasElement>('canvas.canvas')!);
    } catch {
        recording.value = false;
        recorder = null;
        complain(_('This browser cannot record the picture.'));
    }
}
