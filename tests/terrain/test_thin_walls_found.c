/* Which walls are thin: those of less than 0.6 smoothing radii. */
#include "shapes.h"
#include "terrain/thin_walls.h"

#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

enum { SIDE = 128, THICK = 8 };

/* Whether an upright wall from the floor to the lid is thin for a radius, in pixels. */
static bool is_thin(double radius)
{
    static uint8_t picture[SIDE * SIDE];
    memset(picture, 0, sizeof picture);
    for (int y = 0; y < SIDE; y++)
        memset(picture + y * SIDE + SIDE / 2, 255, THICK);
    const float pixel = 0.004f;
    skv_terrain *terrain = make_terrain(SIDE, SIDE, picture, pixel, 0);
    skv_thin_walls *thin;
    assert_int_equal(skv_thin_walls_create(terrain, (float)radius * pixel, NULL, NULL, &thin, NULL),
                     SKV_OK);
    bool any = thin->any;
    skv_thin_walls_destroy(thin);
    skv_terrain_destroy(terrain);
    return any;
}

static void a_wall_is_thin_up_to_its_share_of_the_radius(void **unused)
{
    (void)unused;
    assert_true(is_thin(THICK / 0.3));
    assert_true(is_thin(THICK / 0.57));
    assert_false(is_thin(THICK / 0.63));
    assert_false(is_thin(THICK / 1.2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wall_is_thin_up_to_its_share_of_the_radius)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
