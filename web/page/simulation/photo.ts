// Photos: from the pixels of one to a painted picture (docs/scenes.md), with a preview of it on the way.
//
// Invariant: pixels come from the browser's own decoder and are only looked at; what is opened is a PNG
// made here, which every reader reads alike.
import { encode } from 'fast-png';

export interface Threshold {
    /** From which lightness on something is light, 0..1. */
    level: number;
    /** What is light becomes wall, instead of what is dark: a photo of chalk. */
    inverted: boolean;
}

/** Grey levels of the picture for one of the photo, about the threshold: an edge keeps its place. */
const contrast = 6;

/** Of red, green, blue and alpha: walls are white, and what is free is black, as the painter wants it. */
export function threshold(pixels: Uint8ClampedArray, { level, inverted }: Threshold) {
    const painted = new Uint8ClampedArray(pixels.length);
    const sign = inverted ? contrast : -contrast;
    for (let i = 0; i < pixels.length; i += 4) {
        const light = 0.299 * pixels[i] + 0.587 * pixels[i + 1] + 0.114 * pixels[i + 2];
        const grey = 127.5 + sign * (light - 255 * level);
        painted[i] = painted[i + 1] = painted[i + 2] = grey;
        painted[i + 3] = 255;
    }
    return painted;
}

/** As the bytes of a file, for openBytes. */
export function paintedPicture(pixels: Uint8ClampedArray, width: number, height: number): Uint8Array {
    return encode({ width, height, data: pixels, depth: 8, channels: 4 });
}
