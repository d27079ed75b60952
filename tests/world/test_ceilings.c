/* Ceilings: nothing hangs from them, however small, at any spacing, in either orientation, whether
 * it is gravity that pulls or a force. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Takes gravity away and lets a force pull as much, or a hand some three times as much. */
static void replace_gravity(skv_world *world, bool by_hand)
{
    skv_force force = {.area = skv_box(0, 0, 2, 2), .ay = -9.81f};
    skv_hand hand = skv_default_hand();
    hand.x = 0.25f;
    hand.y = 0;
    hand.radius = 3;
    hand.attraction = 40;
    hand.friction = 0;
    assert_int_equal(skv_world_set_gravity(world, 0, 0, NULL), SKV_OK);
    if (by_hand)
        assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    else
        assert_int_equal(skv_world_set_forces(world, &force, 1, NULL), SKV_OK);
}

typedef enum pull_kind { GRAVITY, FORCE, HAND } pull_kind;

/* Puts a group of particles under the ceiling; soon all have let go and are on their way. Clavet's
 * law takes longer over it, and holds larger drops: it pulls at full density, too. */
static void expect_fall(skv_law law, bool images, pull_kind puller, skv_solver_kind solver,
                        bool high, float spacing, int count)
{
    skv_terrain_def tank = skv_default_terrain_def();
    tank.width = high ? 80 : 120;
    tank.height = high ? 120 : 80;
    tank.pixel_size = 0.01f;
    skv_world_def def = fixture_def(law, solver, 0, spacing, 1);
    def.depth = 0.3f;
    def.fluid.wall_images = images;
    assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    const float ceiling = 0.01f * (float)tank.height;
    const int wide = (int)ceil(sqrt(count));
    for (int i = 0; i < count; i++) {
        int row = i / wide, column = i % wide;
        float x = 0.2f + (1.07f * (float)column + 0.53f * (float)(row % 2)) * spacing;
        float y = ceiling - (0.3f + 0.93f * (float)row) * spacing;
        assert_int_equal(skv_world_add_particle(world, x, y, 0, 0, NULL), SKV_OK);
    }
    if (puller != GRAVITY)
        replace_gravity(world, puller == HAND);
    fixture_run(world, law == SKV_LAW_CLAVET ? 60 : 25);
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++)
        if (!(p.y[i] < ceiling - 0.05f))
            fail_msg(
                "law %d, puller %d, solver %d, %s, spacing %g, %d particles: %d is %g m below the "
                "ceiling",
                (int)law, (int)puller, (int)solver, high ? "high" : "wide", (double)spacing, count,
                i, (double)(ceiling - p.y[i]));
    skv_world_destroy(world);
}

static void nothing_hangs_from_a_ceiling(void **unused)
{
    (void)unused;
    const float spacings[] = {0.006f, 0.0155f, 0.04f};
    const int counts[] = {1, 2, 3, 5, 8, 50};
    /* The calibrated law, with walls by images and without, and the clavet law. */
    for (int kind = 0; kind < 3; kind++) {
        skv_law law = kind == 2 ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED;
        for (int solver = 0; solver < 2; solver++)
            for (int high = 0; high < 2; high++)
                for (int k = 0; k < 3; k++)
                    for (int n = 0; n < (law == SKV_LAW_CLAVET ? 4 : 6); n++)
                        expect_fall(law, kind == 1, GRAVITY, (skv_solver_kind)solver, high,
                                    spacings[k], counts[n]);
    }
}

static void nothing_clings_against_a_force(void **unused)
{
    (void)unused;
    const int counts[] = {1, 3, 8, 50};
    for (int images = 0; images < 2; images++)
        for (pull_kind puller = FORCE; puller <= HAND; puller++)
            for (int solver = 0; solver < 2; solver++)
                for (int high = 0; high < 2; high++)
                    for (int n = 0; n < 4; n++)
                        expect_fall(SKV_LAW_CALIBRATED, images, puller, (skv_solver_kind)solver,
                                    high, 0.0155f, counts[n]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_hangs_from_a_ceiling),
        cmocka_unit_test(nothing_clings_against_a_force),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
