/* As much fluid as is drawn: in vessels of any shape, of many particles and few, by their number
 * and by their spacing, also beside bodies that lie in it; and beside either wall alike.
 *
 * Vessels are as wide as three spacings or wider. What their drawn area is stands beside each, as
 * geometry has it. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "skvalp/skvalp.h"
#include "support/fixture.h"

/* Of what is drawn; a particle more or less is more where they are few. */
#define NEARLY 0.003

typedef struct vessel {
    const char *name, *walls, *water;
    double area; /* m^2 */
} vessel;

#define ALL_BUT "{\"shape\": \"box\"}, "
#define CARVED  "{\"carve\": true, \"shape\": "

static const vessel vessels[] = {
    {"tank", "", "{\"shape\": \"box\", \"y1\": 0.45}", 1.6 * 0.45},
    {"flask",
     ALL_BUT CARVED "\"box\", \"x0\": 0.55, \"x1\": 1.05, \"y0\": 0.1, \"y1\": 0.4}, " CARVED
                    "\"box\", \"x0\": 0.75, \"x1\": 0.85, \"y0\": 0.3}",
     "{\"shape\": \"box\", \"y1\": 0.7}", 0.5 * 0.3 + 0.1 * 0.3},
    {"funnel",
     ALL_BUT CARVED "\"polygon\", \"points\": [[0.7, 0.1], [0.9, 0.1], [1.3, 0.9], [0.3, 0.9]]}",
     "{\"shape\": \"box\", \"y1\": 0.7}", 0.6 * (0.2 + 0.8) / 2},
    {"slanted vessel",
     ALL_BUT CARVED "\"polygon\", \"points\": [[0.2, 0.1], [0.5, 0.1], [1.3, 0.9], [1.0, 0.9]]}",
     "{\"shape\": \"box\", \"y1\": 0.7}", 0.6 * 0.3},
    {"bowl", ALL_BUT CARVED "\"circle\", \"x\": 0.8, \"y\": 0.6, \"radius\": 0.5}",
     "{\"shape\": \"box\", \"y1\": 0.6}", 3.14159265358979 * 0.25 / 2},
    {"drops", "",
     "{\"shape\": \"circle\", \"x\": 0.5, \"y\": 0.5, \"radius\": 0.2}, "
     "{\"shape\": \"circle\", \"x\": 1.1, \"y\": 0.4, \"radius\": 0.1}",
     3.14159265358979 * 0.05},
    {"bodies half in, turned, and all below", "",
     "{\"shape\": \"box\", \"y1\": 0.45}], \"bodies\": ["
     "{\"shape\": \"box\", \"x0\": 0.3, \"x1\": 0.5, \"y0\": 0.35, \"y1\": 0.55}, "
     "{\"shape\": \"box\", \"x0\": 0.7, \"x1\": 0.9, \"y0\": 0.1, \"y1\": 0.2, \"angle\": 1}, "
     "{\"shape\": \"circle\", \"x\": 1.3, \"y\": 0.2, \"radius\": 0.1, \"fixed\": true}",
     1.6 * 0.45 - 0.2 * 0.1 - 0.2 * 0.1 - 3.14159265358979 * 0.01},
};
enum { VESSELS = sizeof vessels / sizeof *vessels };

static skv_scene *open(const vessel *v, const char *path, const char *value)
{
    char text[1000];
    snprintf(text, sizeof text, "{\"settle\": false, \"solid\": [%s], \"water\": [%s]}", v->walls,
             v->water);
    const char *const setting[] = {path, value, NULL};
    skv_scene *scene;
    skv_error error = {0};
    if (load_text(text, setting, &scene, &error) != SKV_OK)
        fail_msg("%s: %s", v->name, error.text);
    return scene;
}

/* The world of a scene, which is given back, once its particles are as many as the scene says. */
static skv_world *fill(skv_scene *scene)
{
    skv_world *world;
    skv_error error = {0};
    if (skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_int_equal(skv_world_particle_count(world), skv_scene_particles(scene));
    skv_scene_destroy(scene);
    return world;
}

/* The mass, as a share of what is drawn. */
static double mass(const skv_world *world, const vessel *v)
{
    double s = skv_world_spacing(world);
    return skv_world_particle_count(world) * s * s / v->area;
}

/* Fails unless a vessel has its mass at a number of particles, and at the spacing they would have.
 */
static void expect_mass(const vessel *v, int particles)
{
    char value[32];
    snprintf(value, sizeof value, "%d", particles);
    skv_world *world = fill(open(v, "particles", value));
    assert_int_equal(skv_world_particle_count(world), particles);
    double by_number = mass(world, v);
    skv_world_destroy(world);
    snprintf(value, sizeof value, "%.6f", sqrt(v->area / particles));
    world = fill(open(v, "fluid.spacing", value));
    double by_spacing = mass(world, v);
    skv_world_destroy(world);
    if (!(fabs(by_number - 1) < NEARLY && fabs(by_spacing - 1) < NEARLY))
        fail_msg("%s, %d particles: %.4f of what is drawn, by its spacing %.4f", v->name, particles,
                 by_number, by_spacing);
}

static void a_vessel_holds_what_is_drawn(void **unused)
{
    (void)unused;
    static const int numbers[] = {300, 1000, 3000, 10000};
    for (int i = 0; i < VESSELS; i++)
        for (int k = 0; k < 4; k++)
            expect_mass(&vessels[i], numbers[k]);
}

/* Tubes 0.6 m deep, as wide as whole pixels are: 3.2, 5 and 10 spacings of 300 particles. */
static void a_tube_holds_what_is_drawn(void **unused)
{
    (void)unused;
    static const double widths[] = {0.02, 0.05, 0.2};
    for (int i = 0; i < 3; i++) {
        char walls[200];
        snprintf(walls, sizeof walls,
                 ALL_BUT CARVED "\"box\", \"x0\": 0.7, \"x1\": %.2f, \"y0\": 0.1}",
                 0.7 + widths[i]);
        vessel tube = {"tube", walls, "{\"shape\": \"box\", \"y1\": 0.7}", 0.6 * widths[i]};
        expect_mass(&tube, 300);
    }
}

static int count_between(const skv_world *world, double x0, double x1)
{
    skv_particles p = skv_world_particles(world);
    int count = 0;
    for (int i = 0; i < p.count; i++)
        count += p.x[i] > x0 && p.x[i] < x1;
    return count;
}

/* Wide vessels and narrow ones in one world have each what is drawn in it, to a particle. */
static void each_vessel_has_its_own(void **unused)
{
    (void)unused;
    static const double tubes[][2] = {{0.1, 0.14}, {0.2, 0.9}, {1.0, 1.06}, {1.1, 1.2}, {1.3, 1.5}};
    static const int numbers[] = {700, 1000, 3000};
    char walls[800] = "{\"shape\": \"box\"}";
    double area = 0;
    for (int i = 0; i < 5; i++) {
        size_t used = strlen(walls);
        snprintf(walls + used, sizeof walls - used,
                 ", " CARVED "\"box\", \"x0\": %.2f, \"x1\": %.2f, \"y0\": 0.05}", tubes[i][0],
                 tubes[i][1]);
        area += 0.6 * (tubes[i][1] - tubes[i][0]);
    }
    vessel all = {"tubes", walls, "{\"shape\": \"box\", \"y1\": 0.65}", area};
    for (int k = 0; k < 3; k++) {
        char value[32];
        snprintf(value, sizeof value, "%d", numbers[k]);
        skv_world *world = fill(open(&all, "particles", value));
        double s = skv_world_spacing(world);
        for (int i = 0; i < 5; i++) {
            double drawn = 0.6 * (tubes[i][1] - tubes[i][0]) / (s * s);
            int count = count_between(world, tubes[i][0], tubes[i][1]);
            if (!(fabs(count - drawn) < 1 + NEARLY * drawn))
                fail_msg("%d particles: tube %d has %d of %.1f", numbers[k], i, count, drawn);
        }
        skv_world_destroy(world);
    }
}

/* Of two fluids, one over the other, neither gets particles of the other. */
static void each_fluid_has_its_own(void **unused)
{
    (void)unused;
    const char *text = "{\"settle\": false, \"fluids\": [{\"name\": \"oil\", \"density\": 800}],"
                       "\"water\": [{\"shape\": \"box\", \"y1\": 0.31},"
                       "{\"shape\": \"box\", \"y0\": 0.31, \"y1\": 0.4, \"fluid\": \"oil\"}]}";
    static const char *const numbers[] = {"300", "907", "1000", "3001"};
    for (int i = 0; i < 4; i++) {
        const char *const setting[] = {"particles", numbers[i], NULL};
        skv_scene *scene;
        assert_int_equal(load_text(text, setting, &scene, NULL), SKV_OK);
        skv_world *world = fill(scene);
        assert_near(skv_world_fluid_stats(world, 1).particles,
                    skv_world_particle_count(world) * 0.09 / 0.4, 1);
        skv_world_destroy(world);
    }
}

/* Rows begin and end at walls as the lattice has it: a quarter and three quarters of a particle
 * from them, in turn. */
static void both_walls_are_alike(void **unused)
{
    (void)unused;
    for (int particles = 300; particles < 3000; particles += 250) {
        char value[32];
        snprintf(value, sizeof value, "%d", particles);
        skv_world *world = fill(open(&vessels[0], "particles", value));
        skv_particles p = skv_world_particles(world);
        double left = 9, right = 9, s = skv_world_spacing(world);
        for (int i = 0; i < p.count; i++) {
            left = fmin(left, (double)p.x[i]);
            right = fmin(right, 1.6 - (double)p.x[i]);
        }
        assert_near(left, 0.27 * s, 0.03 * s);
        assert_near(right, 0.27 * s, 0.03 * s);
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_vessel_holds_what_is_drawn),
        cmocka_unit_test(a_tube_holds_what_is_drawn),
        cmocka_unit_test(each_vessel_has_its_own),
        cmocka_unit_test(each_fluid_has_its_own),
        cmocka_unit_test(both_walls_are_alike),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
