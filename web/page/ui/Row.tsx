// Row: one value of the registry, with its unit, help and a way back. Invariant: what is shown is what
// there is, or what is being typed, or was and is refused, with the reason below it.
import { type Dispatch, type StateUpdater, useState } from 'preact/hooks';
import type { Field } from '../simulation/protocol';
import { Button } from './Button';
import { shown, typed } from './numbers';
import { refusalOf } from './refusal';
import { _, titleOfPath, word } from './words';

export interface RowProps {
    field: Field;
    value: string;
    /** What it began with. */
    standard: string;
    set: (text: string) => void;
}

/** What is being typed, or was and is not taken: why. */
interface Draft {
    text: string;
    refusal: string | null;
    /** What there was then. */
    value: string;
}

interface ControlProps extends RowProps {
    id: string;
    draft: Draft | null;
    setDraft: Dispatch<StateUpdater<Draft | null>>;
}

function Control({ field, value, set, id, draft, setDraft }: ControlProps) {
    const common = { id, 'aria-describedby': draft?.refusal ? `${id}-wrong ${id}-help` : `${id}-help` };
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
            aria-invalid={Boolean(draft?.refusal)}
            value={draft?.text ?? shown(value)}
            onInput={({ currentTarget }) => setDraft({ text: currentTarget.value, refusal: null, value })}
            onChange={({ currentTarget }) => {
                const text = typed(currentTarget.value.trim()), refusal = refusalOf(field, text);
                setDraft(refusal ? { text: currentTarget.value, refusal, value } : null);
                if (!refusal)
                    set(text);
            }}
            onBlur={() => setDraft((last) => (last?.refusal ? last : null))}
        />
    );
}

export function Row(props: RowProps) {
    const { field, value, set } = props;
    const id = `field-${field.path}`;
    const [last, setDraft] = useState<Draft | null>(null);
    const draft = last?.refusal && last.value !== value ? null : last; // it was set elsewhere
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
                <Control {...props} id={id} draft={draft} setDraft={setDraft} />
            </span>
            {draft?.refusal && (
                <span class="wrong" id={`${id}-wrong`} role="alert">
                    {draft.refusal}
                </span>
            )}
            <span class="caption" id={`${id}-help`}>
                {[field.unit, word(field.help)].filter(Boolean).join(' · ')}
            </span>
        </div>
    );
}
