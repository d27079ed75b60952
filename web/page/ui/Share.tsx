// Share: the link to this moment, to be copied, passed on or photographed.
import qrcode from 'qrcode-generator';
import { Icon } from './Icon';
import { saveFile } from './files';
import { canShare, copyLink, link, passOn } from './sharing';
import { _ } from './words';

/** What a QR code holds at most, with the weakest correction. */
const LARGEST = 2900;
/** Modules of quiet around it. */
const QUIET = 4;

function QrCode({ text }: { text: string }) {
    const code = qrcode(0, 'L');
    code.addData(text);
    code.make();
    const count = code.getModuleCount();
    let path = '';
    for (let row = 0; row < count; row++)
        for (let column = 0; column < count; column++)
            if (code.isDark(row, column))
                path += `M${column + QUIET} ${row + QUIET}h1v1h-1z`;
    const size = count + 2 * QUIET;
    return (
        <svg class="qr" viewBox={`0 0 ${size} ${size}`} role="img" aria-label={_('The link as a QR code')}>
            <rect width={size} height={size} fill="white" />
            <path d={path} fill="black" shape-rendering="crispEdges" />
        </svg>
    );
}

export default function Share() {
    const text = link.value;
    return (
        <>
            <p>{_('Who opens this link sees the same water, and plays on from this moment.')}</p>
            <textarea
                class="link"
                rows={3}
                readOnly
                aria-label={_('Link')}
                value={text}
                placeholder={_('Loading…')}
                onFocus={(event) => event.currentTarget.select()}
            />
            <p class="row">
                <button type="button" class="text suggested" disabled={!text} onClick={() => void copyLink()}>
                    <Icon name="copy" />
                    {_('Copy')}
                </button>
                {canShare && (
                    <button type="button" class="text" disabled={!text} onClick={() => void passOn(text.startsWith('skvalp:') ? { text } : { url: text })}>
                        <Icon name="share" />
                        {_('Pass on')}
                    </button>
                )}
                <button type="button" class="text" onClick={() => void saveFile('skvr')}>
                    <Icon name="save" />
                    {_('Save as a file')}
                </button>
            </p>
            {text.length > 0 && text.length <= LARGEST && <QrCode text={text} />}
            {text.length > LARGEST && <p class="caption">{_('This link is too long for a QR code.')}</p>}
        </>
    );
}
