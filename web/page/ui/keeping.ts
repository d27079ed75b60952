// Keeping: what is open is kept in the browser, since a page that is reloaded, or that a phone ends, loses it;
// what was kept is offered at the next visit, the newest first, and never opened unasked. Invariant: a tab writes
// over what it has written itself or has gone on with, so tabs keep a world each; a browser that keeps nothing
// does not hinder the page.
import { signal } from '@preact/signals';
import { dismiss, propose, showPanel, simulation, toast, world } from './model';
import { opened } from './reports';
import { _, say, word } from './words';

/** ms: a third of the app's half minute, for a page that ends is given no time. */
const PERIOD = 10_000;
const NAME = 'kept';

/** Worlds: of those left behind earlier nobody remembers which is which. As in the app. */
const MOST = 8;

interface Kept {
    key: IDBValidKey;
    title: string;
    bytes: Uint8Array;
}

/** From before this visit; null: nothing. */
export const offered = signal<Kept | null>(null);
let busy = false;
/** Where this tab's world is; null: nowhere yet. Keys are in the order of time. */
let own: IDBValidKey | null = null;

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

/** The newest; or the next older one. */
async function find(than?: IDBValidKey): Promise<Kept | null> {
    const cursor = await inStore('readonly', (store) =>
        store.openCursor(than === undefined ? null : IDBKeyRange.upperBound(than, true), 'prev')).catch(() => null);
    if (!cursor)
        return null;
    // What is no world is refused once it is to be opened.
    const { title, bytes } = cursor.value as Partial<Kept>;
    return { key: cursor.key, title: String(title ?? ''), bytes: bytes instanceof Uint8Array ? bytes : new Uint8Array(1) };
}

function write(value: Omit<Kept, 'key'>, key: IDBValidKey, before: IDBValidKey | null) {
    return inStore('readwrite', (store) => {
        if (before !== null)
            store.delete(before);
        const put = store.put(value, key), all = store.getAllKeys();
        all.onsuccess = () => all.result.slice(0, -MOST).forEach((old) => store.delete(old));
        return put;
    });
}

async function keep(): Promise<void> {
    if (busy)
        return;
    busy = true;
    try {
        const title = world.value?.title ?? '', before = own, key = [Date.now(), Math.random()];
        const bytes = await simulation.keep();
        if (bytes) {
            await write({ title, bytes }, key, before);
            own = own === before ? key : own;
        }
    } catch {
        // There is no room, or nobody may keep anything here.
    }
    busy = false;
}

/** What the tab has is kept before, where it was so far. */
export function goOn(): void {
    const { key, title, bytes } = offered.value!;
    offered.value = null;
    dismiss();
    showPanel(null);
    void keep();
    simulation.openKept(bytes, title || NAME);
    opened().then(() => void (own = key), () => {
        toast(_('What was kept from last time is damaged; it is gone.'));
        return inStore('readwrite', (store) => store.delete(key)).catch(() => {});
    }).then(async () => (offered.value = await find(key)));
}

/** @param offers says that something was kept */
export async function beginKeeping(offers: boolean): Promise<void> {
    const found = await find();
    offered.value = found;
    if (found && offers)
        propose(found.title ? say(_('Kept: %s'), word(found.title)) : _('Your last world was kept'), _('Go On There'), goOn);
    setInterval(keep, PERIOD);
    document.addEventListener('visibilitychange', () => void (document.hidden && keep()));
    window.addEventListener('pagehide', keep);
}
