// A worker of the pool: it comes in to compute, and never returns.
/** @import { Post } from './instance.js' */

/** @param {Post} post */
export function serve({ module, memory, stack }) {
    // It computes, no more: the host is its owner's.
    const refuse = () => {
        throw new Error('a worker of the pool asked for its host');
    };
    /** @type {Record<string, Record<string, any>>} */
    const imports = {};
    for (const entry of WebAssembly.Module.imports(module)) {
        (imports[entry.module] ??= {})[entry.name] = entry.kind === 'memory' ? memory : refuse;
    }
    const { exports } = new WebAssembly.Instance(module, imports);
    const { __stack_pointer: pointer, skv_wasm_serve: comeIn } = /** @type {any} */ (exports);
    pointer.value = stack;
    comeIn();
}
