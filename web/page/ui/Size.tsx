// Size: the radius of the tool, and what it dyes with.
import { longerSide } from './actions';
import { catalogue, dye, part, simulation } from './model';
import { quantity } from './numbers';
import { _, word } from './words';

const brush = part((s) => s.brush, 0);

export default function Size() {
    const { least_brush: least, largest_brush: largest } = catalogue.limits;
    return (
        <>
            <input
                type="range"
                class="wide"
                aria-label={_('Size of the tool')}
                aria-valuetext={quantity(100 * brush.value, 1, 'cm')}
                min={Math.log(least)}
                max={Math.log(largest)}
                step={0.05}
                value={Math.log(brush.value / longerSide())}
                onInput={(event) => simulation.setBrush(Math.exp(Number(event.currentTarget.value)) * longerSide())}
            />
            <p class="numeric">{quantity(100 * brush.value, 1, 'cm')}</p>
            <fieldset class="choices">
                <legend>{_('Dye')}</legend>
                {catalogue.dyes.map((name, index) => (
                    <label class="choice" key={name}>
                        <input
                            type="radio"
                            name="dye"
                            checked={dye.value === index}
                            onChange={() => simulation.setDye(index)}
                        />
                        <span class={`swatch dye-${name}`} />
                        {word(name)}
                    </label>
                ))}
            </fieldset>
        </>
    );
}
