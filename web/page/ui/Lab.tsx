// Lab: an experiment's card: question, prediction, measurement, comparison. Invariant: what theory says
// is shown once something was measured, not before: who predicts shall not read it off.
import type { ComponentChildren } from 'preact';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Curve, Experiment, LabMessage, Row } from '../simulation/protocol';
import { countParticles } from '../simulation/lab';
import { beginErrand, wordsOfFailure } from './errands';
import { download } from './files';
import { Icon } from './Icon';
import { predictions, runs, startExperiment, stopExperiment } from './labs';
import { catalogue, showPanel, simulation, subject } from './model';
import { Plot } from './Plot';
import { fixed, short, withUnit } from './numbers';
import { preferences } from './preferences';
import { _, say, word } from './words';

function Part({ title, text, children }: { title: string; text: string; children?: ComponentChildren }) {
    return (
        <section>
            <h3>{title}</h3>
            <p>{word(text)}</p>
            {children}
        </section>
    );
}

function Prediction({ index }: { index: number }) {
    return (
        <textarea
            rows={2}
            aria-label={_('Your prediction')}
            placeholder={_('Your prediction')}
            value={predictions.value[index] ?? ''}
            onInput={(event) =>
                (predictions.value = { ...predictions.value, [index]: event.currentTarget.value })
            }
        />
    );
}

function ResultRow({ quantity, unit, measured, theory, pass }: Row) {
    const known = Number.isFinite(theory) && theory !== 0;
    return (
        <tr>
            <th scope="row">{word(quantity)}</th>
            <td>{withUnit(short(measured, 4), unit)}</td>
            <td>{known ? withUnit(short(theory, 4), unit) : '–'}</td>
            <td class={pass ? 'pass' : 'fail'}>{pass ? `✓ ${_('as theory')}` : `✗ ${_('not as theory')}`}</td>
        </tr>
    );
}

function Results({ rows }: { rows: Row[] }) {
    return (
        <div class="scrolled" tabIndex={0} role="region" aria-label={_('4. Compare')}>
            <table class="results numeric">
                <thead>
                    <tr>
                        <th scope="col">{_('Quantity')}</th>
                        <th scope="col">{_('Measured')}</th>
                        <th scope="col">{_('Theory')}</th>
                        <th scope="col">{_('Within what is allowed')}</th>
                    </tr>
                </thead>
                <tbody>
                    {rows.map((row) => (
                        <ResultRow key={row.quantity} {...row} />
                    ))}
                </tbody>
            </table>
        </div>
    );
}

function shownCurves(latest: LabMessage | null | undefined): Curve[] {
    if (!latest || latest.kind === 'failed' || latest.kind === 'counted')
        return [];
    const curves = latest.curves.map((curve) => ({ ...curve, label: word(curve.label) }));
    return latest.kind === 'done' ? curves : curves.filter(({ style }) => style !== 'theory');
}

/** With how many particles it is going to be measured. */
function Amount({ index }: { index: number }) {
    const { particles } = preferences.value;
    const [count, setCount] = useState(0);
    useEffect(() => {
        let shows = true, end: (() => void) | null = null;
        const show = (known: number) => {
            if (known > 0)
                setCount(known);
            else if (shows) // it comes with the larger module
                end = beginErrand(() => countParticles(index, particles, (told) => told.kind === 'counted' && setCount(told.particles)), () => {});
        };
        void simulation.experimentParticles(index, particles).then(show);
        return () => {
            shows = false;
            end?.();
        };
    }, [index, particles]);
    return (
        <p class="caption">{count > 0 ? say(_('It is measured with %s particles.'), fixed(count, 0)) : '\u00a0'}</p>
    );
}

function Measurement({ index, experiment }: { index: number; experiment: Experiment }) {
    const run = runs.value[index];
    const curves = shownCurves(run?.latest);
    const holder = useRef<HTMLDivElement>(null);
    useLayoutEffect(() => {
        if (!run?.running)
            return;
        holder.current!.scrollIntoView();
        holder.current!.querySelector('.plot')!.scrollIntoView({ block: 'nearest' });
    }, [run?.running]);
    return (
        <div ref={holder} class="measurement">
            <Part title={_('3. Measure')} text={experiment.measure}>
                <div class="controls">
                    <p class="row">
                        <button
                            type="button"
                            class="text suggested"
                            onClick={() => (run?.running ? stopExperiment() : startExperiment(index))}
                        >
                            {run?.running ? _('Stop') : _('Measure')}
                        </button>
                        <button
                            type="button"
                            class="text"
                            onClick={() => {
                                simulation.openExperiment(index);
                                showPanel(null);
                            }}
                        >
                            {_('Play with the set-up')}
                        </button>
                    </p>
                    {run?.running && <progress aria-label={_('3. Measure')} value={run.share} />}
                </div>
                <Amount index={index} />
                {curves.length > 0 ? (
                    <Plot
                        xLabel={word(experiment.x_label)}
                        yLabel={word(experiment.y_label)}
                        curves={curves}
                        name={word(experiment.title)}
                    />
                ) : (
                    run?.running && <div class="plot" />
                )}
            </Part>
        </div>
    );
}

/** @param comes into sight: who waited for it may have the plot there */
function Comparison({ text, comes, children }: { text: string; comes: boolean; children: ComponentChildren }) {
    const holder = useRef<HTMLDivElement>(null);
    useLayoutEffect(() => {
        if (comes)
            holder.current!.scrollIntoView({ block: 'nearest' });
    }, []);
    return (
        <div ref={holder} class="measurement">
            <Part title={_('4. Compare')} text={text}>
                {children}
            </Part>
        </div>
    );
}

export default function Lab() {
    const index = subject.value;
    const experiment = catalogue.experiments[index];
    const run = runs.value[index], latest = run?.latest;
    const waited = useRef(-1);
    if (run?.running)
        waited.current = index;
    return (
        <>
            <h3 class="title">{word(experiment.title)}</h3>
            <p class="caption">{word(experiment.description)}</p>
            <Part title={_('1. Question')} text={experiment.question} />
            <Part title={_('2. Predict')} text={experiment.predict}>
                <Prediction index={index} />
            </Part>
            <Measurement index={index} experiment={experiment} />
            {latest?.kind === 'failed' && <p role="alert">{wordsOfFailure(latest.error)}</p>}
            {latest?.kind === 'done' && (
                <Comparison key={index} text={experiment.compare} comes={waited.current === index}>
                    {predictions.value[index] && (
                        <p class="quote">{`${_('Your prediction')}: ${predictions.value[index]}`}</p>
                    )}
                    <p class="caption">{say(_('Measured with %s particles'), fixed(latest.particles, 0))}</p>
                    <Results rows={latest.rows} />
                    <p class="row">
                        <button
                            type="button"
                            class="text"
                            onClick={() => download(latest.csv, 'text/csv', `${experiment.name}.csv`)}
                        >
                            <Icon name="save" />
                            CSV
                        </button>
                        <button
                            type="button"
                            class="text"
                            onClick={() => download(latest.svg, 'image/svg+xml', `${experiment.name}.svg`)}
                        >
                            <Icon name="save" />
                            SVG
                        </button>
                    </p>
                </Comparison>
            )}
        </>
    );
}
