// The script of the page of one file (tools/single.js), and of each of its workers: which one it is to be
// the address says, after its '#'.
const roles: Record<string, () => Promise<unknown>> = {
    '': () => import('../main'),
    '#simulation': () => import('../simulation/simulation.worker'),
    '#bench': () => import('../simulation/bench.worker'),
    '#lab': () => import('../simulation/lab.worker'),
};

void roles[typeof document === 'undefined' ? location.hash : '']();

export {};
