// Photograph: a photo of any size becomes pixels that the painter of scenes can take, with water in them.
// Invariant: what the preview shows is what is opened.
import { threshold } from '../simulation/photo';

/** Pixels on the longer side: as fine as walls need. */
const LONGER = 320;

/** The photo, made smaller. */
export async function readPhoto(file: Blob): Promise<ImageData> {
    const bitmap = await createImageBitmap(file);
    const factor = Math.min(1, LONGER / Math.max(bitmap.width, bitmap.height));
    const canvas = document.createElement('canvas');
    canvas.width = Math.max(16, Math.round(bitmap.width * factor));
    canvas.height = Math.max(16, Math.round(bitmap.height * factor));
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    context.fillStyle = 'white'; // what is transparent is paper
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
    bitmap.close();
    return context.getImageData(0, 0, canvas.width, canvas.height);
}

/** How many pixels have each lightness. */
function histogramOf(pixels: Uint8ClampedArray): Float64Array {
    const counts = new Float64Array(256);
    for (let i = 0; i < pixels.length; i += 4)
        counts[Math.round(0.299 * pixels[i] + 0.587 * pixels[i + 1] + 0.114 * pixels[i + 2])]++;
    return counts;
}

/** The lightness, 0..1, that parts dark from light best: Otsu's, the largest variance between both. */
export function bestLevel(pixels: Uint8ClampedArray): number {
    const counts = histogramOf(pixels);
    const all = pixels.length / 4;
    const sum = counts.reduce((total, count, value) => total + count * value, 0);
    let below = 0;
    let sumBelow = 0;
    let best = 128;
    let most = -1;
    for (let value = 0; value < 255; value++) {
        below += counts[value];
        sumBelow += value * counts[value];
        const above = all - below;
        if (below === 0 || above === 0)
            continue;
        const spread = below * above * (sumBelow / below - (sum - sumBelow) / above) ** 2;
        if (spread > most) {
            most = spread;
            best = value + 0.5;
        }
    }
    return best / 255;
}

export interface Taking {
    level: number;
    inverted: boolean;
    /** The share of the height, from below, where water is between the walls. */
    water: number;
}

/** The scene's picture (docs/scenes.md). */
export function paint(photo: ImageData, { level, inverted, water }: Taking): ImageData {
    const pixels = threshold(photo.data, { level, inverted });
    const surface = Math.round(photo.height * (1 - water));
    for (let i = 4 * surface * photo.width; i < pixels.length; i += 4)
        pixels[i + 2] = 255; // walls are white already; pale blue between places them more finely
    return new ImageData(pixels, photo.width, photo.height);
}
