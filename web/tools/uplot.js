// uPlot for the built page, without what its plots do not use: ways to draw a curve, axes of dates and logarithms,
// which are 4 KB, and a number format, which it makes of the browser's language as it is loaded. Some browsers call theirs C, which is none, and
// then there were no plots: WebKitGTK does, where the system has no language.

/** What stands there, and what takes its place. */
const changes = [
    ['new Intl.NumberFormat(domEnv ? nav.language : \'en-US\')', 'new Intl.NumberFormat()'],
    ['(paths.stepped = stepped);', ''],
    ['(paths.bars    = bars);', ''],
    ['(paths.spline  = monotoneCubic);', ''],
];

/** Functions for axes that no plot has, and what they return. */
const unused = {
    genTimeStuffs: '[[], [], () => []]', fmtDate: "() => ''", tzDate: 'date', timeAxisStamps: '[]',
    timeAxisVals: '() => []', timeAxisVal: '() => []', timeSeriesVal: "() => ''",
    logAxisSplits: '[]', asinhAxisSplits: '[]', log10AxisValsFilt: 'splits', log2AxisValsFilt: 'splits',
    rangeLog: '[min, max]', rangeAsinh: '[min, max]',
};

/** @param {string} code */
function emptied(code) {
    return Object.entries(unused).map(([name, value]) => {
        const there = new RegExp(`^function ${name}\\(.*\\{$`, 'm').exec(code)?.[0] ?? `function ${name}(`;
        return [there, `${there} return ${value};`];
    });
}

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
                code: [...changes, ...emptied(code)].reduce((left, [there, instead]) => {
                    if (!left.includes(there)) {
                        this.error(`uPlot has no '${there}' now`);
                    }
                    return left.replace(there, () => instead);
                }, code),
                map: null,
            };
        },
    };
}
