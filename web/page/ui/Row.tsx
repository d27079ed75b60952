// Row: one value of the registry, with its unit, help and a way back. Invariant: what is shown is what
// there is; what was typed and refused is forgotten.
import type { Field } from '../simulation/protocol';
import { Button } from './Button';
import { shown, typed } from './numbers';
import { _, titleOfPath, word } from './words';

export interface RowProps {
    field: Field;
    value: string;
    /** What it began with. */
    standard: string;
    set: (text: string) => void;
}

function Control({ field, value, set, id }: RowProps & { id: string }) {
    const common = { id, 'aria-describedby': `${id}-help` };
    if (field.type === 'boolean')
        return (
            <input
                {...common}
                type="checkbox"
                role="switch"
                class="switch"
                checked={value === 'true'}
                onChange={(event) => set(event.currentTarget.checked ? 'true' : 'false')}
            />
        );
    if (field.type === 'choice')
        return (
            <select {...common} value={value} onChange={(event) => set(event.currentTarget.value)}>
                {field.choices.map((name) => (
                    <option value={name} key={name}>
                        {word(name)}
                    </option>
                ))}
            </select>
        );
    return (
        <input
            {...common}
            type="text"
            inputMode="decimal"
            class="figure numeric"
            value={shown(value)}
            onChange={(event) => {
                const text = typed(event.currentTarget.value.trim());
                event.currentTarget.value = shown(value); // what is refused is forgotten
                set(text);
            }}
        />
    );
}

export function Row(props: RowProps) {
    const { field, value, set } = props;
    const id = `field-${field.path}`;
    return (
        <div class="property">
            <label for={id}>{titleOfPath(field.path)}</label>
            <span class="control">
                {value !== props.standard && (
                    <Button
                        icon="undo"
                        name={`${titleOfPath(field.path)}: ${_('As the scene began')}`}
                        class="small"
                        onClick={() => set(props.standard)}
                    />
                )}
                <Control {...props} id={id} />
            </span>
            <span class="caption" id={`${id}-help`}>
                {[field.unit, word(field.help)].filter(Boolean).join(' · ')}
            </span>
        </div>
    );
}
