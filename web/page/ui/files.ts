// Files: what is saved goes to the browser's downloads.
import { complain, simulation, toast, world } from './model';
import { _ } from './words';

export function download(bytes: BlobPart, type: string, name: string): void {
    const address = URL.createObjectURL(new Blob([bytes], { type }));
    const link = document.createElement('a');
    link.href = address;
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000); // the browser may ask where to first
}

const types = {
    skv: 'application/octet-stream',
    skvr: 'application/octet-stream',
    csv: 'text/csv',
    png: 'image/png',
};

/** The name of what is open, as a file's. */
export function fileName(ending: string): string {
    return `${(world.value?.name ?? '').replace(/[^\p{L}\p{N}-]+/gu, '-') || 'skvalp'}.${ending}`;
}

export async function saveFile(what: keyof typeof types): Promise<void> {
    try {
        const bytes = await simulation.save(what);
        download(bytes as Uint8Array<ArrayBuffer>, types[what], fileName(what));
        if (what === 'png')
            toast(_('The picture was saved'));
    } catch (error) {
        complain(error instanceof Error ? error.message : String(error));
    }
}
