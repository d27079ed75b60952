/* What the command line does to the user's files: no output takes the place of an input, nothing is
 * left behind, and a name is taken at its word. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "program.h"
#include "skvalp/skvalp.h"

#define SHORT "--particles", "300", "--seconds", "0.02", "--threads", "1"

static const char scene[] = "{\"world\": {\"picture\": \"picture.png\"}}";

static void path_of(char path[4096], const char *folder, const char *name)
{
    snprintf(path, 4096, "%s/%s", folder, name);
}

/* scene.json, its picture.png, and a symbolic and a hard link to each. */
static void write_inputs(const char *folder)
{
    static const char *const names[] = {"scene.json", "picture.png"};
    char path[4096], link_path[4096];
    program_result copied =
        program_run(folder, (const char *const[]){"cp", SKV_SOURCE_DIR "/scenes/painted/maze.png",
                                                  "picture.png", NULL});
    assert_int_equal(copied.status, 0);
    program_free(&copied);
    file_write(folder, "scene.json", scene);
    for (int i = 0; i < 2; i++) {
        char name[64];
        path_of(path, folder, names[i]);
        snprintf(name, sizeof name, "soft-%s", names[i]);
        path_of(link_path, folder, name);
        assert_int_equal(symlink(names[i], link_path), 0);
        snprintf(name, sizeof name, "hard-%s", names[i]);
        path_of(link_path, folder, name);
        assert_int_equal(link(path, link_path), 0);
    }
}

static void expect_refused(program_result result, const char *says)
{
    assert_int_equal(result.status, 2);
    assert_string_equal(result.out, "");
    assert_int_equal(count_lines(result.err), 1);
    if (!strstr(result.err, says))
        fail_msg("it says: %s", result.err);
    program_free(&result);
}

static void test_inputs_are_kept(void **state)
{
    const char *folder = *state;
    write_inputs(folder);
    int entries = folder_entries(folder);
    static const char *const cases[][3] = {
        {"scene.json", "--csv", "scene.json"},
        {"scene.json", "--trace", "./soft-scene.json"},
        {"scene.json", "--csv", "hard-scene.json"},
        {"soft-scene.json", "--csv", "scene.json"},
        {"scene.json", "--png", "picture.png"},
        {"scene.json", "--png", "soft-picture.png"},
        {"scene.json", "--csv", "hard-picture.png"},
        {"picture.png", "--png", "picture.png"},
        {"hard-picture.png", "--png", "picture.png"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        expect_refused(SKVALP(folder, "run", cases[i][0], SHORT, cases[i][1], cases[i][2]),
                       "the scene is read from there and would be lost; name another file");
    assert_int_equal(folder_entries(folder), entries);
    char *text = file_read(folder, "scene.json");
    assert_string_equal(text, scene);
    free(text);
    program_result same =
        program_run(folder, (const char *const[]){"cmp", SKV_SOURCE_DIR "/scenes/painted/maze.png",
                                                  "picture.png", NULL});
    assert_int_equal(same.status, 0);
    program_free(&same);
}

/* A picture's name must not promise what it will not hold; a link to nowhere is not replaced. */
static void test_names_are_taken_at_their_word(void **state)
{
    expect_refused(SKVALP(*state, "run", "pool", SHORT, "--png", "s.jpg"),
                   "--png: 's.jpg' is no .png");
    expect_refused(SKVALP(*state, "bench", "--plot", "s.png"), "--plot: 's.png' is no .svg");
    char path[4096];
    path_of(path, *state, "link.png");
    assert_int_equal(symlink("nowhere.png", path), 0);
    expect_refused(SKVALP(*state, "run", "pool", SHORT, "--png", "link.png"),
                   "link.png: it is a link that leads nowhere; remove it or name another file");
    assert_int_equal(folder_entries(*state), 1);
    char target[16] = "";
    assert_int_equal(readlink(path, target, sizeof target), 11);

    program_result result = SKVALP(*state, "run", "pool", SHORT, "--png", "a.PNG");
    assert_int_equal(result.status, 0);
    program_free(&result);
    result = SKVALP(*state, "run", "pool", SHORT, "--png", "picture");
    assert_int_equal(result.status, 0);
    program_free(&result);
}

/* A file's name goes to the terminal as plain text, also where nothing is wrong with it. */
static void test_names_are_shown_plain(void **state)
{
    file_write(*state,
               "a\xe2\x80\xae"
               "b\xc2\x9b"
               "c.json",
               "{\"particles\": 300, \"water\": [{\"shape\": \"box\", \"y1\": 0.3}]}");
    program_result result = SKVALP(*state, "check",
                                   "a\xe2\x80\xae"
                                   "b\xc2\x9b"
                                   "c.json");
    assert_int_equal(result.status, 0);
    assert_non_null(strstr(result.out, "a?b?c: ok, "));
    program_free(&result);
    result = SKVALP(*state, "run", "pool", SHORT, "--particles", "300", "--snapshot", "s\x9b.skv");
    assert_int_equal(result.status, 0);
    program_free(&result);
    result = SKVALP(*state, "replay", "s\x9b.skv");
    assert_null(strstr(result.out, "\x9b"));
    assert_null(strstr(result.err, "\x9b"));
    program_free(&result);
    result = SKVALP(*state, "run", "s\x9b.skv", "--seconds", "0");
    assert_int_equal(result.status, 0);
    assert_non_null(strstr(result.out, "s?.skv: 300 particles"));
    program_free(&result);
}

/* What a stranger may have made to keep one waiting is named, and opened only with a word more. */
static void test_states_that_ask_for_much(void **state)
{
    skv_world_def def = skv_default_world_def();
    skv_terrain_def tank = skv_default_terrain_def();
    skv_world *world;
    assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    for (int i = 0; i < 300; i++)
        assert_int_equal(skv_world_add_particle(world, 0.5f, 0.5f, 0, 0, NULL), SKV_OK);
    size_t size = skv_world_snapshot_size(world, true);
    char *bytes = malloc(size), path[4096];
    assert_int_equal(skv_world_save(world, true, bytes, size, NULL), SKV_OK);
    skv_world_destroy(world);
    path_of(path, *state, "crowd.skv");
    FILE *file = fopen(path, "wb");
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
    free(bytes);
    expect_refused(SKVALP(*state, "run", "crowd.skv", "--seconds", "0"),
                   "crowd.skv: its fluid is pressed to 33 times what it is at rest, and takes as "
                   "much longer to step; add --anyway if that is wanted");
    expect_refused(SKVALP(*state, "replay", "crowd.skv"), "add --anyway if that is wanted");
    program_result result = SKVALP(*state, "run", "crowd.skv", "--seconds", "0", "--anyway");
    assert_int_equal(result.status, 0);
    program_free(&result);
}

static void test_long_names_leave_room_for_the_remedy(void **state)
{
    char name[5001];
    memset(name, 'a', 5000);
    name[5000] = '\0';
    memcpy(name + 4995, ".json", 5);
    expect_refused(SKVALP(*state, "run", name), "aaa.json: cannot be opened");
    memcpy(name + 4995, "a.png", 5);
    expect_refused(SKVALP(*state, "run", "pool", SHORT, "--png", name),
                   "aaa.png: cannot be written: File name too long; ");
    expect_refused(SKVALP(*state, "run", "pool", "--seconds", name),
                   "aaa.png' is not a number; allowed is 0 to 86400 s");
}

/* Beyond the largest size that the shell allows, the signal must not end the program untidily. */
static void test_size_limit(void **state)
{
    static const char *const outputs[] = {"--png big.png", "--trace big.csv --trace-every 0.001"};
    for (int i = 0; i < 2; i++) {
        char line[512];
        snprintf(line, sizeof line,
                 "ulimit -f 8; exec \"$0\" run pool --particles 1000 --seconds 0.2 %s", outputs[i]);
        expect_refused(program_run(*state, (const char *const[]){"bash", "-c", line,
                                                                 SKV_BINARY_DIR "/skvalp", NULL}),
                       "cannot be written: File too large; make room or write elsewhere");
        assert_int_equal(folder_entries(*state), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_inputs_are_kept, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_names_are_taken_at_their_word, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_names_are_shown_plain, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_states_that_ask_for_much, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_long_names_leave_room_for_the_remedy, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_size_limit, folder_setup, folder_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
