// Messages: what is to be told at once; a fault stays until it is closed.
import { Button } from './Button';
import { Icon } from './Icon';
import { dismiss, message } from './model';
import { _ } from './words';

export function Messages() {
    const said = message.value;
    return (
        <div class="messages" role={said?.fault ? 'alert' : 'status'}>
            {said && (
                <div class={`message ${said.fault ? 'fault' : ''}`}>
                    {said.fault && <Icon name="warning" />}
                    <p>{[said.text, ...(said.notes ?? [])].join('; ')}</p>
                    {said.offer && (
                        <button type="button" class="text suggested" onClick={said.offer.act}>
                            {said.offer.name}
                        </button>
                    )}
                    <Button icon="close" name={_('Close this message')} hint={_('Esc')} onClick={dismiss} />
                </div>
            )}
        </div>
    );
}
