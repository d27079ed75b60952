// Asked: what an address asks for that the page can begin without. Invariant: a value that is none is named with
// what can be had in its place. A first visit, which asks for nothing, does not fetch it.
import { LARGEST, SMALLEST } from './benching';
import { catalogue, complain, message, showPanel } from './model';
import { refusalOf } from './refusal';
import { _, known, say } from './words';

const names = (of: { name: string }[]) => of.map(({ name }) => name);

/** A sentence as a part of another. */
const within = (sentence: string) => sentence.charAt(0).toLowerCase() + sentence.slice(1).replace(/\.$/, '');

/** Of whole numbers; an empty text asks for none. */
const numbers = (minimum: number, maximum: number) => (value: string) =>
    value && within(refusalOf({ type: 'integer', minimum, maximum }, value) ?? '');

const oneOf = (choices: string[]) => (value: string) =>
    choices.includes(value) ? null : say(_('there is none; there is %s'), choices.join(', '));

/** When the water is there, or a fault of the link's is told, which stays. */
export function answer(asked: URLSearchParams): void {
    if (asked.has('bench'))
        showPanel('bench');
    const { scenes, views, sceneFields, amounts } = catalogue;
    const checks: Record<string, (value: string) => string | null> = {
        scene: oneOf(names(scenes)),
        view: oneOf(names(views)),
        lang: oneOf(known),
        controls: oneOf(['all', 'play', 'none']),
        paused: oneOf(['0', '1']),
        embed: oneOf(['0', '1']),
        particles: numbers(sceneFields.find(({ path }) => path === 'particles')!.minimum, amounts.at(-1)!),
        bench: numbers(SMALLEST, LARGEST),
    };
    const complaints = Object.entries(checks).flatMap(([name, check]) => {
        const value = asked.get(name), wrong = value === null ? null : check(value);
        return wrong ? `${name}=${value!.slice(0, 40)}: ${wrong}` : [];
    });
    if (complaints.length === 0)
        return;
    const text = `${_('What this address asks for cannot be had:')} ${complaints.join('; ')}`, told = message.peek();
    complain(told?.fault ? `${told.text}. ${text}` : text);
}
