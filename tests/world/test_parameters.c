/* The registry of a world's parameters: defaults, ranges, and access by path, of a definition and
 * of a world that runs. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "skvalp/skvalp.h"

static const char *get(const skv_world_def *def, const char *path)
{
    static char text[32];
    skv_error error;
    if (skv_world_def_get(def, path, text, sizeof text, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return text;
}

static void set(skv_world_def *def, const char *path, const char *text)
{
    skv_error error;
    if (skv_world_def_set(def, path, text, &error) != SKV_OK)
        fail_msg("%s", error.text);
}

/* The defaults are those of the rows, and what is read can be set again. */
static void defaults_are_the_rows(void **unused)
{
    (void)unused;
    const skv_field *field;
    skv_world_def def = skv_default_world_def();
    for (int i = 0; (field = skv_world_field(i)); i++) {
        char again[32];
        snprintf(again, sizeof again, "%s", get(&def, field->path));
        set(&def, field->path, field->default_text);
        assert_string_equal(get(&def, field->path), again);
        set(&def, field->path, again);
        assert_string_equal(get(&def, field->path), again);
    }
    assert_true(def.fluid.spacing == 0.0155f && def.fluid.cohesion == 8 * 9.81f);
    assert_true(def.gravity_y == -9.81f && def.sleep && def.fluid.iterations == 2);
    assert_null(skv_world_field(-1));
    skv_fluid_def clavet = skv_default_fluid_def(SKV_LAW_CLAVET);
    assert_true(clavet.law == SKV_LAW_CLAVET && clavet.iterations == 1);
    assert_true(clavet.radius_ratio == 2.85f && clavet.contact_distance == 0.3f);
    assert_true(clavet.near_stiffness == 107.9f);
}

/* By number as by path, in a definition and in a world that runs: the same values, the same ranges.
 */
static void numbers_need_no_text(void **unused)
{
    (void)unused;
    skv_world_def by_number = skv_default_world_def(), by_text = by_number;
    const skv_field *field;
    skv_error error;
    for (int i = 0; (field = skv_world_field(i)); i++) {
        assert_int_equal(skv_world_parameter(field->path), i);
        double value = skv_world_def_number(&by_number, i), other = value;
        if (field->type == SKV_FIELD_NUMBER || field->type == SKV_FIELD_INTEGER) {
            other = field->maximum;
            skv_result low = skv_world_def_set_number(&by_number, i, field->minimum - 1, &error);
            assert_int_equal(low, SKV_ERROR_VALUE);
            assert_non_null(strstr(error.text, field->path));
            assert_non_null(strstr(error.text, "is out of range; allowed is"));
        } else {
            other = value == 1 ? 0 : 1;
            assert_int_equal(skv_world_def_set_number(&by_number, i, 9, NULL), SKV_ERROR_VALUE);
            assert_int_equal(skv_world_def_set_number(&by_number, i, 0.5, NULL), SKV_ERROR_VALUE);
        }
        assert_int_equal(skv_world_def_set_number(&by_number, i, NAN, NULL), SKV_ERROR_VALUE);
        assert_true(skv_world_def_number(&by_number, i) == value);
        assert_int_equal(skv_world_def_set_number(&by_number, i, other, NULL), SKV_OK);
        assert_true(skv_world_def_number(&by_number, i) == (double)(float)other);
        set(&by_text, field->path, get(&by_number, field->path));
        assert_string_equal(get(&by_text, field->path), get(&by_number, field->path));
        assert_true(skv_world_def_number(&by_text, i) == skv_world_def_number(&by_number, i));
    }
    assert_int_equal(skv_world_parameter("gravity.z"), -1);
    assert_int_equal(skv_world_def_set_number(&by_number, -1, 0, &error), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_def_set_number(&by_number, 1000, 0, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "parameter 1000: there is none"));
}

static void numbers_of_a_world_that_runs(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.04f, 1);
    skv_world *twin = fixture_dam(SKV_LAW_CALIBRATED, 0.04f, 1);
    const struct {
        const char *path, *text;
        double value;
    } changes[] = {{"fluid.viscosity", "0.002", 0.002},
                   {"gravity.x", "3", 3},
                   {"emission.replaces", "true", 1},
                   {"emission.limit", "700", 700},
                   {"fluid.material", "honey", 2}};
    for (size_t c = 0; c < sizeof changes / sizeof *changes; c++) {
        int parameter = skv_world_parameter(changes[c].path);
        assert_int_equal(skv_world_set_number(world, parameter, changes[c].value, NULL), SKV_OK);
        assert_true(skv_world_number(world, parameter) == (double)(float)changes[c].value);
        assert_int_equal(skv_world_set(twin, changes[c].path, changes[c].text, NULL), SKV_OK);
    }
    fixture_run(world, 5);
    fixture_run(twin, 5);
    assert_true(skv_world_hash(world) == skv_world_hash(twin));
    skv_error error;
    int spacing = skv_world_parameter("fluid.spacing");
    assert_int_equal(skv_world_set_number(world, spacing, 0.02, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "fluid.spacing: cannot change while a world runs"));
    assert_int_equal(skv_world_set_number(world, 99, 0, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_set_number(world, skv_world_parameter("fluid.viscosity"), -1, NULL),
                     SKV_ERROR_VALUE);
    assert_true(skv_world_number(world, spacing) == (double)0.04f);
    skv_world_destroy(world);
    skv_world_destroy(twin);
}

static void members_are_set_by_path(void **unused)
{
    (void)unused;
    skv_world_def def = skv_default_world_def();
    set(&def, "fluid.viscosity", "1e-3");
    set(&def, "gravity.x", "2.5");
    set(&def, "substeps", "12");
    set(&def, "sleep", "false");
    set(&def, "solver", "reference");
    set(&def, "threads", "3");
    set(&def, "depth", "0.05");
    assert_true(def.fluid.viscosity == 1e-3f && def.gravity_x == 2.5f && def.substeps == 12);
    assert_true(!def.sleep && def.solver == SKV_SOLVER_REFERENCE && def.threads == 3);
    assert_string_equal(get(&def, "depth"), "0.05");
    assert_string_equal(get(&def, "solver"), "reference");
    assert_string_equal(get(&def, "sleep"), "false");
}

/* What was chosen stays, what was left alone follows the law. */
static void a_law_brings_its_defaults(void **unused)
{
    (void)unused;
    skv_world_def def = skv_default_world_def();
    set(&def, "fluid.iterations", "4");
    set(&def, "fluid.law", "clavet");
    assert_true(def.fluid.law == SKV_LAW_CLAVET && def.fluid.iterations == 4);
    assert_true(def.fluid.radius_ratio == 2.85f);
    set(&def, "fluid.law", "calibrated");
    assert_true(def.fluid.radius_ratio == 3 && def.fluid.contact_distance == 0.2f);
}

static void a_material_sets_two(void **unused)
{
    (void)unused;
    skv_world_def def = skv_default_world_def();
    assert_string_equal(get(&def, "fluid.material"), "water");
    set(&def, "fluid.material", "honey");
    assert_true(def.fluid.density == 1420 && def.fluid.viscosity == 7e-3f);
    assert_string_equal(get(&def, "fluid.material"), "honey");
    set(&def, "fluid.density", "1000");
    assert_string_equal(get(&def, "fluid.material"), "");
}

/* What is out of its range by the last digit of a float does not read as its bound. */
static void bounds_do_not_contradict_themselves(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.1f, 1);
    skv_error error = {0};
    assert_int_equal(skv_world_step(world, 0.1f, NULL), SKV_OK);
    assert_int_equal(skv_world_step(world, nextafterf(0.1f, 1), &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "step: dt 0.10000001 s is out of range; allowed is 1e-06..0.1 s");
    assert_int_equal(skv_world_step(world, 2, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "step: dt 2 s is out of range; allowed is 1e-06..0.1 s");
    assert_int_equal(skv_world_set_gravity(world, 0, nextafterf(-1000, -2000), &error),
                     SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "gravity: (0, -1000.00006) is out of range; allowed is -1000..1000 m/s^2");
    skv_world_destroy(world);
}

static void mistakes_are_named(void **unused)
{
    (void)unused;
    const struct {
        const char *path, *text, *message;
    } cases[] = {
        {"fluid.viscocity", "1", "fluid.viscocity: unknown field; did you mean fluid.viscosity?"},
        {"gravity.zebra", "1", "gravity.zebra: unknown field; allowed are x, y"},
        {"depth", "17", "depth: 17 is out of range; allowed is a number from 0 to 16 m"},
        {"fluid.viscosity", "0,001",
         "fluid.viscosity: 0,001 is not a number; allowed is a number from 0 to 0.05 m^2/s"},
        {"fluid.viscosity", "",
         "fluid.viscosity: it is empty; allowed is a number from 0 to 0.05 m^2/s"},
        {"fluid.iterations", "2.5",
         "fluid.iterations: 2.5 is not a whole number; allowed is a whole number from 1 to 8"},
        {"fluid.material", "tar",
         "fluid.material: tar is not known; allowed is water, oil, honey or mercury"},
        {"sleep", "yes", "sleep: yes is not true or false; allowed is true or false"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        skv_world_def def = skv_default_world_def(), before = def;
        skv_error error = {0};
        assert_int_equal(skv_world_def_set(&def, cases[i].path, cases[i].text, &error),
                         SKV_ERROR_VALUE);
        assert_string_equal(error.text, cases[i].message);
        assert_memory_equal(&def, &before, sizeof def);
    }
    skv_world_def def = skv_default_world_def();
    char text[32];
    assert_int_equal(skv_world_def_get(&def, "fluid.colour", text, sizeof text, NULL),
                     SKV_ERROR_VALUE);
}

/* The ends of a range are allowed in single precision, and a world names the path that one sets. */
static void ranges_are_checked_by_the_world(void **unused)
{
    (void)unused;
    skv_world_def def = skv_default_world_def();
    skv_world *world;
    skv_error error;
    def.fluid.viscosity = 0.05f;
    def.fluid.relaxation = 0.4f;
    def.fluid.wall_softness = 0.1f;
    assert_int_equal(skv_world_create(&def, &world, &error), SKV_OK);
    skv_world_destroy(world);
    def.depth = 50;
    assert_int_equal(skv_world_create(&def, &world, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "depth: 50 is out of range; allowed is a number from 0 to 16 m");
    def.depth = 0;
    def.solver = (skv_solver_kind)7;
    assert_int_equal(skv_world_create(&def, &world, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "solver: 7 is not known; allowed is fast or reference");
}

/* ---- A world that runs ----------------------------------------------------------------------- */

static void step(skv_world *world, int frames)
{
    for (int i = 0; i < frames; i++)
        assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
}

static skv_world *make_thrown(void)
{
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.02f;
    def.gravity_y = 0;
    def.threads = 1;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    for (int i = 0; i < 100; i++) {
        float x = 0.5f + 0.02f * (float)(i % 10), y = 0.4f + 0.02f * (float)(i / 10);
        assert_int_equal(skv_world_add_particle(world, x, y, i % 2 ? 1 : -1, 0, NULL), SKV_OK);
    }
    return world;
}

/* Each parameter that can be changed is read back, and one that matters changes what happens. */
static void a_running_world_changes(void **unused)
{
    (void)unused;
    skv_world *thin = make_thrown(), *thick = make_thrown();
    skv_error error;
    char text[32];
    step(thin, 1);
    step(thick, 1);
    assert_true(skv_world_hash(thin) == skv_world_hash(thick));
    assert_int_equal(skv_world_set(thick, "fluid.viscosity", "0.05", &error), SKV_OK);
    assert_int_equal(skv_world_get(thick, "fluid.viscosity", text, sizeof text, &error), SKV_OK);
    assert_string_equal(text, "0.05");
    step(thin, 5);
    step(thick, 5);
    assert_true(skv_world_stats(thick).rms_speed < 0.5 * skv_world_stats(thin).rms_speed);
    assert_int_equal(skv_world_set(thin, "gravity.y", "-1.62", &error), SKV_OK);
    float gx, gy;
    skv_world_gravity(thin, &gx, &gy);
    assert_true(gx == 0 && gy == -1.62f);
    assert_int_equal(skv_world_set(thin, "fluid.material", "oil", &error), SKV_OK);
    assert_true(skv_world_fluid(thin)->density == 911);
    step(thin, 1);
    skv_world_destroy(thin);
    skv_world_destroy(thick);
}

static void what_cannot_change_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_thrown();
    skv_error error;
    int count = 0, fixed = 0;
    const skv_field *field;
    for (; (field = skv_world_field(count)); count++) {
        char now[32];
        assert_int_equal(skv_world_get(world, field->path, now, sizeof now, &error), SKV_OK);
        skv_result result = skv_world_set(world, field->path, now, &error);
        assert_int_equal(result == SKV_OK, skv_world_can_change(field->path));
        fixed += result != SKV_OK;
    }
    assert_true(fixed >= 8 && fixed < count / 2);
    assert_int_equal(skv_world_set(world, "fluid.spacing", "0.01", &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "fluid.spacing: cannot change while a world runs; set it in the "
                        "definition of a new one");
    assert_int_equal(skv_world_set(world, "fluid.cohesion", "-1", &error), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_set(world, "fluid.kohesion", "1", &error), SKV_ERROR_VALUE);
    assert_false(skv_world_can_change("fluid.kohesion"));
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_are_the_rows),
        cmocka_unit_test(numbers_need_no_text),
        cmocka_unit_test(numbers_of_a_world_that_runs),
        cmocka_unit_test(members_are_set_by_path),
        cmocka_unit_test(a_law_brings_its_defaults),
        cmocka_unit_test(a_material_sets_two),
        cmocka_unit_test(bounds_do_not_contradict_themselves),
        cmocka_unit_test(mistakes_are_named),
        cmocka_unit_test(ranges_are_checked_by_the_world),
        cmocka_unit_test(a_running_world_changes),
        cmocka_unit_test(what_cannot_change_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
