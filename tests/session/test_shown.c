/* What is shared is what was seen: view, instruments, a second world, whether time stands still;
 * and who opens it watches until they take over. Links of the version before still open.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <unistd.h>

#include <skvalp/controls.h>
#include <skvalp/link.h>

#include "base/envelope.h"
#include "session/support.h"
#include "support/kept.h"

static void expect_done(skv_stage *stage, skv_outcome_kind kind)
{
    skv_outcome outcome;
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &outcome));
    assert_string_equal(outcome.error.text, "");
    assert_int_equal(outcome.kind, kind);
}

static kept share(skv_stage *stage)
{
    kept shared = {0};
    skv_stage_share(stage);
    expect_done(stage, SKV_OUTCOME_SHARE);
    assert_true(skv_stage_read_shared(stage, kept_add, &shared));
    return shared;
}

/* Another stage, on which it is open. */
static skv_stage *open_shared(const kept *shared, bool own_thread)
{
    skv_stage *stage = stage_make(own_thread, stage_still);
    skv_stage_open_memory(stage, shared->bytes, shared->size, "skvr", "link", NULL);
    expect_done(stage, SKV_OUTCOME_OPEN);
    return stage;
}

static uint32_t add_probe(skv_stage *stage, skv_instrument_kind kind, double x)
{
    skv_instrument_def def = skv_default_instrument_def(kind);
    def.x0 = x;
    def.y0 = 0.125;
    def.x1 = x + 0.25;
    def.y1 = 0.375;
    return skv_stage_add_probe(stage, &def);
}

static void expect_probe(const skv_probe *probe, skv_instrument_kind kind, double x)
{
    assert_int_equal(probe->def.kind, kind);
    assert_true(probe->def.x0 == x && probe->def.y0 == 0.125);
    assert_true(probe->def.x1 == x + 0.25 && probe->def.y1 == 0.375);
}

static void expect_seen(skv_stage *stage)
{
    const skv_picture *picture = stage_look(stage, 0);
    assert_string_equal(picture->view, "pressure");
    assert_string_equal(picture->overlays, "grid,velocity");
    assert_int_equal(picture->probe_count, 2);
    expect_probe(&picture->probes[0], SKV_INSTRUMENT_RULER, 0.25);
    expect_probe(&picture->probes[1], SKV_INSTRUMENT_PRESSURE, 0.5);
    assert_int_equal(picture->probes[0].samples, 0);
    assert_int_equal(picture->probes[0].id, 1);
    assert_true(picture->probes[1].samples > 0);
}

static void set_seen(skv_stage *stage)
{
    skv_stage_set_look(stage, "pressure", "grid,velocity");
    add_probe(stage, SKV_INSTRUMENT_RULER, 0.25);
    skv_stage_watch_probe(stage, add_probe(stage, SKV_INSTRUMENT_PRESSURE, 0.5), true);
}

/* A set-up that is paused begins so; a game that was paused stops at its end. */
static void share_seen(bool own_thread)
{
    skv_stage *stage = stage_open_pool(200, own_thread);
    set_seen(stage);
    skv_stage_set_paused(stage, true);
    kept set_up = share(stage);
    skv_stage_set_paused(stage, false);
    stage_pass_frames(stage, 12);
    skv_stage_set_paused(stage, true);
    kept game = share(stage);

    skv_stage *other = open_shared(&set_up, own_thread);
    expect_seen(other);
    const skv_picture *picture = skv_stage_picture(other, 0);
    assert_true(picture->paused && !picture->watching);
    skv_stage_destroy(other);

    other = open_shared(&game, own_thread);
    assert_true(stage_look(other, 0)->watching && !skv_stage_paused(other));
    /* No time passes after it has paused, as in a face that has nothing more to show. */
    for (int i = 0; i < 20 && !skv_stage_paused(other); i++)
        stage_pass(other, 1.0 / 60);
    expect_seen(other);
    picture = skv_stage_picture(other, 0);
    assert_true(picture->paused && !picture->watching && picture->as_recorded);
    assert_int_equal(picture->moment, 12);
    assert_int_equal(stage_hash(other, 0), stage_hash(stage, 0));
    skv_stage_set_look(other, picture->view, picture->overlays);
    kept again = share(other); /* and so on, from hand to hand */
    assert_int_equal(again.size, game.size);
    assert_memory_equal(again.bytes, game.bytes, game.size);

    assert_int_equal(add_probe(other, SKV_INSTRUMENT_GATE, 0.75), 3);
    kept_clear(&again);
    kept_clear(&game);
    kept_clear(&set_up);
    skv_stage_destroy(other);
    skv_stage_destroy(stage);
}

static void test_seen(void **state)
{
    (void)state;
    share_seen(false);
    share_seen(true);
}

/* ---- Two worlds ------------------------------------------------------------------------------ */

/* Side by side, an edit in one of them alone. */
static skv_stage *make_pair(bool own_thread)
{
    skv_stage *stage = stage_open_pool(200, own_thread);
    set_seen(stage);
    stage_pass_frames(stage, 4);
    skv_control_compare(stage, skv_choice_named("honey"));
    stage_compared(stage);
    skv_stage_set_linked(stage, false);
    stage_pass_frames(stage, 12);
    stage_draw_wall(stage, 1, 400);
    stage_pass_frames(stage, 12);
    skv_stage_set_paused(stage, true);
    while (stage_look(stage, 0)->moment != stage_look(stage, 1)->moment)
        stage_pass(stage, 1.0 / 60);
    return stage;
}

static void expect_pair(skv_stage *stage, skv_stage *original)
{
    assert_int_equal(stage_compared(stage).error.code, SKV_OK);
    assert_int_equal(skv_stage_sides(stage), 2);
    assert_string_equal(skv_stage_choice(stage), "honey");
    assert_false(skv_stage_linked(stage));
    assert_true(stage_look(stage, 0)->watching && stage_look(stage, 1)->watching);
    for (int i = 0; i < 200 && !skv_stage_paused(stage); i++)
        stage_pass(stage, 1.0 / 60);
    assert_int_equal(stage_moment(stage), stage_moment(original));
    for (int side = 0; side < 2; side++) {
        assert_int_equal(stage_hash(stage, side), stage_hash(original, side));
        assert_int_equal(skv_stage_picture(stage, side)->probe_count, 2);
    }
    assert_int_not_equal(stage_hash(stage, 0), stage_hash(stage, 1));
    expect_seen(stage);
}

static void share_pair(bool own_thread)
{
    skv_stage *stage = make_pair(own_thread);
    kept shared = share(stage);
    skv_stage *other = open_shared(&shared, own_thread);
    expect_pair(other, stage);
    skv_stage_end_compare(other);
    kept alone = share(other); /* the second is gone from what is shared next */
    assert_true(alone.size < shared.size * 2 / 3);
    kept_clear(&alone);
    skv_stage_destroy(other);
    kept_clear(&shared);

    /* The same as a file, asked for between others: reports come in order. */
    char folder[] = "/tmp/skvalp-XXXXXX", first[64], pair[64], none[64];
    assert_non_null(mkdtemp(folder));
    snprintf(first, sizeof first, "%s/a.skv", folder);
    snprintf(pair, sizeof pair, "%s/b.skvr", folder);
    snprintf(none, sizeof none, "%s/none/c.skvr", folder);
    skv_stage_save(stage, pair);
    skv_stage_save(stage, none);
    skv_stage_save(stage, first);
    expect_done(stage, SKV_OUTCOME_SAVE);
    skv_outcome outcome;
    assert_true(skv_stage_next_outcome(stage, &outcome));
    assert_int_equal(outcome.kind, SKV_OUTCOME_SAVE);
    assert_int_not_equal(outcome.error.code, SKV_OK);
    expect_done(stage, SKV_OUTCOME_SAVE);
    other = stage_make(own_thread, stage_still);
    skv_stage_open(other, pair, NULL);
    expect_done(other, SKV_OUTCOME_OPEN);
    expect_pair(other, stage);
    unlink(first);
    unlink(pair);
    rmdir(folder);
    skv_stage_destroy(other);
    skv_stage_destroy(stage);
}

static void test_pair(void **state)
{
    (void)state;
    share_pair(false);
    share_pair(true);
}

/* A moment is opened as it was, and goes on from there: nothing that was done before it is in it.
 */
static void keep_moment(bool own_thread)
{
    char folder[] = "/tmp/skvalp-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/kept.skvr", folder);
    skv_stage *stage = stage_open_pool(200, own_thread);
    assert_false(skv_control_would_be_missed(stage));
    skv_stage_destroy(stage);
    stage = make_pair(own_thread);
    assert_false(skv_control_would_be_missed(stage)); /* what was done was done in the other one */
    stage_draw_wall(stage, 0, 400);
    stage_look(stage, 0);
    assert_true(skv_control_would_be_missed(stage));
    skv_stage_save_moment(stage, path);
    expect_done(stage, SKV_OUTCOME_SAVE);

    skv_stage *other = stage_make(own_thread, stage_still);
    skv_stage_open(other, path, NULL);
    expect_done(other, SKV_OUTCOME_OPEN);
    assert_int_equal(stage_compared(other).error.code, SKV_OK);
    assert_true(skv_stage_sides(other) == 2 && !skv_stage_linked(other));
    for (int side = 0; side < 2; side++)
        assert_int_equal(stage_hash(other, side), stage_hash(stage, side));
    const skv_picture *picture = stage_look(other, 0);
    assert_true(picture->paused && !picture->watching && !picture->can_undo);
    assert_int_equal(picture->end, 0);
    assert_string_equal(picture->title, skv_stage_picture(stage, 0)->title);
    expect_seen(other);
    assert_false(skv_control_would_be_missed(other));
    skv_stage_end_compare(other);
    skv_stage_set_paused(other, false);
    while (stage_look(other, 0)->end < 1800) {
        assert_false(skv_control_would_be_missed(other));
        skv_stage_push(other, 0, 0.5, 0); /* or it would come to rest */
        stage_pass(other, 1.0 / 60);
    }
    assert_true(skv_control_would_be_missed(other));

    skv_outcome outcome;
    skv_stage_share(other);
    skv_stage_wait(other);
    assert_true(skv_stage_next_outcome(other, &outcome));
    assert_non_null(strstr(outcome.error.text, "it does not begin as its scene does"));
    unlink(path);
    rmdir(folder);
    skv_stage_destroy(other);
    skv_stage_destroy(stage);
}

static void test_moment(void **state)
{
    (void)state;
    keep_moment(false);
    keep_moment(true);
}

/* What plays is asked for its link, too: both worlds end at one moment. */
static void test_pair_that_plays(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_stage *stage = make_pair(own_thread);
        skv_stage_set_paused(stage, false);
        for (int i = 0; i < 5; i++)
            skv_stage_advance(stage, 1.0 / 60, 0);
        skv_stage_share(stage);
        skv_outcome outcome;
        do
            stage_pass(stage, 1.0 / 60);
        while (!skv_stage_next_outcome(stage, &outcome));
        assert_string_equal(outcome.error.text, "");
        kept shared = {0};
        assert_true(skv_stage_read_shared(stage, kept_add, &shared));
        skv_stage *other = open_shared(&shared, own_thread);
        assert_int_equal(stage_compared(other).error.code, SKV_OK);
        int64_t end = stage_look(other, 0)->end;
        assert_true(end > 20);
        assert_int_equal(stage_look(other, 1)->end, end);
        kept_clear(&shared);
        skv_stage_destroy(other);
        skv_stage_destroy(stage);
    }
}

/* ---- Watching -------------------------------------------------------------------------------- */

static void expect_watching(skv_stage *stage, unsigned withheld, int64_t end)
{
    const skv_picture *picture = stage_look(stage, 0);
    assert_true(picture->watching && picture->following);
    assert_int_equal(picture->withheld, withheld);
    assert_int_equal(picture->end, end);
    assert_int_equal(picture->hand_count, 0);
}

/* Nothing that people do meanwhile cuts off what is to come. */
static void test_watching(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_stage *stage = stage_open_pool(200, own_thread);
        skv_stage_push(stage, 0, 0.5, 0);
        stage_pass_frames(stage, 30);
        kept shared = share(stage);
        skv_stage *other = open_shared(&shared, own_thread);
        stage_pass_frames(other, 3);
        expect_watching(other, 0, 30);
        stage_touch(other, SKV_PHASE_DOWN, SKV_DEVICE_FINGER, 1, 800, 700, 0);
        stage_pass_frames(other, 2);
        stage_touch(other, SKV_PHASE_UP, SKV_DEVICE_FINGER, 1, 800, 700, 0.1);
        skv_stage_set(other, 0, "fluid.viscosity", "0.5");
        skv_stage_undo(other);
        skv_stage_redo(other);
        skv_stage_set_gravity(other, 0, 1, 0);
        skv_stage_push(other, 0, 1, 0);
        stage_pass_frames(other, 2);
        expect_watching(other, 4, 30);
        skv_stage_seek(other, 2); /* looking elsewhere is no taking over */
        stage_pass_frames(other, 1);
        expect_watching(other, 4, 30);

        skv_stage_skip(other); /* to its end, and on */
        const skv_picture *picture = stage_look(other, 0);
        assert_true(!picture->watching && picture->as_recorded && picture->moment == 30);
        stage_pass_frames(other, 3);
        assert_true(stage_look(other, 0)->moment > 30);

        skv_stage_replay(other); /* or it is taken over, and what was cut off can be had again */
        stage_pass_frames(other, 3);
        assert_true(stage_look(other, 0)->watching);
        int64_t end = stage_look(other, 0)->end;
        skv_stage_take_over(other);
        stage_pass_frames(other, 1);
        picture = stage_look(other, 0);
        assert_true(!picture->watching && picture->end < 10 && picture->can_redo);
        skv_stage_redo(other);
        assert_int_equal(stage_look(other, 0)->end, end);
        kept_clear(&shared);
        skv_stage_destroy(other);
        skv_stage_destroy(stage);
    }
}

/* ---- What strangers may have written --------------------------------------------------------- */

/* Where it lies in what was shared. */
static size_t find(const kept *shared, const char *text)
{
    size_t length = strlen(text), at = shared->size - length;
    while (at > 0 && memcmp(shared->bytes + at, text, length) != 0)
        at--;
    assert_int_not_equal(at, 0);
    return at;
}

/* One line says it, and nothing is opened; the byte is put back. */
static void expect_refused(kept *shared, size_t at, uint8_t byte)
{
    skv_player *player;
    skv_error error = {0};
    skv_demands demands;
    uint8_t *bytes = (uint8_t *)shared->bytes, before = bytes[at];
    bytes[at] = byte;
    skv_envelope_seal(bytes, shared->size);
    assert_int_equal(skv_player_load(bytes, shared->size, NULL, &player, &error), SKV_ERROR_FORMAT);
    assert_null(player);
    assert_string_equal(error.text, "replay: it is damaged; take another copy");
    assert_int_equal(skv_player_ask(bytes, shared->size, &demands, NULL), SKV_ERROR_FORMAT);
    bytes[at] = before;
    skv_envelope_seal(bytes, shared->size);
}

static void test_hostile(void **state)
{
    (void)state;
    skv_stage *stage = make_pair(false);
    kept shared = share(stage);
    skv_demands demands;
    assert_int_equal(skv_player_ask(shared.bytes, shared.size, &demands, NULL), SKV_OK);
    int both =
        stage_look(stage, 0)->frame.particles.count + stage_look(stage, 1)->frame.particles.count;
    assert_in_range(demands.particles, both * 0.9, both * 1.1); /* the scenes' own figures */
    assert_int_equal(demands.frames, stage_moment(stage));

    size_t view = find(&shared, "\010pressure\015grid,velocity");
    expect_refused(&shared, view - 1, 4);   /* flags that there are not */
    expect_refused(&shared, view, 200);     /* a name that is too long */
    expect_refused(&shared, view + 1, 'P'); /* and one that is none */
    size_t ruler = find(&shared, "\005ruler"), choice = find(&shared, "\005honey\002");
    expect_refused(&shared, choice + 6, 33);      /* instruments */
    expect_refused(&shared, ruler + 1, 'R');      /* a kind that there is not */
    expect_refused(&shared, ruler + 6 + 7, 0x7f); /* 1e300 m away */
    expect_refused(&shared, ruler + 6 + 32, 2);   /* watched or not */
    size_t second = find(&shared, "\x89SKR");
    assert_true(second > ruler);
    expect_refused(&shared, second + 8, 3);   /* a second world with one beside it */
    expect_refused(&shared, second + 3, 'V'); /* or that is none */
    expect_refused(&shared, shared.size - 1, (uint8_t)~shared.bytes[shared.size - 1]);
    kept_clear(&shared);
    skv_stage_destroy(stage);
}

/* ---- The version before ---------------------------------------------------------------------- */

/* Made by version 0.1.0 with replays of version 2: a mere set-up, and half a second of a dam break.
 */
static const struct {
    const char *link, *name;
    int particles;
    int64_t end;
} old_links[] = {
    {"skvalp:1.6wz2DuLlkuJiYoCAaijd8Z-FmXlJvgurgZ6hngFIRAIqw1CqW1KalMowgZEBK1BE4RnYQ-gJIDphx7xme8bD"
     "wpUibdM7fwAA",
     "u-tube", 400, 0},
    {"skvalp:1.6wz2DuLlkuJiYoCAFVB6m7XPrs2e1_exGugZ6hnIAUWkoTIMKYm5uklFqYnZDDqMDFiBNwrPwB5CTwDRCTvm"
     "NdsvYGNknDVT0p7R2NjYnjEtLQ3K4rqubOvIsBhoqoMDkBA4-JB3M2PMYaFl-hsA",
     "dam-break", 300, 30},
};

static void test_old_links(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof old_links / sizeof *old_links; i++) {
        kept inside = {0};
        assert_int_equal(skv_link_read(old_links[i].link, kept_add, &inside, NULL), SKV_OK);
        assert_int_equal(skv_envelope_version((uint8_t *)inside.bytes, inside.size), 2);
        skv_stage *stage = open_shared(&inside, false);
        const skv_picture *picture = stage_look(stage, 0);
        assert_string_equal(picture->name, old_links[i].name);
        assert_in_range(picture->frame.particles.count, old_links[i].particles * 0.9,
                        old_links[i].particles * 1.1);
        assert_int_equal(picture->end, old_links[i].end);
        assert_true(picture->watching == (old_links[i].end > 0));
        assert_string_equal(picture->view, "");
        assert_int_equal(picture->probe_count, 0);
        stage_pass_frames(stage, (int)old_links[i].end + 2);
        assert_true(!stage_look(stage, 0)->watching);
        kept_clear(&inside);
        skv_stage_destroy(stage);
    }
}

/* Whatever becomes of a letter, it is the link that is called damaged: not what it turns into. */
static void test_damaged_links(void **state)
{
    (void)state;
    static const char letters[] = "Aq_";
    kept whole = {0};
    const char *link = old_links[1].link;
    assert_int_equal(skv_link_read(link, kept_add, &whole, NULL), SKV_OK);
    for (size_t at = strlen("skvalp:1."), i = 0; at < strlen(link); i++) {
        char damaged[256] = "";
        kept inside = {0};
        skv_error error;
        memcpy(damaged, link, strlen(link));
        damaged[at] = letters[i % (sizeof letters - 1)];
        if (skv_link_read(damaged, kept_add, &inside, &error) == SKV_OK) {
            assert_int_equal(inside.size, whole.size);
            assert_memory_equal(inside.bytes, whole.bytes, whole.size);
        } else if (!strstr(error.text, "link: it is damaged")) {
            fail_msg("letter %zu as %c: %s", at, damaged[at], error.text);
        }
        at += i % (sizeof letters - 1) == sizeof letters - 2;
        kept_clear(&inside);
    }
    kept_clear(&whole);
}

/* What is no letter has a place, which is named by what stands before it. */
static void test_place_of_damage(void **state)
{
    (void)state;
    static const struct {
        const char *link, *after;
    } cases[] = {
        {"skvalp:1.6wz2DuLlkuJiYoCA*ijd8Z", "\"DuLlkuJiYoCA\""},
        {"skvalp:1.6wz2DuLlku\nJiY \n*oCA", "\"JiY\""},
        {"https://example.org/water/#1.%3C", "\"1.\""},
        {"skvalp:1.6w\303\2512DuLlku", "\"1.6w\""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        kept inside = {0};
        skv_error error;
        assert_int_equal(skv_link_read(cases[i].link, kept_add, &inside, &error), SKV_ERROR_FORMAT);
        if (!strstr(error.text, cases[i].after) || strchr(error.text, '\n'))
            fail_msg("%s: %s", cases[i].link, error.text);
        assert_null(inside.bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_seen),
        cmocka_unit_test(test_pair),
        cmocka_unit_test(test_pair_that_plays),
        cmocka_unit_test(test_moment),
        cmocka_unit_test(test_watching),
        cmocka_unit_test(test_hostile),
        cmocka_unit_test(test_damaged_links),
        cmocka_unit_test(test_place_of_damage),
        cmocka_unit_test(test_old_links),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
