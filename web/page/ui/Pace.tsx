// Pace: how fast it goes, what it costs, and what was chosen for that.
import type { State } from '../simulation/protocol';
import { chooseParticles } from './amounts';
import { catalogue, simulation, state } from './model';
import { fixed, quantity } from './numbers';
import { preferences } from './preferences';
import { _, say, word } from './words';

/** Device pixels in a CSS pixel: more are not drawn anywhere. */
const SHARPEST = 2;

/** What this device is spared, or spares the reader. */
function wordsOfChoices(now: State): string[] {
    const said = [];
    if (now.chosen !== null)
        said.push(say(_('Scenes made for %s particles begin with %s on this device.'), fixed(catalogue.limits.usual_amount, 0), fixed(now.chosen, 0)));
    if (now.ratio < Math.min(window.devicePixelRatio, SHARPEST))
        said.push(_('Drawing is slow here: pictures are coarser than the screen.'));
    // Comes and goes: last, so that what is above it stays.
    if (now.going.slow)
        said.push(_('Slow motion: this device cannot compute so many particles in real time. Fewer go faster (Properties).'));
    return said;
}

/** How many particles scenes begin with. */
function Particles() {
    const { particles, measured } = preferences.value;
    const here = measured ? say(_('As measured: %s'), fixed(measured, 0)) : _('As measured');
    return (
        <div class="property">
            <label for="particles">{_('Particles')}</label>
            <select
                id="particles"
                value={particles}
                onChange={(event) => chooseParticles(Number(event.currentTarget.value))}
            >
                {[0, ...catalogue.amounts].map((count) => (
                    <option value={count} key={count}>
                        {count ? fixed(count, 0) : here}
                    </option>
                ))}
            </select>
        </div>
    );
}

export default function Pace() {
    const now = state.value;
    if (!now)
        return null;
    const costs = [
        say(_('Step: %s'), quantity(now.stepMs, 1, 'ms')),
        say(_('Picture: %s'), quantity(now.drawMs, 1, 'ms')),
        say(_('%d substeps a frame'), now.worlds[0].substeps),
        say(_('Threads: %d'), now.threads),
    ];
    return (
        <>
            <fieldset class="choices">
                <legend>{_('Speed')}</legend>
                {catalogue.speeds.map(({ number: speed, title }) => (
                    <label class="choice" key={speed}>
                        <input
                            type="radio"
                            name="speed"
                            checked={Math.abs(now.speed - speed) < 1e-6}
                            onChange={() => simulation.setSpeed(speed)}
                        />
                        {word(title)}
                    </label>
                ))}
            </fieldset>
            <Particles />
            {wordsOfChoices(now).map((text) => (
                <p class="caption" key={text}>{text}</p>
            ))}
            <ul class="plain numeric">
                {costs.map((cost) => (
                    <li>{cost}</li>
                ))}
            </ul>
        </>
    );
}
