/* Water at rest on slanted and curved walls, black and white or smooth: staircases neither make it
 * creep nor heat it, and no layer is stacked on them. */
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

enum { WIDTH = 320, HEIGHT = 180 };

/* Height of a floor at x, m. */
typedef double floor_at(double x, double parameter);

static double slope(double x, double degrees)
{
    return (x - 0.4) * tan(degrees * acos(-1) / 180);
}

/* A bowl of this radius. */
static double bowl(double x, double radius)
{
    double square = radius * radius - (x - 0.8) * (x - 0.8);
    return square > 0 ? radius - sqrt(square) : 1;
}

/* A hill of this radius. */
static double hill(double x, double radius)
{
    double square = radius * radius - (x - 0.8) * (x - 0.8);
    return square > 0 ? 0.25 - radius + sqrt(square) : -1;
}

/* A closed tank with a floor of black and white pixels, or with smooth edges, filled to `level`. */
static skv_world *pool_on(floor_at *floor, double parameter, bool smooth, float level)
{
    double pixel = 1.6 / (double)WIDTH;
    uint8_t *coverage = calloc(WIDTH * HEIGHT, 1);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            int solid = 0;
            for (int k = 0; k < 64; k++) {
                double px = (x + (k % 8 + 0.5) / 8) * pixel, py = (y + (k / 8 + 0.5) / 8) * pixel;
                solid += py < floor(px, parameter);
            }
            coverage[y * WIDTH + x] = (uint8_t)(smooth ? solid * 255 / 64 : solid >= 32 ? 255 : 0);
        }
    }
    skv_terrain_def picture = skv_default_terrain_def();
    picture.width = WIDTH;
    picture.height = HEIGHT;
    picture.pixel_size = (float)pixel;
    picture.coverage = coverage;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.0155f;
    def.depth = level;
    def.threads = 1;
    skv_world *world;
    assert_int_equal(skv_terrain_create(&picture, &def.terrain, NULL), SKV_OK);
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 1.6f, level);
    free(coverage);
    return world;
}

typedef struct rest {
    double creep; /* m/s: mean drift along the wall of the particles within h of it */
    double rms;   /* m/s: of all particles, over the time of measuring */
    double layer; /* particles at the walls, by their weights, against rest */
} rest;

static rest measure(skv_world *world, double degrees, float level, int frames)
{
    double angle = degrees * acos(-1) / 180, tx = cos(angle), ty = sin(angle);
    int n = skv_world_particle_count(world);
    float h = skv_world_smoothing_radius(world);
    float *x = malloc((size_t)n * sizeof *x), *y = malloc((size_t)n * sizeof *y);
    int near_wall = 0;
    rest result = {0};
    const skv_terrain *terrain = skv_world_terrain(world);
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < n; i++) {
        x[i] = p.x[i];
        y[i] = p.y[i];
    }
    for (int f = 0; f < frames; f++) {
        fixture_run(world, 1);
        double speed = skv_world_stats(world).rms_speed;
        result.rms += speed * speed / frames;
    }
    result.rms = sqrt(result.rms);
    p = skv_world_particles(world);
    /* The part of the slope that is under water and clear of both ends. */
    double x0 = 0.4 + 3 * (double)h,
           x1 = fmin(1.6, 0.4 + (double)level / tan(angle)) - 6 * (double)h;
    for (int i = 0; i < n; i++) {
        if ((double)x[i] < x0 || (double)x[i] > x1)
            continue;
        float distance = skv_terrain_distance(terrain, x[i], y[i]);
        if (distance < h) {
            near_wall++;
            result.creep += (double)(p.x[i] - x[i]) * tx + (double)(p.y[i] - y[i]) * ty;
        }
    }
    result.creep /= near_wall * (frames / 60.0);
    result.layer = fixture_wall_layer(world, (double)level - 0.03);
    free(x);
    free(y);
    return result;
}

static void staircases_neither_creep_nor_heat(void **unused)
{
    (void)unused;
    const double angles[] = {10, 30, 45};
    for (int a = 0; a < 3; a++) {
        if (angles[a] != 30 && !long_tests())
            continue;
        float level = 0.5f;
        skv_world *world = pool_on(slope, angles[a], false, level);
        fixture_run(world, FIXTURE_SWING(6));
        rest r = measure(world, angles[a], level, 3 * 60);
        printf("%2.0f degrees: creep %+.5f m/s, rms speed %.5f m/s, layer %.3f\n", angles[a],
               r.creep, r.rms, r.layer);
        assert_true(fabs(r.creep) <= 0.001);
        assert_true(r.rms <= 0.01);
        assert_true(fabs(r.layer - 1) < 0.1);
        assert_int_equal(skv_world_stats(world).escaped, 0);
        skv_world_destroy(world);
    }
}

static void no_layer_is_stacked_on_any_wall(void **unused)
{
    (void)unused;
    const struct {
        const char *name;
        floor_at *floor;
        double parameter;
    } floors[] = {
        {"slope of 17 degrees", slope, 17}, {"slope of 38 degrees", slope, 38},
        {"bowl of 1 m", bowl, 1},           {"bowl of 0.5 m", bowl, 0.5},
        {"hill of 0.3 m", hill, 0.3},
    };
    for (size_t i = 0; i < sizeof floors / sizeof *floors; i++) {
        if (i % 2 == 0 && !long_tests())
            continue;
        for (int smooth = 0; smooth < 2; smooth++) {
            skv_world *world = pool_on(floors[i].floor, floors[i].parameter, smooth, 0.5f);
            fixture_run(world, FIXTURE_SWING(6));
            double layer = 0, rms = 0;
            const int frames = 60;
            for (int f = 0; f < frames; f++) {
                fixture_run(world, 1);
                layer += fixture_wall_layer(world, 0.47) / frames;
                double speed = skv_world_stats(world).rms_speed;
                rms += speed * speed / frames;
            }
            printf("%s, %s: layer %.3f, rms speed %.5f m/s\n", floors[i].name,
                   smooth ? "smooth" : "steps", layer, sqrt(rms));
            assert_true(fabs(layer - 1) < 0.1);
            assert_true(sqrt(rms) <= 0.01);
            skv_world_destroy(world);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(staircases_neither_creep_nor_heat),
        cmocka_unit_test(no_layer_is_stacked_on_any_wall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
