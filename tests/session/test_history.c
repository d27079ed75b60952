/* Key frames that are dropped: of the last half minute evenly, of what is older the more; and those
 * that go with a replay to another player of the same program, as what was undone does. */
#include "session/player.h"
#include "session/support.h"
#include "support/fixture.h"
#include "support/kept.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/query.h>

enum { EVERY = 30, KEYS = 301, KEPT = 60 };

static int64_t gap_after(const skv_history *history, int i)
{
    return history->list[i + 1].position.frame - history->list[i].position.frame;
}

static void the_older_the_wider_apart(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.1f, 1);
    fixture_fill(world, 0.2f, 0.2f, 0.4f, 0.4f);
    skv_history history = {0};
    for (int i = 0; i < KEYS; i++)
        assert_int_equal(
            skv_history_add(&history, world, (skv_position){.frame = (int64_t)i * EVERY}, NULL),
            SKV_OK);
    size_t each = history.bytes / KEYS;
    while (history.count > KEPT)
        assert_true(skv_history_thin(&history));
    assert_int_equal(history.bytes, KEPT * each);
    /* The first and the last always stay. */
    assert_int_equal(history.list[0].position.frame, 0);
    assert_int_equal(history.list[KEPT - 1].position.frame, (KEYS - 1) * EVERY);
    /* 150 s: at their beginning six times as wide apart as at the end, (9000 + 1800) / 1800. */
    double first = 0, last = 0;
    for (int i = 0; i < 4; i++) {
        first += (double)gap_after(&history, i) / 4;
        last += (double)gap_after(&history, KEPT - 2 - i) / 4;
    }
    assert_near(first / last, 6, 2);
    skv_history_free(&history);
    skv_world_destroy(world);
}

/* ---- Handed over ----------------------------------------------------------------------------- */

/* Frames: from a key frame to the next; at which something is done, and how long is played. */
enum { BETWEEN = 15, PAINTED = 40, SET = 97, END = 130 };

static uint64_t hash_of(const skv_player *player)
{
    return skv_world_hash(skv_player_world(player));
}

/* A game of two edits; hashes before each, and at its end. */
static skv_player *play_game(uint64_t hashes[3], kept *half)
{
    skv_player *player = open_player(0);
    skv_command paint = {.kind = SKV_COMMAND_PAINT}, set = {.kind = SKV_COMMAND_SET};
    paint.paint.count = 1;
    paint.paint.list[0] = (skv_brush_stroke){0.5f, 0.05f, 0.5f, 0.3f, 0.02f, false};
    strcpy(set.set.path, "fluid.viscosity");
    strcpy(set.set.text, "0.01");
    for (int f = 0; f < END; f++) {
        if (f == PAINTED || f == SET) {
            hashes[f == SET] = hash_of(player);
            assert_int_equal(skv_player_edit(player, f == SET ? &set : &paint, NULL), SKV_OK);
        }
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        if (f == PAINTED)
            assert_int_equal(skv_player_save(player, kept_add, half, NULL), SKV_OK);
    }
    hashes[2] = hash_of(player);
    return player;
}

static skv_player *load(const kept *replay)
{
    skv_player *player;
    assert_int_equal(skv_player_load(replay->bytes, replay->size, NULL, &player, NULL), SKV_OK);
    return player;
}

/* How many frames it takes to where it is on its way to. */
static int settle(skv_player *player)
{
    int steps = 0;
    for (; skv_player_seeking(player); steps++)
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    return steps;
}

/* How many key frames it takes, or ways that were not taken. */
static int hand_over(skv_player *from, skv_player *to, bool branches)
{
    int taken = 0;
    kept one = {0};
    for (int i = 0;; i++) {
        if (branches)
            skv_player_write_branch(from, i, kept_add, &one);
        else
            skv_player_write_key(from, i, kept_add, &one);
        if (one.size == 0)
            return taken;
        const uint8_t *written = (const uint8_t *)one.bytes;
        taken += branches ? skv_player_take_branch(to, written) : skv_player_take_key(to, written);
        kept_clear(&one);
    }
}

static void who_takes_keys_steps_little(void **unused)
{
    (void)unused;
    kept whole = {0}, half = {0};
    uint64_t hashes[3];
    skv_player *first = play_game(hashes, &half);
    assert_int_equal(skv_player_save(first, kept_add, &whole, NULL), SKV_OK);
    skv_player *second = load(&whole), *shorter = load(&half);
    /* All but the start, which is there, and the end's. */
    assert_int_equal(hand_over(first, second, false), END / BETWEEN + 1);
    assert_int_equal(skv_player_seek(second, END, NULL), SKV_OK);
    assert_true(settle(second) < BETWEEN);
    assert_int_equal(hash_of(second), hashes[2]);
    assert_int_equal(skv_player_mismatch(second), -1);
    for (int i = 1; i >= 0; i--) {
        assert_int_equal(skv_player_undo(second, NULL), SKV_OK);
        assert_true(settle(second) < BETWEEN);
        assert_int_equal(skv_player_frame(second), i ? SET : PAINTED);
        assert_int_equal(hash_of(second), hashes[i]);
    }
    /* Of moments that a log does not have it takes none. */
    assert_int_equal(hand_over(first, shorter, false), PAINTED / BETWEEN);
    skv_player_destroy(first);
    skv_player_destroy(second);
    skv_player_destroy(shorter);
    kept_clear(&whole);
    kept_clear(&half);
}

static void who_takes_what_was_undone_redoes_it(void **unused)
{
    (void)unused;
    kept rest = {0}, half = {0};
    uint64_t hashes[3];
    skv_player *first = play_game(hashes, &half);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(skv_player_undo(first, NULL), SKV_OK);
        settle(first);
    }
    assert_int_equal(skv_player_save(first, kept_add, &rest, NULL), SKV_OK);
    skv_player *second = load(&rest);
    hand_over(first, second, false);
    assert_false(skv_player_can_redo(second));
    assert_int_equal(hand_over(first, second, true), 2);
    assert_int_equal(skv_player_seek(second, PAINTED, NULL), SKV_OK);
    settle(second);
    for (int i = 1; i <= 2; i++) {
        assert_int_equal(skv_player_redo(second, NULL), SKV_OK);
        assert_true(settle(second) < BETWEEN);
        assert_int_equal(skv_player_frame(second), i == 1 ? SET : END);
        assert_int_equal(hash_of(second), hashes[i]);
    }
    assert_false(skv_player_can_redo(second));
    /* It is what was played, and is undone again. */
    assert_int_equal(skv_player_undo(second, NULL), SKV_OK);
    settle(second);
    assert_int_equal(hash_of(second), hashes[1]);
    skv_player_destroy(first);
    skv_player_destroy(second);
    kept_clear(&rest);
    kept_clear(&half);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_older_the_wider_apart),
                                       cmocka_unit_test(who_takes_keys_steps_little),
                                       cmocka_unit_test(who_takes_what_was_undone_redoes_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
