// Views: what is shown, from the renderer's tables. Invariant: no view is named here.
import { setView, toggleOverlay, zoom } from './actions';
import { catalogue, part } from './model';
import { _, word } from './words';

const view = part((s) => s.style.view, '');
const shown = part((s) => s.style.overlays.join(), '');

export default function Views() {
    const overlays = shown.value.split(',');
    return (
        <>
            <fieldset class="choices">
                <legend>{_('Views')}</legend>
                {catalogue.views.map(({ name, title }) => (
                    <label class="choice" key={name}>
                        <input
                            type="radio"
                            name="view"
                            checked={view.value === name}
                            onChange={() => setView(name)}
                        />
                        {word(title)}
                    </label>
                ))}
            </fieldset>
            <fieldset class="choices">
                <legend>{_('Over it')}</legend>
                {catalogue.overlays
                    .filter(({ name }) => name !== 'legend') // the page has its own
                    .map(({ name, title }) => (
                        <label class="choice" key={name}>
                            <input
                                type="checkbox"
                                checked={overlays.includes(name)}
                                onChange={() => toggleOverlay(name)}
                            />
                            {word(title)}
                        </label>
                    ))}
            </fieldset>
            <div class="row" role="group" aria-label={_('Zoom')}>
                <button type="button" class="text" onClick={() => zoom(1)}>
                    {_('Zoom In')}
                </button>
                <button type="button" class="text" onClick={() => zoom(-1)}>
                    {_('Zoom Out')}
                </button>
                <button type="button" class="text" onClick={() => zoom(0)}>
                    {_('All of It')}
                </button>
            </div>
        </>
    );
}
