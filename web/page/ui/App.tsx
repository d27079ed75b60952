// App: how the page is laid out. Invariant: the water has all the room that controls leave; on phones
// they lie below it, on wide screens around it.
import { openFile } from './actions';
import { Header } from './Header';
import { Messages } from './Messages';
import { later } from './later';
import { controls, fluids, measures, part, ready } from './model';
import { Panel } from './Panel';
import { Stage } from './Stage';
import { Tools } from './Tools';
import { Transport } from './Transport';
import { _ } from './words';

const Chips = later(() => import('./Chips'), true);
const Fluids = later(() => import('./Fluids'), true);
const Watching = later(() => import('./Watching'), true);
const watching = part((s) => s.watching, false);

function onDrop(event: DragEvent): void {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file && ready.value)
        void openFile(file);
}

export function App({ canvas }: { canvas: HTMLCanvasElement }) {
    const shown = ready.value ? controls.value : 'none';
    return (
        <main class={`app controls-${shown}`} onDragOver={(event) => event.preventDefault()} onDrop={onDrop}>
            <div class="main">
                <h1 class="hidden">Skvalp</h1>
                <Stage canvas={canvas} />
                {shown === 'all' && <Header />}
                <Messages />
                {!ready.value && <p class="loading">{_('Water is coming…')}</p>}
            </div>
            {shown !== 'none' && (
                <div class="dock">
                    <div class="trays">
                        {measures.value && <Chips />}
                        {shown === 'all' && fluids.value && <Fluids />}
                    </div>
                    <div class="playback">
                        {watching.value && <Watching />}
                        <Transport />
                    </div>
                    {shown === 'all' && <Tools />}
                </div>
            )}
            {shown === 'all' && <Panel />}
        </main>
    );
}
