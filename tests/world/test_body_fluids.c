/* Bodies among several fluids: what is denser than one and lighter than the other lies between them
 * by Archimedes; and a body in one fluid alone moves the same, whatever the first fluid is. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#define SPACING 0.0155f
#define WIDTH   0.8f
#define BESIDE  1

static const double length = 0.2, height = 0.1;

/* A tank with a second fluid of some density, and as deep with fluids as fills make it. */
static skv_world *make(float density, int substeps)
{
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = (int)(WIDTH / terrain.pixel_size + 0.5f);
    terrain.height = 320;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, 1);
    fixture_add_liquids(&def, 1);
    def.liquids[0].density = density;
    def.substeps = substeps;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

static skv_body_id add(skv_world *world, float y, float density)
{
    skv_body_def def = skv_default_body_def();
    def.shape =
        skv_box((float)-length / 2, (float)-height / 2, (float)length / 2, (float)height / 2);
    def.x = WIDTH / 2;
    def.y = y;
    def.density = density;
    return fixture_add_body(world, &def);
}

/* How much of a body lies in the lower of two fluids, by the level that the volume gives, on
 * average over two seconds. */
static double share_below(skv_world *world, skv_body_id id, int lower, double *angle)
{
    const int frames = 120;
    double s = (double)skv_world_spacing(world), bottom = 0;
    double volume = skv_world_fluid_stats(world, lower).particles * s * s;
    *angle = 0;
    for (int f = 0; f < frames; f++) {
        fixture_run(world, 1);
        skv_body body = fixture_body(world, id);
        bottom += ((double)body.y - height / 2) / frames;
        *angle += (double)body.angle / frames;
    }
    return ((volume - length * bottom) / ((double)WIDTH - length) - bottom) / height;
}

/* So stiff that fluid is hardly compressed, with the first fluid above or below. */
static void check_between(float density, int lower, float body, double tolerance)
{
    skv_world *world = make(density, 12);
    fixture_fill_with(world, 0, 0, WIDTH, 0.2f, lower);
    fixture_fill_with(world, 0, 0.2f, WIDTH, 0.38f, !lower);
    skv_body_id id = add(world, 0.21f, body);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    fixture_run(world, 420);
    double angle, share = share_below(world, id, lower, &angle);
    double light = lower ? 1000 : (double)density, heavy = lower ? (double)density : 1000;
    assert_near(share, ((double)body - light) / (heavy - light), tolerance);
    assert_near(angle, 0, 0.05);
    skv_world_destroy(world);
}

static void bodies_float_between_fluids(void **unused)
{
    (void)unused;
    check_between(2000, BESIDE, 1500, 0.03);
    check_between(13546, BESIDE, 7800, 0.03);
    check_between(500, 0, 750, 0.03);
}

/* A body that begins on the floor, in a fluid alone: its films bear that fluid's pressure. After
 * five frames it is 10 mm higher, and 4 mm where films bear water's pressure. */
static void a_fluid_alone_moves_bodies_by_its_ratio(void **unused)
{
    (void)unused;
    skv_body moved[2];
    for (int k = 0; k < 2; k++) {
        skv_world *world = make(4000, 0);
        fixture_fill_with(world, 0, 0, WIDTH, 0.3f, k ? BESIDE : 0);
        skv_body_id id = add(world, (float)height / 2 + 0.001f, k ? 2000 : 500);
        fixture_run(world, 5);
        moved[k] = fixture_body(world, id);
        assert_int_equal(skv_world_fluid_stats(world, k ? 0 : BESIDE).particles, 0);
        skv_world_destroy(world);
    }
    assert_true(moved[0].y > 0.06f);
    assert_near((double)moved[1].x, (double)moved[0].x, 1e-5);
    assert_near((double)moved[1].y, (double)moved[0].y, 1e-5);
    assert_near((double)moved[1].angle, (double)moved[0].angle, 1e-4);
}

/* A hand holds what is light as firmly in mercury as in water, the first fluid, of which there is
 * none here: as much fluid goes with the body as it displaces, of that which is there. */
static void hands_feel_the_fluid_that_is_there(void **unused)
{
    (void)unused;
    const double mercury = 13600, cork = 240, follow = 40;
    skv_world *world = make((float)mercury, 0);
    fixture_fill_with(world, 0, 0, WIDTH, 0.4f, BESIDE);
    skv_body_id id = add(world, 0.2f, (float)cork);
    skv_hand hand = skv_default_hand();
    hand.x = WIDTH / 2;
    hand.y = 0.2f;
    hand.attraction = 300;
    hand.follow = (float)follow;
    assert_true(skv_world_grasp(world, hand.x, hand.y, 0, &hand));
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    fixture_run(world, 120);
    double rises = 9.81 * (mercury - cork) / (mercury + cork) / (follow * follow);
    assert_near((double)fixture_body(world, id).y, 0.2 + rises, 0.1 * rises);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_float_between_fluids),
        cmocka_unit_test(a_fluid_alone_moves_bodies_by_its_ratio),
        cmocka_unit_test(hands_feel_the_fluid_that_is_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
