// Tools: buttons made from the catalogue. Invariant: no tool is named here; a new row of the library's
// table is a new button, with a picture of its own if there is one of its name.
import { Button, PanelButton } from './Button';
import { hasIcon } from './Icon';
import { catalogue, dye, simulation, tool } from './model';
import { knock } from './device';
import { _, say, word } from './words';

export function Tools() {
    return (
        <div class="tools" role="toolbar" aria-label={_('Tools')}>
            <div class="scroller">
                {catalogue.tools.map((row, index) => {
                    const colour = row.dyes ? catalogue.dyes[dye.value] : '';
                    return (
                        <Button
                            key={row.name}
                            icon={hasIcon(row.name) ? row.name : 'probe'}
                            name={colour ? say(_('Dye: %s'), word(colour)) : word(row.title)}
                            hint={row.key}
                            description={word(row.help)}
                            class={`tool ${colour ? `dye-${colour}` : ''}`}
                            pressed={tool.value === index}
                            onClick={() => {
                                simulation.chooseTool(index);
                                knock();
                            }}
                        />
                    );
                })}
            </div>
            <PanelButton opens="size" icon="size" name={_('Size of the tool')} hint="[ ]" class="tool" />
        </div>
    );
}
