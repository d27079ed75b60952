// Scenes: the gallery, and the experiments below it, from the catalogue.
import { useRef } from 'preact/hooks';
import { openFile, openScene } from './actions';
import { Icon } from './Icon';
import { catalogue, showPanel, world } from './model';
import { _, word } from './words';

/** Pictures of the built-in scenes, as far as there are some. */
const pictures = import.meta.glob<string>('../pictures/*.webp', {
    query: '?url',
    import: 'default',
    eager: true,
});

function Card({ name, title, description }: { name: string; title: string; description: string }) {
    const picture = pictures[`../pictures/${name}.webp`];
    return (
        <button
            type="button"
            class="card"
            aria-current={world.value?.name === name ? 'true' : undefined}
            onClick={() => openScene(name)}
        >
            {picture && <img src={picture} alt="" width="320" height="180" loading="lazy" />}
            <strong>{word(title)}</strong>
            <span class="caption">{word(description)}</span>
        </button>
    );
}

function Opening() {
    const input = useRef<HTMLInputElement>(null);
    return (
        <p class="row">
            <button type="button" class="text wide" onClick={() => input.current!.click()}>
                <Icon name="open" />
                {_('Open a scene or a picture')}
            </button>
            <input
                ref={input}
                type="file"
                hidden
                aria-label={_('Open a scene or a picture')}
                accept=".json,.png,.skv,.skvr,image/*"
                onChange={(event) => {
                    const [file] = event.currentTarget.files ?? [];
                    event.currentTarget.value = '';
                    if (file)
                        void openFile(file);
                }}
            />
        </p>
    );
}

export function Scenes() {
    return (
        <>
            <div class="cards">
                {catalogue.scenes.map((scene) => (
                    <Card key={scene.name} {...scene} />
                ))}
            </div>
            <Opening />
            <h3>{_('Experiments')}</h3>
            <ul class="list">
                {catalogue.experiments.map((experiment, index) => (
                    <li key={experiment.name}>
                        <button type="button" onClick={() => showPanel('experiment', index)}>
                            <span>
                                <strong>{word(experiment.title)}</strong>
                                <span class="caption">{word(experiment.description)}</span>
                            </span>
                            <Icon name="next" />
                        </button>
                    </li>
                ))}
            </ul>
        </>
    );
}
