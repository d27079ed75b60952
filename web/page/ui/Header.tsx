// Header: what opens panels, over the picture's upper edge.
import { Button, PanelButton } from './Button';
import { embedded } from './model';
import { canFullscreen, fullscreen, toggleFullscreen } from './device';
import { quantity } from './numbers';
import { recorded, toggleRecording } from './recording';
import { _ } from './words';

/** That it records, and for how long by now; whoever presses it has enough. */
function Recorded() {
    const seconds = recorded.value;
    if (seconds === null)
        return null;
    const time = quantity(seconds, 0, 's');
    return (
        <button
            type="button"
            class="button recorded"
            aria-label={_('Stop recording')}
            aria-description={time}
            title={_('Stop recording')}
            onClick={toggleRecording}
        >
            <span class="numeric">{time}</span>
        </button>
    );
}

export function Header() {
    return (
        <header class="header">
            <PanelButton
                opens="scenes"
                icon="scenes"
                name={_('Scenes and experiments')}
                hint="G"
                class="labelled"
            >
                <span class="label">{_('Scenes')}</span>
            </PanelButton>
            <Recorded />
            <span class="space" />
            <PanelButton opens="measure" icon="probe" name={_('Measure')} />
            <PanelButton opens="views" icon="views" name={_('Views')} hint="V" />
            <PanelButton opens="properties" icon="sliders" name={_('Properties')} hint="P" />
            {(canFullscreen && (embedded.value || fullscreen.value)) && (
                <Button
                    icon={fullscreen.value ? 'window' : 'fullscreen'}
                    name={fullscreen.value ? _('Leave full screen') : _('Full Screen')}
                    hint="F"
                    onClick={toggleFullscreen}
                />
            )}
            <PanelButton opens="menu" icon="menu" name={_('Main menu')} />
        </header>
    );
}
