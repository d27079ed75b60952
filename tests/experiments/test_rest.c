/* No row of particles beats for ever: deep, coarse pools, whose substeps start as warm as they may,
 * come to rest (docs/notebook/2026-11-26-rows-that-beat.md). */
#include "skvalp/scene.h"

#include "support/fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static const char deep[] = "{\"world\": {\"width\": 2, \"height\": 1.4}, \"sleep\": false,"
                           " \"water\": [{\"shape\": \"box\", \"x1\": 2, \"y1\": 1}]}";

/* The rms speed after a minute, m/s. */
static double left_of_motion(int particles)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error;
    if (skv_scene_load_memory(deep, strlen(deep), "json", "test", &options, &scene, &error) !=
            SKV_OK ||
        skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_scene_destroy(scene);
    fixture_run(world, 60 * 60);
    double speed = skv_world_stats(world).rms_speed;
    skv_world_destroy(world);
    return speed;
}

/* Where rows beat, half of these keep 1.2 to 2.1 mm/s; else none has more than 0.4. */
static void deep_pools_come_to_rest(void **unused)
{
    (void)unused;
    for (int particles = 1900; particles <= 2150; particles += 50) {
        double speed = left_of_motion(particles);
        if (speed > 0.0007)
            fail_msg("%d particles still move with %.2g m/s after a minute", particles, speed);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(deep_pools_come_to_rest)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
