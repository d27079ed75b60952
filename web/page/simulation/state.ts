// The state: what a picture says, as plain data.
import type { Library } from '../../src/library.js';
import type { Located, skv_picture, skv_probe, skv_render_style } from '../../src/interface.js';
import { using } from '../../src/memory.js';

import { parametersOf, texts } from './catalogue';
import type { Legend, Probe, WorldState } from './protocol';
import type { World, Worlds } from './worlds';

const textRoom = 160;

/** Reads pictures; remembers what stays the same from one to the next. */
export class Reader {
    #library;
    #paths: string[];
    /** By world: the definition as it was last read, and what it said. */
    #parameters = new WeakMap<World, { bytes: Uint8Array; values: Record<string, string> }>();
    #channels = new Map<number, { name: string; unit: string; theory: boolean }[]>();
    #room: number;
    #units = new Map<string, { unit: string; size: number; decimals: number }>();
    #si = false;

    constructor(library: Library) {
        this.#library = library;
        this.#paths = parametersOf(library).map(({ path }) => path);
        this.#room = library.instance.allocate(textRoom);
    }

    /** Readings in SI units, or in those that people know. */
    set si(si: boolean) {
        this.#si = si;
        this.#units.clear();
    }

    world(world: World, { ratio }: Worlds, style: skv_render_style): WorldState {
        const { c } = this.#library;
        const { picture, area, camera } = world;
        const { frame } = picture;
        const { terrain } = frame;
        return {
            name: picture.name,
            title: picture.title,
            description: picture.description,
            opened: picture.opened,
            notes: picture.scene ? texts((i) => c.skv_scene_notice(picture.scene, i)) : [],
            view: picture.view,
            overlays: picture.overlays,
            time: frame.time,
            particles: frame.particles.count,
            substeps: picture.substeps,
            width: terrain ? c.skv_terrain_width(terrain) : camera.world_width,
            height: terrain ? c.skv_terrain_height(terrain) : camera.world_height,
            spacing: frame.spacing,
            parameters: this.#readParameters(world),
            fluids: this.#readFluids(frame, style.palette),
            area: { ...area },
            camera: {
                scale: camera.scale / ratio,
                originX: area.x + camera.origin_x / ratio,
                originY: area.y + camera.origin_y / ratio,
                zoom: camera.zoom,
            },
            legend: terrain ? this.#readLegend(frame, style) : null,
            probes: picture.probes.slice(0, picture.probe_count).map((probe) => this.#readProbe(probe)),
            hands: picture.hand_count,
        };
    }

    #readParameters(world: World) {
        const { c, instance } = this.#library;
        const { address } = world.picture.parameters;
        const bytes = instance.copy(address, this.#library.size('skv_world_def'));
        const before = this.#parameters.get(world);
        if (before?.bytes.every((byte, i) => byte === bytes[i])) {
            return before.values;
        }
        const values: Record<string, string> = {};
        for (const path of this.#paths) {
            this.#library.check((error) => c.skv_world_def_get(address, path, this.#room, textRoom, error));
            values[path] = instance.text(this.#room);
        }
        this.#parameters.set(world, { bytes, values });
        return values;
    }

    /** The unit in which a quantity is shown, and how much of the SI unit it is. */
    #unit(si: string) {
        let unit = this.#units.get(si);
        if (!unit) {
            unit = using(this.#library, this.#library.c.skv_unit_of(si, !this.#si),
                ({ name, size, decimals }) => ({ unit: name, size, decimals }));
            this.#units.set(si, unit);
        }
        return unit;
    }

    #readLegend(frame: skv_picture['frame'], style: Located): Legend | null {
        return using(this.#library, this.#library.c.skv_render_legend(frame, style), (legend) => {
            if (!legend.shown) {
                return null;
            }
            const colors = legend.colors.map((rgb) => `rgb(${rgb.join(' ')})`);
            const { label, low, high, step } = legend;
            return { label, ...this.#unit(legend.unit), low, high, step, colors };
        });
    }

    #readFluids(frame: skv_picture['frame'], palette: number) {
        const library = this.#library, size = library.size('skv_liquid');
        return Array.from({ length: frame.fluid_count }, (_, i) => ({
            name: library.view('skv_liquid', frame.fluids + i * size).name,
            color: `#${library.c.skv_render_fluid_color(frame, palette, i).toString(16).padStart(6, '0')}`,
        }));
    }

    #channelsOf(kind: number) {
        const { c } = this.#library;
        let channels = this.#channels.get(kind);
        if (!channels) {
            channels = [];
            for (let i = 0, address; (address = c.skv_instrument_channel(kind, i)) !== 0; i++) {
                const { name, unit, theory } = this.#library.view('skv_channel', address);
                channels.push({ name, unit, theory });
            }
            this.#channels.set(kind, channels);
        }
        return channels;
    }

    #readProbe(probe: skv_probe): Probe {
        const { instance } = this.#library;
        const { id, def, lack, samples, value } = probe;
        const channels = this.#channelsOf(def.kind)
            .map(({ name, unit, theory }, i) => ({ name, value: value[i], lack: Number.isNaN(value[i]) ? lack : '', ...this.#unit(unit), theory }));
        const copy = (address: number) => new Float64Array(instance.copy(address, 8 * samples).buffer);
        return {
            id,
            kind: def.kind,
            x0: def.x0,
            y0: def.y0,
            x1: def.x1,
            y1: def.y1,
            channels,
            times: samples > 0 ? copy(probe.times) : null,
            values: samples > 0 ? probe.history.slice(0, channels.length).map(copy) : null,
        };
    }
}
