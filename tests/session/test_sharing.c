/* What a stage shares goes the same way in another player, and the stage says whether it did.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/envelope.h"
#include "session/support.h"
#include "support/kept.h"

/* Opens what was shared, lets it play past its end, and returns whether it went as recorded.
 * Without a frame it is a set-up: there is no end of which to say so. */
static bool plays_as_recorded(skv_stage *stage, const kept *shared, int64_t frames)
{
    skv_picture picture;
    skv_outcome outcome;
    skv_stage_open_memory(stage, shared->bytes, shared->size, "skvr", "link", NULL);
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &outcome), SKV_OK);
    stage_copy(stage, &picture);
    assert_string_equal(picture.name, "pool");
    assert_int_equal(picture.end, frames);
    assert_true(picture.following == (frames > 0));
    for (int64_t i = 0; i < frames + 5; i++)
        stage_advance(stage, 1.0 / 60);
    stage_copy(stage, &picture);
    assert_true(!picture.following && !picture.seeking);
    assert_true(picture.moment >= frames);
    assert_true(picture.as_recorded == (frames > 0 && !picture.mismatch));
    return !picture.mismatch;
}

/* The last hash counts, too, which stands after the last frame. */
static void share_twice(bool own_thread)
{
    kept shared = {0};
    skv_stage *stage = stage_open_pool(300, own_thread);
    skv_outcome outcome;
    assert_false(skv_stage_read_shared(stage, kept_add, &shared));
    for (int frames = 0; frames <= 20; frames += 20) {
        skv_stage_push(stage, 0, 0.2, 0);
        for (int i = 0; i < frames; i++)
            stage_advance(stage, 1.0 / 60);
        skv_stage_share(stage);
        skv_stage_wait(stage);
        assert_int_equal(stage_report(stage, &outcome), SKV_OK);
        assert_int_equal(outcome.kind, SKV_OUTCOME_SHARE);
        assert_true(skv_stage_read_shared(stage, kept_add, &shared));
        kept_clear(&shared); /* and again, as often as wanted */
        assert_true(skv_stage_read_shared(stage, kept_add, &shared));
        assert_true(plays_as_recorded(stage, &shared, frames));
        shared.bytes[shared.size - 1] ^= 1; /* of the hash */
        skv_envelope_seal((uint8_t *)shared.bytes, shared.size);
        assert_false(plays_as_recorded(stage, &shared, frames));
        kept_clear(&shared);
        skv_stage_seek(stage, 0);
        skv_stage_wait(stage);
    }
    skv_stage_destroy(stage);
}

static void test_sharing(void **state)
{
    (void)state;
    share_twice(true);
    share_twice(false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sharing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
