// Writes down what the page's module needs to export, and what of interface.js the page needs to know:
// whatever its sources name, for the host's side calls by name. The rest the linker leaves out.
//   node needed.js INTERFACE OUTPUT EXPORTS SOURCE... (a module; arguments for the linker)
//
// Invariant: a name stands whole in a source, or, of an enumeration's values, as `SKV_BEGINNING_${`; what
// a line of comment names is not needed for that.
import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [from, output, exports, ...sources] = process.argv.slice(2);
const { constants, functions, records } = await import(pathToFileURL(resolve(from)).href);
const text = sources.map((source) => readFileSync(source, 'utf8')).join('\n').replace(/^\s*(\/\/|\/?\*).*$/gm, '');
const words = new Set(text.match(/\w+/g));
const beginnings = Array.from(text.matchAll(/`(SKV_\w+_)\$\{/g), ([, beginning]) => beginning);

/** The entries that are kept. */
function pick(all, keep) {
    return Object.fromEntries(Object.entries(all).filter(([name]) => keep(name)));
}

/** The structures that a type consists of. */
function recordsIn(type) {
    return type.kind === 'record' ? [type.name] : type.kind === 'array' ? recordsIn(type.of) : [];
}

const called = pick(functions, (name) => words.has(name));
const known = new Set();
function know(name) {
    if (!known.has(name)) {
        known.add(name);
        membersOf(records[name]).forEach(([, member]) => recordsIn(member).forEach(know));
    }
}
function membersOf({ members }) {
    return Object.entries(members).filter(([name]) => words.has(name));
}
Object.keys(records).filter((name) => words.has(name)).forEach(know);
Object.values(called).flatMap(({ result }) => recordsIn(result)).forEach(know);

const parts = {
    constants: pick(constants, (name) => words.has(name) || beginnings.some((one) => name.startsWith(one))),
    // Of what goes in the names are for people alone.
    functions: Object.fromEntries(Object.entries(called).map(([name, { result, parameters }]) =>
        [name, { result, parameters: parameters.map(({ kind }) => ({ kind })) }])),
    records: Object.fromEntries(Array.from(known, (name) =>
        [name, { size: records[name].size, members: Object.fromEntries(membersOf(records[name])) }])),
};
writeFileSync(output, `// Made by web/tools/needed.js for the page.
${Object.entries(parts).map(([name, part]) => `export const ${name} = ${JSON.stringify(part)};\n`).join('')}`);
writeFileSync(exports, Object.keys(called).map((name) => `--export-if-defined=${name}\n`).join(''));
