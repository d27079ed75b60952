// Anew: what a scene can only begin with, from the registry; a change begins it anew.
import { signal } from '@preact/signals';
import type { Field, Settings, WorldState } from '../simulation/protocol';
import { catalogue, simulation } from './model';
import { Row } from './Row';
import { _ } from './words';

/** What was asked for of the scene that is open. */
const asked = signal<{ scene: string; settings: Settings }>({ scene: '', settings: {} });

/** Single values that cannot be changed while it runs. */
function isOffered(field: Field): boolean {
    const isLive = catalogue.parameters.some(({ path }) => path === field.path);
    return !isLive && field.type !== 'text' && !field.path.includes('[');
}

export function Anew({ world }: { world: WorldState }) {
    const settings = asked.value.scene === world.name ? asked.value.settings : {};
    const known: Settings = {
        particles: String(world.particles),
        'world.width': String(Number(world.width.toPrecision(4))),
        'world.height': String(Number(world.height.toPrecision(4))),
    };
    const change = (path: string, text: string) => {
        asked.value = { scene: world.name, settings: { ...settings, [path]: text } };
        simulation.change(asked.value.settings);
    };
    return (
        <details>
            <summary>{_('What it begins with')}</summary>
            <p class="caption">{_('A change begins the scene anew.')}</p>
            {catalogue.sceneFields.filter(isOffered).map((field) => {
                const value =
                    settings[field.path] ?? world.parameters[field.path] ?? known[field.path] ?? field.default;
                return (
                    <Row
                        key={field.path}
                        field={field}
                        value={value}
                        standard={value}
                        set={(text) => change(field.path, text)}
                    />
                );
            })}
        </details>
    );
}
