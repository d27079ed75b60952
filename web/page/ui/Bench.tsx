// Bench: how fast this device is, measured by whoever wants to know.
import { useEffect } from 'preact/hooks';
import {
    copyReport, device, figures, report, running, share, showing, startBench, stopBench,
} from './benching';
import { Icon } from './Icon';
import { catalogue } from './model';
import { canShare, passOn } from './sharing';
import { fixed, quantity, short } from './numbers';
import { _, say, word } from './words';

function titleOf(scene: string): string {
    return word(catalogue.scenes.find(({ name }) => name === scene)?.title ?? scene);
}

function Table() {
    const heads = [_('Scene'), _('Law'), _('Particles'), _('Threads'), _('Least'), _('Median')];
    return (
        <div class="scrolled" tabIndex={0} role="region" aria-label={_('What was measured')}>
            <table class="results numeric">
                <caption>{_('Nanoseconds for a particle and substep')}</caption>
                <thead>
                    <tr>
                        {heads.map((name) => (
                            <th scope="col" key={name}>
                                {name}
                            </th>
                        ))}
                    </tr>
                </thead>
                <tbody>
                    {figures.value.map(({ scene, law, particles, threads, least, median }) => (
                        <tr key={`${scene} ${law} ${particles} ${threads}`}>
                            <th scope="row">{titleOf(scene)}</th>
                            <td>{law}</td>
                            <td>{fixed(particles, 0)}</td>
                            <td>{threads}</td>
                            <td>{short(least, 3)}</td>
                            <td>{short(median, 3)}</td>
                        </tr>
                    ))}
                </tbody>
            </table>
        </div>
    );
}

export default function Bench() {
    useEffect(() => stopBench, []);
    const seen = showing.value;
    const done = !running.value && figures.value.length > 0;
    return (
        <>
            <p>{_('What a particle costs here: two scenes and two laws of pressure, on one thread and on all. It takes up to a minute; nothing is sent anywhere.')}</p>
            <p class="caption">{device.browser}</p>
            <p class="caption">
                {[
                    say(_('Cores: %d'), device.cores),
                    ...(device.memory ? [say(_('Memory: %s or more'), quantity(device.memory, 0, 'GB'))] : []),
                ].join(', ')}
            </p>
            <p class="row">
                <button
                    type="button"
                    class="text suggested"
                    onClick={() => (running.value ? stopBench() : void startBench())}
                >
                    {running.value ? _('Stop') : _('Measure')}
                </button>
                <button type="button" class="text" disabled={!done} onClick={() => void copyReport()}>
                    <Icon name="copy" />
                    {_('Copy')}
                </button>
                {canShare && (
                    <button type="button" class="text" disabled={!done}
                        onClick={() => void passOn({ text: report.value })}>
                        <Icon name="share" />
                        {_('Pass on')}
                    </button>
                )}
            </p>
            {running.value && <progress aria-label={_('Measure')} value={share.value} />}
            {seen && (
                <p>
                    {say(
                        _('The water that was open: %s pictures and %s of 60 frames a second; a frame takes %s, a picture %s.'),
                        fixed(seen.pictures, 0), fixed(seen.frames, 0), quantity(seen.stepMs, 1, 'ms'), quantity(seen.drawMs, 1, 'ms'),
                    )}
                </p>
            )}
            {figures.value.length > 0 && <Table />}
        </>
    );
}
