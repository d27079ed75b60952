/* The registry: complete, free of duplicates, with defaults that its own ranges allow and that the
 * core library shares. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/fields.h"

static void test_every_row_is_complete(void **state)
{
    (void)state;
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    assert_int_equal(count, SKV_F_COUNT);
    for (int i = 0; i < count; i++) {
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
        assert_int_equal(skv_field_find(fields[i].path), i);
    assert_int_equal(skv_field_find("fluid"), -1);
    assert_string_equal(fields[SKV_F_FLUID_SPACING].path, "fluid.spacing");
    assert_string_equal(fields[SKV_F_OPEN_TOP].path, "world.open.top");
    assert_string_equal(fields[SKV_F_SOLID + SKV_SHAPE_CARVE].path, "solid[].carve");
    assert_string_equal(fields[SKV_F_WATER + SKV_SHAPE_POINTS].path, "water[].points[][]");
    assert_string_equal(fields[SKV_F_WATER + SKV_SHAPE_VY].path, "water[].vy");
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
            assert_true(skv_parse_number(f->default_text, &value));
            assert_true(value >= f->minimum && value <= f->maximum);
        }
    }
}

static void test_fluid_defaults_are_the_librarys(void **state)
{
    (void)state;
    skv_fluid_def fluid = skv_default_fluid_def(SKV_LAW_CALIBRATED);
    const struct {
        skv_field_id id;
        double value;
    } cases[] = {
        {SKV_F_FLUID_RADIUS_RATIO, (double)fluid.radius_ratio},
        {SKV_F_FLUID_DENSITY, (double)fluid.density},
        {SKV_F_FLUID_VISCOSITY_LINEAR, (double)fluid.viscosity_linear},
        {SKV_F_FLUID_VISCOSITY_QUADRATIC, (double)fluid.viscosity_quadratic},
        {SKV_F_FLUID_NEAR_STIFFNESS, (double)fluid.near_stiffness},
        {SKV_F_FLUID_COHESION, (double)fluid.cohesion},
        {SKV_F_FLUID_RELAXATION, (double)fluid.relaxation},
        {SKV_F_FLUID_ITERATIONS, fluid.iterations},
        {SKV_F_FLUID_CLAVET_STIFFNESS, (double)fluid.clavet_stiffness},
        {SKV_F_FLUID_CLAVET_NEAR_STIFFNESS, (double)fluid.clavet_near_stiffness},
        {SKV_F_FLUID_CLAVET_REST_DENSITY, (double)fluid.clavet_rest_density},
        {SKV_F_FLUID_WALL_FRICTION, (double)fluid.wall_friction},
        {SKV_F_FLUID_WALL_SOFTNESS, (double)fluid.wall_softness},
        {SKV_F_FLUID_CONTACT_DISTANCE, (double)fluid.contact_distance},
    };
    const skv_field *fields = skv_scene_fields(NULL);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[32];
        skv_format_number((double)(float)atof(fields[cases[i].id].default_text), text);
        char library[32];
        skv_format_number(cases[i].value, library);
        assert_string_equal(text, library);
    }
    assert_int_equal(skv_field_choice("calibrated|clavet", skv_law_name(SKV_LAW_CALIBRATED)),
                     SKV_LAW_CALIBRATED);
    assert_int_equal(skv_field_choice("calibrated|clavet", skv_law_name(SKV_LAW_CLAVET)),
                     SKV_LAW_CLAVET);
}

/* The ends of every fluid range are fluids that a world accepts. */
static void test_range_ends_make_worlds(void **state)
{
    (void)state;
    const skv_field *fields = skv_scene_fields(NULL);
    for (int id = SKV_F_GRAVITY_X; id <= SKV_F_FLUID_CONTACT_DISTANCE; id++) {
        for (int end = 0; fields[id].type != SKV_FIELD_CHOICE && end < 2; end++) {
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
    int count;
    const skv_material *materials = skv_materials(&count);
    const char *choices = skv_scene_fields(NULL)[SKV_F_FLUID_MATERIAL].choices;
    for (int i = 0; i < count; i++)
        assert_int_equal(skv_field_choice(choices, materials[i].name), i);
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

static void test_numbers_do_not_depend_on_the_locale(void **state)
{
    (void)state;
    const struct {
        const char *text;
        bool good;
        double value;
    } cases[] = {
        {"1", true, 1},      {"-2.5", true, -2.5},      {"+3", true, 3},
        {"1e3", true, 1000}, {"1.25E-2", true, 0.0125}, {"", false, 0},
        {".5", false, 0},    {"5.", false, 0},          {"1,5", false, 0},
        {"0x10", false, 0},  {"nan", false, 0},         {"inf", false, 0},
        {"1e999", false, 0}, {"1 ", false, 0},          {" 1", false, 0},
        {"1e", false, 0},    {"--1", false, 0},         {"1.2.3", false, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double value = 0;
        assert_int_equal(skv_parse_number(cases[i].text, &value), cases[i].good);
        if (cases[i].good)
            assert_true(value == cases[i].value);
    }
    char text[32];
    skv_format_number(0.0005, text);
    assert_string_equal(text, "0.0005");
    skv_format_number(2000000, text);
    assert_string_equal(text, "2000000");
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
        cmocka_unit_test(test_fluid_defaults_are_the_librarys),
        cmocka_unit_test(test_range_ends_make_worlds),
        cmocka_unit_test(test_materials),
        cmocka_unit_test(test_numbers_do_not_depend_on_the_locale),
        cmocka_unit_test(test_paths_are_taken_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
