// Panel: a sheet that rises from below on phones, a column beside the water on wide screens. Invariant:
// one is open at most; the focus goes into it when it opens, and back to where it was once it closes.
import type { ComponentType } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { Button } from './Button';
import { compared, panel, showPanel, subject } from './model';
import type { Panel as Which } from './model';
import { later } from './later';
import { Scenes } from './Scenes';
import { _ } from './words';

/** Titles and contents; what is not needed at once is loaded when it opens. */
const panels: Record<Which, { title: () => string; Content: ComponentType }> = {
    scenes: { title: () => _('Scenes and experiments'), Content: Scenes },
    experiment: { title: () => _('Experiments'), Content: later(() => import('./Lab')) },
    views: { title: () => _('What is shown'), Content: later(() => import('./Views')) },
    properties: { title: () => _('Properties'), Content: later(() => import('./Properties')) },
    measure: { title: () => _('Measure'), Content: later(() => import('./Measure')) },
    probe: { title: () => _('Measurements'), Content: later(() => import('./ProbeCard')) },
    compare: { title: () => _('Compare Two Worlds'), Content: later(() => import('./Compare')) },
    menu: { title: () => _('Main menu'), Content: later(() => import('./Menu')) },
    size: { title: () => _('Size of the tool'), Content: later(() => import('./Size')) },
    pace: { title: () => _('How fast it goes'), Content: later(() => import('./Pace')) },
    share: { title: () => _('Share'), Content: later(() => import('./Share')) },
    settings: { title: () => _('Preferences'), Content: later(() => import('./Settings')) },
    keys: { title: () => _('Keyboard Shortcuts'), Content: later(() => import('./Keys')) },
    about: { title: () => _('About Skvalp'), Content: later(() => import('./About')) },
    bench: { title: () => _('How fast this device is'), Content: later(() => import('./Bench')) },
    photo: { title: () => _('A scene from a photo'), Content: later(() => import('./Photo')) },
};

/** Where Back leads from a panel that another one opens. */
const above: Partial<Record<Which, Which>> = {
    experiment: 'scenes',
    share: 'menu',
    settings: 'menu',
    keys: 'menu',
    about: 'menu',
    bench: 'about',
    compare: 'menu',
};

export function Panel() {
    const which = panel.value;
    const dialog = useRef<HTMLDialogElement>(null);
    const before = useRef<HTMLElement | null>(null);
    const open = which !== null;
    useLayoutEffect(() => {
        if (open)
            before.current = document.activeElement as HTMLElement | null;
        else if (document.activeElement === document.body || !document.activeElement)
            before.current?.focus();
    }, [open]);
    // Before the browser paints: a panel in another's place would show where that one was scrolled to.
    useLayoutEffect(() => {
        dialog.current?.querySelector<HTMLElement>('h2')?.focus({ preventScroll: true });
        dialog.current?.scrollTo(0, 0);
    }, [which, subject.value]);
    if (!which)
        return null;
    const { title, Content } = panels[which];
    const back = above[which];
    return (
        <dialog
            ref={dialog}
            open
            class={`panel panel-${which} ${compared.value ? 'two' : ''}`}
            aria-labelledby="panel-title"
        >
            <div class="panel-head">
                {back && <Button icon="back" name={_('Back')} onClick={() => showPanel(back)} />}
                <h2 id="panel-title" tabIndex={-1}>
                    {title()}
                </h2>
                <Button icon="close" name={_('Close')} hint={_('Esc')} onClick={() => showPanel(null)} />
            </div>
            <div class="panel-body">
                <Content />
            </div>
        </dialog>
    );
}
