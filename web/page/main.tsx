// The page's start: the canvas goes to the simulation, what the address says is opened, and the page
// follows what the simulation tells.
import { effect, signal } from '@preact/signals';
import { render } from 'preact';
import { connect } from './simulation/connect';
import type { Listener } from './simulation/protocol';
import './style.css';
import { applyPreferences } from './ui/actions';
import { readAddress } from './ui/address';
import { App } from './ui/App';
import { keepAwake } from './ui/device';
import { followHistory } from './ui/history';
import { attachKeys } from './ui/keys';
import { begin, complain, controls, framed, part, simulation, state, trouble } from './ui/model';
import { preferences } from './ui/preferences';
import { listenToReports } from './ui/reports';
import { language, preferred, speak } from './ui/words';

const canvas = document.createElement('canvas');
const address = readAddress();

const listener: Listener = {
    state: (now) => (state.value = now),
    report: listenToReports,
    picture: (what) => (trouble.value = what),
};

/** What is done again whenever what it reads has changed. */
function follow(): void {
    effect(applyPreferences);
    const plays = part((now) => !now.paused && !now.atRest, false);
    const hidden = signal(document.hidden);
    effect(() => void keepAwake(plays.value && !hidden.value));
    effect(() => simulation.setHidden(hidden.value));
    document.addEventListener('visibilitychange', () => (hidden.value = document.hidden));
    window.addEventListener('hashchange', () => address.openAsked());
    followHistory();
}

async function start(): Promise<void> {
    const connecting = connect(canvas, listener); // while the page is drawn for the first time
    effect(() => void speak(address.language || preferences.value.language || preferred()));
    effect(() => void (document.documentElement.lang = language.value));
    render(<App canvas={canvas} />, document.getElementById('page')!);
    attachKeys();
    const simulation = await connecting;
    begin(simulation, await simulation.catalogue());
    Object.assign(window, { skvalp: { simulation, state } }); // for scripts, see docs/embed.md
    follow();
    // Once the stage has its size; what a page around this one asks for comes after what it opens with.
    requestAnimationFrame(() => requestAnimationFrame(() => {
        address.open();
        if (framed)
            void import('./ui/embed').then(({ serveEmbedding }) => serveEmbedding());
        else if (controls.value === 'all')
            void import('./ui/keeping').then(({ beginKeeping }) => beginKeeping(!location.hash));
    }));
}

start().catch((error: unknown) => complain(error instanceof Error ? error.message : String(error)));
