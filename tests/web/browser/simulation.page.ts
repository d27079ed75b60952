// A page with nothing but a simulation on a canvas that fills it, for simulation.js to ask.
import { connect } from '../../../web/page/simulation/connect';
import { runExperiment } from '../../../web/page/simulation/lab';
import type { LabMessage, Report, Simulation, State } from '../../../web/page/simulation/protocol';

interface Trial {
    simulation: Simulation;
    states: number;
    state: State | null;
    reports: Report[];
    pictures: (string | null)[];
    /** Resolves with the first state of which this holds. */
    until(holds: (state: State) => boolean): Promise<State>;
    lab(index: number, particles: number): Promise<LabMessage[]>;
}

const canvas = document.createElement('canvas');
canvas.style.cssText = 'position: fixed; inset: 0; width: 100vw; height: 100vh';
document.body.append(canvas);

const waiting: { holds: (state: State) => boolean; resolve: (state: State) => void }[] = [];
const trial: Partial<Trial> & Pick<Trial, 'states' | 'reports' | 'pictures' | 'state'> = {
    states: 0, state: null, reports: [], pictures: [],
};
Object.assign(window, { trial });
trial.until = (holds) => trial.state && holds(trial.state) ? Promise.resolve(trial.state)
    : new Promise((resolve) => waiting.push({ holds, resolve }));
trial.lab = (index, particles) => new Promise((resolve) => {
    const messages: LabMessage[] = [];
    runExperiment(index, particles, (message) => {
        messages.push(message);
        if (message.kind !== 'moment') {
            resolve(messages);
        }
    });
});
trial.simulation = await connect(canvas, {
    state(state) {
        trial.states++;
        trial.state = state;
        for (const one of waiting.filter(({ holds }) => holds(state))) {
            waiting.splice(waiting.indexOf(one), 1);
            one.resolve(state);
        }
    },
    report: (report) => trial.reports.push(report),
    picture: (trouble) => trial.pictures.push(trouble),
});
trial.simulation.setView(innerWidth, innerHeight, devicePixelRatio);
Object.assign(window, { ready: true });
