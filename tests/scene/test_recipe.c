/* Recipes: from what a scene holds of its making it is made again, without its files. */
#include "scene/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <skvalp/query.h>
#include <skvalp/world.h>

#include "scene/recipe.h"

static uint64_t hash_of(const skv_scene *scene)
{
    skv_world *world;
    assert_int_equal(skv_scene_create_world(scene, 1, &world, NULL), SKV_OK);
    uint64_t hash = skv_world_hash(world);
    skv_world_destroy(world);
    return hash;
}

/* Takes the scene over. */
static void expect_again(skv_scene *scene, size_t most)
{
    size_t size;
    skv_scene *again;
    skv_error error = {0};
    const uint8_t *recipe = skv_scene_recipe(scene, &size);
    assert_non_null(recipe);
    assert_true(size <= most);
    if (skv_recipe_load(recipe, size, NULL, &again, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_true(hash_of(again) == hash_of(scene));
    assert_string_equal(skv_scene_name(again), skv_scene_name(scene));
    skv_scene_destroy(again);
    skv_scene_destroy(scene);
}

static void test_built_in_with_settings(void **state)
{
    (void)state;
    skv_scene *scene;
    skv_scene_options options = skv_default_scene_options();
    skv_setting settings[] = {{"fluid.material", "honey"}, {"title", "Two \"words\""}};
    options.particles = 300;
    options.settings = settings;
    options.setting_count = 2;
    assert_int_equal(skv_scene_load("dam-break", &options, &scene, NULL), SKV_OK);
    expect_again(scene, 100); /* its name and what was set, not its text */
}

static void test_built_in_with_a_picture(void **state)
{
    (void)state;
    skv_scene *scene;
    skv_scene_options options = skv_default_scene_options();
    options.particles = 300;
    assert_int_equal(skv_scene_load("funnel", &options, &scene, NULL), SKV_OK);
    expect_again(scene, 100); /* which every library of this version has, too */
}

static void test_json_without_its_space(void **state)
{
    (void)state;
    skv_scene *scene;
    static const char text[] =
        "{\n  \"title\": \"A \\\" in a  title\",\n"
        "  \"particles\": 100,\t\"water\" : [ { \"shape\": \"box\", \"y1\": 0.4 } ]\n}\n";
    skv_error error = {0};
    if (load_text(text, NULL, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    size_t size;
    const char *recipe = (const char *)skv_scene_recipe(scene, &size);
    static const char packed[] =
        "{\"title\":\"A \\\" in a  "
        "title\",\"particles\":100,\"water\":[{\"shape\":\"box\",\"y1\":0.4}]}";
    size_t length = sizeof packed - 1;
    assert_memory_equal(recipe + size - 4 - length, packed, length);
    expect_again(scene, sizeof text + 20);
}

static rgb paint(int x, int y, void *user)
{
    (void)user;
    return x < 3 || y > 36 ? (rgb){255, 255, 255} : y > 20 ? (rgb){0, 0, 255} : (rgb){0, 0, 0};
}

static void write_file(const char *path, const void *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    fclose(file);
}

static void test_a_picture_beside_its_file(void **state)
{
    (void)state;
    static const char text[] =
        "{ \"particles\": 100, \"world\": { \"width\": 1, \"picture\": \"p.png\" } }";
    char folder[] = "/tmp/skvalp-recipe-XXXXXX", json[64], png[64];
    assert_non_null(mkdtemp(folder));
    snprintf(json, sizeof json, "%s/tank.json", folder);
    snprintf(png, sizeof png, "%s/p.png", folder);
    buffer picture = write_rgb(40, 40, paint, NULL);
    write_file(json, text, sizeof text - 1);
    write_file(png, picture.data, picture.size);
    skv_scene *scene, *painted;
    skv_error error = {0};
    if (skv_scene_load(json, NULL, &scene, &error) || skv_scene_load(png, NULL, &painted, &error))
        fail_msg("%s", error.text);
    unlink(json);
    unlink(png);
    rmdir(folder);
    size_t size;
    const uint8_t *recipe = skv_scene_recipe(scene, &size);
    for (size_t i = 0; i + 4 < size; i++) /* nobody's folders */
        assert_true(memcmp(recipe + i, "/tmp", 4) != 0);
    expect_again(scene, sizeof text + picture.size + 40);
    expect_again(painted, picture.size + 40);
    buffer_free(&picture);
}

static void test_damage_is_refused(void **state)
{
    (void)state;
    skv_scene *scene, *again;
    size_t size;
    skv_error error = {0};
    assert_int_equal(skv_scene_load("pool", NULL, &scene, NULL), SKV_OK);
    const uint8_t *recipe = skv_scene_recipe(scene, &size);
    for (size_t cut = 0; cut < size; cut++) {
        assert_int_equal(skv_recipe_load(recipe, cut, NULL, &again, &error), SKV_ERROR_FORMAT);
        assert_null(again);
        assert_non_null(strstr(error.text, "take another copy"));
    }
    skv_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_built_in_with_settings),
        cmocka_unit_test(test_built_in_with_a_picture),
        cmocka_unit_test(test_json_without_its_space),
        cmocka_unit_test(test_a_picture_beside_its_file),
        cmocka_unit_test(test_damage_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
