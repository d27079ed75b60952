// Draws in a browser's worker, on a canvas that it was given: does what it is sent, one after the other,
// and sends back what came of it. The worlds are built-in scenes after a second.
import { load } from '../../../web/src/browser.js';
import { Canvas } from '../../../web/src/canvas.js';

/** @type {Awaited<ReturnType<typeof load>>} */
let library;
/** @type {Canvas} */
let canvas;
/** @type {OffscreenCanvas} */
let surface;
const worlds = new Map();
const troubles = [];

/** A frame of a scene's world. */
function frameOf(name, particles) {
    const { c } = library;
    if (!worlds.has(name)) {
        const options = c.skv_default_scene_options();
        options.particles = particles;
        const scene = library.create((out, error) => c.skv_scene_load(name, options, out, error));
        const world = library.create((out, error) => c.skv_scene_create_world(scene, 1, out, error));
        for (let i = 0; i < 60; i++) {
            library.check((error) => c.skv_world_step(world, Math.fround(1 / 60), error));
        }
        worlds.set(name, world);
    }
    return c.skv_world_frame(worlds.get(name));
}

function styleOf(choices) {
    const { c, constants } = library;
    const style = c.skv_default_render_style();
    const parts = { view: 'VIEW', overlay: 'OVERLAY', palette: 'PALETTE', detail: 'DETAIL' };
    for (const [name, value] of Object.entries(choices)) {
        const part = constants[`SKV_STYLE_${parts[name]}`];
        library.check((error) => c.skv_render_style_set(style, part, value, error));
    }
    return style;
}

function drawInto(view, { scene, particles, style }, place) {
    const { c } = library;
    const frame = frameOf(scene, particles);
    const camera = c.skv_camera_fit(view.width, view.height, c.skv_terrain_width(frame.terrain),
        c.skv_terrain_height(frame.terrain));
    return canvas.draw(frame, camera, styleOf(style), undefined, place);
}

/** Counts the calls of WebGL's functions, by name. */
function countCalls(work) {
    const { prototype } = WebGL2RenderingContext;
    const names = Object.getOwnPropertyNames(prototype).filter((name) =>
        typeof Object.getOwnPropertyDescriptor(prototype, name)?.value === 'function');
    const kept = new Map(names.map((name) => [name, prototype[name]]));
    const calls = {};
    kept.forEach((call, name) => {
        prototype[name] = function (...values) {
            calls[name] = (calls[name] ?? 0) + 1;
            return call.apply(this, values);
        };
    });
    try {
        work();
    } finally {
        kept.forEach((call, name) => {
            prototype[name] = call;
        });
    }
    return calls;
}

/** As a browser would whose WebGL takes no memory that is shared. */
function refuseShared() {
    const { prototype } = WebGL2RenderingContext;
    for (const name of ['bufferData', 'texImage2D', 'texSubImage2D', 'uniform3fv']) {
        const call = prototype[name];
        prototype[name] = function (...values) {
            if (values.some((value) => value?.buffer instanceof SharedArrayBuffer)) {
                throw new TypeError('a view of shared memory');
            }
            return call.apply(this, values);
        };
    }
}

const deeds = {
    async begin({ surface: given, threads, refusing }) {
        surface = given;
        if (refusing) {
            refuseShared();
        }
        library = await load('/', { workers: threads - 1 });
        canvas = new Canvas(library, surface, (trouble) => troubles.push(trouble));
        return { workers: library.workers, trouble: canvas.trouble, reason: canvas.reason };
    },

    picture({ scene, particles, style }) {
        return canvas.picture(frameOf(scene, particles), styleOf(style), surface.width, surface.height);
    },

    /** What is on the canvas after drawing, as the picture above; `place`: of a view in a larger canvas. */
    draw({ what, place }) {
        const { width, height } = surface;
        const view = place ?? { x: 0, y: 0, width, height };
        if (!drawInto(view, what, place)) {
            return null;
        }
        const gl = surface.getContext('webgl2');
        const rows = new Uint8Array(4 * view.width * view.height);
        const bottom = height - view.y - view.height;
        gl.readPixels(view.x, bottom, view.width, view.height, gl.RGBA, gl.UNSIGNED_BYTE, rows);
        const stride = 4 * view.width;
        const flipped = new Uint8Array(rows.length);
        for (let y = 0; y < view.height; y++) {
            flipped.set(rows.subarray(y * stride, (y + 1) * stride), (view.height - 1 - y) * stride);
        }
        return flipped;
    },

    resize({ width, height }) {
        Object.assign(surface, { width, height });
    },

    /** The calls of a context's first picture and of a later one, and the milliseconds of a later one. */
    count({ what, frames }) {
        frameOf(what.scene, what.particles);
        const draw = () => drawInto(surface, what);
        const first = countCalls(draw);
        const later = countCalls(draw);
        const begun = performance.now();
        for (let i = 0; i < frames; i++) {
            draw();
        }
        return { first, later, milliseconds: (performance.now() - begun) / frames };
    },

    /** Takes the context away, or gives it back; what was told of it. */
    async lose({ back }) {
        const extension = deeds.extension ??= surface.getContext('webgl2').getExtension('WEBGL_lose_context');
        troubles.length = 0;
        if (back) {
            extension.restoreContext();
        } else {
            extension.loseContext();
        }
        for (let turns = 0; turns < 1000 && troubles.length === 0; turns++) {
            await new Promise((resolve) => setTimeout(resolve, 5));
        }
        return troubles;
    },
};

onmessage = async ({ data }) => {
    try {
        postMessage({ result: await deeds[data.deed](data) });
    } catch (error) {
        postMessage({ error: String(error.stack ?? error) });
    }
};
