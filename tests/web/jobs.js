// What reference.c, bits_hashes and `skvalp replay` do natively, over a library in WebAssembly: the jobs
// print the same lines. Invariant: nothing of node or of a browser is used.

/**
 * @param {import('../../web/src/library.js').Library} library
 * @param {number} count threads
 * @param {{ print: (line: string) => void, read: (path: string) => Uint8Array }} outside
 */
export function makeJobs(library, count, { print, read }) {
    const { c, instance } = library;
    const frame = Math.fround(1 / 60);
    const hex = (bits) => BigInt.asUintN(64, bits).toString(16).padStart(16, '0');

    function bitsOf(value) {
        const data = new DataView(new ArrayBuffer(8));
        data.setFloat64(0, value);
        return Number.isNaN(value) ? 'nan' : hex(data.getBigUint64(0));
    }

    /** As bits_hashes: the golden worlds after so many frames; `fast`: without the reference solver's. */
    function bits(frames, fast) {
        if (instance.text(instance.exports.bits_instruction_set()) !== 'wasm') {
            throw new Error('the module does not compute with SIMD');
        }
        const { bits_count, bits_name, bits_hash } = instance.exports;
        for (let i = 0; i < bits_count(); i++) {
            const name = instance.text(bits_name(i));
            if (!fast || !name.includes('reference')) {
                print(`${name} ${frames} ${hex(bits_hash(i, count, Number(frames)))}`);
            }
        }
    }

    /** As tests/bits/test_bits_scenes.sh: built-in scenes, whose names match, with both laws after a second. */
    function scenes(pattern) {
        const setting = library.make('skv_setting');
        const law = { calibrated: instance.allocateText('calibrated'), clavet: instance.allocateText('clavet') };
        setting.path = instance.allocateText('fluid.law');
        const options = c.skv_default_scene_options();
        options.particles = 700;
        options.settings = setting;
        options.setting_count = 1;
        const wanted = new RegExp(`^(${pattern})$`);
        for (const name of names(c.skv_builtin_scene, 'skv_scene_info').filter((name) => wanted.test(name))) {
            for (const which of ['calibrated', 'clavet']) {
                setting.value = law[which];
                const scene = library.create((out, error) => c.skv_scene_load(name, options, out, error));
                const world = library.create((out, error) => c.skv_scene_create_world(scene, count, out, error));
                for (let i = 0; i < 60; i++) {
                    library.check((error) => c.skv_world_step(world, frame, error));
                }
                print(`${name} ${which} ${hex(c.skv_world_hash(world))}`);
                c.skv_world_destroy(world);
                c.skv_scene_destroy(scene);
            }
        }
    }

    /** The names in a table of the library's. */
    function names(entry, record) {
        const all = [];
        for (let i = 0, pointer; (pointer = entry(i)) !== 0; i++) {
            all.push(library.view(record, pointer).name);
        }
        return all;
    }

    /** As `web_reference lab`, of the experiments whose names match. */
    function lab(particles, pattern = '.*') {
        const wanted = new RegExp(`^(${pattern})$`);
        const setting = library.make('skv_setting');
        setting.path = instance.allocateText('particles');
        setting.value = instance.allocateText(particles);
        const options = c.skv_default_lab_options();
        options.settings = setting;
        options.setting_count = 1;
        options.threads = count;
        for (const [i, name] of names(c.skv_experiment_info, 'skv_experiment').entries()) {
            if (!wanted.test(name)) {
                continue;
            }
            try {
                const report = library.create((out, error) => c.skv_experiment_run(i, options, out, error));
                for (let r = 0, pointer; (pointer = c.skv_report_row(report, r)) !== 0; r++) {
                    const row = library.view('skv_lab_row', pointer);
                    const numbers = [row.measured, row.theory, row.ratio].map(bitsOf).join(' ');
                    print(`${row.experiment}: ${row.quantity} [${row.unit}] ${numbers} ${row.pass ? 'pass' : 'fail'}`);
                }
                c.skv_report_destroy(report);
            } catch (error) {
                print(`${name}: ${error.message}`);
            }
        }
    }

    /** Plays a player to its end. */
    function play(player) {
        while (c.skv_player_frame(player) < c.skv_player_end(player)) {
            library.check((error) => c.skv_player_step(player, error));
        }
        library.check((error) => c.skv_player_seek(player, c.skv_player_end(player), error));
        while (c.skv_player_seeking(player)) {
            library.check((error) => c.skv_player_step(player, error));
        }
        const hash = hex(c.skv_world_hash(c.skv_player_world(player)));
        return `${c.skv_player_end(player)} ${hash} ${c.skv_player_mismatch(player) < 0n ? 'same' : 'another'}`;
    }

    function openReplay(bytes) {
        const data = instance.allocateBytes(bytes);
        const def = c.skv_default_player_def();
        def.threads = count;
        const player = library.create((out, error) => c.skv_player_load(data, bytes.length, def, out, error));
        instance.release(data);
        return player;
    }

    /** As `skvalp replay`, of files and links: frames, hash, and whether it went as it was recorded. */
    function replay(...sources) {
        for (const source of sources) {
            let bytes = source.includes('skvalp:') ? null : read(source);
            if (!bytes) {
                const keep = (piece) => {
                    bytes = piece;
                };
                instance.lend(keep, (user) =>
                    library.check((error) => c.skv_link_read(source, instance.exports.skv_wasm_write(), user, error)));
            }
            const player = openReplay(bytes);
            print(play(player));
            c.skv_player_destroy(player);
        }
    }

    /** Plays with a scene on a stage, as a face does, and saves that as a replay. */
    function game(name, path) {
        const def = c.skv_default_stage_def();
        def.threads = count;
        def.own_thread = false;
        def.clock = instance.exports.skv_wasm_clock();
        const stage = library.create((out, error) => c.skv_stage_create(def, out, error));
        const options = c.skv_default_scene_options();
        options.particles = 500;
        c.skv_stage_set_view(stage, 0, 640, 360);
        c.skv_stage_open(stage, name, options);
        const outcome = library.make('skv_outcome');
        const settle = () => {
            while (c.skv_stage_next_outcome(stage, outcome)) {
                if (outcome.error.code !== 0) {
                    throw new Error(outcome.error.text);
                }
            }
        };
        settle();
        const event = library.make('skv_pointer_event');
        const pointer = (phase, px, py, time) => {
            Object.assign(event, { phase, px, py, time, device: library.constants.SKV_DEVICE_FINGER });
            c.skv_stage_pointer(stage, 0, event);
        };
        const { SKV_PHASE_DOWN: down, SKV_PHASE_MOVE: move, SKV_PHASE_UP: up } = library.constants;
        pointer(down, 200, 300, 0);
        for (let i = 1; i <= 40; i++) {
            pointer(move, 200 + 4 * i, 300 - 3 * i, i / 60);
            c.skv_stage_step_once(stage);
        }
        pointer(up, 360, 180, 41 / 60);
        c.skv_stage_set_gravity(stage, 0, 0.5, -0.5);
        for (let i = 0; i < 20; i++) {
            c.skv_stage_step_once(stage);
        }
        c.skv_stage_save(stage, path);
        settle();
        c.skv_stage_destroy(stage);
    }

    /** As `web_reference files`. */
    function files(path) {
        const packed = read(path);
        const view = new DataView(packed.buffer, packed.byteOffset);
        const options = c.skv_default_scene_options();
        options.particles = 200;
        for (let at = 0; at < packed.length;) {
            const size = view.getUint32(at + 4, true);
            const bytes = packed.subarray(at + 8, at + 8 + size);
            const format = packed[at] === 'p'.charCodeAt(0) ? 'png' : 'json';
            const data = instance.allocateBytes(bytes);
            let scene = 0, world = 0;
            try {
                scene = library.create((out, error) =>
                    c.skv_scene_load_memory(data, size, format, 'file', options, out, error));
                world = library.create((out, error) => c.skv_scene_create_world(scene, count, out, error));
                print(`0 ${c.skv_world_particle_count(world)} ${hex(c.skv_world_hash(world))}`);
            } catch (error) {
                print(`${error.code} ${error.message}`);
            }
            c.skv_world_destroy(world);
            c.skv_scene_destroy(scene);
            instance.release(data);
            at += 8 + size;
        }
    }

    return { bits, scenes, lab, replay, game, files };
}
