/* A game as a link: played with hand, wall, water and undo in one process, played again from the
 * link in another, with the same end; and how long such links are. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/link.h>
#include <skvalp/stage.h>

#include "program.h"
#include "support/fixture.h"

/* ---- A person -------------------------------------------------------------------------------- */

/* A stage that works within its calls, on a pool of 1.6 m shown with 1000 pixels a metre. */
typedef struct game {
    skv_stage *stage;
    double time;
    uint32_t dice;
} game;

static double still(void)
{
    return 0;
}

static game begin(const char *scene, int particles)
{
    game g = {.dice = 1};
    skv_stage_def def = skv_default_stage_def();
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    def.threads = 1;
    def.own_thread = false;
    def.clock = still;
    assert_int_equal(skv_stage_create(&def, &g.stage, NULL), SKV_OK);
    skv_stage_set_view(g.stage, 0, 1600, 900);
    skv_stage_open(g.stage, scene, &options);
    return g;
}

static void pass(game *g, double seconds)
{
    for (int i = 0; i < (int)(60 * seconds + 0.5); i++) {
        skv_stage_advance(g->stage, 1.0 / 60, 0);
        g->time += 1.0 / 60;
    }
}

static void point(game *g, skv_phase phase, double px, double py)
{
    skv_stage_pointer(g->stage, 0,
                      &(skv_pointer_event){.phase = phase,
                                           .device = SKV_DEVICE_MOUSE,
                                           .px = floor(px + 0.5),
                                           .py = floor(py + 0.5),
                                           .time = g->time});
}

/* Nobody holds still: a pixel or two to either side. */
static double tremor(game *g)
{
    g->dice = g->dice * 1664525 + 1013904223;
    return (g->dice >> 8) / 16777216.0 * 3 - 1.5;
}

/* A curve from one place to another, the way arms move: slowly, fast, slowly. */
static void drag(game *g, int tool, double x0, double y0, double x1, double y1, double seconds)
{
    int steps = (int)(60 * seconds);
    skv_stage_set_tool(g->stage, tool);
    point(g, SKV_PHASE_DOWN, x0, y0);
    for (int i = 1; i <= steps; i++) {
        double t = (double)i / steps, s = t * t * t * (10 - 15 * t + 6 * t * t);
        double bow = 60 * sin(3.14159 * s);
        pass(g, 1.0 / 60);
        point(g, SKV_PHASE_MOVE, x0 + s * (x1 - x0) + bow + tremor(g),
              y0 + s * (y1 - y0) - bow + tremor(g));
    }
    point(g, SKV_PHASE_UP, x1, y1);
}

enum { HAND, WALL, WATER };

/* Ten seconds of play: half of them with the hand, a wall, water, and moments of looking on. */
static void play_ten_seconds(game *g)
{
    drag(g, HAND, 300, 800, 900, 300, 1.5);
    drag(g, HAND, 1200, 800, 500, 400, 1.5);
    drag(g, WALL, 700, 500, 1000, 550, 1);
    pass(g, 1);
    drag(g, WATER, 400, 150, 600, 200, 1);
    drag(g, HAND, 800, 700, 1300, 250, 2);
    pass(g, 2);
}

/* ---- Links ----------------------------------------------------------------------------------- */

typedef struct text {
    char bytes[SKV_LONGEST_LINK + 1];
    size_t size; /* of the replay inside */
    skv_result result;
    skv_error error;
} text;

static bool keep_text(const char *link, size_t length, void *user)
{
    text *kept = user;
    assert_true(length < sizeof kept->bytes);
    memcpy(kept->bytes, link, length);
    kept->bytes[length] = '\0';
    return true;
}

static bool make_link(const char *bytes, size_t size, void *user)
{
    text *kept = user;
    kept->size = size;
    kept->result = skv_link_write(bytes, size, NULL, keep_text, kept, &kept->error);
    return true;
}

static text share(game *g)
{
    text link = {.size = 0};
    skv_outcome outcome;
    while (skv_stage_next_outcome(g->stage, &outcome))
        continue;
    skv_stage_share(g->stage);
    assert_true(skv_stage_next_outcome(g->stage, &outcome));
    assert_int_equal(outcome.kind, SKV_OUTCOME_SHARE);
    assert_string_equal(outcome.error.text, "");
    assert_true(skv_stage_read_shared(g->stage, make_link, &link));
    assert_int_equal(link.result, SKV_OK);
    return link;
}

static uint64_t hash_of(game *g)
{
    skv_stage_look(g->stage);
    const skv_picture *picture = skv_stage_picture(g->stage, 0);
    uint64_t hash = fixture_hash(&picture->frame.particles);
    return hash;
}

static void expect_end(const char *folder, const char *link, int64_t frames, uint64_t hash)
{
    char wanted[80];
    program_result result = SKVALP(folder, "replay", link);
    if (result.status)
        fail_msg("%s", result.err);
    snprintf(wanted, sizeof wanted, "link: %lld frames,", (long long)frames);
    assert_non_null(strstr(result.out, wanted));
    snprintf(wanted, sizeof wanted, "as recorded; hash %016llx", (unsigned long long)hash);
    assert_non_null(strstr(result.out, wanted));
    program_free(&result);
}

static int64_t moment(game *g)
{
    skv_stage_look(g->stage);
    const skv_picture *picture = skv_stage_picture(g->stage, 0);
    int64_t at = picture->moment;
    return at;
}

static void test_the_other_end_is_the_same(void **state)
{
    const char *folder = *state;
    game g = begin("pool", 400);
    pass(&g, 0.2);
    drag(&g, HAND, 300, 800, 900, 300, 0.7);
    drag(&g, WALL, 700, 500, 1000, 550, 0.4);
    drag(&g, WATER, 400, 150, 600, 200, 0.5);
    skv_stage_undo(g.stage); /* the water */
    skv_stage_set_gravity(g.stage, 0, 0.6, -0.8);
    skv_stage_set(g.stage, 0, "fluid.viscosity", "0.002");
    skv_stage_push(g.stage, 0, 0.3, 1);
    pass(&g, 0.5);
    text link = share(&g);
    expect_end(folder, link.bytes, moment(&g), hash_of(&g));
    /* Of a moment in the past: what came after is not in it. */
    skv_stage_seek(g.stage, 40);
    text past = share(&g);
    assert_true(strlen(past.bytes) < strlen(link.bytes));
    expect_end(folder, past.bytes, 40, hash_of(&g));
    skv_stage_destroy(g.stage);
}

/* What replay says of another world, and of no link at all. */
static void test_what_is_not_the_same(void **state)
{
    const char *folder = *state;
    game g = begin("pool", 300);
    pass(&g, 0.5);
    text link = share(&g);
    skv_stage_destroy(g.stage);
    link.bytes[strlen(link.bytes) / 2] ^= 1;
    program_result result = SKVALP(folder, "replay", link.bytes);
    assert_int_equal(result.status, 2);
    assert_int_equal(count_lines(result.err), 1);
    program_free(&result);
    result = SKVALP(folder, "replay", "skvalp:2.AAAA");
    assert_int_equal(result.status, 2);
    assert_non_null(strstr(result.err, "use a newer skvalp"));
    program_free(&result);
}

/* A saved game becomes a link by the command line; a link of a page; a state becomes none. */
static void test_share_command(void **state)
{
    const char *folder = *state;
    char path[4096];
    game g = begin("dam-break", 300);
    drag(&g, HAND, 300, 800, 900, 300, 0.5);
    uint64_t hash = hash_of(&g);
    int64_t frames = moment(&g);
    snprintf(path, sizeof path, "%s/game.skvr", folder);
    skv_stage_save(g.stage, path);
    snprintf(path, sizeof path, "%s/state.skv", folder);
    skv_stage_save(g.stage, path);
    skv_stage_destroy(g.stage);
    program_result result = SKVALP(folder, "share", "game.skvr", "--quiet");
    assert_int_equal(result.status, 0);
    assert_int_equal(count_lines(result.out), 1);
    expect_end(folder, result.out, frames, hash); /* its line end does no harm */
    program_result again = SKVALP(folder, "share", result.out, "--page", "https://example.org/a/");
    assert_int_equal(again.status, 0);
    assert_int_equal(strncmp(again.out, "https://example.org/a/#1.", 25), 0);
    assert_string_equal(again.out + 25, result.out + strlen("skvalp:1."));
    expect_end(folder, again.out, frames, hash);
    program_free(&again);
    program_free(&result);
    result = SKVALP(folder, "share", "game.skvr", "--particles", "100");
    assert_int_equal(result.status, 2);
    assert_non_null(strstr(result.err, "leave out --particles"));
    program_free(&result);
    /* Of the second no link could be read again. */
    static const char *const no_pages[] = {"https://a b", "example.org/water/", "a b"};
    for (int i = 0; i < 3; i++) {
        result = SKVALP(folder, "share", "pool", "--page", no_pages[i]);
        assert_int_equal(result.status, 2);
        assert_non_null(strstr(result.err, "is no address of a page"));
        program_free(&result);
    }
}

/* docs/share.md says how long links are; those of a minute have to fit. */
static void test_links_are_short(void **state)
{
    (void)state;
    game g = begin("pool", 100);
    play_ten_seconds(&g);
    text ten = share(&g);
    for (int i = 1; i < 6; i++)
        play_ten_seconds(&g);
    text minute = share(&g);
    skv_stage_destroy(g.stage);
    g = begin("pool", 100);
    for (int i = 0; i < 30; i++)
        drag(&g, HAND, 300 + 40 * (i % 20), 800, 1300 - 30 * (i % 11), 300, 2);
    text busy = share(&g);
    skv_stage_destroy(g.stage);
    printf(
        "links: %zu characters (%zu bytes) for 10 s, %zu (%zu) for 60 s, %zu (%zu) for 60 s with "
        "the hand\n",
        strlen(ten.bytes), ten.size, strlen(minute.bytes), minute.size, strlen(busy.bytes),
        busy.size);
    assert_true(strlen(ten.bytes) < 4000);
    assert_true(strlen(minute.bytes) < 20000);
    assert_true(strlen(busy.bytes) < SKV_LONGEST_LINK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_the_other_end_is_the_same, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_what_is_not_the_same, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_share_command, folder_setup, folder_teardown),
        cmocka_unit_test(test_links_are_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
