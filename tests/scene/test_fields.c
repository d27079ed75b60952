/* The registry: complete, free of duplicates, with defaults that its own ranges allow and that the
 * core library shares. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/fields.h"
#include <skvalp/parameters.h>

static void test_every_row_is_complete(void **state)
{
    (void)state;
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    assert_int_equal(count, SKV_F_COUNT);
    for (int i = 0; i < count; i++) {
        assert_ptr_equal(skv_scene_field(i), &fields[i]);
        assert_non_null(fields[i].path);
        assert_non_null(fields[i].unit);
        assert_non_null(fields[i].default_text);
        assert_true(strlen(fields[i].help) > 3);
        assert_null(strchr(fields[i].help, '\n'));
        assert_int_equal(fields[i].type == SKV_FIELD_CHOICE, fields[i].choices != NULL);
        if (fields[i].type != SKV_FIELD_CHOICE)
            assert_true(fields[i].minimum < fields[i].maximum);
    }
}

static void test_paths_are_unique_and_found(void **state)
{
    (void)state;
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    for (int i = 0; i < count; i++)
        assert_int_equal(skv_field_find(fields, count, fields[i].path), i);
    assert_int_equal(skv_field_find(fields, count, "fluid"), -1);
    assert_string_equal(fields[SKV_F_FLUID_SPACING].path, "fluid.spacing");
    assert_string_equal(fields[SKV_F_OPEN_TOP].path, "world.open.top");
    assert_string_equal(fields[SKV_F_SOLID + SKV_SOLID_CARVE].path, "solid[].carve");
    assert_string_equal(fields[SKV_F_WATER + SKV_SHAPE_POINTS].path, "water[].points[][]");
    assert_string_equal(fields[SKV_F_WATER + SKV_WATER_VY].path, "water[].vy");
}

static void test_defaults_lie_in_their_ranges(void **state)
{
    (void)state;
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    for (int i = 0; i < count; i++) {
        const skv_field *f = &fields[i];
        double value;
        if (f->default_text[0] == '\0')
            continue;
        if (f->type == SKV_FIELD_CHOICE) {
            assert_true(skv_field_choice(f->choices, f->default_text) >= 0);
        } else if (f->type == SKV_FIELD_BOOLEAN) {
            assert_true(strcmp(f->default_text, "true") == 0 ||
                        strcmp(f->default_text, "false") == 0);
        } else {
            assert_int_not_equal(f->type, SKV_FIELD_TEXT);
            assert_null(skv_field_read(f, f->default_text, &value));
        }
    }
}

/* A parameter of the world stands in both registries, and says the same in both; a scene finds the
 * spacing by itself, and the host's affairs are none of its. */
static void test_the_worlds_parameters_are_fields(void **state)
{
    (void)state;
    int count, shared = 0;
    const skv_field *fields = skv_scene_fields(&count), *world;
    for (int i = 0; (world = skv_world_field(i)); i++) {
        int found = skv_field_find(fields, count, world->path);
        if (found < 0)
            continue;
        shared++;
        const skv_field *f = &fields[found];
        assert_int_equal(f->type, world->type);
        assert_string_equal(f->unit, world->unit);
        assert_string_equal(f->help, world->help);
        assert_true(f->minimum == world->minimum && f->maximum == world->maximum);
        bool spacing = found == SKV_F_FLUID_SPACING;
        assert_string_equal(f->default_text, spacing ? "" : world->default_text);
    }
    assert_int_equal(shared, SKV_F_SINGLE - SKV_F_WORLDS);
    assert_int_equal(skv_field_find(fields, count, "threads"), -1);
}

/* The ends of every range are worlds that can be made. */
static void test_range_ends_make_worlds(void **state)
{
    (void)state;
    const skv_field *fields = skv_scene_fields(NULL);
    for (int id = SKV_F_WORLDS; id < SKV_F_SINGLE; id++) {
        bool number = fields[id].type == SKV_FIELD_NUMBER || fields[id].type == SKV_FIELD_INTEGER;
        for (int end = 0; number && end < 2; end++) {
            char value[32];
            skv_format_number(end ? fields[id].maximum : fields[id].minimum, value);
            const char *settings[] = {fields[id].path, value, NULL};
            skv_scene *scene;
            skv_world *world;
            skv_error error = {0};
            const char *text = "{\"world\":{\"width\":0.2,\"height\":0.2},"
                               "\"water\":[{\"shape\":\"box\",\"y1\":0.1}]}";
            const char *few = "{\"world\":{\"width\":0.2,\"height\":0.2},\"particles\":20,"
                              "\"water\":[{\"shape\":\"box\",\"y1\":0.1}]}";
            bool spacing = id == SKV_F_FLUID_SPACING;
            if (load_text(spacing ? text : few, settings, &scene, &error) != SKV_OK)
                fail_msg("%s=%s: %s", fields[id].path, value, error.text);
            if (skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
                fail_msg("%s=%s: %s", fields[id].path, value, error.text);
            skv_world_destroy(world);
            skv_scene_destroy(scene);
        }
    }
}

/* The material's choices are the library's liquids; it sets density and viscosity, and what is
 * given besides wins. */
static void test_materials(void **state)
{
    (void)state;
    const skv_material *material;
    const char *choices = skv_scene_fields(NULL)[SKV_F_FLUID_MATERIAL].choices;
    int count = 0;
    for (; (material = skv_material_info(count)); count++)
        assert_int_equal(skv_field_choice(choices, material->name), count);
    assert_int_equal(skv_field_choices(choices), count);
    assert_int_equal(skv_field_choice(choices, "tar"), -1);
    const char *text = "{\"particles\":20,\"fluid\":{\"viscosity\":0.001,\"material\":\"honey\"},"
                       "\"water\":[{\"shape\":\"box\",\"y1\":0.1}]}";
    for (int given = 0; given < 2; given++) {
        const char *settings[] = {"fluid.density", "900", NULL};
        skv_scene *scene;
        skv_world *world;
        assert_int_equal(load_text(text, given ? settings : NULL, &scene, NULL), SKV_OK);
        assert_int_equal(skv_scene_create_world(scene, 1, &world, NULL), SKV_OK);
        const skv_fluid_def *fluid = skv_world_fluid(world);
        assert_true(fluid->density == (given ? 900 : 1420));
        assert_true(fluid->viscosity == 0.001f);
        skv_world_destroy(world);
        skv_scene_destroy(scene);
    }
}

static void test_paths_are_taken_apart(void **state)
{
    (void)state;
    skv_field_path path;
    assert_true(skv_field_parse_path("water[2].points[0][1]", &path));
    assert_string_equal(path.pattern, "water[].points[][]");
    assert_int_equal(path.index_count, 3);
    assert_int_equal(path.index[0], 2);
    assert_int_equal(path.index[2], 1);
    char lengthy[SKV_PATH_SIZE + 20];
    memset(lengthy, 'a', sizeof lengthy);
    lengthy[sizeof lengthy - 1] = '\0';
    const char *const bad[] = {"water[]",       "water[-1]", "water[1", "water[99999999]",
                               "a[1][2][3][4]", "water[x]",  lengthy};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        assert_false(skv_field_parse_path(bad[i], &path));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_row_is_complete),
        cmocka_unit_test(test_paths_are_unique_and_found),
        cmocka_unit_test(test_defaults_lie_in_their_ranges),
        cmocka_unit_test(test_the_worlds_parameters_are_fields),
        cmocka_unit_test(test_range_ends_make_worlds),
        cmocka_unit_test(test_materials),
        cmocka_unit_test(test_paths_are_taken_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
