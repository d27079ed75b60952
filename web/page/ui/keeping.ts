// Keeping: what is open is kept in the browser, since a page that is reloaded, or that a phone ends, loses it;
// what was kept is offered at the next visit, and never opened unasked. Invariant: what is offered stays what it
// was, though this visit is kept in its place; a browser that keeps nothing does not hinder the page.
import { signal } from '@preact/signals';
import { dismiss, propose, showPanel, simulation, toast, world } from './model';
import { opened } from './reports';
import { _, say, word } from './words';

/** ms: a third of the app's half minute, for a page that ends is given no time. */
const PERIOD = 10_000;
const NAME = 'kept';

interface Kept {
    title: string;
    bytes: Uint8Array;
}

/** From before this visit; null: nothing. */
export const offered = signal<Kept | null>(null);
let busy = false;

function inStore<T>(mode: IDBTransactionMode, ask: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
    return new Promise((resolve, reject) => {
        const opening = indexedDB.open('skvalp');
        opening.onupgradeneeded = () => opening.result.createObjectStore(NAME);
        opening.onerror = () => reject(opening.error);
        opening.onsuccess = () => {
            const database = opening.result;
            const transaction = database.transaction(NAME, mode);
            const asked = ask(transaction.objectStore(NAME));
            const end = (settle: () => void) => () => {
                database.close();
                settle();
            };
            transaction.oncomplete = end(() => resolve(asked.result));
            transaction.onabort = end(() => reject(transaction.error));
        };
    });
}

async function keep(): Promise<void> {
    if (busy)
        return;
    busy = true;
    try {
        const title = world.value?.title ?? '';
        const bytes = await simulation.keep();
        if (bytes)
            await inStore('readwrite', (store) => store.put({ title, bytes }, NAME));
    } catch {
        // There is no room, or nobody may keep anything here.
    }
    busy = false;
}

export function goOn(): void {
    const { title, bytes } = offered.value!;
    offered.value = null;
    dismiss();
    showPanel(null);
    simulation.openKept(bytes, title || NAME);
    opened().catch(() => {
        toast(_('What was kept from last time is damaged; it is gone.'));
        inStore('readwrite', (store) => store.delete(NAME)).catch(() => {});
    });
}

/** @param offers says that something was kept */
export async function beginKeeping(offers: boolean): Promise<void> {
    const found: Partial<Kept> | undefined = await inStore('readonly', (store) => store.get(NAME)).catch(() => undefined);
    if (found) {
        const title = String(found.title ?? '');
        // What is no world is refused once it is to be opened.
        offered.value = { title, bytes: found.bytes instanceof Uint8Array ? found.bytes : new Uint8Array(1) };
        if (offers)
            propose(title ? say(_('Kept: %s'), word(title)) : _('Your last world was kept'), _('Go On There'), goOn);
    }
    setInterval(keep, PERIOD);
    document.addEventListener('visibilitychange', () => void (document.hidden && keep()));
    window.addEventListener('pagehide', keep);
}
