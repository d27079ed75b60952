// Amounts: how many particles scenes begin with on this device: as the address says for this visit, as a person
// chose, or as it was measured once. Invariant: what was measured is kept, so that every visit has the same.
import { effect } from '@preact/signals';
import { openScene } from './actions';
import { catalogue, framed, part, simulation, world } from './model';
import { prefer, preferences } from './preferences';

const chosen = part((s) => s.chosen, null as number | null);

/** Into the address, so that who copies it begins with as many; that of a file on a disk is nobody else's. */
function write(count: number | null): void {
    if (!count || framed || location.protocol === 'file:')
        return;
    const address = new URL(location.href);
    address.searchParams.set('particles', String(count));
    if (address.href !== location.href)
        history.replaceState(history.state, '', address);
}

/** @param asked what the address says, 0: nothing */
export function beginAmounts(asked: number): void {
    const { particles, measured } = preferences.value;
    const wanted = asked || particles || measured;
    simulation.setParticles(wanted);
    const tell = () => write(chosen.value);
    effect(tell);
    window.addEventListener('popstate', tell); // an earlier entry has the number of its time
    if (!wanted)
        effect(() => {
            if (chosen.value !== null && !preferences.peek().measured && !preferences.peek().particles)
                prefer({ measured: chosen.value });
        });
}

/** From now on; a built-in scene begins anew with it. 0: as it was measured. */
export function chooseParticles(particles: number): void {
    prefer({ particles });
    simulation.setParticles(particles || preferences.value.measured);
    const { name = '' } = world.value ?? {};
    if (catalogue.scenes.some((scene) => scene.name === name))
        openScene(name);
}
