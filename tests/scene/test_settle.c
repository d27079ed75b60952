/* Scenes begin settled: what can rest where it is begins at rest, however short the substeps are;
 * what is going to flow or to fall keeps its shape, and all of it its velocity. */
#include "scene/support.h"

#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static skv_world *open_scene(const char *json, int particles, const char *substeps, bool settle,
                             int threads)
{
    const skv_setting settings[] = {{"settle", settle ? "true" : "false"}, {"substeps", substeps}};
    skv_scene_options options = skv_default_scene_options();
    options.settings = settings;
    options.setting_count = 2;
    options.particles = particles;
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error;
    if (skv_scene_load_memory(json, strlen(json), "json", "test", &options, &scene, &error) !=
            SKV_OK ||
        skv_scene_create_world(scene, threads, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_scene_destroy(scene);
    return world;
}

/* The highest rms speed of the first second, m/s. */
static double unrest(skv_world *world)
{
    double worst = 0;
    for (int frame = 0; frame < 60; frame++) {
        fixture_run(world, 1);
        worst = fmax(worst, skv_world_stats(world).rms_speed);
    }
    return worst;
}

static const char pool[] = "{\"water\": [{\"shape\": \"box\", \"y1\": 0.45}]}";
static const char clavet_pool[] = "{\"fluid\": {\"law\": \"clavet\"},"
                                  " \"water\": [{\"shape\": \"box\", \"y1\": 0.45}]}";

/* Where the fluid's top is: above it there is nothing. */
static float top_of(const skv_world *world)
{
    skv_particles p = skv_world_particles(world);
    float top = 0;
    for (int i = 0; i < p.count; i++)
        top = fmaxf(top, p.y[i]);
    return top;
}

static void pools_begin_at_rest(void **unused)
{
    (void)unused;
    const struct {
        const char *json;
        int particles;
        const char *substeps;
        double most; /* m/s */
    } cases[] = {
        {pool, 295, "0", 0.02},
        {pool, 380, "0", 0.02}, /* whose surface is thinned to that number */
        {pool, 1000, "0", 0.02},
        {pool, 2960, "0", 0.02},
        {pool, 9946, "0", 0.02},
        {pool, 20000, "0", 0.017}, /* which get a quarter of the rounds that would make them calm */
        {pool, 300, "6", 0.02},
        {pool, 2960, "10", 0.02},
        {pool, 9946, "18", 0.02},
        {pool, 2960, "20", 0.025},
        {pool, 295, "300", 0.035},
        {clavet_pool, 295, "0", 0.01},
        {clavet_pool, 2960, "0", 0.025},
        {clavet_pool, 9946, "0", 0.03},
        {clavet_pool, 1000, "14", 0.01},
        {clavet_pool, 295, "40", 0.01},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (cases[i].particles > 1000 && !long_tests())
            continue;
        skv_world *world =
            open_scene(cases[i].json, cases[i].particles, cases[i].substeps, true, 1);
        assert_true(skv_world_time(world) == 0);
        assert_int_equal(skv_world_substep_count(world), 0);
        float before = top_of(world);
        double speed = unrest(world);
        if (!(speed <= cases[i].most))
            fail_msg("case %d, %d particles: %.4f m/s", (int)i, cases[i].particles, speed);
        /* It neither sinks nor swells any more. */
        assert_near(top_of(world), before, 0.6 * skv_world_spacing(world));
        skv_world_destroy(world);
    }
    skv_world *raw = open_scene(pool, 2960, "0", false, 1);
    assert_true(unrest(raw) > 0.1);
    skv_world_destroy(raw);
}

/* Tanks that are no boxes, water whose columns end at a roof, and gates. */
static void any_vessel_begins_at_rest(void **unused)
{
    (void)unused;
    const char *const vessels[] = {
        /* A U-tube with equal levels. */
        "{\"solid\": [{\"shape\": \"box\", \"x0\": 0.3, \"x1\": 1.3, \"y0\": 0.2}],"
        " \"water\": [{\"shape\": \"box\", \"y1\": 0.5}]}",
        /* Slanted walls, steep and shallow. */
        "{\"solid\": [{\"shape\": \"polygon\", \"points\": [[0, 0], [0.4, 0], [0, 0.9]]},"
        " {\"shape\": \"polygon\", \"points\": [[0.9, 0], [1.6, 0], [1.6, 0.35]]}],"
        " \"water\": [{\"shape\": \"box\", \"y1\": 0.5}]}",
        /* A body in the water, and a thin wall. */
        "{\"solid\": [{\"shape\": \"box\", \"x0\": 0.5, \"y0\": 0.15, \"x1\": 0.8, \"y1\": 0.3},"
        " {\"shape\": \"line\", \"thickness\": 0.01, \"points\": [[1.2, 0], [1.2, 0.9]]}],"
        " \"water\": [{\"shape\": \"box\", \"y1\": 0.45}]}",
        /* Gates between unequal levels, which are bodies. */
        "{\"bodies\": [{\"shape\": \"box\", \"x0\": 0.5, \"x1\": 0.54, \"y0\": -0.05, \"y1\": 0.8,"
        " \"fixed\": true}, {\"shape\": \"box\", \"x0\": 1.1, \"x1\": 1.14, \"y0\": -0.05, \"y1\": "
        "0.8,"
        " \"fixed\": true}], \"water\": [{\"shape\": \"box\", \"x1\": 0.5, \"y1\": 0.6},"
        " {\"shape\": \"box\", \"x0\": 0.54, \"x1\": 1.1, \"y1\": 0.4},"
        " {\"shape\": \"box\", \"x0\": 1.14, \"y1\": 0.2}]}",
    };
    for (size_t i = 0; i < sizeof vessels / sizeof *vessels; i++) {
        skv_world *world = open_scene(vessels[i], 2000, "0", true, 1);
        double speed = unrest(world);
        if (!(speed <= 0.02))
            fail_msg("vessel %d: %.4f m/s", (int)i, speed);
        skv_world_destroy(world);
    }
}

/* The mean of the rightmost and of the highest places, in bands of a spacing and a half. */
static void measure_block(const skv_world *world, double *right, double *top)
{
    skv_particles p = skv_world_particles(world);
    double band = 1.5 * skv_world_spacing(world), highest[64] = {0}, farthest[64] = {0};
    for (int i = 0; i < p.count; i++) {
        int row = (int)(p.y[i] / band), column = (int)(p.x[i] / band);
        if (row < 64)
            farthest[row] = fmax(farthest[row], p.x[i]);
        if (column < 64)
            highest[column] = fmax(highest[column], p.y[i]);
    }
    *right = *top = 0;
    int rows = 0, columns = 0;
    for (int i = 1; i < 64 && i * band < 0.5; i++, rows++)
        *right += farthest[i];
    for (int i = 1; i < 64 && i * band < 0.3; i++, columns++)
        *top += highest[i];
    *right /= rows;
    *top /= columns;
}

static void expect_face(const char *dam)
{
    skv_world *raw = open_scene(dam, 2000, "0", false, 1);
    skv_world *settled = open_scene(dam, 2000, "0", true, 1);
    double spacing = skv_world_spacing(raw), right, top, right_now, top_now;
    measure_block(raw, &right, &top);
    measure_block(settled, &right_now, &top_now);
    assert_near(right_now, right, 0.5 * spacing);
    /* It is compressed by its weight. */
    assert_true(top_now < top - 0.5 * spacing && top_now > top - 2.5 * spacing);
    fixture_run(settled, 30);
    measure_block(settled, &right_now, &top_now);
    assert_true(right_now > right + 10 * spacing);
    skv_world_destroy(raw);
    skv_world_destroy(settled);
}

/* Also where the ceiling keeps the air from its top. */
static void a_dam_keeps_its_face(void **unused)
{
    (void)unused;
    expect_face("{\"water\": [{\"shape\": \"box\", \"x1\": 0.4, \"y1\": 0.6}]}");
    expect_face("{\"water\": [{\"shape\": \"box\", \"x1\": 0.4}]}");
}

/* The pool with a surface of 81 points: `height` of `amplitude` times a cosine of `waves` lengths,
 * or of a straight line if there are none. */
static void draw_wave(char text[8000], double height, double amplitude, double waves)
{
    int used = sprintf(text, "{\"water\": [{\"shape\": \"polygon\", \"points\": [[0, 0]");
    for (int i = 0; i <= 80; i++) {
        double share = i / 80.0;
        double up = waves > 0 ? cos(6.283185307179586 * waves * share) : 2 * share - 1;
        used += sprintf(text + used, ", [%.4f, %.5f]", 1.6 * share, height + amplitude * up);
    }
    sprintf(text + used, ", [1.6, 0]]}]}");
}

/* How far the highest places, in bands of a spacing and a half, go along with the wave: its
 * amplitude, m. */
static double measure_wave(const skv_world *world, double waves)
{
    skv_particles p = skv_world_particles(world);
    int bands = (int)(1.6 / (1.5 * skv_world_spacing(world)));
    double highest[256] = {0}, product = 0, square = 0;
    assert_true(bands < 256);
    for (int i = 0; i < p.count; i++) {
        int band = (int)fmin(p.x[i] / 1.6 * bands, bands - 1);
        highest[band] = fmax(highest[band], p.y[i]);
    }
    for (int i = 0; i < bands; i++) {
        double share = (i + 0.5) / bands;
        double up = waves > 0 ? cos(6.283185307179586 * waves * share) : 2 * share - 1;
        product += highest[i] * up;
        square += up * up;
    }
    return product / square;
}

/* How much of a wave is left when a scene begins, and writes how fast its fluid gets. By chance a
 * lattice leans by some hundredths of a spacing, so a wave that is to be levelled is measured in
 * eight numbers of particles. */
static double share_of_wave(double amplitude, double waves, int particles, bool stays,
                            double *speed)
{
    enum { LEANING = 8 };
    const int starts = stays ? 1 : LEANING;
    double share = 0;
    *speed = 0;
    for (int k = 0; k < starts; k++) {
        char text[8000];
        draw_wave(text, 0.45, amplitude, waves);
        skv_world *world = open_scene(text, particles + k * particles / 100, "0", true, 1);
        share += measure_wave(world, waves) / amplitude / starts;
        *speed = fmax(*speed, unrest(world));
        skv_world_destroy(world);
    }
    return share;
}

/* A surface that is drawn out of balance by more than a spacing stays so, and swings. Less, which
 * particles can't show, is levelled. */
static void a_wave_stays_as_it_is_drawn(void **unused)
{
    (void)unused;
    const struct {
        double amplitude, waves; /* m */
        int particles;
        bool stays;
    } cases[] = {{0.02, 4, 1000, true},   {0.02, 4, 3000, true},  {0.02, 1, 1500, true},
                 {0.03, 0, 900, true},    {0.02, 0, 2000, true},  {0.06, 2, 1100, true},
                 {0.005, 3, 1000, false}, {0.003, 0, 2000, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (cases[i].particles > 1100 && !long_tests())
            continue;
        double speed, now = share_of_wave(cases[i].amplitude, cases[i].waves, cases[i].particles,
                                          cases[i].stays, &speed);
        if (cases[i].stays ? !(now > 0.8 && speed > 0.04) : !(fabs(now) < 0.1 && speed < 0.02))
            fail_msg("case %d: %.2f of its height, then %.3f m/s", (int)i, now, speed);
    }
}

/* The centre of the particles above a height, the diameter of a disc that is as wide, and their
 * number. */
static int measure_above(const skv_world *world, float height, double *x, double *y,
                         double *diameter)
{
    skv_particles p = skv_world_particles(world);
    int count = 0;
    double squares = 0;
    *x = *y = 0;
    for (int i = 0; i < p.count; i++) {
        if (p.y[i] < height)
            continue;
        count++;
        *x += p.x[i];
        *y += p.y[i];
        squares += p.x[i] * p.x[i] + p.y[i] * p.y[i];
    }
    *x /= count;
    *y /= count;
    *diameter = sqrt(8 * (squares / count - *x * *x - *y * *y));
    return count;
}

/* A disc in the air above a pool that is at rest: it stays, and keeps its speed. */
static void what_is_in_the_air_stays_and_keeps_its_speed(void **unused)
{
    (void)unused;
    const char *drop = "{\"water\": [{\"shape\": \"box\", \"y1\": 0.25}, {\"shape\": \"circle\","
                       "\"x\": 0.8, \"y\": 0.65, \"radius\": 0.12, \"vx\": 1.5, \"vy\": -2}]}";
    skv_world *raw = open_scene(drop, 2000, "0", false, 1);
    skv_world *settled = open_scene(drop, 2000, "0", true, 1);
    double spacing = skv_world_spacing(raw), x, y, wide, x_now, y_now, wide_now;
    int count = measure_above(raw, 0.45f, &x, &y, &wide);
    assert_int_equal(measure_above(settled, 0.45f, &x_now, &y_now, &wide_now), count);
    assert_near(x_now, x, 0.05 * spacing);
    assert_near(y_now, y, 0.05 * spacing);
    assert_near(wide_now, wide, 0.1 * spacing);
    skv_particles p = skv_world_particles(settled);
    for (int i = 0; i < p.count; i++) {
        bool thrown = p.y[i] > 0.45f;
        assert_true(p.vx[i] == (thrown ? 1.5f : 0) && p.vy[i] == (thrown ? -2.0f : 0));
    }
    skv_world_destroy(raw);
    skv_world_destroy(settled);
}

/* Gravity in any direction, and none. */
static void gravity_may_point_anywhere(void **unused)
{
    (void)unused;
    const char *aside = "{\"gravity\": {\"x\": 9.81, \"y\": 0},"
                        "\"water\": [{\"shape\": \"box\", \"x0\": 1.2}]}";
    skv_world *world = open_scene(aside, 2000, "0", true, 1);
    assert_true(unrest(world) < 0.04);
    skv_world_destroy(world);
    const char *none = "{\"gravity\": {\"x\": 0, \"y\": 0},"
                       "\"water\": [{\"shape\": \"box\", \"x1\": 0.5, \"y1\": 0.5}]}";
    world = open_scene(none, 1000, "0", true, 1);
    assert_true(unrest(world) < 0.03);
    skv_world_destroy(world);
}

/* The same places on any number of threads; and the same scene once more. */
static void settling_is_deterministic(void **unused)
{
    (void)unused;
    const char *const scenes[] = {pool, "{\"water\": [{\"shape\": \"box\", \"x1\": 0.4}]}"};
    for (int i = 0; i < 2; i++) {
        skv_world *one = open_scene(scenes[i], 1500, "0", true, 1);
        skv_world *three = open_scene(scenes[i], 1500, "0", true, 3);
        assert_int_equal(skv_world_hash(one), skv_world_hash(three));
        fixture_run(one, 5);
        fixture_run(three, 5);
        assert_int_equal(skv_world_hash(one), skv_world_hash(three));
        skv_world_destroy(one);
        skv_world_destroy(three);
    }
}

/* A host that calls it itself: both laws, both solvers, and a world without particles. */
static void a_host_may_settle(void **unused)
{
    (void)unused;
    for (int k = 0; k < 4; k++) {
        skv_law law = k & 1 ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED;
        skv_solver_kind solver = k & 2 ? SKV_SOLVER_REFERENCE : SKV_SOLVER_FAST;
        double raw = 0, settled = 0;
        for (int settle = 0; settle < 2; settle++) {
            skv_world *world = fixture_tank_with(law, solver, 0.04f);
            assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
            fixture_fill(world, 0, 0, 1.6f, 0.4f);
            if (settle)
                assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
            fixture_run(world, 1);
            *(settle ? &settled : &raw) = skv_world_stats(world).rms_speed;
            skv_world_destroy(world);
        }
        assert_true(settled < 0.25 * raw);
    }
}

/* Mean height of the highest places between two uprights, in bands of a spacing and a half. */
static double measure_top(const skv_world *world, double x0, double x1)
{
    skv_particles p = skv_world_particles(world);
    int bands = (int)((x1 - x0) / (1.5 * skv_world_spacing(world)));
    double highest[64] = {0}, sum = 0;
    assert_true(bands > 0 && bands < 64);
    for (int i = 0; i < p.count; i++) {
        int band = (int)floor((p.x[i] - x0) / (x1 - x0) * bands);
        if (band >= 0 && band < bands)
            highest[band] = fmax(highest[band], p.y[i]);
    }
    for (int i = 0; i < bands; i++)
        sum += highest[i];
    return sum / bands;
}

/* Also those that a roof divides: arms of a U-tube, drawn 40 mm apart, two spacings. */
static void levels_of_arms_stay_as_they_are_drawn(void **unused)
{
    (void)unused;
    skv_world *world =
        open_scene("{\"solid\": [{\"shape\": \"box\", \"x0\": 0.4, \"x1\": 1.2, \"y0\": 0.2}],"
                   " \"water\": [{\"shape\": \"box\", \"x1\": 0.4, \"y1\": 0.52},"
                   " {\"shape\": \"box\", \"x0\": 0.4, \"x1\": 1.2, \"y1\": 0.2},"
                   " {\"shape\": \"box\", \"x0\": 1.2, \"y1\": 0.48}]}",
                   1400, "0", true, 1);
    double apart = measure_top(world, 0, 0.4) - measure_top(world, 1.2, 1.6);
    assert_near(skv_world_spacing(world), 0.02, 0.002);
    assert_near(apart, 0.04, 0.008);
    skv_world_destroy(world);
}

static bool drawn_slope(float x, float y, void *user)
{
    return y < 0.3f + *(const float *)user * x;
}

/* A host tells how fluid was drawn: else the same slope is levelled. */
static void a_host_may_say_how_it_is_drawn(void **unused)
{
    (void)unused;
    float slope = 0.04f;
    for (int told = 0; told < 2; told++) {
        skv_world *world = fixture_tank_with(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0.04f);
        skv_fill_def def = skv_default_fill_def();
        def.inside = drawn_slope;
        def.user = &slope;
        assert_int_equal(skv_world_fill(world, &def, NULL, NULL), SKV_OK);
        assert_int_equal(told ? skv_world_settle_drawn(world, drawn_slope, &slope, NULL)
                              : skv_world_settle_drawn(world, NULL, NULL, NULL),
                         SKV_OK);
        double half = measure_wave(world, 0), drawn = 0.8 * (double)slope;
        if (told ? !(half > 0.7 * drawn) : !(half < 0.2 * drawn))
            fail_msg("told %d: %.4f of %.4f m", told, half, drawn);
        skv_world_destroy(world);
    }
}

static bool count_question(void *user)
{
    ++*(int *)user;
    return false;
}

/* How often settling a scene is asked whether it is to stop: twice a round. */
static int questions_of(const char *text, int particles)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_scene *scene;
    skv_world *world;
    skv_pool *own;
    int asked = 0;
    skv_error error;
    if (skv_scene_load_memory(text, strlen(text), "json", "test", &options, &scene, &error) !=
        SKV_OK)
        fail_msg("%s", error.text);
    assert_int_equal(skv_pool_create(1, &own, NULL), SKV_OK);
    skv_pool_set_stop(own, count_question, &asked);
    skv_world_def def = skv_scene_world_def(scene);
    def.pool = own;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    assert_int_equal(skv_scene_fill(scene, world, NULL), SKV_OK);
    skv_scene_destroy(scene);
    skv_world_destroy(world);
    skv_pool_destroy(own);
    return asked;
}

/* The basin is cut in pieces by upright walls, of which each particle has one near. */
static int questions_of_pieces(const char *pixel)
{
    char text[1000];
    size_t used = (size_t)snprintf(text, sizeof text,
                                   "{\"world\":{\"width\":3.2,\"height\":3.2,\"pixel\":%s},"
                                   "\"fluid\":{\"spacing\":0.1},\"solid\":[",
                                   pixel);
    for (int i = 1; i < 8; i++)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "%s{\"shape\":\"box\",\"x0\":%g,\"x1\":%g}", i > 1 ? "," : "",
                                 0.4 * i, 0.4 * i + 0.02);
    snprintf(text + used, sizeof text - used, "],\"water\":[{\"shape\":\"box\",\"y1\":2.4}]}");
    return questions_of(text, 0);
}

/* Where a radius has very many pixels, each round takes long beside thin walls, and is one of
 * fewer.
 */
static void fine_pictures_get_fewer_rounds(void **unused)
{
    (void)unused;
    int coarse = questions_of_pieces("0.01"), fine = questions_of_pieces("0.002");
    if (!(fine < coarse / 2))
        fail_msg("%d rounds, and %d in a fine picture", coarse / 2, fine / 2);
}

/* The more particles, the fewer rounds: a million begin with less work than a third of a frame's,
 * and ten thousand, which could have 500 rounds of five millions, with half of these. */
static void many_particles_get_few_rounds(void **unused)
{
    (void)unused;
    static const struct {
        int particles, most;
    } cases[] = {{10000, 250}, {40000, 125}, {200000, 25}, {1000000, 20}};
    for (int i = 0; i < (long_tests() ? 4 : 2); i++) {
        int rounds = questions_of(pool, cases[i].particles) / 2;
        if (!(rounds > 0 && rounds <= cases[i].most))
            fail_msg("%d rounds of %d particles", rounds, cases[i].particles);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pools_begin_at_rest),
        cmocka_unit_test(any_vessel_begins_at_rest),
        cmocka_unit_test(a_dam_keeps_its_face),
        cmocka_unit_test(a_wave_stays_as_it_is_drawn),
        cmocka_unit_test(what_is_in_the_air_stays_and_keeps_its_speed),
        cmocka_unit_test(gravity_may_point_anywhere),
        cmocka_unit_test(settling_is_deterministic),
        cmocka_unit_test(a_host_may_settle),
        cmocka_unit_test(levels_of_arms_stay_as_they_are_drawn),
        cmocka_unit_test(a_host_may_say_how_it_is_drawn),
        cmocka_unit_test(fine_pictures_get_fewer_rounds),
        cmocka_unit_test(many_particles_get_few_rounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
