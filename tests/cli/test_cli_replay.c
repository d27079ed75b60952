/* skvalp replay and skvalp run over replay files: the recorded way, another way, and no replay. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/player.h>
#include <skvalp/query.h>

#include "program.h"
#include "support/kept.h"

static void write_bytes(const char *folder, const char *name, const kept *from)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(from->bytes, 1, from->size, file), from->size);
    fclose(file);
}

/* Two seconds of a pool that is pushed; returns the hash at the end. */
static uint64_t record(kept *saved)
{
    skv_scene_options options = skv_default_scene_options();
    skv_scene *scene;
    skv_player *player;
    options.particles = 200;
    assert_int_equal(skv_scene_load("pool", &options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_player_create(scene, NULL, &player, NULL), SKV_OK);
    for (int i = 0; i < 120; i++) {
        skv_command push = {.kind = SKV_COMMAND_PUSH};
        push.vector.x = 0.5f;
        if (i % 40 == 20)
            assert_int_equal(skv_player_apply(player, &push, NULL), SKV_OK);
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    }
    kept_clear(saved);
    assert_int_equal(skv_player_save(player, kept_add, saved, NULL), SKV_OK);
    uint64_t hash = skv_world_hash(skv_player_world(player));
    skv_player_destroy(player);
    return hash;
}

/* Makes the checksum right again: FNV-1a of all but its own eight bytes, which begin at 24. */
static void sign(kept *saved)
{
    uint64_t hash = 14695981039346656037u;
    for (size_t i = 0; i < saved->size; i++)
        if (i < 24 || i >= 32)
            hash = (hash ^ (uint8_t)saved->bytes[i]) * 1099511628211u;
    for (int i = 0; i < 8; i++)
        saved->bytes[24 + i] = (char)(uint8_t)(hash >> 8 * i);
}

static kept saved;

static void test_as_recorded(void **state)
{
    const char *folder = *state;
    char wanted[64];
    uint64_t hash = record(&saved);
    write_bytes(folder, "game.skvr", &saved);
    program_result result = SKVALP(folder, "replay", "game.skvr");
    assert_int_equal(result.status, 0);
    snprintf(wanted, sizeof wanted, "as recorded; hash %016llx", (unsigned long long)hash);
    assert_non_null(strstr(result.out, "120 frames, 2 s"));
    assert_non_null(strstr(result.out, wanted));
    program_free(&result);
    result = SKVALP(folder, "replay", "game.skvr", "--json", "--threads", "2");
    assert_int_equal(result.status, 0);
    assert_non_null(strstr(result.out, "\"same\": true"));
    program_free(&result);
    /* What run makes of it. */
    result = SKVALP(folder, "run", "game.skvr", "--json", "--csv", "a.csv");
    assert_int_equal(result.status, 0);
    snprintf(wanted, sizeof wanted, "%016llx", (unsigned long long)hash);
    assert_non_null(strstr(result.out, wanted));
    assert_true(file_exists(folder, "a.csv"));
    program_free(&result);
    result = SKVALP(folder, "run", "game.skvr", "--particles", "100");
    assert_int_equal(result.status, 2);
    program_free(&result);
}

/* The last record's hash is another one: the way that was gone is not the one recorded. */
static void test_another_way(void **state)
{
    const char *folder = *state;
    record(&saved);
    saved.bytes[saved.size - 1] ^= 1;
    sign(&saved);
    write_bytes(folder, "game.skvr", &saved);
    program_result result = SKVALP(folder, "replay", "game.skvr");
    assert_int_equal(result.status, 1);
    assert_string_equal(result.out, "");
    assert_int_equal(count_lines(result.err), 1);
    assert_non_null(strstr(result.err, "at 2 s, frame 120"));
    program_free(&result);
    result = SKVALP(folder, "replay", "game.skvr", "--json");
    assert_int_equal(result.status, 1);
    assert_non_null(strstr(result.out, "\"same\": false"));
    program_free(&result);
    /* No link is made of it. */
    result = SKVALP(folder, "share", "game.skvr");
    assert_int_equal(result.status, 1);
    assert_string_equal(result.out, "");
    program_free(&result);
}

static void test_no_replay(void **state)
{
    const char *folder = *state;
    const struct {
        const char *name, *says;
    } cases[] = {
        {"none.skvr", "cannot be opened"}, {"text.skvr", "not one"}, {"cut.skvr", "cut short"}};
    record(&saved);
    saved.size /= 2;
    write_bytes(folder, "cut.skvr", &saved);
    file_write(folder, "text.skvr", "hello");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        program_result result = SKVALP(folder, "replay", cases[i].name);
        assert_int_equal(result.status, 2);
        assert_int_equal(count_lines(result.err), 1);
        assert_non_null(strstr(result.err, cases[i].name));
        if (!strstr(result.err, cases[i].says))
            fail_msg("it says: %s", result.err);
        program_free(&result);
    }
    program_result result = SKVALP(folder, "replay");
    assert_int_equal(result.status, 2);
    assert_non_null(strstr(result.err, "FILE is missing"));
    program_free(&result);
}

/* Looking between two frames changes nothing of the run. */
static void test_moments_between_frames(void **state)
{
    const char *folder = *state;
    program_result plain =
        SKVALP(folder, "run", "dam-break", "--particles", "300", "--seconds", "0.5", "--json");
    program_result looked =
        SKVALP(folder, "run", "dam-break", "--particles", "300", "--seconds", "0.5", "--json",
               "--trace", "t.csv", "--trace-every", "0.007", "--snapshot", "s.skv", "--at", "0.21");
    const char *a = strstr(plain.out, "\"hash\""), *b = strstr(looked.out, "\"hash\"");
    assert_true(a && b && strncmp(a, b, 26) == 0);
    program_free(&plain);
    program_free(&looked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_as_recorded, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_another_way, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_no_replay, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_moments_between_frames, folder_setup, folder_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
