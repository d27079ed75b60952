// A world on the screen: its session, the picture of it that shows, and the camera through which.
//
// Invariant: one picture is held, the newest that was looked at; what else is asked of the session
// (fingers, gravity, time) goes through whoever has both worlds.
import type { Library } from '../../src/library.js';
import type { Located, skv_camera, skv_picture } from '../../src/interface.js';
import { assign, using } from '../../src/memory.js';

/** For rewinding: half a minute of 8000 particles, and the memory of a phone holds two of it. */
const history = 32 << 20;

/** A part of the canvas, in CSS pixels. */
export interface Area {
    x: number;
    y: number;
    width: number;
    height: number;
}

export class World {
    readonly session: number;
    picture: skv_picture;
    /** In device pixels of its own area. */
    readonly camera: skv_camera;
    area: Area = { x: 0, y: 0, width: 640, height: 360 };
    ratio = 1;
    /** The picture that shows is another one than was drawn. */
    stale = true;
    #library;

    constructor(library: Library, threads: number) {
        const { c, instance } = library;
        this.#library = library;
        this.session = using(library, c.skv_default_stage_def(), (def) => {
            def.threads = threads;
            def.own_thread = false;
            def.history = history;
            def.clock = instance.exports.skv_wasm_clock();
            return library.create((out, error) => c.skv_session_create(def, out, error));
        });
        this.picture = this.#acquire();
        this.camera = library.make('skv_camera');
        this.setArea(this.area, 1);
    }

    destroy() {
        const { c } = this.#library;
        c.skv_session_release(this.session, this.picture);
        c.skv_session_destroy(this.session);
        this.#library.release(this.camera);
    }

    #acquire() {
        const { c } = this.#library;
        return this.#library.view('skv_picture', c.skv_session_acquire(this.session));
    }

    /** Takes the newest picture; whether it is another one. */
    look() {
        const before = this.picture, number = before.number;
        this.picture = this.#acquire();
        this.#library.c.skv_session_release(this.session, before);
        if (this.picture.number === number) {
            return false;
        }
        this.#keepCamera();
        this.stale = true;
        return true;
    }

    // ---- The camera ------------------------------------------------------------------------------

    setArea(area: Area, ratio: number) {
        const { c } = this.#library;
        this.area = area;
        this.ratio = ratio;
        this.stale = true;
        c.skv_session_set_view(this.session, ...this.pixels());
        this.#keepCamera();
    }

    /** The area's size in device pixels. */
    pixels(): [number, number] {
        const { width, height } = this.area;
        return [Math.max(Math.round(width * this.ratio), 1), Math.max(Math.round(height * this.ratio), 1)];
    }

    #setCamera(made: skv_camera) {
        using(this.#library, made, (camera) => assign(this.#library, 'skv_camera', this.camera, camera));
        this.stale = true;
    }

    /** It stays where it looks while the view or the world changes its size. */
    #keepCamera() {
        const { c } = this.#library, { camera } = this;
        const fit = c.skv_session_camera(this.session);
        const { world_width: width, world_height: height } = fit;
        const same = camera.world_width === width && camera.world_height === height;
        if (!same) {
            this.#setCamera(fit);
            return;
        }
        this.#library.release(fit);
        this.#setCamera(c.skv_camera_at(...this.pixels(), width, height,
            camera.centre_x, camera.centre_y, camera.zoom));
    }

    showAll() {
        this.#setCamera(this.#library.c.skv_session_camera(this.session));
    }

    /** Shows the same part of its world as another one. */
    showAs({ camera: other }: World) {
        const { camera } = this;
        this.#setCamera(this.#library.c.skv_camera_at(...this.pixels(), camera.world_width,
            camera.world_height, other.centre_x, other.centre_y, other.zoom));
    }

    zoom(factor: number, px: number, py: number) {
        this.#library.c.skv_camera_zoom(this.camera, factor, px, py);
        this.stale = true;
    }

    pan(dx: number, dy: number) {
        this.#library.c.skv_camera_pan(this.camera, dx, dy);
        this.stale = true;
    }

    // ---- Pointers --------------------------------------------------------------------------------

    /** An event whose place is in the pixels of a world's area: at the same place of this world. */
    send(event: Located, seenBy: World) {
        const library = this.#library, { c, instance } = library;
        const place = instance.allocate(16), sent = library.make('skv_pointer_event');
        try {
            assign(library, 'skv_pointer_event', sent, event);
            c.skv_camera_to_world(seenBy.camera, sent.px, sent.py, place, place + 8);
            const data = instance.data();
            const x = data.getFloat64(place, true), y = data.getFloat64(place + 8, true);
            // The session's camera shows the whole world; this one perhaps a part of it.
            using(library, c.skv_session_camera(this.session),
                (whole) => c.skv_camera_to_view(whole, x, y, place, place + 8));
            sent.px = instance.data().getFloat64(place, true);
            sent.py = instance.data().getFloat64(place + 8, true);
            c.skv_session_pointer(this.session, sent);
        } finally {
            library.release(sent);
            instance.release(place);
        }
    }
}
