// Compare: a second world beside the first.
import { choices, compareWith } from './choices';
import { compared, part, showPanel, simulation } from './model';
import { _ } from './words';

const linked = part((s) => s.linked, true);

export function Compare() {
    return (
        <>
            <ul class="list">
                {choices.map(({ label }, index) => (
                    <li key={label}>
                        <button
                            type="button"
                            onClick={() => {
                                compareWith(index);
                                showPanel(null);
                            }}
                        >
                            {_(label)}
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
