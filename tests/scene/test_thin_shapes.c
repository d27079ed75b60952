/* A drawn wall thinner than a pixel holds water, wherever it lies and whatever way it runs. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "skvalp/scene.h"

#define PIXEL 0.0025

/* The terrain of a scene with one solid. */
static skv_terrain *make_terrain(const char *solid, bool *noted)
{
    char text[600];
    skv_scene *scene;
    skv_error error;
    snprintf(text, sizeof text,
             "{\"world\":{\"width\":0.4,\"height\":0.3},\"solid\":[%s],\"particles\":100,"
             "\"water\":[{\"shape\":\"box\",\"y1\":0.1}]}",
             solid);
    if (load_text(text, NULL, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    *noted = skv_scene_notice(scene, 0) != NULL;
    skv_world_def def = skv_scene_world_def(scene);
    skv_scene_destroy(scene);
    return def.terrain;
}

static double uniform(uint32_t *seed)
{
    return dice(seed) % 65536 / 65536.0;
}

/* Sweeps across a wall that runs through (cx, cy) along (c, s), at many places and angles. */
static void expect_tight(const skv_terrain *terrain, double cx, double cy, double c, double s,
                         uint32_t *seed, const char *solid)
{
    for (int i = 0; i < 200; i++) {
        double along = 0.16 * (uniform(seed) - 0.5), slant = 2 * (uniform(seed) - 0.5);
        double x = cx + along * c, y = cy + along * s;
        double nx = 0.02 * (-s + slant * c), ny = 0.02 * (c + slant * s);
        float made = skv_terrain_sweep(terrain, (float)(x - nx), (float)(y - ny), (float)(x + nx),
                                       (float)(y + ny), (float)(0.1 * PIXEL));
        if (made >= 1)
            fail_msg("%s leaks at (%g, %g)", solid, x, y);
    }
}

static void test_a_thin_line_holds(void **state)
{
    (void)state;
    uint32_t seed = 11;
    for (int i = 0; i < 120; i++) {
        /* First along the pixels, on their borders and between; then anyhow. */
        double angle = i < 40 ? i % 2 * 1.5707963267948966 : 6.283 * uniform(&seed);
        double cx = 0.2 + PIXEL * (i < 40 ? i / 40.0 : uniform(&seed));
        double cy = 0.15 + PIXEL * (i < 40 ? i / 40.0 : uniform(&seed));
        double c = cos(angle), s = sin(angle);
        char solid[300];
        snprintf(solid, sizeof solid,
                 "{\"shape\":\"line\",\"thickness\":%g,\"points\":[[%.9g,%.9g],[%.9g,%.9g]]}",
                 i % 3 == 0 ? 0.002 : 0.0002, cx - 0.1 * c, cy - 0.1 * s, cx + 0.1 * c,
                 cy + 0.1 * s);
        bool noted;
        skv_terrain *terrain = make_terrain(solid, &noted);
        assert_true(noted);
        expect_tight(terrain, cx, cy, c, s, &seed, solid);
        skv_terrain_destroy(terrain);
    }
}

static void test_a_thin_box_holds(void **state)
{
    (void)state;
    uint32_t seed = 12;
    for (int i = 0; i < 40; i++) {
        double x = 0.2 + PIXEL * i / 40.0;
        char solid[200];
        snprintf(solid, sizeof solid,
                 "{\"shape\":\"box\",\"x0\":%.9g,\"x1\":%.9g,\"y0\":0.05,\"y1\":0.25}", x,
                 x + 0.001);
        bool noted;
        skv_terrain *terrain = make_terrain(solid, &noted);
        assert_true(noted);
        expect_tight(terrain, x + 0.0005, 0.15, 0, 1, &seed, solid);
        skv_terrain_destroy(terrain);
    }
}

/* What is thick enough is left alone, and so is what is carved. */
static void test_other_shapes_stay(void **state)
{
    (void)state;
    bool noted;
    skv_terrain *terrain = make_terrain("{\"shape\":\"box\",\"x0\":0.15,\"x1\":0.25},"
                                        "{\"shape\":\"line\",\"carve\":true,\"thickness\":0.001,"
                                        "\"points\":[[0.15,0.2],[0.25,0.2]]}",
                                        &noted);
    assert_false(noted);
    assert_true(skv_terrain_distance(terrain, 0.2f, 0.2f) < -0.04f);
    skv_terrain_destroy(terrain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_thin_line_holds),
        cmocka_unit_test(test_a_thin_box_holds),
        cmocka_unit_test(test_other_shapes_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
