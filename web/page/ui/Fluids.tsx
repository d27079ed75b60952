// Fluids: the row of chips that chooses what is poured, each in its colour and with its name.
import { simulation, state, world } from './model';
import { _, word } from './words';

export default function Fluids() {
    return (
        <div class="chips" role="group" aria-label={_('What is poured')}>
            {world.value?.fluids.map(({ name, color }, index) => (
                <button
                    type="button"
                    key={name}
                    class="chip"
                    aria-pressed={state.value!.fluid === index}
                    onClick={() => simulation.chooseFluid(index)}
                >
                    <span class="drop" style={{ background: color }} />
                    {word(name)}
                </button>
            ))}
        </div>
    );
}
