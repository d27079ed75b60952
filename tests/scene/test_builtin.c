/* The built-in scenes and the painted examples: they load, say what they are, and build worlds of
 * exactly the particles that were asked for. */
#include "support.h"
#include "support/fixture.h"
#include "support/long.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[] = {
    "pool",    "dam-break",     "waves",    "breaking-wave", "u-tube",      "communicating",
    "splash",  "pipes",         "fountain", "duck",          "water-wheel", "ink",
    "oil",     "three-liquids", "mercury",  "floating",      "boat",        "lock",
    "tsunami", "jelly",         "goo",      "funnel",        "tank"};
enum { SCENES = sizeof names / sizeof *names };

static bool is_painted(const char *name)
{
    return strcmp(name, "funnel") == 0;
}

static bool is_empty(const char *name)
{
    return strcmp(name, "tank") == 0;
}

static void test_the_list(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        const skv_scene_info *info = skv_builtin_scene(i);
        assert_non_null(info);
        assert_string_equal(info->name, names[i]);
        assert_true(strlen(info->title) >= 4);
        assert_true(strlen(info->description) >= 40);
        assert_int_equal(info->painted, is_painted(names[i]));
    }
    assert_null(skv_builtin_scene(SCENES));
    assert_null(skv_builtin_scene(-1));
}

/* The compiled-in scene and the file of scenes/ are the same. */
static void test_files_and_builtins_agree(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        char path[512];
        snprintf(path, sizeof path, "%s/scenes/%s.json", SKV_SOURCE_DIR, names[i]);
        skv_scene *file, *builtin;
        skv_error error = {0};
        if (skv_scene_load(path, NULL, &file, &error) != SKV_OK)
            fail_msg("%s", error.text);
        assert_int_equal(skv_scene_load(names[i], NULL, &builtin, &error), SKV_OK);
        assert_string_equal(skv_scene_name(file), names[i]);
        assert_string_equal(skv_scene_name(builtin), names[i]);
        assert_string_equal(skv_scene_title(file), skv_builtin_scene(i)->title);
        assert_string_equal(skv_scene_description(file), skv_builtin_scene(i)->description);
        assert_true(skv_scene_seconds(file) == skv_scene_seconds(builtin));
        assert_int_equal(skv_scene_amount(file), skv_scene_amount(builtin));
        assert_true((skv_scene_notice(file, 0) != NULL) == is_painted(names[i]));
        skv_scene_destroy(file);
        skv_scene_destroy(builtin);
    }
}

/* Loads a scene, and checks the number. */
static skv_scene *load(const char *name, int particles, int expected)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_scene *scene;
    skv_error error = {0};
    if (skv_scene_load(name, &options, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_int_equal(skv_scene_particles(scene), expected);
    return scene;
}

/* And builds it; everybody has a place. */
static uint64_t build(const char *name, int particles, int expected)
{
    skv_scene *scene = load(name, particles, expected);
    skv_world *world;
    skv_error error = {0};
    if (skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s: %s", name, error.text);
    assert_int_equal(skv_world_particle_count(world), expected);
    skv_stats stats = skv_world_stats(world);
    assert_int_equal(stats.escaped, 0);
    assert_int_equal(stats.not_finite, 0);
    /* With fewer particles narrow vessels have hardly any bulk to measure. */
    double ratio = fixture_packing(world).volume_ratio;
    if (expected >= 1000 && !(ratio > 0.97 && ratio < 1.03))
        fail_msg("%s with %d: volume ratio %f", name, expected, ratio);
    uint64_t hash = skv_world_hash(world);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    return hash;
}

/* As many as a scene says by itself. */
static int own_number(const char *name)
{
    return is_empty(name)                     ? 0
           : strcmp(name, "fountain") == 0    ? 1500
           : strcmp(name, "duck") == 0        ? 2500
           : strcmp(name, "water-wheel") == 0 ? 2000
           : strcmp(name, "ink") == 0         ? 4000
                                              : 3000;
}

/* And the same world each time. Worlds of a scene's own number, and large ones, in long. */
static void test_numbers_of_particles(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        int few = is_empty(names[i]) ? 0 : 500;
        uint64_t hash = build(names[i], 500, few);
        assert_true(build(names[i], 500, few) == hash);
        build(names[i], 1000, 2 * few);
        skv_scene_destroy(load(names[i], 0, own_number(names[i])));
        if (long_tests()) {
            build(names[i], 0, own_number(names[i]));
            build(names[i], 6000, 12 * few);
        }
    }
}

static void test_painted_examples(void **state)
{
    (void)state;
    static const char *const pictures[] = {"maze", "funnel", "harbour"};
    for (int i = 0; i < 3; i++) {
        char path[512];
        snprintf(path, sizeof path, "%s/scenes/painted/%s.png", SKV_SOURCE_DIR, pictures[i]);
        build(path, 0, 3000);
        build(path, 1000, 1000);
    }
}

static void test_unknown_names(void **state)
{
    (void)state;
    static const char *const bad[] = {"pol", "", "Pool", "pool ", ".", "/", "scenes/pool.txt"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        skv_scene *scene;
        skv_error error;
        char message[600];
        assert_int_equal(skv_scene_load(bad[i], NULL, &scene, &error), SKV_ERROR_FILE);
        snprintf(message, sizeof message,
                 "%s: is no scene; allowed are a file that ends in .json or .png, or one of pool, "
                 "dam-break, waves, breaking-wave, u-tube, communicating, splash, pipes, fountain, "
                 "duck, water-wheel, ink, oil, three-liquids, mercury, floating, boat, lock, "
                 "tsunami, jelly, goo, funnel, tank",
                 bad[i]);
        assert_string_equal(error.text, message);
        assert_null(scene);
    }
}

/* ---- Callers' mistakes ----------------------------------------------------------------------- */

static int asserted;

static void count_assert(const char *condition, const char *file, int line, void *user)
{
    (void)condition;
    (void)file;
    (void)line;
    (void)user;
    asserted++;
}

static void test_misuse_is_asserted(void **state)
{
    (void)state;
    skv_set_assert_handler(count_assert, NULL);
    asserted = 0;
    skv_scene *scene;
    skv_world *world;
    skv_scene_options empty = {0};
    assert_int_equal(skv_scene_load(NULL, NULL, &scene, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_scene_load("pool", NULL, NULL, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_scene_load("pool", &empty, &scene, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_scene_load_memory(NULL, 0, "json", "a", NULL, &scene, NULL),
                     SKV_ERROR_VALUE);
    assert_int_equal(skv_scene_create_world(NULL, 1, &world, NULL), SKV_ERROR_VALUE);
    assert_null(world);
    assert_string_equal(skv_scene_name(NULL), "");
    assert_int_equal(skv_scene_particles(NULL), 0);
    assert_int_equal(asserted, 7);
    skv_set_assert_handler(NULL, NULL);
    assert_int_equal(skv_scene_load_memory("", 0, "gif", "a.gif", NULL, &scene, NULL),
                     SKV_ERROR_FORMAT);
    skv_scene_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_list),
        cmocka_unit_test(test_files_and_builtins_agree),
        cmocka_unit_test(test_numbers_of_particles),
        cmocka_unit_test(test_painted_examples),
        cmocka_unit_test(test_unknown_names),
        cmocka_unit_test(test_misuse_is_asserted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
