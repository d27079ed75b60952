// Transport: time as a person handles it. Invariant: while a finger is on the bar, the picture follows
// it; once it lets go, the scene plays on from there if it played before.
import { useSignal } from '@preact/signals';
import { step, togglePause } from './actions';
import { Button } from './Button';
import { FRAMES, catalogue, part, paused, simulation, state, togglePanel } from './model';
import { reading, readingWords } from './stopwatch';
import { wordsOfPace } from './spoken';
import { fixed, quantity } from './numbers';
import { _ } from './words';

const canUndo = part((s) => s.canUndo, false);
const canRedo = part((s) => s.canRedo, false);

function Bar() {
    const now = state.value;
    const resumes = useSignal(false);
    const end = now?.end ?? 0;
    const first = Math.max(0, end - (catalogue?.limits.reach ?? 0));
    const behind = end - (now?.moment ?? 0);
    const seconds = now?.worlds[0].time ?? 0;
    const clock = quantity(seconds, 1, 's') + (behind > 0 ? ` (${fixed(-behind / FRAMES, 1)})` : '');
    return (
        <>
            <input
                class="bar"
                type="range"
                aria-label={_('Rewind')}
                aria-valuetext={clock}
                title={_('The last 30 seconds: drag to go back (Shift+Left)')}
                min={first}
                max={Math.max(end, first + 1)}
                value={now?.moment ?? 0}
                disabled={end === 0}
                onPointerDown={() => (resumes.value = !paused.value)}
                onInput={(event) => simulation.scrub(Number(event.currentTarget.value))}
                onChange={() => {
                    if (resumes.value)
                        simulation.setPaused(false);
                    resumes.value = false;
                }}
            />
            <span class="clock">{clock}</span>
        </>
    );
}

function Pace() {
    const now = state.value;
    return (
        <button
            type="button"
            class={`pace ${now?.going.slow ? 'slow' : ''}`}
            title={_('How fast it goes, and what it costs')}
            onClick={() => togglePanel('pace')}
        >
            <span class="hidden">{`${_('How fast it goes')}: `}</span>
            {now ? wordsOfPace(now) : ''}
        </button>
    );
}

function Stopwatch() {
    return (
        <>
            <Button
                icon="stopwatch"
                name={_('Stopwatch')}
                hint="W"
                description={reading.value.used ? readingWords.value : undefined}
                onClick={() => simulation.pressStopwatch(false)}
            />
            {reading.value.used && (
                <span class="stopwatch">
                    <span class="numeric">{readingWords.value}</span>
                    {reading.value.running && (
                        <button type="button" class="text" onClick={() => simulation.pressStopwatch(true)}>
                            {_('Lap')}
                        </button>
                    )}
                </span>
            )}
        </>
    );
}

export function Transport() {
    return (
        <div class="transport" role="group" aria-label={_('Playback')}>
            <div class="buttons">
                <Button
                    icon={paused.value ? 'play' : 'pause'}
                    name={paused.value ? _('Play') : _('Pause')}
                    hint={_('Space')}
                    class="primary"
                    onClick={togglePause}
                />
                <Button icon="step" name={_('One step of 1/60 s')} hint="." onClick={step} />
                <Button
                    icon="reset"
                    name={_('Back to the start')}
                    hint="R"
                    onClick={() => simulation.reset()}
                />
                <Button
                    icon="undo"
                    name={_('Undo')}
                    hint={_('Ctrl+Z')}
                    disabled={!canUndo.value}
                    onClick={() => simulation.undo()}
                />
                <Button
                    icon="redo"
                    name={_('Redo')}
                    hint={_('Shift+Ctrl+Z')}
                    disabled={!canRedo.value}
                    onClick={() => simulation.redo()}
                />
                <Stopwatch />
            </div>
            <Bar />
            <Pace />
        </div>
    );
}
