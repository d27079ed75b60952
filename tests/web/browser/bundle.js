// Makes one script of a module and all that it imports, as a page is built: browsers know no packages.
// Arguments: the folder it goes to, the modules.
import { createRequire } from 'node:module';
import { basename } from 'node:path';
import { pathToFileURL } from 'node:url';

const fromWeb = createRequire(new URL('../../../web/package.json', import.meta.url));
const { build } = await import(pathToFileURL(fromWeb.resolve('vite')).href);

const { alias } = await import('../../../web/tools/modules.js');
const [folder, ...modules] = process.argv.slice(2);
await build({
    configFile: false,
    root: new URL('.', import.meta.url).pathname,
    base: './',
    resolve: { alias },
    logLevel: 'error',
    worker: { format: 'es' },
    build: {
        outDir: folder, target: 'es2022', minify: false, emptyOutDir: false,
        rollupOptions: {
            input: Object.fromEntries(modules.map((module) => [basename(module).replace(/\.[jt]s$/, ''), module])),
            output: { entryFileNames: '[name].js' },
        },
    },
});
