// The catalogue: all that there is to choose from, out of the library's own tables.
//
// Invariant: nothing is named here that the library names; a new row of a table is a new entry.
import type { Library } from '../../src/library.js';
import type { skv_field } from '../../src/interface.js';
import { plain, table, using } from '../../src/memory.js';

import { amountsOf } from './amount';
import type { Catalogue, Field, Named } from './protocol';

function typeOf(library: Library, type: number): Field['type'] {
    switch (type) {
        case library.constants.SKV_FIELD_NUMBER: return 'number';
        case library.constants.SKV_FIELD_INTEGER: return 'integer';
        case library.constants.SKV_FIELD_TEXT: return 'text';
        case library.constants.SKV_FIELD_CHOICE: return 'choice';
        default: return 'boolean';
    }
}

/** As people write it: "m/s²". */
export function unitOf(library: Library, si: string): string {
    return using(library, library.c.skv_unit_of(si, false), ({ name }) => name);
}

function fieldOf(library: Library, field: skv_field): Field {
    const type = typeOf(library, field.type);
    const { path, minimum, maximum, help } = field;
    const unit = unitOf(library, field.unit);
    const choices = type === 'choice' ? field.choices.split('|') : [];
    return { path, type, unit, minimum, maximum, choices, default: field.default_text, help };
}

function choicesOf(library: Library, part: number): Named[] {
    return table(library, 'skv_style_choice', (i) => library.c.skv_style_choice_at(part, i))
        .map(({ name, label, help }) => ({ name, title: label, help }));
}

export function texts<T>(entry: (i: number) => T | null): T[] {
    const all: T[] = [];
    for (let i = 0, text; (text = entry(i)) !== null; i++) {
        all.push(text);
    }
    return all;
}

/** What can be changed while a world runs. */
export function parametersOf(library: Library): Field[] {
    return table(library, 'skv_field', library.c.skv_world_field)
        .filter(({ path }) => library.c.skv_world_can_change(path))
        .map((field) => fieldOf(library, field));
}

export function makeCatalogue(library: Library): Catalogue {
    const { c, constants } = library;
    const fields = (entry: (i: number) => number) =>
        table(library, 'skv_field', entry).map((field) => fieldOf(library, field));
    return {
        version: c.skv_version()!,
        scenes: table(library, 'skv_scene_info', c.skv_builtin_scene).map(plain),
        tools: table(library, 'skv_tool', c.skv_tool_info)
            .map((tool) => ({ ...plain(tool), key: String.fromCharCode(tool.key) })),
        views: choicesOf(library, constants.SKV_STYLE_VIEW),
        overlays: choicesOf(library, constants.SKV_STYLE_OVERLAY),
        palettes: choicesOf(library, constants.SKV_STYLE_PALETTE),
        details: choicesOf(library, constants.SKV_STYLE_DETAIL),
        dyes: texts(c.skv_dye_name),
        numerals: table(library, 'skv_numerals', c.skv_numerals_at).map(plain),
        instruments: texts(c.skv_instrument_kind_name),
        gauges: table(library, 'skv_gauge', c.skv_gauge_at).map(plain),
        choices: table(library, 'skv_choice', c.skv_choice_at).map(plain),
        speeds: table(library, 'skv_named_number', c.skv_speed_at).map(plain),
        planets: table(library, 'skv_named_number', c.skv_planet_at).map(plain),
        keys: table(library, 'skv_key', c.skv_key_at).map(plain),
        refusals: texts(c.skv_refusal_words),
        amounts: amountsOf(library),
        limits: plain(library.view('skv_limits', c.skv_control_limits())),
        parameters: parametersOf(library),
        sceneFields: fields(c.skv_scene_field),
        experimentFields: fields(c.skv_lab_parameter),
        experiments: table(library, 'skv_experiment', c.skv_experiment_info).map(plain),
    };
}
