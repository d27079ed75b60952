// Makes lib/, the built part of the npm package: the modules with their description, the host's side as
// one script for browsers, and types. `npm pack` calls it.
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { build } from 'vite';

import { folder } from './modules.js';

const web = fileURLToPath(new URL('..', import.meta.url));
const lib = `${web}lib`;

rmSync(lib, { recursive: true, force: true });
/**
 * Whoever bundles the package is to find the addresses of its files as they stand: `new URL('./x', import.meta.url)`.
 * @type {import('vite').Plugin}
 */
const addresses = {
    name: 'addresses',
    enforce: 'pre',
    resolveId: (id) => (/\/interface\.js$/.test(id) ? { id: './interface.js', external: true } : null),
    transform: (code) => code.replaceAll('import.meta.url', '__SKV_HERE__'),
    renderChunk: (code) => code.replaceAll('__SKV_HERE__', 'import.meta.url'),
};
await build({
    configFile: false,
    root: web,
    logLevel: 'error',
    plugins: [addresses],
    build: {
        outDir: lib, target: 'es2022', emptyOutDir: false,
        lib: {
            entry: { skvalp: `${web}src/index.browser.js`, 'pool.worker': `${web}src/pool.worker.js` },
            formats: ['es'], fileName: (_, name) => `${name}.js`,
        },
    },
});
for (const file of ['skvalp.wasm', 'skvalp-threads.wasm', 'interface.js', 'interface.d.ts']) {
    copyFileSync(`${folder}/${file}`, `${lib}/${file}`);
}
copyFileSync(`${web}../LICENSE`, `${web}LICENSE`);
mkdirSync(`${lib}/types`);
copyFileSync(`${folder}/interface.d.ts`, `${lib}/types/interface.d.ts`);
const project = `${lib}/tsconfig.json`;
writeFileSync(project, JSON.stringify({
    extends: `${web}tsconfig.json`,
    compilerOptions: {
        noEmit: false, declaration: true, emitDeclarationOnly: true, checkJs: false, outDir: 'types',
        rootDir: `${web}src`, rootDirs: [`${web}src`, folder], typeRoots: [`${web}node_modules/@types`],
    },
    include: [], files: [`${web}src/index.node.js`, `${web}src/index.browser.js`],
}));
execFileSync(process.execPath, [`${web}node_modules/typescript/bin/tsc`, '-p', project],
    { stdio: ['ignore', 'inherit', 'inherit'] });
rmSync(project);
if (!readdirSync(`${lib}/types`).includes('index.node.d.ts')) {
    throw new Error('the types have gone elsewhere');
}
