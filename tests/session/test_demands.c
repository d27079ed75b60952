/* What strangers send: what it asks for is known before it is opened, what is not modest is opened
 * only when it is asked for twice, and no frame keeps whoever steps. */
#include "base/envelope.h"
#include "skvalp/snapshot.h"
#include "support.h"
#include "support/fixture.h"
#include "support/kept.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static kept save(const skv_player *player)
{
    kept saved = {0};
    assert_int_equal(skv_player_save(player, kept_add, &saved, NULL), SKV_OK);
    return saved;
}

/* A replay of two frames, with so many commands before its first. */
static kept make_replay(int commands)
{
    skv_player *player = open_player(0);
    for (int i = 0; i < commands; i++) {
        skv_command command = {.kind = SKV_COMMAND_GRAVITY,
                               .vector = {0.001f * (float)(i % 7), -9}};
        assert_int_equal(skv_player_apply(player, &command, NULL), SKV_OK);
    }
    for (int f = 0; f < 2; f++)
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    kept saved = save(player);
    skv_player_destroy(player);
    return saved;
}

/* The same that claims to go on for very long: its end stands behind the version's text. */
static kept make_endless(void)
{
    kept saved = make_replay(1);
    skv_writer w = {(uint8_t *)saved.bytes, 32 + 1 + strlen(skv_version())};
    skv_put(&w, UINT32_MAX, 4);
    skv_envelope_seal((uint8_t *)saved.bytes, saved.size);
    return saved;
}

/* A state of so many particles in two millimetres. */
static kept make_crowd(int particles)
{
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    for (int i = 0; i < particles; i++)
        assert_int_equal(skv_world_add_particle(world, 0.5f + 1e-7f * (float)i, 0.5f, 0, 0, NULL),
                         SKV_OK);
    kept saved = {.size = skv_world_snapshot_size(world, true)};
    saved.bytes = malloc(saved.size);
    assert_int_equal(skv_world_save(world, true, saved.bytes, saved.size, NULL), SKV_OK);
    skv_world_destroy(world);
    return saved;
}

static skv_demands ask(kept saved)
{
    skv_demands demands;
    skv_error error;
    if (skv_player_ask(saved.bytes, saved.size, &demands, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return demands;
}

static void expect_modest(skv_demands demands)
{
    skv_error error;
    if (skv_demands_check(&demands, &error) != SKV_OK)
        fail_msg("%s", error.text);
}

static void expect_much(skv_demands demands, const char *says)
{
    skv_error error = {0};
    assert_int_equal(skv_demands_check(&demands, &error), SKV_ERROR_LIMIT);
    if (!strstr(error.text, says))
        fail_msg("%s", error.text);
}

static void what_it_asks_for_is_known(void **unused)
{
    (void)unused;
    kept saved = make_replay(30);
    skv_demands demands = ask(saved);
    assert_int_equal(demands.frames, 2);
    assert_int_equal(demands.particles, 300);
    assert_int_equal(demands.at_once, 30);
    assert_true(demands.crowding > 0.5 && demands.crowding < 3);
    expect_modest(demands);
    free(saved.bytes);

    saved = make_endless();
    expect_much(ask(saved), "it plays for 1193046 minutes, 4294967295 frames");
    free(saved.bytes);
    saved = make_replay(SKV_MODEST_AT_ONCE + 1);
    expect_much(ask(saved), "it does 5001 things within a frame");
    free(saved.bytes);
    saved = make_crowd(3000);
    demands = ask(saved);
    assert_int_equal(demands.particles, 3000);
    expect_much(demands, "its fluid is pressed to ");
    free(saved.bytes);
    expect_modest((skv_demands){.particles = SKV_MODEST_PARTICLES});
    expect_much((skv_demands){.particles = SKV_MODEST_PARTICLES + 1}, "it begins with 100001");

    skv_error error = {0};
    assert_int_equal(skv_player_ask("nothing", 7, &demands, &error), SKV_ERROR_FORMAT);
}

/* A link has the scene alone: what it makes is counted before it is made. */
static bool ask_linked(const char *bytes, size_t size, void *user)
{
    return skv_player_ask(bytes, size, user, NULL) == SKV_OK;
}

static void a_scene_s_particles_are_counted(void **unused)
{
    (void)unused;
    skv_player *player = open_player(0);
    skv_demands demands;
    assert_int_equal(skv_player_share(player, ask_linked, &demands, NULL), SKV_OK);
    assert_int_equal(demands.particles, 300);
    assert_true(demands.crowding == 0);
    skv_player_destroy(player);
}

static void open_cautiously(skv_stage *stage, kept saved, const char *format)
{
    skv_scene_options options = skv_default_scene_options();
    options.cautious = true;
    skv_stage_open_memory(stage, saved.bytes, saved.size, format, "a.skvr", &options);
}

static void what_asks_for_much_is_opened_when_asked_for_twice(void **state)
{
    skv_stage *stage = *state;
    skv_outcome report;
    kept endless = make_endless(), crowd = make_crowd(3000);
    while (stage_report(stage, &report) != -1)
        continue;
    for (int round = 0; round < 2; round++) {
        open_cautiously(stage, endless, "skvr");
        assert_int_equal(stage_report(stage, &report), SKV_ERROR_LIMIT);
        assert_string_equal(report.error.text,
                            "a.skvr: it plays for 1193046 minutes, 4294967295 frames; open it once "
                            "more if that is wanted");
        /* Something else between, and one is asked again. */
        open_cautiously(stage, crowd, "skv");
        assert_int_equal(stage_report(stage, &report), SKV_ERROR_LIMIT);
    }
    for (int again = 0; again < 2; again++) {
        open_cautiously(stage, crowd, "skv");
        assert_int_equal(stage_report(stage, &report), SKV_OK);
    }
    /* What one has made oneself is not asked about. */
    skv_stage_open_memory(stage, endless.bytes, endless.size, "skvr", "a.skvr", NULL);
    assert_int_equal(stage_report(stage, &report), SKV_OK);
    free(endless.bytes);
    free(crowd.bytes);
}

/* 1000 commands before a frame: each call gives 256, and the last one steps. */
static void a_frame_with_many_commands_comes_in_pieces(void **unused)
{
    (void)unused;
    kept saved = make_replay(1000);
    skv_player *player;
    assert_int_equal(skv_player_load(saved.bytes, saved.size, NULL, &player, NULL), SKV_OK);
    for (int call = 1; call <= 4; call++) {
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        assert_int_equal(skv_player_frame(player), call == 4);
    }
    assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    assert_int_equal(skv_player_end(player), 2);
    assert_int_equal(skv_player_frame(player), 2);
    uint64_t hash = skv_world_hash(skv_player_world(player));
    /* Seeking comes there as well, and to the same world. */
    assert_int_equal(skv_player_seek(player, 0, NULL), SKV_OK);
    assert_int_equal(skv_player_seek(player, 2, NULL), SKV_OK);
    while (skv_player_seeking(player))
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    assert_true(skv_world_hash(skv_player_world(player)) == hash);
    assert_int_equal(skv_player_mismatch(player), -1);
    skv_player_destroy(player);
    free(saved.bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_it_asks_for_is_known),
        cmocka_unit_test(a_scene_s_particles_are_counted),
        cmocka_unit_test_setup_teardown(what_asks_for_much_is_opened_when_asked_for_twice,
                                        stage_setup, stage_teardown),
        cmocka_unit_test(a_frame_with_many_commands_comes_in_pieces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
