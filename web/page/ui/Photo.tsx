// Photo: a photo or a drawing on paper becomes a scene; the preview shows what it will be.
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { useSignal } from '@preact/signals';
import { paintedPicture } from '../simulation/photo';
import { photo } from './actions';
import { complain, showPanel, simulation } from './model';
import { bestLevel, paint, readPhoto } from './photograph';
import type { Taking } from './photograph';
import { _ } from './words';

function Slider(props: { name: string; value: number; change: (value: number) => void }) {
    return (
        <label class="slider">
            {props.name}
            <input
                type="range"
                class="wide"
                min={0}
                max={1}
                step={0.01}
                value={props.value}
                onInput={(event) => props.change(Number(event.currentTarget.value))}
            />
        </label>
    );
}

function open(picture: ImageData, name: string): void {
    simulation.openBytes(paintedPicture(picture.data, picture.width, picture.height), 'png', name);
    showPanel(null);
}

export default function Photo() {
    const pixels = useSignal<ImageData | null>(null);
    const taking = useSignal<Taking>({ level: 0.5, inverted: false, water: 0.4 });
    const canvas = useRef<HTMLCanvasElement>(null);
    const file = photo.value;
    useEffect(() => {
        if (!file)
            return;
        let wanted = true;
        readPhoto(file).then(
            (read) => {
                if (!wanted)
                    return;
                taking.value = { ...taking.value, level: bestLevel(read.data) };
                pixels.value = read;
            },
            () => {
                if (!wanted)
                    return;
                showPanel(null);
                complain(_('This picture cannot be read.'));
            },
        );
        return () => (wanted = false);
    }, [file]);
    const picture = pixels.value && paint(pixels.value, taking.value);
    // A canvas whose size is set is empty until it is drawn anew.
    useLayoutEffect(() => {
        if (picture)
            canvas.current!.getContext('2d')!.putImageData(picture, 0, 0);
    }, [picture]);
    const change = (changes: Partial<Taking>) => (taking.value = { ...taking.value, ...changes });
    return (
        <>
            <p>{_('Walls are white, water is blue. Move the sliders until the walls are as they should be.')}</p>
            <canvas
                ref={canvas}
                class="preview"
                role="img"
                aria-label={_('What the scene will be')}
                width={picture?.width ?? 16}
                height={picture?.height ?? 9}
            />
            <Slider
                name={_('Darkness of walls')}
                value={taking.value.level}
                change={(level) => change({ level })}
            />
            <Slider
                name={_('Water')}
                value={taking.value.water}
                change={(water) => change({ water })}
            />
            <label class="choice">
                <input
                    type="checkbox"
                    checked={taking.value.inverted}
                    onChange={(event) => change({ inverted: event.currentTarget.checked })}
                />
                {_('Light parts are walls')}
            </label>
            <button
                type="button"
                class="text suggested wide"
                disabled={!picture}
                onClick={() => open(picture!, `${file?.name ?? ''}.png`)}
            >
                {_('Open')}
            </button>
        </>
    );
}
