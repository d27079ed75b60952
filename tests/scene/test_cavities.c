/* Fluid begins without a cavity where it is drawn in one piece, in all scenes.
 *
 * A place is deep if nothing within three spacings of it is drawn dry. Of a lattice no place is
 * farther than 0.6 spacings from a particle, of fluid at rest 0.95, at a wall's corner 1.2. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "skvalp/skvalp.h"
#include "support/fixture.h"

/* In spacings: from place to place, how deep is deep, and where no particle is near. */
#define STEP  0.5
#define DEEP  3
#define DRY   0.95
#define EMPTY 1.25

static skv_world *open_scene(const char *name, int particles, const char *law, const char *settle)
{
    const skv_setting settings[] = {{"fluid.law", law}, {"settle", settle}};
    skv_scene_options options = skv_default_scene_options();
    options.settings = settings;
    options.setting_count = 2;
    options.particles = particles;
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error = {0};
    if (skv_scene_load(name, &options, &scene, &error) != SKV_OK ||
        skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s: %s", name, error.text);
    skv_scene_destroy(scene);
    return world;
}

/* Places of a world, row by row. */
typedef struct places {
    int columns, rows;
    double apart; /* m */
} places;

static void find_place(const places *all, int i, double *x, double *y)
{
    int column = i % all->columns, row = i / all->columns;
    *x = (column + 0.5) * all->apart;
    *y = (row + 0.5) * all->apart;
}

static double nearest(const skv_world *world, double x, double y)
{
    skv_particles p = skv_world_particles(world);
    double least = INFINITY;
    for (int i = 0; i < p.count; i++) {
        double dx = (double)p.x[i] - x, dy = (double)p.y[i] - y;
        least = fmin(least, dx * dx + dy * dy);
    }
    return sqrt(least);
}

/* Whether a place is drawn dry; of one in a wall it is not. */
static bool *find_dry(const places *all, const skv_world *drawn)
{
    bool *dry = calloc((size_t)all->columns * (size_t)all->rows, sizeof *dry);
    assert_non_null(dry);
    const skv_terrain *terrain = skv_world_terrain(drawn);
    double spacing = (double)skv_world_spacing(drawn);
    for (int i = 0; i < all->columns * all->rows; i++) {
        double x, y;
        find_place(all, i, &x, &y);
        dry[i] = skv_terrain_distance(terrain, (float)x, (float)y) > 0 &&
                 nearest(drawn, x, y) > DRY * spacing;
    }
    return dry;
}

static bool is_deep(const places *all, const bool *dry, int i)
{
    int reach = (int)(DEEP / STEP), column = i % all->columns, row = i / all->columns;
    for (int r = row - reach; r <= row + reach; r++)
        for (int c = column - reach; c <= column + reach; c++)
            if (r >= 0 && r < all->rows && c >= 0 && c < all->columns && dry[r * all->columns + c])
                return false;
    return true;
}

static void expect_none(const char *name, int particles, const char *law)
{
    skv_world *drawn = open_scene(name, particles, law, "false"),
              *begun = open_scene(name, particles, law, "true");
    double spacing = (double)skv_world_spacing(drawn);
    places all = {.apart = STEP * spacing};
    all.columns = (int)((double)skv_terrain_width(skv_world_terrain(drawn)) / all.apart);
    all.rows = (int)((double)skv_terrain_height(skv_world_terrain(drawn)) / all.apart);
    bool *dry = find_dry(&all, drawn);
    int deep = 0;
    for (int i = 0; i < all.columns * all.rows; i++) {
        double x, y;
        find_place(&all, i, &x, &y);
        if (skv_terrain_distance(skv_world_terrain(drawn), (float)x, (float)y) <= 0 ||
            !is_deep(&all, dry, i))
            continue;
        deep++;
        double way = nearest(begun, x, y) / spacing;
        if (way > EMPTY)
            fail_msg("%s, %d particles, %s: no particle within %.2f spacings of (%.3f, %.3f)", name,
                     particles, law, way, x, y);
    }
    assert_true(deep > 20);
    free(dry);
    skv_world_destroy(drawn);
    skv_world_destroy(begun);
}

static void fluid_begins_without_cavities(void **unused)
{
    (void)unused;
    static const char *const names[] = {"pool",   "dam-break",    "waves", "breaking-wave",
                                        "u-tube", "splash",       "ink",   "oil",
                                        "funnel", "communicating"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        expect_none(names[i], 500, "calibrated");
        expect_none(names[i], 1500, "calibrated");
    }
    expect_none("dam-break", 3100, "calibrated");
}

/* Clavet's fluid draws its free corners in, so only vessels are full. */
static void vessels_begin_full_by_clavets_law(void **unused)
{
    (void)unused;
    static const char *const names[] = {"pool", "u-tube", "communicating"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        expect_none(names[i], 500, "clavet");
        expect_none(names[i], 1500, "clavet");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fluid_begins_without_cavities),
        cmocka_unit_test(vessels_begin_full_by_clavets_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
