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

bool skv_message_has_request(const skv_message *message)
{
    return message->kind == SKV_MESSAGE_OPEN || message->kind == SKV_MESSAGE_SAVE ||
           message->kind == SKV_MESSAGE_EDIT || message->kind == SKV_MESSAGE_SHOW ||
           message->kind == SKV_MESSAGE_BESIDE;
}

bool skv_message_outlives(const skv_message *message)
{
    switch (message->kind) {
    case SKV_MESSAGE_OPEN:
    case SKV_MESSAGE_SAVE: /* after what is to be opened: none was asked for before */
    case SKV_MESSAGE_SHARE:
    case SKV_MESSAGE_SHOW:
    case SKV_MESSAGE_BESIDE:
    case SKV_MESSAGE_LOOK:
    case SKV_MESSAGE_SPEED:
    case SKV_MESSAGE_LED:
    case SKV_MESSAGE_PLAY:
    case SKV_MESSAGE_GRAVITY:
    case SKV_MESSAGE_CHOSEN:
    case SKV_MESSAGE_POINTER:
    case SKV_MESSAGE_CANCEL:
        return true;
    default:
        return false;
    }
}
