// History: the browser's Back closes what is open. Invariant: an entry stands for an open panel, and for one alone;
// a panel that is closed by hand takes its entry with it.
import { effect } from '@preact/signals';
import { framed, panel, showPanel } from './model';

const isEntered = () => history.state?.panel === true;

function settle(): void {
    const open = panel.peek() !== null;
    if (open && !isEntered())
        history.pushState({ panel: true }, '');
    else if (!open && isEntered())
        history.back();
}

export function followHistory(): void {
    if (framed)
        return; // its entries would be the page's around it
    if (isEntered()) // by a panel that was open when the page was loaded anew; what lies behind may be another page
        history.replaceState(null, '');
    let due: number | undefined;
    effect(() => {
        void panel.value;
        clearTimeout(due);
        due = window.setTimeout(settle); // one panel may take another's place
    });
    window.addEventListener('popstate', () => {
        if (!isEntered())
            showPanel(null);
        else
            settle();
    });
}
