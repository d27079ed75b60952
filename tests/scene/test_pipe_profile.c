/* The thesis' figure 4.5: by its own law, fluid in a pipe is slower beside the wall than in the
 * middle, and it is the friction of Algorithm 7 that makes it so.
 *
 * The thesis does not say how strong its friction is. The default one, 5 % in a frame, takes 2 % of
 * the flow and leaves no profile in a pipe so short; the scene's own, 70 %, does. */
#include "skvalp/scene.h"
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Strips across the lower pipe of the scene, which is 5 cm wide: 4 particles. */
enum { STRIPS = 5 };
static const float left = 0.7f, right = 0.95f, bottom = 0.12f, top = 0.17f;

/* The mean speed along the pipe in each strip, m/s, while the reservoir drains through it: as the
 * scene has it, or with a friction of one's own. */
static void measure(const char *friction, double speed[STRIPS])
{
    const skv_setting settings[] = {{"fluid.law", "clavet"}, {"fluid.wall_friction", friction}};
    skv_scene_options options = skv_default_scene_options();
    options.particles = 3000;
    options.settings = settings;
    options.setting_count = friction ? 2 : 1;
    skv_scene *scene;
    skv_world *world;
    assert_int_equal(skv_scene_load("pipes", &options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_scene_create_world(scene, 1, &world, NULL), SKV_OK);
    skv_scene_destroy(scene);
    int count[STRIPS] = {0};
    for (int i = 0; i < STRIPS; i++)
        speed[i] = 0;
    fixture_run(world, 18); /* until the pipe is full */
    for (int frame = 18; frame < 60; frame++) {
        fixture_run(world, 1);
        skv_particles p = skv_world_particles(world);
        for (int i = 0; i < p.count; i++) {
            if (p.x[i] < left || p.x[i] > right || p.y[i] < bottom || p.y[i] >= top)
                continue;
            int strip = (int)((p.y[i] - bottom) / (top - bottom) * STRIPS);
            speed[strip] += (double)p.vx[i];
            count[strip]++;
        }
    }
    for (int i = 0; i < STRIPS; i++) {
        assert_true(count[i] > 200);
        speed[i] /= count[i];
    }
    skv_world_destroy(world);
}

/* How much slower the strips beside the walls are than the others, as a share. */
static double lag_of(const double *speed)
{
    double walls = (speed[0] + speed[STRIPS - 1]) / 2, inside = 0;
    for (int i = 1; i < STRIPS - 1; i++)
        inside += speed[i] / (STRIPS - 2);
    return 1 - walls / inside;
}

static void fluid_is_slower_beside_the_wall(void **unused)
{
    (void)unused;
    double rough[STRIPS], smooth[STRIPS];
    measure(NULL, rough);
    measure("0", smooth);
    for (int i = 0; i < STRIPS / 2; i++) {
        assert_true(rough[i] < rough[i + 1]);
        assert_true(rough[STRIPS - 1 - i] < rough[STRIPS - 2 - i]);
    }
    assert_true(lag_of(rough) > 0.08);
    assert_true(fabs(lag_of(smooth)) < 0.04);
    /* What is slow at the wall slows down the rest. */
    assert_true(rough[STRIPS / 2] < 0.9 * smooth[STRIPS / 2]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fluid_is_slower_beside_the_wall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
