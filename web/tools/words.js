// Words: makes modules of the app's translations, po/LANGUAGE.po, for vite: `virtual:words` loads a
// language when it is asked for. Invariant: a text is translated once, in po/; a language holds what the
// library's tables and messages say (gettext's comments tell those) and what the page's own
// sources say, no more.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

/** @param {string} line a quoted text of a .po file, with what stands before it */
function textOf(line) {
    return JSON.parse(line.slice(line.indexOf('"')));
}

/**
 * The entries of a .po file: what is translated, into what (several, if it has a plural), and whether
 * it comes from a table.
 * @param {string} text
 */
export function readPo(text) {
    /** @type {{ id: string, forms: string[], fromTable: boolean }[]} */
    const entries = [];
    for (const block of text.split(/\n\n+/)) {
        const entry = { id: '', forms: /** @type {string[]} */ ([]), fromTable: false };
        let into = '';
        for (const line of block.split('\n')) {
            const [word] = line.split(/[ "]/, 1);
            if (line.startsWith('#. ') && !line.startsWith('#. Translators'))
                entry.fromTable = true;
            if (!line || line.startsWith('#'))
                continue;
            into = word || into;
            if (into === 'msgid')
                entry.id += textOf(line);
            else if (into === 'msgstr' || into === 'msgstr[0]')
                entry.forms[0] = (entry.forms[0] ?? '') + textOf(line);
            else if (into === 'msgstr[1]')
                entry.forms[1] = (entry.forms[1] ?? '') + textOf(line);
        }
        if (entry.id && entry.forms[0])
            entries.push(entry);
    }
    return entries;
}

/** @param {string} folder of the page's sources */
function readSources(folder) {
    return readdirSync(folder, { recursive: true, encoding: 'utf8' })
        .filter((name) => /\.tsx?$/.test(name))
        .map((name) => readFileSync(join(folder, name), 'utf8'))
        .join('\n')
        .replaceAll("\\'", "'");
}

/**
 * @param {string} po the folder of the translations
 * @param {string} sources the folder of what uses them
 * @returns {import('vite').Plugin}
 */
export function words(po, sources) {
    const languages = readdirSync(po)
        .filter((name) => name.endsWith('.po'))
        .map((name) => name.slice(0, -3));
    return {
        name: 'words',
        resolveId: (id) => (id.startsWith('virtual:words') ? `\0${id}` : undefined),
        load(id) {
            if (id === '\0virtual:words') {
                const loaders = languages.map((name) => `'${name}': () => import('virtual:words/${name}')`);
                return `export const languages = { ${loaders.join(', ')} };`;
            }
            if (!id.startsWith('\0virtual:words/'))
                return undefined;
            const file = join(po, `${id.slice('\0virtual:words/'.length)}.po`);
            const own = readSources(sources);
            this.addWatchFile(file);
            const kept = readPo(readFileSync(file, 'utf8'))
                .filter((entry) => entry.fromTable || own.includes(entry.id.replaceAll('\n', '\\n')))
                .map((entry) => [entry.id, entry.forms.length > 1 ? entry.forms : entry.forms[0]]);
            const said = JSON.stringify(join(sources, 'ui/said.ts'));
            return `export { sayerOf } from ${said};\nexport default ${JSON.stringify(Object.fromEntries(kept))};`;
        },
    };
}
