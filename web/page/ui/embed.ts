// Embedding: what a page around this one may ask for (docs/embed.md); loaded where there is one.
// Invariant: whoever embeds can do no more than who plays; nothing is read from here that is not in
// the picture or its figures.
import { effect } from '@preact/signals';
import { showView } from './actions';
import { catalogue, simulation, state } from './model';
import { opened } from './reports';
import { payloadOf } from './links';
import { refusalOf } from './refusal';

/** Throws if it is none, or out of range. */
function numberOf(name: string, value: unknown, least = -Infinity, most = Infinity): number {
    if (typeof value !== 'number' || !Number.isFinite(value) || value < least || value > most)
        throw new Error(`'${name}' takes ${Number.isFinite(most) ? `a number from ${least} to ${most}` : 'a number'}`);
    return value;
}

/** What a parameter takes, as text; throws what is wrong with it. */
function parameterOf(path: unknown, value: unknown): [string, string] {
    const field = catalogue.parameters.find((known) => known.path === path);
    if (!field)
        throw new Error(`there is no parameter '${String(path)}'`);
    const text = String(value);
    const { type, choices, minimum, maximum } = field;
    const takes = type === 'choice' ? choices.includes(text)
        : type === 'boolean' ? /^(true|false)$/.test(text)
            : refusalOf(field, text) === null;
    if (!takes)
        throw new Error(`'${field.path}' does not take '${text}': ${choices.join(', ') || `${minimum} to ${maximum}`}`);
    return [field.path, text];
}

/** Requests, by what stands in `skvalp`; each takes the members of the message that it knows. */
const requests: Record<string, (data: Record<string, unknown>) => unknown> = {
    open: ({ scene }) => {
        if (!catalogue.scenes.some(({ name }) => name === scene))
            throw new Error(`there is no scene '${String(scene)}'`);
        const done = opened();
        simulation.open(String(scene));
        return done;
    },
    link: ({ link }) => {
        const done = opened();
        simulation.openLink(payloadOf(String(link)) ?? String(link));
        return done;
    },
    play: () => simulation.setPaused(false),
    pause: () => simulation.setPaused(true),
    step: () => simulation.stepOnce(),
    reset: () => simulation.reset(),
    seek: ({ frame }) => simulation.seek(numberOf('frame', frame, 0, Number.MAX_SAFE_INTEGER)),
    speed: ({ speed }) => simulation.setSpeed(numberOf('speed', speed, 0.1, 2)),
    gravity: ({ x, y }) => {
        const wanted = [numberOf('x', x), numberOf('y', y)] as const;
        simulation.takeOver(); // of a link that plays: whoever asks means it
        simulation.setGravity(...wanted);
    },
    set: ({ path, value }) => {
        const wanted = parameterOf(path, value);
        simulation.takeOver();
        simulation.set(...wanted);
    },
    view: ({ view }) => {
        if (!showView(view))
            throw new Error(`there is no view '${String(view)}'`);
    },
    share: () => simulation.share(),
};

async function answer(event: MessageEvent): Promise<void> {
    const data: unknown = event.data;
    if (typeof data !== 'object' || data === null || !('skvalp' in data))
        return;
    const { skvalp: name, id } = data as { skvalp: unknown; id?: unknown };
    const request = typeof name === 'string' && Object.hasOwn(requests, name) ? requests[name] : null;
    const reply = (content: object) =>
        (event.source as Window | null)?.postMessage({ skvalp: 'answer', id, ...content }, { targetOrigin: '*' });
    try {
        if (!request)
            throw new Error(`there is no request '${String(name)}'`);
        reply({ result: (await request(data as Record<string, unknown>)) ?? null });
    } catch (error) {
        reply({ error: error instanceof Error ? error.message : String(error) });
    }
}

/** Four times a second is enough for figures beside the picture. */
const PERIOD = 250;

export function serveEmbedding(): void {
    const tell = (content: object) => window.parent.postMessage(content, '*');
    let told = -Infinity;
    let late: number | undefined;
    window.addEventListener('message', (event) => {
        if (event.source === window.parent)
            void answer(event);
    });
    /** What came too soon after the last one is told later, as it is then. */
    function tellState(): void {
        const now = state.peek();
        const rest = told + PERIOD - performance.now();
        clearTimeout(late);
        if (!now?.worlds[0].name)
            return;
        if (rest > 0) {
            late = window.setTimeout(tellState, rest);
            return;
        }
        told = performance.now();
        const { time, particles, name, title, probes } = now.worlds[0];
        const readings = probes.map(({ id, channels }) => ({
            id,
            readings: channels.map((channel) => ({ name: channel.name, value: channel.value })),
        }));
        const { moment, paused, atRest } = now;
        tell({ skvalp: 'state', scene: name, title, time, moment, paused, atRest, particles, readings });
    }
    effect(() => {
        void state.value;
        tellState();
    });
    tell({ skvalp: 'ready', version: catalogue.version, scenes: catalogue.scenes.map(({ name }) => name) });
}
