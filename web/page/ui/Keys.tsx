// Keys: what the keyboard and fingers do, in a table.
import { actions } from './keys';
import { catalogue } from './model';
import { _, word } from './words';

const signs: Record<string, string> = { Left: '←', Right: '→', Up: '↑', Down: '↓', '-': '−' };

/** "Ctrl+Z" of "Ctrl+z"; gestures and long names are translated. */
function shown(key: string): string {
    const [, held, name] = /^((?:Ctrl\+|Shift\+)*)(.+)$/.exec(key)!;
    return held + (signs[name] ?? (name.length === 1 ? name.toUpperCase() : word(name)));
}

function Section({ title, rows }: { title: string; rows: Map<string, string[]> }) {
    return (
        <table class="keys">
            <caption>{word(title)}</caption>
            <tbody>
                {[...rows].map(([what, keys]) => (
                    <tr key={what}>
                        <th scope="row">{word(what)}</th>
                        <td>{keys.map(shown).join(keys.some((key) => key.length > 2) ? ', ' : ' ')}</td>
                    </tr>
                ))}
            </tbody>
        </table>
    );
}

export default function Keys() {
    const sections = new Map<string, Map<string, string[]>>();
    for (const { section, title, key, action } of catalogue.keys) {
        const rows = sections.get(section) ?? new Map<string, string[]>(
            section === 'Tools' ? catalogue.tools.map((tool) => [tool.title, [tool.key]]) : []);
        sections.set(section, rows);
        if (title && (!action || action in actions))
            rows.set(title, [...(rows.get(title) ?? []), key]);
    }
    return (
        <>
            {[...sections].map(([title, rows]) => (
                <Section key={title} title={title} rows={rows} />
            ))}
            <p class="caption">{_('Keys without Ctrl can be switched off in the preferences.')}</p>
        </>
    );
}
