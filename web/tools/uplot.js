// uPlot for the built page: without a number format of its own, which the page's plots do not use, and which it
// makes of the browser's language as it is loaded. Some browsers call theirs C, which is none, and then there were no
// plots: WebKitGTK does, where the system has no language.

const made = 'new Intl.NumberFormat(domEnv ? nav.language : \'en-US\')';

/** @returns {import('vite').Plugin} */
export function plots() {
    return {
        name: 'plots',
        apply: 'build',
        transform(code, id) {
            if (!/uPlot\.esm\.js$/.test(id)) {
                return null;
            }
            if (!code.includes(made)) {
                this.error('uPlot makes its number format in another way now');
            }
            return { code: code.replace(made, 'new Intl.NumberFormat()'), map: null };
        },
    };
}
