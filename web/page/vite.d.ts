/// <reference types="vite/client" />

declare module 'virtual:words' {
    /** The languages besides English: what loads their words. */
    export const languages: Record<string, () => Promise<{
        default: Record<string, string | string[]>;
        sayerOf: (words: ReadonlyMap<string, string | string[]>) => (english: string) => string;
    }>>;
}
