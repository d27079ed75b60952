// The service worker: keeps the page for where there is no network, and isolates it on servers that
// cannot, so that memory can be shared by workers. tools/offline.js writes down what there is to keep.
//
// Invariant: a page gets all its files of one version. A new version is fetched whole beside the old
// one, which stays for pages that are still open, until another has come.
const version = '@version';
/** Relative to this script; of names with a hash in assets/. */
const files = ['@files'];
/** Kept if the page has used them: the module without threads, where those cannot be had, and those with bodies. */
const ifUsed = ['@ifUsed'];

const prefix = 'skvalp ';
const own = prefix + version;
const start = new URL('./', location.href).href;

/** Puts all files into a cache; those of an older version that are the same are not fetched again. */
async function keep() {
    const cache = await caches.open(own);
    const put = async (/** @type {string} */ file, /** @type {RequestCache} */ from) => {
        const url = new URL(file, start).href;
        const known = file.startsWith('assets/') ? await caches.match(url) : undefined;
        const response = known ?? await fetch(url, { cache: from, mode: 'same-origin' });
        if (!response.ok) {
            throw new Error(`${url}: ${response.status}`);
        }
        await cache.put(url, response);
    };
    try {
        await Promise.all(files.map((file) => put(file, 'no-cache')));
    } catch (error) {
        await caches.delete(own); // nothing half kept: the next visit tries again
        throw error;
    }
    await Promise.allSettled(ifUsed.map((file) => put(file, 'only-if-cached')));
}

/** Only the version before stays. */
async function tidy() {
    const versions = (await caches.keys()).filter((name) => name.startsWith(prefix) && name !== own);
    await Promise.all(versions.slice(0, -1).map((name) => caches.delete(name)));
}

/**
 * With the headers that isolate; in a frame they do no more than let it into pages that have them.
 * @param {Response} response
 */
function isolated(response) {
    const headers = new Headers(response.headers);
    headers.set('Cross-Origin-Opener-Policy', 'same-origin');
    headers.set('Cross-Origin-Embedder-Policy', 'require-corp');
    headers.set('Cross-Origin-Resource-Policy', 'same-origin');
    const { status, statusText } = response;
    return new Response(response.body, { headers, status, statusText });
}

/** The address that a file is kept under; null: it is none of the page's. @param {string} url */
function nameOf(url) {
    const bare = url.replace(/[?#].*$/, '');
    const own = bare.startsWith(start) ? bare.slice(start.length) : null;
    return own === '' || own === 'index.html' ? start : own?.startsWith('assets/') || files.includes(own ?? '') ? bare : null;
}

/** @param {Request} request @param {string} name */
async function answer(request, name) {
    const cache = await caches.open(own);
    const kept = await cache.match(name) ?? await caches.match(name);
    if (kept) {
        return isolated(kept);
    }
    const response = await fetch(request);
    if (response.ok && ifUsed.some((file) => name === new URL(file, start).href)) {
        await cache.put(name, response.clone()).catch(() => {}); // there may be no room
    }
    return response.type === 'basic' ? isolated(response) : response;
}

const worker = /** @type {any} */ (self);
worker.addEventListener('install', (/** @type {any} */ event) => {
    worker.skipWaiting();
    event.waitUntil(keep());
});
worker.addEventListener('activate', (/** @type {any} */ event) => {
    event.waitUntil(tidy().then(() => worker.clients.claim()));
});
worker.addEventListener('fetch', (/** @type {any} */ event) => {
    const name = nameOf(event.request.url);
    if (event.request.method === 'GET' && name) {
        event.respondWith(answer(event.request, name));
    }
});
