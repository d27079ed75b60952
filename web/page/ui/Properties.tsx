// Properties: rows made from the registry. Invariants: a row shows what the state has, whoever changed it
// or went back in time; no parameter is named here, but for the quick choices of planets.
import { effect, signal } from '@preact/signals';
import type { Side } from '../simulation/protocol';
import { Anew } from './Anew';
import { catalogue, compared, simulation, state } from './model';
import { Row, type RowProps } from './Row';
import { _, titleOfPath, word } from './words';

/** Which world they are of. */
const side = signal<Side>(0);
/** Each world's parameters as it began, and which one that was. */
const standards: { opened: number; values: Record<string, string> }[] = [];

effect(() => {
    state.value?.worlds.forEach(({ opened, parameters }, which) => {
        if (standards[which]?.opened !== opened)
            standards[which] = { opened, values: parameters };
    });
});

/** "fluid" of "fluid.viscosity"; "world" of what has no group. */
function groupOf(path: string): string {
    return path.includes('.') ? path.slice(0, path.indexOf('.')) : 'world';
}

function Group({ name, rows }: { name: string; rows: RowProps[] }) {
    return (
        <section aria-labelledby={`group-${name}`}>
            <h3 id={`group-${name}`}>{titleOfPath(name)}</h3>
            {rows.map((row) => (
                <Row key={row.field.path} {...row} />
            ))}
        </section>
    );
}

function Sides() {
    return (
        <div class="linked" role="group" aria-label={_('Properties')}>
            {([0, 1] as const).map((which) => (
                <button
                    type="button"
                    class="text"
                    aria-pressed={side.value === which}
                    onClick={() => (side.value = which)}
                >
                    {which === 0 ? _('World A') : _('World B')}
                </button>
            ))}
        </div>
    );
}

export default function Properties() {
    const worlds = state.value?.worlds ?? [];
    const which = compared.value ? side.value : 0;
    const world = worlds[which];
    if (!world)
        return null;
    const groups = new Map<string, RowProps[]>();
    for (const field of catalogue.parameters) {
        const name = groupOf(field.path);
        const row = {
            field,
            value: world.parameters[field.path] ?? '',
            standard: standards[which]?.values[field.path] ?? '',
            set: (text: string) => simulation.set(field.path, text, which),
        };
        groups.set(name, [...(groups.get(name) ?? []), row]);
    }
    return (
        <>
            {compared.value && <Sides />}
            <section aria-labelledby="planets">
                <h3 id="planets">{_('Gravity as on')}</h3>
                <div class="linked">
                    {catalogue.planets.map(({ title }, index) => (
                        <button type="button" class="text" key={title} onClick={() => simulation.setPlanet(index, which)}>
                            {word(title)}
                        </button>
                    ))}
                </div>
            </section>
            {[...groups].map(([name, rows]) => (
                <Group key={name} name={name} rows={rows} />
            ))}
            {!compared.value && <Anew world={world} />}
        </>
    );
}
