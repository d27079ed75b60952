// Keys: what the keyboard and fingers do, in a table.
import { catalogue } from './model';
import { N_, _, word } from './words';

const sections: { title: string; rows: [string, string][] }[] = [
    {
        title: N_('Playback'),
        rows: [
            [N_('Play or pause'), N_('Space')],
            [N_('One step of 1/60 s'), '. S'],
            [N_('One step back'), ','],
            [N_('A second back, a second on'), '⇧← ⇧→'],
            [N_('Back to the start of the scene'), 'R'],
            [N_('Slower and faster'), '− +'],
            [N_('Undo and redo'), N_('Ctrl+Z, Shift+Ctrl+Z')],
            [N_('Stopwatch: start and stop, lap'), 'W L'],
        ],
    },
    {
        title: N_('Tools'),
        rows: [
            [N_('Smaller and larger'), '[ ]'],
            [N_('A pressure probe'), 'M'],
            [N_('A hand for the keyboard: arrow keys move it'), 'K'],
            [N_('Close that hand, and open it'), N_('Return')],
        ],
    },
    {
        title: N_('Fingers'),
        rows: [
            [N_('Use the tool, each as a hand'), N_('One finger, and more beside it')],
            [N_('Move the picture, and zoom it'), N_('Two fingers that come down together')],
            [N_('Undo'), N_('A tap of three fingers')],
        ],
    },
    {
        title: N_('Gravity'),
        rows: [
            [N_('Point it that way, until another key is pressed'), '← → ↑ ↓'],
            [N_('Switch it off'), '0'],
        ],
    },
    {
        title: N_('View'),
        rows: [
            [N_('What is shown'), 'V'],
            [N_('White tracers'), 'T'],
            [N_('Zoom in and out'), N_('Ctrl++, Ctrl+−, wheel')],
            [N_('All of it'), 'Ctrl+0'],
            [N_('Full screen'), 'F'],
            [N_('Scenes and experiments'), 'G'],
            [N_('Properties'), 'P'],
        ],
    },
    {
        title: N_('General'),
        rows: [
            [N_('Save a state or a replay'), 'Ctrl+S'],
            [N_('Save a picture'), 'Ctrl+P'],
            [N_('Compare two worlds, or close the second'), 'C'],
            [N_('Open a link from the clipboard'), 'Ctrl+V'],
            [N_('Leave what was entered last'), 'Esc'],
            [N_('Keyboard shortcuts'), '?'],
        ],
    },
];

function Section({ title, rows }: { title: string; rows: [string, string][] }) {
    return (
        <table class="keys">
            <caption>{word(title)}</caption>
            <tbody>
                {rows.map(([what, keys]) => (
                    <tr key={what}>
                        <th scope="row">{word(what)}</th>
                        <td>{word(keys)}</td>
                    </tr>
                ))}
            </tbody>
        </table>
    );
}

export default function Keys() {
    const tools = catalogue.tools.map(({ title, key }): [string, string] => [title, key]);
    return (
        <>
            {sections.map(({ title, rows }) => (
                <Section key={title} title={title} rows={title === 'Tools' ? [...tools, ...rows] : rows} />
            ))}
            <p class="caption">{_('Keys without Ctrl can be switched off in the preferences.')}</p>
        </>
    );
}
