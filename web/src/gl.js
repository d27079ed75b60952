// OpenGL ES 3.0, as far as src/render uses it, over a WebGL 2 context: what the module imports from "gl".
//
// Invariant: a number that the module holds stands for the same object until it is deleted; 0 stands for
// none, and of framebuffers for the canvas.
/** @import { Instance } from './instance.js' */

/** What is taken as it comes. */
const same = [
    'activeTexture', 'blendEquation', 'blendFunc', 'checkFramebufferStatus', 'clear', 'clearColor',
    'colorMask', 'disable', 'drawArrays', 'drawArraysInstanced', 'enable', 'enableVertexAttribArray',
    'pixelStorei', 'texParameteri', 'vertexAttribDivisor', 'vertexAttribPointer', 'viewport',
];
/** What is made and deleted several at a time. */
const kinds = ['Buffer', 'Framebuffer', 'Texture', 'VertexArray'];
/** Each of them makes half-float textures something to draw into, once it is asked for. */
const floatBuffers = ['EXT_color_buffer_half_float', 'EXT_color_buffer_float'];
/** Of OpenGL's numbers those that WebGL has no names for. */
const MAJOR_VERSION = 0x821b, MINOR_VERSION = 0x821c, NUM_EXTENSIONS = 0x821d;

/** @typedef {Record<string, (...values: any[]) => any>} Imports */

export class Gl {
    #instance;
    /** @type {WebGL2RenderingContext | null} */
    #context = null;
    /** @type {string[]} */
    #extensions = [];
    #takesShared = true;
    /** @type {Map<number, any>} objects by number, of all kinds */
    #objects = new Map();
    #lastObject = 0;
    /** @type {Map<number, Map<string, number>>} the uniforms of programs */
    #uniforms = new Map();
    #framebuffer = 0;
    /** @type {Map<string, number>} texts that the module was given, which stay in its memory */
    #texts = new Map();

    /** @param {Instance} instance */
    constructor(instance) {
        this.#instance = instance;
    }

    /**
     * The context to draw by, or null; no renderer may be left of another one.
     * @param {WebGL2RenderingContext | null} context
     */
    use(context) {
        this.#context = context;
        this.#framebuffer = 0;
        this.#extensions = context ? floatBuffers.filter((name) => context.getExtension(name)) : [];
        this.#takesShared = !context || this.#canTakeShared(context);
    }

    /**
     * Without a context glGetString tells the module that there is none, so that it makes no renderer,
     * which alone would call the rest.
     * @returns {Imports}
     */
    imports() {
        const context = () => {
            if (!this.#context) {
                throw new Error('nothing can be drawn without a canvas that has WebGL 2');
            }
            return this.#context;
        };
        return { ...this.#makeSame(context), ...this.#makeQueries(context), ...this.#makeObjects(context),
            ...this.#makePrograms(context), ...this.#makeData(context) };
    }

    /**
     * Draws into a framebuffer of the host's instead of the canvas.
     * @template Result
     * @param {WebGLFramebuffer} framebuffer
     * @param {() => Result} draw
     */
    into(framebuffer, draw) {
        const gl = /** @type {WebGL2RenderingContext} */ (this.#context);
        this.#framebuffer = this.#add(framebuffer);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        try {
            return draw();
        } finally {
            this.#take(this.#framebuffer);
            this.#framebuffer = 0;
            gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        }
    }

    // ---- What lies in the module's memory -------------------------------------------------------

    /** Browsers may refuse views of memory that is shared. @param {WebGL2RenderingContext} context */
    #canTakeShared(context) {
        const buffer = context.createBuffer();
        context.bindBuffer(context.ARRAY_BUFFER, buffer);
        try {
            context.bufferData(context.ARRAY_BUFFER, this.#instance.bytes(0, 4), context.STREAM_DRAW);
            return true;
        } catch {
            return false;
        } finally {
            context.deleteBuffer(buffer);
        }
    }

    /** @template {Uint8Array | Float32Array} View @param {View} view @returns {View} */
    #lend(view) {
        return this.#takesShared ? view : /** @type {View} */ (view.slice());
    }

    /** @param {number} pointer @param {number} count */
    #floats(pointer, count) {
        return new Float32Array(this.#instance.memory.buffer, pointer, count);
    }

    /** @param {number} pointer @param {number} count */
    #numbers(pointer, count) {
        return new Uint32Array(this.#instance.memory.buffer, pointer, count);
    }

    /** @param {number} pointer of a short name in ASCII */
    #name(pointer) {
        const bytes = new Uint8Array(this.#instance.memory.buffer);
        let name = '';
        for (let at = pointer; bytes[at] !== 0; at++) {
            name += String.fromCharCode(bytes[at]);
        }
        return name;
    }

    /** @param {string} text */
    #hold(text) {
        const held = this.#texts.get(text) ?? this.#instance.allocateText(text);
        this.#texts.set(text, held);
        return held;
    }

    // ---- Objects --------------------------------------------------------------------------------

    /** @param {any} object */
    #add(object) {
        this.#objects.set(++this.#lastObject, object);
        return this.#lastObject;
    }

    /** @param {number} number */
    #take(number) {
        const object = this.#objects.get(number) ?? null;
        this.#objects.delete(number);
        return object;
    }

    /** @param {number} number @returns {any} */
    #get(number) {
        return this.#objects.get(number) ?? null;
    }

    // ---- The functions, by what they are about --------------------------------------------------

    /** @param {() => any} context @returns {Imports} */
    #makeSame(context) {
        return Object.fromEntries(same.map((name) => [`gl${name[0].toUpperCase()}${name.slice(1)}`,
            (a, b, c, d, e, f) => context()[name](a, b, c, d, e, f)]));
    }

    /** @param {() => WebGL2RenderingContext} context @returns {Imports} */
    #makeQueries(context) {
        const integer = (/** @type {number} */ what) =>
            what === MAJOR_VERSION ? 3
                : what === MINOR_VERSION ? 0
                    : what === NUM_EXTENSIONS ? this.#extensions.length
                        : what === context().FRAMEBUFFER_BINDING ? this.#framebuffer
                            : context().getParameter(what);
        const string = (/** @type {WebGL2RenderingContext} */ gl, /** @type {number} */ what) => {
            if (what === gl.VERSION) {
                return `OpenGL ES 3.0 (${gl.getParameter(what)})`;
            }
            const info = what === gl.RENDERER && gl.getExtension('WEBGL_debug_renderer_info');
            return String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : what));
        };
        return {
            glGetIntegerv: (what, to) => this.#instance.data().setInt32(to, integer(what), true),
            glGetString: (what) => (this.#context ? this.#hold(string(this.#context, what)) : 0),
            glGetStringi: (_, i) => this.#hold(`GL_${this.#extensions[i]}`),
        };
    }

    /** @param {() => any} context @returns {Imports} */
    #makeObjects(context) {
        /** @type {Imports} */
        const all = {};
        for (const kind of kinds) {
            all[`glGen${kind}s`] = (count, to) =>
                this.#numbers(to, count).forEach((_, i, numbers) => {
                    numbers[i] = this.#add(context()[`create${kind}`]());
                });
            all[`glDelete${kind}s`] = (count, from) =>
                this.#numbers(from, count).forEach((number) => {
                    context()[`delete${kind}`](this.#take(number));
                });
        }
        return {
            ...all,
            glBindBuffer: (target, buffer) => context().bindBuffer(target, this.#get(buffer)),
            glBindTexture: (target, texture) => context().bindTexture(target, this.#get(texture)),
            glBindVertexArray: (array) => context().bindVertexArray(this.#get(array)),
            glBindFramebuffer: (target, framebuffer) => {
                this.#framebuffer = framebuffer;
                context().bindFramebuffer(target, this.#get(framebuffer));
            },
            glFramebufferTexture2D: (target, attachment, kind, texture, level) =>
                context().framebufferTexture2D(target, attachment, kind, this.#get(texture), level),
        };
    }

    /** @param {() => WebGL2RenderingContext} context @returns {Imports} */
    #makePrograms(context) {
        const get = (/** @type {number} */ number) => this.#get(number);
        /** @param {string | null} log @param {number} room @param {number} to */
        const write = (log, room, to) => this.#instance.write(log ?? 'the context was lost', to, room);
        const tell = (/** @type {number} */ to, /** @type {any} */ value) =>
            this.#instance.data().setInt32(to, Number(value), true);
        const set = (/** @type {number} */ location, /** @type {(at: any) => void} */ use) =>
            location >= 0 && use(get(location));
        return {
            glCreateShader: (stage) => this.#add(context().createShader(stage)),
            glDeleteShader: (shader) => context().deleteShader(this.#take(shader)),
            glShaderSource: (shader, count, parts) => {
                const texts = Array.from(this.#numbers(parts, count), (part) => this.#instance.text(part));
                context().shaderSource(get(shader), texts.join(''));
            },
            glCompileShader: (shader) => context().compileShader(get(shader)),
            glGetShaderiv: (shader, what, to) => tell(to, context().getShaderParameter(get(shader), what)),
            glGetShaderInfoLog: (shader, room, _, to) =>
                write(context().getShaderInfoLog(get(shader)), room, to),
            glCreateProgram: () => this.#add(context().createProgram()),
            glDeleteProgram: (program) => {
                this.#uniforms.get(program)?.forEach((location) => this.#take(location));
                this.#uniforms.delete(program);
                context().deleteProgram(this.#take(program));
            },
            glAttachShader: (program, shader) => context().attachShader(get(program), get(shader)),
            glLinkProgram: (program) => context().linkProgram(get(program)),
            glGetProgramiv: (program, what, to) =>
                tell(to, context().getProgramParameter(get(program), what)),
            glGetProgramInfoLog: (program, room, _, to) =>
                write(context().getProgramInfoLog(get(program)), room, to),
            glUseProgram: (program) => context().useProgram(get(program)),
            glGetUniformLocation: (program, name) => this.#locate(context(), program, this.#name(name)),
            glUniform1f: (location, x) => set(location, (at) => context().uniform1f(at, x)),
            glUniform1i: (location, x) => set(location, (at) => context().uniform1i(at, x)),
            glUniform2f: (location, x, y) => set(location, (at) => context().uniform2f(at, x, y)),
            glUniform3f: (location, x, y, z) => set(location, (at) => context().uniform3f(at, x, y, z)),
            glUniform4f: (location, x, y, z, w) => set(location, (at) => context().uniform4f(at, x, y, z, w)),
            glUniform3fv: (location, count, values) =>
                set(location, (at) => context().uniform3fv(at, this.#lend(this.#floats(values, 3 * count)))),
        };
    }

    /**
     * Asking the browser takes long.
     * @param {WebGL2RenderingContext} gl @param {number} program @param {string} name
     */
    #locate(gl, program, name) {
        const known = this.#uniforms.get(program) ?? new Map();
        this.#uniforms.set(program, known);
        let location = known.get(name);
        if (location === undefined) {
            const found = gl.getUniformLocation(this.#get(program), name);
            location = found ? this.#add(found) : -1;
            known.set(name, location);
        }
        return location;
    }

    /** @param {() => WebGL2RenderingContext} context @returns {Imports} */
    #makeData(context) {
        /**
         * The values of a picture: all that is uploaded is floats or bytes, in rows without gaps.
         * @param {number} texels @param {number} format @param {number} type @param {number} from
         * @returns {any}
         */
        const pixels = (texels, format, type, from) => {
            if (!from) {
                return null;
            }
            const gl = context();
            const count = texels * (format === gl.RED ? 1 : format === gl.RGB ? 3 : 4);
            const floats = type === gl.FLOAT;
            return this.#lend(floats ? this.#floats(from, count) : this.#instance.bytes(from, count));
        };
        return {
            glBufferData: (target, size, from, usage) =>
                context().bufferData(target, this.#lend(this.#instance.bytes(from, size)), usage),
            glDrawBuffers: (count, buffers) => context().drawBuffers([...this.#numbers(buffers, count)]),
            glTexImage2D: (target, level, inside, width, height, border, format, type, from) =>
                context().texImage2D(target, level, inside, width, height, border, format, type,
                    pixels(width * height, format, type, from)),
            glTexSubImage2D: (target, level, x, y, width, height, format, type, from) =>
                context().texSubImage2D(target, level, x, y, width, height, format, type,
                    pixels(width * height, format, type, from)),
        };
    }
}
