// Writes down the public interface as a WebAssembly module has it: functions, enumerations, and
// where the members of each structure lie, all as clang sees the headers. Nothing of it is written
// by hand, so it cannot grow stale.
//   node interface.js CLANG-OPTION... OUTPUT (a module; its declarations go to OUTPUT's .d.ts)
import { execFileSync } from 'node:child_process';
import { readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const options = process.argv.slice(2, -1);
const output = process.argv.at(-1);
const headers = join(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../../include');
const source = readdirSync(join(headers, 'skvalp'))
    .map((name) => `#include "skvalp/${name}"\n`)
    .join('');

/** What clang says of all headers. */
function clang(...request) {
    const last = request.includes('-E') ? [] : ['-fsyntax-only'];
    const all = [...options, `-I${headers}`, ...request, ...last, '-x', 'c', '-'];
    return execFileSync('clang-19', all, { input: source, maxBuffer: 1 << 28, encoding: 'utf8' });
}

/** What a C type is to a host: a number type with its size, text, a pointer, a record or none. */
function classify(type) {
    const bare = type.replace(/\b(const|struct|union|enum|restrict)\b/g, '').replace(/\s+/g, ' ').trim();
    const array = /^(.*?)\[(\d+)\]((?:\[\d+\])*)$/.exec(bare);
    if (array) {
        return { kind: 'array', of: classify(array[1].trim() + array[3]), count: Number(array[2]) };
    }
    if (/\(\*?.*\)\(/.test(bare) || bare.includes('*')) {
        return { kind: /^char \*$/.test(bare) && /\bconst\b/.test(type) ? 'text' : 'pointer' };
    }
    const numbers = {
        'bool': 'bool', '_Bool': 'bool', 'char': 'i8', 'uint8_t': 'u8', 'int': 'i32', 'unsigned': 'u32',
        'unsigned int': 'u32', 'int32_t': 'i32', 'uint32_t': 'u32', 'size_t': 'u32',
        'skv_instrument': 'u32', 'skv_acting_id': 'u32', 'skv_body_id': 'u32', 'skv_particle_id': 'u32', 'int64_t': 'i64', 'uint64_t': 'u64', 'float': 'f32', 'double': 'f64',
        'void': 'void',
    };
    if (bare in numbers) {
        return { kind: numbers[bare] };
    }
    return enumerations.has(bare) ? { kind: 'i32' } : { kind: 'record', name: bare };
}

/** Walks over clang's tree: enumerations first, for the functions' types name them. */
const tree = JSON.parse(clang('-Xclang', '-ast-dump=json')).inner;
const constants = {};
const enumerations = new Set();
for (const node of tree) {
    if (node.kind === 'EnumDecl') {
        let value = -1;
        for (const entry of node.inner.filter((inner) => inner.kind === 'EnumConstantDecl')) {
            const given = entry.inner?.find((inner) => inner.kind === 'ConstantExpr');
            value = given ? Number(given.value) : value + 1;
            if (entry.name.startsWith('SKV_')) {
                constants[entry.name] = value;
            }
        }
    }
    if (node.kind === 'TypedefDecl' && node.inner?.[0]?.ownedTagDecl?.kind === 'EnumDecl') {
        enumerations.add(node.name);
    }
    if (node.kind === 'EnumDecl' && node.name) {
        enumerations.add(node.name);
    }
}
const functions = {};
for (const node of tree) {
    if (node.kind === 'FunctionDecl' && node.name.startsWith('skv_')) {
        const parameters = (node.inner ?? []).filter((inner) => inner.kind === 'ParmVarDecl');
        functions[node.name] = {
            result: classify(node.type.qualType.slice(0, node.type.qualType.indexOf('('))),
            parameters: parameters.map((inner) => ({ name: inner.name, ...classify(inner.type.qualType) })),
        };
    }
}

/** The numbers among the macros, such as SKV_MAX_HANDS or (1 << 20). */
const macro = /^#define (SKV_[A-Z0-9_]+) \(?(-?\d+)(?: << (\d+))?\)?$/gm;
for (const [, name, value, shift = 0] of clang('-dM', '-E').matchAll(macro)) {
    constants[name] = Number(value) * 2 ** Number(shift);
}

/** Where members lie: clang's own table, of which a member's members are indented further. */
const records = {};
for (const dump of clang('-Xclang', '-fdump-record-layouts-complete').split('*** Dumping AST Record Layout')) {
    const lines = dump.split('\n').map((line) => /^\s*(\d+)? \| ( *)(.*)$/.exec(line)).filter(Boolean);
    const head = /^(?:struct|union) (skv_\w+)$/.exec(lines[0]?.[3] ?? '');
    if (!head) {
        continue;
    }
    const members = {};
    let depth = 2;
    for (const [, offset, indent, text] of lines.slice(1)) {
        const size = /^\[sizeof=(\d+)/.exec(text);
        if (size) {
            records[head[1]] = { size: Number(size[1]), members };
        } else if (/^(struct|union) .*\(anonymous at [^)]*\)\s*$/.test(text) && indent.length === depth) {
            depth += 2; // its members are as good as those of the whole
        } else if (indent.length === depth) {
            const [, type, name] = /^(.*?)\s*(\w+)$/.exec(text);
            if (type.includes('(unnamed')) {
                continue; // nobody outside can speak of it
            }
            members[name] = { offset: Number(offset), ...classify(type) };
        }
    }
}

/** The type of a value in TypeScript. */
function typescript(type) {
    const simple = { bool: 'boolean', i64: 'bigint', u64: 'bigint', text: 'string', void: 'void' };
    return type.kind === 'record' ? type.name
        : type.kind === 'array' ? (type.of.kind === 'i8' ? 'string' : `Array<${typescript(type.of)}>`)
            : simple[type.kind] ?? 'number';
}

/** Of a function, as JavaScript calls it. */
function signature({ result, parameters }) {
    const goesIn = { text: 'string | number | null', pointer: 'number | Located | null', record: 'Located' };
    const all = parameters.map((parameter) => `${parameter.name}: ${goesIn[parameter.kind] ?? typescript(parameter)}`);
    return `(${all.join(', ')}): ${result.kind === 'text' ? 'string | null' : typescript(result)}`;
}

for (const type of Object.values(functions).flatMap(({ result, parameters }) => [result, ...parameters])) {
    // Nobody outside C has a va_list.
    if (type.kind === 'record' && !(type.name in records) && type.name !== 'va_list') {
        throw new Error(`interface.js: ${type.name} is neither a number that it knows nor a structure`);
    }
}
const json = (value) => JSON.stringify(value, null, 1);
writeFileSync(output, `// Made by web/tools/interface.js from include/skvalp.
export const constants = ${json(constants)};
export const functions = ${json(functions)};
export const records = ${json(records)};
`);
writeFileSync(output.replace(/\.js$/, '.d.ts'), `// Made by web/tools/interface.js from include/skvalp.
export type Kind = 'void' | 'bool' | 'i8' | 'u8' | 'i32' | 'u32' | 'i64' | 'u64' | 'f32' | 'f64'
    | 'text' | 'pointer' | 'record' | 'array';
export interface Type { kind: Kind; name?: string; of?: Type; count?: number }
export interface Member extends Type { offset: number }
export const constants: { ${Object.keys(constants).map((name) => `${name}: number`).join('; ')} };
export const functions: Record<keyof Functions, { result: Type; parameters: Type[] }>;
export const records: Record<keyof Records, { size: number; members: Record<string, Member> }>;
/** What a record is made of; each also has its address. */
export interface Located { readonly address: number }
${Object.entries(records).map(([name, { members }]) => `export interface ${name} extends Located {
${Object.entries(members).map(([member, type]) => `    ${member}: ${typescript(type)};\n`).join('')}}
`).join('')}
export interface Records {
${Object.keys(records).map((name) => `    ${name}: ${name};\n`).join('')}}
/** The public functions. A pointer is a number, 0 for null; a structure goes in as a record. */
export interface Functions {
${Object.entries(functions).map(([name, type]) => `    ${name}${signature(type)};\n`).join('')}}
`);
