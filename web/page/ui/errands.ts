// Errands: what is measured in a worker of its own, and what is said where that cannot be.
import { _ } from './words';

/** Begins one; what it returns ends it. Whether it cannot be begun is told as if it had failed. */
export function beginErrand(begin: () => () => void, fail: (why: string) => void): (() => void) | null {
    try {
        return begin();
    } catch {
        fail(_('This browser has no workers, without which nothing is measured: take a newer one, or another.'));
        return null;
    }
}

/** What is said of a failed one. */
export function wordsOfFailure(error: string): string {
    return error || _('This could not be loaded: is there a network?');
}
