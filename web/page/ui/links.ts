// Links: which texts are some (docs/share.md).
import { complain, simulation } from './model';
import { _ } from './words';

/** What a link holds, or what is left of it: after '#' of an address, or after "skvalp:". */
export function payloadOf(text: string): string | null {
    return /(?:#|^skvalp:)(\d+\..+)$/s.exec(text.trim())?.[1] ?? null;
}

export function openLinkText(text: string): void {
    const payload = payloadOf(text);
    if (payload)
        simulation.openLink(payload);
    else
        complain(_('There is no link to open on the clipboard: copy one whole, from skvalp: or https: on.'));
}
