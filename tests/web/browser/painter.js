// A page whose worker draws on its canvas (painter.worker.js), and how it is asked.

/**
 * @param {Awaited<ReturnType<typeof import('./harness.js').launch>>} browser
 * @param {{ width: number, height: number, isolated?: boolean, threads: number, refusing?: boolean }} options
 * @returns what came of the beginning, and `ask(deed, more)`: bytes come as a Buffer
 */
export async function openPainter(browser, { width, height, isolated, ...options }) {
    const page = await browser.open('/empty.html', { isolated });
    await page.evaluate(() => {
        const canvas = document.body.appendChild(document.createElement('canvas'));
        const worker = new Worker('/painter.worker.js', { type: 'module' });
        window.ask = ({ size, ...task }) => new Promise((resolve, reject) => {
            worker.onerror = (event) => reject(new Error(event.message ?? 'the worker did not load'));
            worker.onmessage = ({ data }) => {
                if (data.error) {
                    reject(new Error(data.error));
                } else {
                    resolve(data.result);
                }
            };
            if (size) {
                const surface = Object.assign(canvas, size).transferControlToOffscreen();
                worker.postMessage({ ...task, surface }, [surface]);
            } else {
                worker.postMessage(task);
            }
        });
    });
    /** @param {string} deed @param {object} [more] */
    const ask = async (deed, more = {}) => {
        const result = await page.evaluate(async (task) => {
            const result = await window.ask(task);
            const letters = (bytes) => Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
            return result instanceof Uint8Array ? { base64: btoa(letters(result)) } : result;
        }, { deed, ...more });
        return result?.base64 ? Buffer.from(result.base64, 'base64') : result;
    };
    const begun = await ask('begin', { size: { width, height }, ...options });
    return { ask, begun, close: () => page.context().close() };
}
