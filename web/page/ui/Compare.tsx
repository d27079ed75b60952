// Compare: a second world beside the first.
import { catalogue, compared, part, showPanel, simulation } from './model';
import { _, word } from './words';

const linked = part((s) => s.linked, true);

export default function Compare() {
    return (
        <>
            <ul class="list">
                {catalogue.choices.map(({ name, title }) => (
                    <li key={name}>
                        <button
                            type="button"
                            onClick={() => {
                                simulation.compareWith(name);
                                showPanel(null);
                            }}
                        >
                            {word(title)}
                        </button>
                    </li>
                ))}
            </ul>
            {compared.value && (
                <>
                    <label class="choice">
                        <input
                            type="checkbox"
                            checked={linked.value}
                            onChange={(event) => simulation.setLinked(event.currentTarget.checked)}
                        />
                        {_('Hands and gravity in both worlds')}
                    </label>
                    <button type="button" class="text wide" onClick={() => simulation.compare(null)}>
                        {_('Close world B (C)')}
                    </button>
                </>
            )}
        </>
    );
}
