// Later: a component whose code is loaded when it is first shown.
import { signal } from '@preact/signals';
import type { ComponentType } from 'preact';
import { useEffect } from 'preact/hooks';
import { _ } from './words';

/** @param quiet nothing is said in its place meanwhile */
export function later(load: () => Promise<{ default: ComponentType }>, quiet = false): ComponentType {
    const loaded = signal<ComponentType | null>(null);
    const failed = signal(false);
    return function Later() {
        useEffect(() => {
            if (!loaded.value)
                load().then(
                    (module) => (loaded.value = module.default),
                    () => (failed.value = true),
                );
        }, []);
        const Content = loaded.value;
        if (Content)
            return <Content />;
        return quiet ? null : <p>{failed.value ? _('This could not be loaded: is there a network?') : _('Loading…')}</p>;
    };
}
