// Measure: the instruments to choose from; each goes into the picture, to be moved there.
import { addProbe, offered } from './instruments';
import { Icon } from './Icon';
import { part, showPanel } from './model';
import { saveFile } from './files';
import { _ } from './words';

const any = part((s) => s.worlds[0].probes.length > 0, false);

export function Measure() {
    return (
        <>
            <ul class="list">
                {offered().map(({ name, title }) => (
                    <li key={name}>
                        <button
                            type="button"
                            onClick={() => {
                                addProbe(name);
                                showPanel(null);
                            }}
                        >
                            <span>{_(title)}</span>
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
