// Settings: what a reader chooses once. Invariant: a choice acts at once and is remembered at once.
import { catalogue } from './model';
import { preferences, prefer } from './preferences';
import type { Preferences } from './preferences';
import { short } from './numbers';
import { canTilt } from './tilting';
import { _, known, word } from './words';

/** A language's name, in that language. */
function nameOf(tag: string): string {
    const name = new Intl.DisplayNames([tag], { type: 'language' }).of(tag) ?? tag;
    return name.charAt(0).toLocaleUpperCase(tag) + name.slice(1);
}

function Choice(props: { id: string; title: string; value: string; options: [string, string][]; choose: (value: string) => void }) {
    return (
        <div class="property">
            <label for={props.id}>{props.title}</label>
            <select
                id={props.id}
                value={props.value}
                onChange={(event) => props.choose(event.currentTarget.value)}
            >
                {props.options.map(([value, text]) => (
                    <option value={value} key={value}>
                        {text}
                    </option>
                ))}
            </select>
        </div>
    );
}

function Switch(props: { id: 'ball' | 'keys' | 'vibrate'; title: string }) {
    return (
        <div class="property">
            <label for={`set-${props.id}`}>{props.title}</label>
            <span class="control">
                <input
                    id={`set-${props.id}`}
                    type="checkbox"
                    role="switch"
                    checked={preferences.value[props.id]}
                    onChange={(event) => prefer({ [props.id]: event.currentTarget.checked })}
                />
            </span>
        </div>
    );
}

/** How strongly the sensor tilts. */
function Tilt() {
    const { tilt } = preferences.value;
    return (
        <label class="slider">
            {`${_('Tilt Sensor')}: ${_('Strength')} ${short(tilt, 2)}`}
            <span class="caption">{_('Against the scene\'s own gravity')}</span>
            <input
                type="range"
                class="wide"
                min={0}
                max={2}
                step={0.1}
                value={tilt}
                aria-valuetext={short(tilt, 2)}
                onInput={(event) => prefer({ tilt: Number(event.currentTarget.value) })}
            />
        </label>
    );
}

export default function Settings() {
    const chosen = preferences.value;
    return (
        <>
            <Choice
                id="set-language"
                title={_('Language')}
                value={chosen.language}
                options={[['', _('As the system')], ...known.map((tag): [string, string] => [tag, nameOf(tag)])]}
                choose={(language) => prefer({ language })}
            />
            <Choice
                id="set-scheme"
                title={_('Colours')}
                value={chosen.scheme}
                options={[
                    ['system', _('As the system')],
                    ['light', _('Light')],
                    ['dark', _('Dark')],
                ]}
                choose={(scheme) => prefer({ scheme: scheme as Preferences['scheme'] })}
            />
            <Choice
                id="set-detail"
                title={_('Detail')}
                value={chosen.detail}
                options={catalogue.details.map(({ name, title }) => [name, word(title)])}
                choose={(detail) => prefer({ detail })}
            />
            <Choice
                id="set-units"
                title={_('Units')}
                value={chosen.si ? 'si' : 'plain'}
                options={[
                    ['plain', _('Everyday (cm of water)')],
                    ['si', _('SI (Pa m)')],
                ]}
                choose={(units) => prefer({ si: units === 'si' })}
            />
            <Switch id="ball" title={_('Gravity ball')} />
            {canTilt && <Tilt />}
            <Switch id="keys" title={_('Keys without Ctrl')} />
            {'vibrate' in navigator && <Switch id="vibrate" title={_('Vibrate at a touch')} />}
        </>
    );
}
