// uPlot for the built page, without what its plots do not use: ways to draw a curve, which are 2 KB, and a number
// format, which it makes of the browser's language as it is loaded. Some browsers call theirs C, which is none, and
// then there were no plots: WebKitGTK does, where the system has no language.

/** What stands there, and what takes its place. */
const changes = [
    ['new Intl.NumberFormat(domEnv ? nav.language : \'en-US\')', 'new Intl.NumberFormat()'],
    ['(paths.stepped = stepped);', ''],
    ['(paths.bars    = bars);', ''],
    ['(paths.spline  = monotoneCubic);', ''],
];

/** @returns {import('vite').Plugin} */
export function plots() {
    return {
        name: 'plots',
        apply: 'build',
        transform(code, id) {
            if (!/uPlot\.esm\.js$/.test(id)) {
                return null;
            }
            return {
                code: changes.reduce((left, [there, instead]) => {
                    if (!left.includes(there)) {
                        this.error(`uPlot has no '${there}' now`);
                    }
                    return left.replace(there, instead);
                }, code),
                map: null,
            };
        },
    };
}
