// Button: an icon with a name and, as its tooltip, the key that does the same.
import type { ComponentChildren } from 'preact';
import { Icon } from './Icon';
import { type Panel, panel, togglePanel } from './model';

export interface ButtonProps {
    icon: string;
    name: string;
    /** The key that does the same, or what else there is to say. */
    hint?: string;
    class?: string;
    disabled?: boolean;
    /** Given: it is a toggle. */
    pressed?: boolean;
    /** Given: it opens a panel, which is open or not. */
    expanded?: boolean;
    description?: string;
    onClick: () => void;
    children?: ComponentChildren;
}

export function Button(props: ButtonProps) {
    return (
        <button
            type="button"
            class={`button ${props.class ?? ''}`}
            title={props.hint ? `${props.name} (${props.hint})` : props.name}
            aria-label={props.name}
            aria-description={props.description}
            aria-pressed={props.pressed}
            aria-expanded={props.expanded}
            disabled={props.disabled}
            onClick={props.onClick}
        >
            <Icon name={props.icon} />
            {props.children}
        </button>
    );
}

/** A button that opens a panel, or closes it. */
export function PanelButton({ opens, ...props }: Omit<ButtonProps, 'expanded' | 'onClick'> & { opens: Panel }) {
    return <Button {...props} expanded={panel.value === opens} onClick={() => togglePanel(opens)} />;
}
