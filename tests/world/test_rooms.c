/* What a thread keeps of a row at work is memory only: where it has no room, all of it is computed
 * again, to the same bits. */
#include "support/fixture.h"

#include "world/world_internal.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum { WIDTH = 64, HEIGHT = 40, WALL = 12, FRAMES = 20 };

/* A tank with a shelf of one pixel, through which pairs must not see each other; the rows of the
 * solver, which stand upright here, all meet it. */
static skv_terrain *make_tank(void)
{
    uint8_t coverage[WIDTH * HEIGHT] = {0};
    for (int x = 0; x < WIDTH; x++)
        coverage[WALL * WIDTH + x] = 255;
    skv_terrain_def def = skv_default_terrain_def();
    def.width = WIDTH;
    def.height = HEIGHT;
    def.pixel_size = 0.008f;
    def.coverage = coverage;
    skv_terrain *terrain;
    assert_int_equal(skv_terrain_create(&def, &terrain, NULL), SKV_OK);
    return terrain;
}

/* After some frames in a solver that expects `share` times as many particles in a row. */
static uint64_t run(skv_law law, float viscosity, int threads, float share)
{
    skv_world_def def = fixture_def(law, SKV_SOLVER_FAST, viscosity, 0.008f, threads);
    def.terrain = make_tank();
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    assert_true(fixture_fill(world, 0, 0, 0.3f, 0.09f) > 300);
    assert_true(fixture_fill(world, 0.1f, 0.11f, 0.512f, 0.2f) > 300);
    const skv_solver_def solver = {
        .x1 = skv_terrain_width(world->terrain),
        .y1 = skv_terrain_height(world->terrain),
        .h = world->h,
        .per_square = share * def.fluid.radius_ratio * def.fluid.radius_ratio,
        .boundary = &world->boundary,
    };
    world->solver->type->destroy(world->solver);
    assert_int_equal(skv_rows_solver.create(&solver, &world->solver, NULL), SKV_OK);
    fixture_run(world, FRAMES);
    uint64_t hash = skv_world_hash(world);
    skv_world_destroy(world);
    return hash;
}

static void what_has_no_room_is_computed_again(void **unused)
{
    (void)unused;
    for (int law = 0; law < 2; law++) {
        for (int viscous = 0; viscous < 2; viscous++) {
            uint64_t usual = run((skv_law)law, viscous ? 30 : 0, 1, 1);
            assert_true(run((skv_law)law, viscous ? 30 : 0, 1, 0.01f) == usual);
            assert_true(run((skv_law)law, viscous ? 30 : 0, 3, 0.01f) == usual);
            assert_true(run((skv_law)law, viscous ? 30 : 0, 3, 0.3f) == usual);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_has_no_room_is_computed_again)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
