/* What counts as escaped: deeper than h in a wall, or outside a closed side; put there by hand,
 * since nothing gets there by itself. */
#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void deeper_than_h_is_escaped(void **unused)
{
    (void)unused;
    for (unsigned open = 0; open < 2; open++) {
        skv_terrain_def tank = skv_default_terrain_def();
        tank.open_sides = open ? SKV_SIDE_RIGHT : 0;
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.02f, 1);
        skv_world *world;
        assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
        assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
        assert_int_equal(skv_world_add_particle(world, 0.8f, 0.4f, 0, 0, NULL), SKV_OK);
        const struct {
            float x, y; /* in h beyond the right and the upper wall */
            bool escaped;
        } places[] = {{-2, -2, false},  {0.9f, -2, false}, {1.1f, -2, !open}, {-2, 0.9f, false},
                      {-2, 1.1f, true}, {5, -2, !open},    {-2, 5, true}};
        for (int i = 0; i < 7; i++) {
            float h = skv_world_smoothing_radius(world);
            world->state.x[0] = 1.6f + places[i].x * h;
            world->state.y[0] = 0.9f + places[i].y * h;
            assert_int_equal(skv_world_stats(world).escaped, places[i].escaped);
        }
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(deeper_than_h_is_escaped)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
