// Header: what opens panels, over the picture's upper edge.
import { Button, PanelButton } from './Button';
import { embedded } from './model';
import { canFullscreen, fullscreen, toggleFullscreen } from './device';
import { later } from './later';
import { recorded } from './recording';
import { _ } from './words';

const Recorded = later(() => import('./Recorded'), true);

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
            {recorded.value !== null && <Recorded />}
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
