// A canvas on which the library draws worlds, by WebGL 2, in a worker or on the page.
//
// Invariant: there is a renderer while there is no trouble, and it belongs to the context as it is now:
// one that was lost takes its renderer along, and the next one gets another, which draws the same.
/** @import { Located, skv_frame, skv_camera, skv_render_style } from './interface.js' */
/** @import { Library } from './library.js' */

/**
 * Why nothing can be drawn: for the time being, or at all.
 * @typedef {'lost' | 'unsupported'} Trouble
 */
/**
 * What tools show, as an skv_picture has it: the address of the first mark.
 * @typedef {{ address: number, count: number }} Marks
 */

const attributes = { alpha: false, antialias: false, depth: false, stencil: false };
const noMarks = { address: 0, count: 0 };

export class Canvas {
    /** @type {Trouble | null} */
    trouble = null;
    /** One line about it. */
    reason = '';
    #library;
    #surface;
    #tell;
    /** @type {WebGL2RenderingContext | null} */
    #gl;
    #renderer = 0;
    /** What parts of the canvas, and pictures, are drawn into. */
    #room = { width: 0, height: 0, framebuffer: /** @type {WebGLFramebuffer | null} */ (null) };

    /**
     * A library draws on one canvas.
     * @param {Library} library
     * @param {HTMLCanvasElement | OffscreenCanvas} surface on which nobody else draws; its size is the
     *     caller's to set
     * @param {(trouble: Trouble | null) => void} [tell] called when that has changed
     */
    constructor(library, surface, tell = () => {}) {
        this.#library = library;
        this.#surface = surface;
        this.#tell = tell;
        this.#gl = /** @type {WebGL2RenderingContext | null} */ (surface.getContext('webgl2', attributes));
        surface.addEventListener('webglcontextlost', this.#lose);
        surface.addEventListener('webglcontextrestored', this.#begin);
        this.#begin();
    }

    /** Releases what it holds in the module and in the context. */
    destroy() {
        this.#surface.removeEventListener('webglcontextlost', this.#lose);
        this.#surface.removeEventListener('webglcontextrestored', this.#begin);
        this.#end();
    }

    /**
     * Draws a frame over the whole canvas, or into the camera's view at a place of it. All that shall be
     * seen has to be drawn anew for each picture. False while there is trouble.
     * @param {skv_frame} frame
     * @param {skv_camera} camera its pixels are the canvas'
     * @param {skv_render_style} style
     * @param {Marks} [marks]
     * @param {{ x: number, y: number }} [place] of the view's upper left corner
     */
    draw(frame, camera, style, marks = noMarks, place) {
        const gl = this.#usable();
        if (!gl) {
            return false;
        }
        if (!place) {
            return this.#render(gl, frame, camera, style, marks);
        }
        const { width, height } = camera;
        const framebuffer = this.#makeRoom(gl, width, height);
        const drawn = this.#library.instance.gl.into(framebuffer, () =>
            this.#render(gl, frame, camera, style, marks));
        const bottom = this.#surface.height - place.y - height;
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
        gl.blitFramebuffer(0, 0, width, height, place.x, bottom, place.x + width, bottom + height,
            gl.COLOR_BUFFER_BIT, gl.NEAREST);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
        return drawn;
    }

    /**
     * A picture of a whole frame as skv_offscreen_render makes it, of any size: RGBA, the top row first.
     * Null while there is trouble.
     * @param {skv_frame} frame
     * @param {skv_render_style} style
     * @param {number} width @param {number} height
     */
    picture(frame, style, width, height) {
        const gl = this.#usable();
        if (!gl) {
            return null;
        }
        const { c, constants, instance } = this.#library;
        const camera = c.skv_camera_fit(width, height, c.skv_terrain_width(frame.terrain),
            c.skv_terrain_height(frame.terrain));
        const detail = style.detail;
        style.detail = detail === constants.SKV_DETAIL_AUTO ? constants.SKV_DETAIL_FULL : detail;
        const rows = new Uint8Array(4 * width * height);
        try {
            const drawn = instance.gl.into(this.#makeRoom(gl, width, height), () => {
                const done = this.#render(gl, frame, camera, style, noMarks);
                gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rows);
                return done;
            });
            return drawn ? flip(rows, width, height) : null;
        } finally {
            style.detail = detail;
            this.#library.release(camera);
        }
    }

    #usable() {
        return this.trouble || this.#gl?.isContextLost() ? null : this.#gl;
    }

    /**
     * @param {WebGL2RenderingContext} gl
     * @param {skv_frame} frame @param {skv_camera} camera @param {skv_render_style} style
     * @param {Marks} marks
     */
    #render(gl, frame, camera, style, marks) {
        try {
            const { c } = this.#library;
            this.#library.check((error) => c.skv_renderer_draw(this.#renderer, frame, camera, style,
                marks.address, marks.count, error));
            return true;
        } catch (error) {
            // Whatever the renderer says of a context that has just gone.
            if (gl.isContextLost()) {
                return false;
            }
            throw error;
        }
    }

    /** @param {WebGL2RenderingContext} gl @param {number} width @param {number} height */
    #makeRoom(gl, width, height) {
        const room = this.#room;
        if (room.framebuffer && room.width === width && room.height === height) {
            return room.framebuffer;
        }
        gl.deleteFramebuffer(room.framebuffer);
        const framebuffer = gl.createFramebuffer();
        const color = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, color);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, width, height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, color);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.deleteRenderbuffer(color); // it lives as long as the framebuffer that it is attached to
        this.#room = { width, height, framebuffer };
        return framebuffer;
    }

    /** A context is there, for the first time or again. */
    #begin = () => {
        const library = this.#library;
        library.instance.gl.use(this.#gl);
        try {
            this.#renderer = library.create((out, error) => library.c.skv_renderer_create(out, error));
            this.#change(null, '');
        } catch (error) {
            this.#change('unsupported', this.#gl ? /** @type {Error} */ (error).message
                : 'this browser cannot draw: it has no WebGL 2, or it is switched off');
        }
    };

    /** @param {Event} event */
    #lose = (event) => {
        event.preventDefault(); // or it would not come back
        this.#end();
        this.#change('lost', 'the graphics device was lost');
    };

    #end() {
        this.#library.c.skv_renderer_destroy(this.#renderer);
        this.#renderer = 0;
        this.#gl?.deleteFramebuffer(this.#room.framebuffer);
        this.#room.framebuffer = null;
        this.#library.instance.gl.use(null);
    }

    /** @param {Trouble | null} trouble @param {string} reason */
    #change(trouble, reason) {
        const changed = trouble !== this.trouble;
        this.trouble = trouble;
        this.reason = reason;
        if (changed) {
            this.#tell(trouble);
        }
    }
}

/**
 * From the bottom row first to the top row first.
 * @param {Uint8Array} rows RGBA @param {number} width @param {number} height
 */
function flip(rows, width, height) {
    const stride = 4 * width;
    const flipped = new Uint8Array(rows.length);
    for (let y = 0; y < height; y++) {
        flipped.set(rows.subarray(y * stride, (y + 1) * stride), (height - 1 - y) * stride);
    }
    return flipped;
}
