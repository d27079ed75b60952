// Sharing: games as links (docs/share.md). Invariant: the clipboard is written only with a link that is
// whole; what follows '#' is never sent to a server.
import { signal } from '@preact/signals';
import { complain, showPanel, simulation, toast } from './model';
import { _ } from './words';

/** The link that the panel shows; '': it is being made. */
export const link = signal('');

/** The page's own address, as others are to open it; that of a file on a disk is nobody else's. */
function addressOf(payload: string): string {
    if (location.protocol === 'file:')
        return `skvalp:${payload}`;
    const address = new URL(location.href);
    address.search = '';
    address.hash = payload;
    return address.href;
}

export async function makeLink(): Promise<void> {
    link.value = '';
    try {
        link.value = addressOf(await simulation.share());
    } catch (error) {
        showPanel(null);
        complain(error instanceof Error ? error.message : String(error));
    }
}

/** To the clipboard; says that it was copied, or refused by the browser. */
export async function copyText(text: string, copied: string, refused: string): Promise<void> {
    try {
        await navigator.clipboard.writeText(text);
        toast(copied);
    } catch {
        complain(refused);
    }
}

export function copyLink(): Promise<void> {
    return copyText(link.value, _('The link was copied: paste it into a message'),
        _('The browser does not let the page write to the clipboard: copy the link by hand.'));
}

/** Opens the panel with a new link. */
export async function shareLink(): Promise<void> {
    showPanel('share');
    await makeLink();
}

export const canShare = 'share' in navigator;

/** By the browser's own dialog. */
export async function passOn(what: ShareData): Promise<void> {
    try {
        await navigator.share({ title: 'Skvalp', ...what });
    } catch {
        // Whoever closed the browser's dialog wanted nothing shared.
    }
}
