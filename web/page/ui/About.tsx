// About: what this is.
import { Icon } from './Icon';
import { catalogue, showPanel } from './model';
import { _ } from './words';

export default function About() {
    const text = _(
        'Water to play with, calibrated like the real thing.\n\nThe method follows Daniel Månsson, “Interactive 2D Particle-based Fluid Simulation for Mobile Devices” (2013), after Clavet, Beaudoin and Poulin (2005).',
    );
    return (
        <div class="prose">
            <p>
                <strong>Skvalp {catalogue.version}</strong>
            </p>
            {text.split('\n\n').map((paragraph) => (
                <p>{paragraph}</p>
            ))}
            <p>{_('All of it runs on this device: nothing is sent anywhere.')}</p>
            <p class="row">
                <button type="button" class="text wide" onClick={() => showPanel('bench')}>
                    {_('How fast this device is')}
                    <Icon name="next" />
                </button>
            </p>
            <p>MIT © {_('The Skvalp authors')}</p>
        </div>
    );
}
