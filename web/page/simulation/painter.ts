// The painter: draws the worlds on the canvas, each into its own area. In node there is none.
//
// Invariant: the canvas gets another size in the moment in which it is drawn anew, and never shows
// nothing in between.

import { Canvas } from '../../src/canvas.js';
import type { Library } from '../../src/library.js';
import type { skv_frame, skv_render_style } from '../../src/interface.js';

import type { Trouble } from './protocol';
import type { World, Worlds } from './worlds';

/** The longer side of a saved picture, pixels: as the command line has it. */
const pictureSize = 1280;
/** The first time shaders are made; where a processor draws, once says enough, s. */
const measurements = 4, longest = 0.1;

export class Painter {
    #library;
    #surface;
    #canvas;
    #size = { width: 1, height: 1 };

    /** @param tell that the picture can't be drawn, or can be again: then it has to be */
    constructor(library: Library, surface: HTMLCanvasElement | OffscreenCanvas,
        tell: (trouble: Trouble) => void) {
        this.#library = library;
        this.#surface = surface;
        this.#canvas = new Canvas(library, surface, tell);
    }

    /** Leaves the canvas to another one. */
    destroy() {
        this.#canvas.destroy();
    }

    /** The canvas's size from the next picture on, in device pixels. */
    resize(width: number, height: number) {
        this.#size = { width, height };
    }

    /** False if it cannot, at present. Throws what the renderer refuses. */
    draw({ all, ratio }: Worlds, style: skv_render_style) {
        const { width, height } = this.#size;
        if (this.#surface.width !== width || this.#surface.height !== height) {
            Object.assign(this.#surface, { width, height });
        }
        return all.every(({ picture, camera, area }) => {
            const marks = { address: picture.marks[0].address, count: picture.mark_count };
            const corner = { x: Math.round(area.x * ratio), y: Math.round(area.y * ratio) };
            const place = all.length > 1 ? corner : undefined;
            return this.#canvas.draw(picture.frame, camera, style, marks, place);
        });
    }

    /** What it takes to draw a world as large as the canvas, s: the least of a few times; 0 if it cannot be drawn. */
    measure(frame: skv_frame, style: skv_render_style, clock: () => number) {
        const { width, height } = this.#size, begun = clock();
        let best = Infinity;
        for (let i = 0; i < measurements && clock() - begun < longest; i++) {
            const before = clock();
            if (!this.#canvas.picture(frame, style, width, height)) {
                return 0;
            }
            best = Math.min(best, clock() - before);
        }
        return best;
    }

    /** A world as a whole, as a PNG. */
    async png({ picture: { frame } }: World, style: skv_render_style) {
        const { c } = this.#library;
        const width = c.skv_terrain_width(frame.terrain), height = c.skv_terrain_height(frame.terrain);
        const scale = pictureSize / Math.max(width, height);
        const size = [width, height].map((length) => Math.max(Math.round(length * scale), 1));
        const data = this.#canvas.picture(frame, style, size[0], size[1]);
        if (!data) {
            throw new Error(`${this.#canvas.reason}: there is no picture to save`);
        }
        const { encode } = await import('fast-png');
        return encode({ width: size[0], height: size[1], data, depth: 8, channels: 4 });
    }
}
