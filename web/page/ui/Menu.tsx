// Menu: what is done seldom.
import { toggleKeyboardHand } from './actions';
import { canFullscreen, fullscreen, toggleFullscreen } from './device';
import { Icon } from './Icon';
import { goOn, offered } from './keeping';
import { keyboardHand, showPanel } from './model';
import { canRecord, recorded, toggleRecording } from './recording';
import { saveFile } from './files';
import { shareLink } from './sharing';
import { beginTilt, canTilt, endTilt, tilt } from './tilting';
import { _ } from './words';

interface Item {
    icon: string;
    text: string;
    act: () => void;
    /** Given: it can be on or off. */
    on?: boolean;
    /** It leads to a panel. */
    leads?: boolean;
}

function closing(act: () => void): () => void {
    return () => {
        showPanel(null);
        act();
    };
}

function items(): Item[][] {
    return [
        [
            { icon: 'share', text: _('Share'), act: () => void shareLink(), leads: true },
            { icon: 'save', text: _('Save a Picture'), act: closing(() => void saveFile('png')) },
            { icon: 'save', text: _('Save all from the start (replay)'), act: closing(() => void saveFile('skvr')) },
            { icon: 'save', text: _('Save this moment alone (state)'), act: closing(() => void saveFile('skv')) },
            ...(canRecord
                ? [
                      {
                          icon: recorded.value !== null ? 'stop' : 'record',
                          text: recorded.value !== null ? _('Stop recording') : _('Record a video'),
                          act: closing(toggleRecording),
                          on: recorded.value !== null,
                      },
                  ]
                : []),
        ],
        [
            ...(canTilt
                ? [
                      {
                          icon: 'tilt',
                          text: _('Tilt by the Sensor'),
                          act: closing(() => void (tilt.value === 'off' ? beginTilt() : endTilt())),
                          on: tilt.value !== 'off',
                      },
                  ]
                : []),
            ...(offered.value ? [{ icon: 'open', text: _('Go On Where You Were'), act: goOn }] : []),
            { icon: 'compare', text: _('Compare Two Worlds'), act: () => showPanel('compare'), leads: true },
            { icon: 'hand', text: _('Keyboard Hand'), act: closing(toggleKeyboardHand), on: keyboardHand.value },
            ...(canFullscreen
                ? [
                      {
                          icon: 'fullscreen',
                          text: _('Full Screen'),
                          act: closing(toggleFullscreen),
                          on: fullscreen.value,
                      },
                  ]
                : []),
        ],
        [
            { icon: 'settings', text: _('Preferences'), act: () => showPanel('settings'), leads: true },
            { icon: 'keyboard', text: _('Keyboard Shortcuts'), act: () => showPanel('keys'), leads: true },
            { icon: 'help', text: _('About Skvalp'), act: () => showPanel('about'), leads: true },
        ],
    ];
}

export default function Menu() {
    return (
        <>
            {items().map((section) => (
                <ul class="list">
                    {section.map(({ icon, text, act, on, leads }) => (
                        <li key={text}>
                            <button type="button" aria-pressed={on} onClick={act}>
                                <Icon name={icon} />
                                <span>{text}</span>
                                {leads && <Icon name="next" />}
                            </button>
                        </li>
                    ))}
                </ul>
            ))}
        </>
    );
}
