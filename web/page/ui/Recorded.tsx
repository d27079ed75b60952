// Recorded: that it records, and for how long by now; whoever presses it has enough.
import { quantity } from './numbers';
import { recorded, toggleRecording } from './recording';
import { _ } from './words';

export default function Recorded() {
    const time = quantity(recorded.value ?? 0, 0, 's');
    return (
        <button
            type="button"
            class="button recorded"
            aria-label={_('Stop recording')}
            aria-description={time}
            title={_('Stop recording')}
            onClick={toggleRecording}
        >
            <span class="numeric">{time}</span>
        </button>
    );
}
