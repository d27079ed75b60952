// Status: what is open, over the picture's corner; and for a while what there is to see.
import { useEffect } from 'preact/hooks';
import { effect, signal } from '@preact/signals';
import { compared, controls, part, state } from './model';
import { Icon } from './Icon';
import { choice } from './choices';
import { preferences } from './preferences';
import { wordsOfAmount } from './spoken';
import { _, word } from './words';

const opened = part((s) => s.worlds[0].opened, 0);
const described = signal(false);
/** Whether anybody has held the water yet: who has needs no hint. */
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
            {_('Hold the water with the mouse or with fingers.')}
            {ball && ` ${_('Drag the white ball to tilt the tank.')}`}
        </p>
    );
}

export function Status() {
    useEffect(() => {
        described.value = true;
        const timer = setTimeout(() => (described.value = false), READING);
        return () => clearTimeout(timer);
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
            {described.value && (touched.value ? <Description text={world.description} /> : <Hint />)}
            {compared.value &&
                state.value!.worlds.map(({ area }, side) => (
                    <p
                        class="pill badge"
                        style={{ left: `${area.x + area.width / 2}px`, top: `${area.y + area.height - 48}px` }}
                    >
                        <span class={`letter world-${side}`}>{'AB'[side]}</span>
                        {side === 0 ? _('As it is') : choice.value}
                    </p>
                ))}
        </div>
    );
}
