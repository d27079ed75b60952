// Measure: the instruments to choose from; each goes into the picture, to be moved there.
import { Icon } from './Icon';
import { catalogue, part, showPanel, simulation } from './model';
import { saveFile } from './files';
import { _, word } from './words';

const any = part((s) => s.worlds[0].probes.length > 0, false);

export default function Measure() {
    return (
        <>
            <ul class="list">
                {catalogue.gauges.map(({ kind, title }) => (
                    <li key={kind}>
                        <button
                            type="button"
                            onClick={() => {
                                simulation.addGauge(kind);
                                showPanel(null);
                            }}
                        >
                            <span>{word(title)}</span>
                            <Icon name="plus" />
                        </button>
                    </li>
                ))}
            </ul>
            {any.value && (
                <button type="button" class="text" onClick={() => void saveFile('csv')}>
                    <Icon name="save" />
                    {_('Save the Readings')}
                </button>
            )}
        </>
    );
}
