// Status: what is open, over the picture's corner; and for a while what there is to see.
import { useEffect } from 'preact/hooks';
import { effect, signal } from '@preact/signals';
import { catalogue, compared, controls, measuring, part, showPanel, state } from './model';
import { Icon } from './Icon';
import { later } from './later';
import { Legend } from './Legend';
import { quantity } from './numbers';
import { preferences, touch } from './preferences';
import { wordsOfAmount } from './spoken';
import { _, say, word } from './words';

const Sides = later(() => import('./Sides'), true);

const opened = part((s) => s.worlds[0].opened, 0);
const described = signal(false);
/** Whether anybody has held the water yet, or opened something else: who has needs no hint. */
const touched = signal(false);
effect(() => {
    if (state.value?.worlds.some(({ hands }) => hands > 0))
        touched.value = true;
});
/** As long as it takes to read two sentences. */
const READING = 8000;

function Description({ text }: { text: string }) {
    return text ? <p class="pill description">{word(text)}</p> : null;
}

function Hint() {
    const ball = controls.value === 'all' && preferences.value.ball;
    return (
        <p class="pill description hint">
            <Icon name="hand" />
            {touch.value ? _('Hold the water with your fingers.') : _('Hold the water with the mouse or with fingers.')}
            {ball && ` ${_('Drag the white ball to tilt the tank.')}`}
        </p>
    );
}

/** That an experiment is measured where nobody sees it; a press leads to it. */
function Measuring() {
    if (!measuring.value)
        return null;
    const { index, share } = measuring.value;
    return (
        <button type="button" class="pill description" onClick={() => showPanel('experiment', index)}>
            {say(_('“%s” is being measured: %s. The water here waits.'), word(catalogue.experiments[index].title),
                quantity(100 * share, 0, '%'))}
        </button>
    );
}

export function Status() {
    useEffect(() => {
        const isAny = opened.value > 0;
        described.value = true;
        const timer = setTimeout(() => (described.value = false), READING);
        return () => {
            clearTimeout(timer);
            touched.value ||= isAny;
        };
    }, [opened.value]);
    const world = state.value?.worlds[0];
    if (!world)
        return null;
    return (
        <div class="status">
            <p class="pill">
                <strong>{word(world.title)}</strong>
                <span class="amount numeric">{wordsOfAmount(world)}</span>
            </p>
            <Measuring />
            {compared.value ? (
                <Sides />
            ) : (
                <>
                    {world.legend && <Legend scale={world.legend} />}
                    {described.value && !measuring.value && (
                        touched.value ? <Description text={world.description} /> : <Hint />
                    )}
                </>
            )}
        </div>
    );
}
