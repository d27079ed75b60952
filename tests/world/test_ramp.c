/* Clavet's numbers go to new values in a running world: what is read is what was set, and what acts
 * comes to it evenly, whatever the steps. */
#include "support/fixture.h"

#include "world/world_internal.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static skv_world *make_world(skv_law law, bool filled)
{
    skv_world_def def = skv_default_world_def();
    def.fluid = skv_default_fluid_def(law);
    def.fluid.spacing = 0.03f;
    def.threads = 1;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    if (filled)
        fixture_fill(world, 0, 0, 0.4f, 0.3f);
    return world;
}

static void set(skv_world *world, const char *path, const char *text)
{
    assert_int_equal(skv_world_set(world, path, text, NULL), SKV_OK);
}

static float rest_density(const skv_world *world)
{
    return skv_world_make_constants(world).rest_density;
}

static void what_acts_comes_evenly_to_what_is_read(void **unused)
{
    (void)unused;
    skv_world *world = make_world(SKV_LAW_CLAVET, true);
    set(world, "fluid.clavet_rest_density", "4");
    set(world, "fluid.contact_distance", "0.6");
    for (int frame = 0; frame <= 60; frame++) {
        assert_true(skv_world_fluid(world)->clavet_rest_density == 4);
        assert_true(skv_world_number(world, skv_world_parameter("fluid.contact_distance")) ==
                    (double)0.6f);
        assert_near((double)rest_density(world), 10 - 6 * frame / 60.0, 1e-4);
        assert_near((double)world->boundary.contact_distance, 0.03 * (0.3 + 0.3 * frame / 60),
                    1e-6);
        fixture_run(world, 1);
    }
    assert_true(rest_density(world) == 4 && world->ramp.left == 0);
    assert_true(world->constants.rest_density == 4);
    skv_world_destroy(world);
}

static void longer_steps_go_as_far(void **unused)
{
    (void)unused;
    skv_world *world = make_world(SKV_LAW_CLAVET, true);
    set(world, "fluid.clavet_rest_density", "4");
    for (int step = 0; step < 5; step++)
        assert_int_equal(skv_world_step(world, 0.1f, NULL), SKV_OK);
    assert_near((double)rest_density(world), 7, 1e-4);
    skv_world_destroy(world);
}

/* A number that is set on the way is gone to from there; another one lets it go on. */
static void another_way_begins_where_one_is_left(void **unused)
{
    (void)unused;
    skv_world *world = make_world(SKV_LAW_CLAVET, true);
    set(world, "fluid.clavet_rest_density", "4");
    fixture_run(world, 30);
    set(world, "fluid.density", "900");
    assert_near((double)rest_density(world), 7, 1e-4);
    fixture_run(world, 10);
    assert_near((double)rest_density(world), 6, 1e-4);
    set(world, "fluid.clavet_rest_density", "10");
    assert_near((double)rest_density(world), 6, 1e-4);
    fixture_run(world, 30);
    assert_near((double)rest_density(world), 8, 1e-4);
    skv_world_destroy(world);
}

/* The calibrated law's fluid is packed all the same, and where there is none, nothing is. */
static void what_is_not_packed_for_a_number_gets_it_at_once(void **unused)
{
    (void)unused;
    skv_world *empty = make_world(SKV_LAW_CLAVET, false);
    set(empty, "fluid.clavet_rest_density", "4");
    assert_true(rest_density(empty) == 4);
    skv_world_destroy(empty);
    skv_world *calibrated = make_world(SKV_LAW_CALIBRATED, true);
    set(calibrated, "fluid.contact_distance", "0.6");
    assert_true(calibrated->boundary.contact_distance ==
                skv_contact_distance(skv_world_fluid(calibrated)));
    assert_true(calibrated->ramp.left == 0);
    skv_world_destroy(calibrated);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_acts_comes_evenly_to_what_is_read),
        cmocka_unit_test(longer_steps_go_as_far),
        cmocka_unit_test(another_way_begins_where_one_is_left),
        cmocka_unit_test(what_is_not_packed_for_a_number_gets_it_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
