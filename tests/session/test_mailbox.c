/* The mailbox: in order, and what must not be lost has room when moves of pointers do not. */
#include "session/mailbox.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static const skv_message move = {.kind = SKV_MESSAGE_POINTER, .pointer.phase = SKV_PHASE_MOVE};
static const skv_message press = {.kind = SKV_MESSAGE_POINTER, .pointer.phase = SKV_PHASE_DOWN};

static int put_until_full(skv_mailbox *box, const skv_message *message)
{
    int count = 0;
    while (skv_mailbox_put(box, message))
        count++;
    return count;
}

static void moves_leave_room_for_the_rest(void **unused)
{
    (void)unused;
    static skv_mailbox box;
    assert_int_equal(put_until_full(&box, &move), SKV_MAILBOX_SIZE - SKV_MAILBOX_RESERVE);
    /* Both hands of a few people press and let go within a picture. */
    assert_true(SKV_MAILBOX_RESERVE >= 100);
    assert_int_equal(put_until_full(&box, &press), SKV_MAILBOX_RESERVE);
    for (int i = 0; i < SKV_MAILBOX_SIZE; i++) {
        const skv_message *next = skv_mailbox_next(&box);
        assert_int_equal(next->pointer.phase, i < SKV_MAILBOX_SIZE - SKV_MAILBOX_RESERVE
                                                  ? SKV_PHASE_MOVE
                                                  : SKV_PHASE_DOWN);
        skv_mailbox_drop(&box);
    }
    assert_null(skv_mailbox_next(&box));
    assert_true(skv_mailbox_put(&box, &move));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(moves_leave_room_for_the_rest)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
