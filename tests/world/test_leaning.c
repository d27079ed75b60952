/* Closed tubes whose walls lean over the water, by 20 to 45 degrees: it comes to rest in them. What
 * circulates in them has no source of energy but the walls. */
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum { MOST_PIXELS = 800, STILL_FROM = 16, STILL_UNTIL = 20, SECOND = 60 };

#define SIDE   2.0 /* of the block, m */
#define LENGTH 1.3 /* of the tube's axis, m */
#define BORE   0.2 /* m */
#define FOOT   0.2 /* of its lower end, from both sides, m */

/* m/s. With the pull of walls cut from what rests below a surface, too, it is 0.008 to 0.01. */
#define MOST_STILL 0.005
/* m/s. Contact before a wall that acts as a mirror drives 0.05 to 0.12, at six pixels a spacing. */
#define MOST_AT_SIX_PIXELS 0.01

static double clamped(double x, double least, double most)
{
    return fmin(fmax(x, least), most);
}

/* A tube with round ends, carved out of a block at an angle. */
static skv_terrain *make_tube(double pixel, double cosine, double sine)
{
    static uint8_t coverage[MOST_PIXELS * MOST_PIXELS];
    const int width = (int)lrint(SIDE / pixel);
    assert_in_range(width, 1, MOST_PIXELS);
    for (int i = 0; i < width * width; i++) {
        double x = (i % width + 0.5) * pixel - FOOT, y = ((double)(i / width) + 0.5) * pixel - FOOT;
        double along = clamped(x * cosine + y * sine, 0, LENGTH);
        double outside = hypot(x - along * cosine, y - along * sine) - BORE / 2;
        coverage[i] = (uint8_t)lrint(255 * clamped(outside / pixel + 0.5, 0, 1));
    }
    skv_terrain_def def = skv_default_terrain_def();
    def.width = def.height = width;
    def.pixel_size = (float)pixel;
    def.coverage = coverage;
    skv_terrain *terrain;
    assert_int_equal(skv_terrain_create(&def, &terrain, NULL), SKV_OK);
    return terrain;
}

static double mean_square_speed(const skv_world *world)
{
    skv_particles p = skv_world_particles(world);
    double sum = 0;
    for (int i = 0; i < p.count; i++)
        sum += (double)(p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]);
    return sum / p.count;
}

/* Half a tube of water at so many degrees. */
static void expect_rest(int degrees, float spacing, double pixel, double most)
{
    const double angle = degrees * acos(-1) / 180, cosine = cos(angle), sine = sin(angle);
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, spacing, 1);
    def.terrain = make_tube(pixel, cosine, sine);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    int count = fixture_fill(world, 0, 0, 2, (float)(FOOT + LENGTH / 2 * sine));
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    fixture_run(world, STILL_FROM * SECOND);
    double sum = 0;
    for (int k = STILL_FROM; k < STILL_UNTIL; k++) {
        fixture_run(world, SECOND);
        sum += mean_square_speed(world);
    }
    double speed = sqrt(sum / (STILL_UNTIL - STILL_FROM));
    if (!(speed < most))
        fail_msg("%d degrees, %d particles, spacing %g m, pixels of %g m: %.2g mm/s after %d s",
                 degrees, count, (double)spacing, pixel, 1000 * speed, STILL_FROM);
    skv_world_destroy(world);
}

static void water_rests_under_walls_that_lean(void **unused)
{
    (void)unused;
    const float spacings[] = {0.0114f, 0.0107f, 0.0084f};
    const int degrees[] = {30, 20, 45};
    const int most = long_tests() ? 3 : 1;
    for (int n = 0; n < most; n++)
        for (int k = 0; k < most; k++)
            expect_rest(degrees[k], spacings[n], 0.005, MOST_STILL);
}

static void water_rests_where_a_spacing_has_six_pixels(void **unused)
{
    (void)unused;
    const float spacings[] = {0.0145f, 0.0155f};
    for (int n = 0; n < (long_tests() ? 2 : 1); n++)
        expect_rest(30, spacings[n], 0.0025, MOST_AT_SIX_PIXELS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_rests_under_walls_that_lean),
        cmocka_unit_test(water_rests_where_a_spacing_has_six_pixels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
