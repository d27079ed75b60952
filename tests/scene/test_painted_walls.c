/* Water at rest in a painted picture: no layer stacked on its walls, no heat from them. */
#include "skvalp/scene.h"
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

static int ascending(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* The height below which all but a few particles are. */
static double surface(const skv_world *world)
{
    skv_particles p = skv_world_particles(world);
    float *y = malloc((size_t)p.count * sizeof *y);
    for (int i = 0; i < p.count; i++)
        y[i] = p.y[i];
    qsort(y, (size_t)p.count, sizeof *y, ascending);
    double height = (double)y[p.count * 97 / 100];
    free(y);
    return height;
}

static void painted_walls_are_walls(void **unused)
{
    (void)unused;
    skv_scene *scene;
    skv_world *world;
    assert_int_equal(
        skv_scene_load(SKV_SOURCE_DIR "/scenes/painted/harbour.png", NULL, &scene, NULL), SKV_OK);
    assert_int_equal(skv_scene_create_world(scene, 1, &world, NULL), SKV_OK);
    skv_scene_destroy(scene);
    fixture_run(world, 8 * 60);
    double layer = 0, rms = 0;
    const int frames = 60;
    for (int f = 0; f < frames; f++) {
        fixture_run(world, 1);
        layer += fixture_wall_layer(world, surface(world)) / frames;
        double speed = skv_world_stats(world).rms_speed;
        rms += speed * speed / frames;
    }
    printf("harbour: layer %.3f, rms speed %.5f m/s\n", layer, sqrt(rms));
    assert_true(fabs(layer - 1) < 0.1);
    assert_true(sqrt(rms) < 0.01);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(painted_walls_are_walls)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
