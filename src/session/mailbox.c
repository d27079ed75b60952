/* A ring of messages. Invariant: those from `taken` to `written` belong to the reader, all others
 * to the writer; each of the two counters has one thread that changes it. */
#include "session/mailbox.h"

bool skv_mailbox_put(skv_mailbox *box, const skv_message *message)
{
    unsigned written = atomic_load_explicit(&box->written, memory_order_relaxed);
    unsigned room = SKV_MAILBOX_SIZE - (written - atomic_load(&box->taken));
    bool move = message->kind == SKV_MESSAGE_POINTER && message->pointer.phase == SKV_PHASE_MOVE;
    if (room == 0 || (move && room <= SKV_MAILBOX_RESERVE))
        return false;
    box->list[written % SKV_MAILBOX_SIZE] = *message;
    atomic_store(&box->written, written + 1);
    return true;
}

const skv_message *skv_mailbox_next(skv_mailbox *box)
{
    unsigned taken = atomic_load_explicit(&box->taken, memory_order_relaxed);
    return taken == atomic_load(&box->written) ? NULL : &box->list[taken % SKV_MAILBOX_SIZE];
}

void skv_mailbox_drop(skv_mailbox *box)
{
    unsigned taken = atomic_load_explicit(&box->taken, memory_order_relaxed);
    atomic_store(&box->taken, taken + 1);
}
