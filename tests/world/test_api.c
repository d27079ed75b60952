/* The world's boundary: definitions, hostile numbers, misuse, capacity, open sides, queries. */
#include "support/fixture.h"
#include "support/misuse.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void expect_refused(skv_world_def def, const char *named)
{
    skv_world *world = NULL;
    skv_error error = {0};
    assert_int_equal(skv_world_create(&def, &world, &error), SKV_ERROR_VALUE);
    assert_null(world);
    if (!strstr(error.text, named))
        fail_msg("\"%s\" does not name %s", error.text, named);
}

static void bad_definitions_are_refused(void **unused)
{
    (void)unused;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = NAN;
    expect_refused(def, "fluid.spacing");
    def = skv_default_world_def();
    def.fluid.radius_ratio = 5;
    expect_refused(def, "fluid.radius_ratio");
    def = skv_default_world_def();
    def.gravity_x = INFINITY;
    expect_refused(def, "gravity.x");
    def = skv_default_world_def();
    def.threads = 65;
    expect_refused(def, "threads");
    def = skv_default_world_def();
    def.fluid.law = (skv_law)7;
    expect_refused(def, "fluid.law");
}

static void a_refused_world_leaves_the_terrain(void **unused)
{
    (void)unused;
    skv_terrain_def tank = skv_default_terrain_def();
    skv_world_def def = skv_default_world_def();
    assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
    def.substeps = -1;
    expect_refused(def, "substeps");
    assert_true(skv_terrain_distance(def.terrain, 0.8f, 0.06f) > 0.05f);
    skv_terrain_destroy(def.terrain);
}

static void hostile_numbers_change_nothing(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_world *twin = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    const float bad[] = {NAN, INFINITY, -INFINITY, 1e30f};
    skv_error error;
    for (int b = 0; b < 4; b++) {
        skv_hand hand = skv_default_hand();
        float *fields[] = {&hand.x,      &hand.y,          &hand.vx,       &hand.vy,
                           &hand.radius, &hand.attraction, &hand.friction, &hand.follow};
        for (int f = 0; f < 8; f++) {
            float kept = *fields[f];
            *fields[f] = bad[b];
            assert_int_equal(skv_world_set_hands(world, &hand, 1, &error), SKV_ERROR_VALUE);
            *fields[f] = kept;
        }
        assert_int_equal(skv_world_set_gravity(world, bad[b], 0, &error), SKV_ERROR_VALUE);
        assert_int_equal(skv_world_add_particle(world, bad[b], 0.5f, 0, 0, &error),
                         SKV_ERROR_VALUE);
        assert_int_equal(skv_world_add_particle(world, 0.5f, 0.5f, 0, bad[b], &error),
                         SKV_ERROR_VALUE);
        assert_int_equal(skv_world_add_velocity(world, 0, 1, bad[b], 0, &error), SKV_ERROR_VALUE);
        assert_int_equal(skv_world_step(world, bad[b], NULL), SKV_ERROR_VALUE);
        for (int f = 0; f < 6; f++) {
            skv_fill_def fill = skv_default_fill_def();
            float *numbers[] = {&fill.x0, &fill.y0, &fill.x1, &fill.y1, &fill.vx, &fill.vy};
            *numbers[f] = bad[b];
            assert_int_equal(skv_world_fill(world, &fill, NULL, &error), SKV_ERROR_VALUE);
        }
    }
    skv_hand hand = skv_default_hand();
    assert_int_equal(skv_world_set_hands(world, &hand, SKV_MAX_HANDS + 1, &error), SKV_ERROR_LIMIT);
    assert_int_equal(skv_world_add_velocity(world, 1 << 30, 5, 0, 0, &error), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_add_velocity(world, 0, INT32_MAX, 0, 0, &error), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_step(world, 0, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_step(world, -1, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_add_particle(world, -0.1f, 0.5f, 0, 0, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "solid"));
    fixture_run(world, 5);
    fixture_run(twin, 5);
    assert_int_equal(skv_world_hash(world), skv_world_hash(twin));
    skv_world_destroy(world);
    skv_world_destroy(twin);
}

/* Both ends of the range that world.h names are inside it. */
static void a_step_takes_the_times_it_names(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.05f, 1);
    assert_int_equal(skv_world_step(world, 1e-6f, NULL), SKV_OK);
    assert_int_equal(skv_world_step(world, 0.1f, NULL), SKV_OK);
    const float outside[] = {nextafterf(1e-6f, 0), nextafterf(0.1f, 1)};
    for (int i = 0; i < 2; i++) {
        skv_error error = {0};
        assert_int_equal(skv_world_step(world, outside[i], &error), SKV_ERROR_VALUE);
        assert_non_null(strstr(error.text, "allowed is 1e-06..0.1 s"));
    }
    skv_world_destroy(world);
}

/* The strongest hands that are allowed and the steepest gravity: no NaN, nothing escapes. */
static void allowed_violence_is_survived(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        skv_world *world = fixture_dam((skv_law)law, 0.025f, 1);
        for (int f = 0; f < 60; f++) {
            skv_hand hand = {.x = 0.4f,
                             .y = 0.2f,
                             .vx = 1000,
                             .vy = -1000,
                             .radius = 2,
                             .attraction = f % 2 ? 10000.0f : -10000.0f,
                             .friction = 10000,
                             .follow = 10000};
            float gravity = f % 3 ? 1000.0f : -1000.0f;
            assert_int_equal(skv_world_set_hands(world, &hand, f % 4 < 2, NULL), SKV_OK);
            assert_int_equal(skv_world_set_gravity(world, gravity, -gravity, NULL), SKV_OK);
            fixture_run(world, 1);
        }
        skv_stats stats = skv_world_stats(world);
        assert_int_equal(stats.not_finite, 0);
        assert_int_equal(stats.escaped, 0);
        skv_world_destroy(world);
    }
}

static void misuse_reaches_the_handler(void **unused)
{
    (void)unused;
    misuse_begin(NULL);
    float gx = 0, gy = 0;
    assert_int_equal(skv_world_step(NULL, 1, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_particle_count(NULL), 0);
    assert_int_equal(skv_world_particles(NULL).count, 0);
    assert_int_equal(skv_world_stats(NULL).particles, 0);
    assert_int_equal(skv_world_hash(NULL), 0);
    assert_null(skv_world_fluid(NULL));
    assert_null(skv_world_terrain(NULL));
    skv_world_gravity(NULL, &gx, &gy);
    assert_int_equal(skv_world_create(NULL, NULL, NULL), SKV_ERROR_VALUE);
    skv_world *world;
    skv_world_def def = skv_default_world_def();
    def.cookie = 0;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_ERROR_VALUE);
    def = skv_default_world_def();
    def.fluid.cookie = 1;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, 11);
    misuse_end(NULL);
    skv_world_destroy(NULL);
}

static void facts_are_right(void **unused)
{
    (void)unused;
    skv_world_def def = skv_default_world_def();
    def.capacity = 100;
    def.threads = 2;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    assert_int_equal(skv_world_threads(world), 2);
    assert_true(skv_world_spacing(world) == def.fluid.spacing);
    assert_true(skv_world_smoothing_radius(world) == def.fluid.spacing * 3);
    assert_int_equal(skv_world_fluid(world)->law, SKV_LAW_CALIBRATED);
    assert_string_equal(skv_law_name(SKV_LAW_CLAVET), "clavet");
    assert_true(fabsf(skv_terrain_width(skv_world_terrain(world)) - 1.6f) < 1e-6f);
    assert_true(skv_world_substeps_per_frame(world) >= 1);
    skv_profile profile = skv_world_profile(world, false);
    assert_int_equal(profile.count, 4);
    assert_string_equal(profile.name[1], "sort");
    assert_int_equal(skv_world_memory(world).kept, 0);
    /* An empty world steps, reports and stays empty. */
    fixture_run(world, 3);
    assert_int_equal(skv_world_stats(world).particles, 0);
    assert_int_equal(skv_world_hash(world), 14695981039346656037u);
    /* Beyond the capacity the world grows; numbers and positions stay. */
    for (int i = 0; i < 250; i++)
        assert_int_equal(skv_world_add_particle(world, 0.1f + 0.005f * (float)i, 0.5f, 0, 0, NULL),
                         SKV_OK);
    skv_particles p = skv_world_particles(world);
    assert_int_equal(p.count, 250);
    for (int i = 0; i < 250; i++) {
        assert_int_equal(p.id[i], i);
        assert_true(p.x[i] == 0.1f + 0.005f * (float)i);
    }
    fixture_run(world, 1);
    assert_true(skv_world_memory(world).kept > 0);
    skv_world_destroy(world);
}

static bool inside_disc(float x, float y, void *user)
{
    const float *disc = user;
    return (x - disc[0]) * (x - disc[0]) + (y - disc[1]) * (y - disc[1]) < disc[2] * disc[2];
}

static void filling_respects_shape_limit_and_count(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.01f, 1);
    const skv_terrain *terrain = skv_world_terrain(world);
    float disc[] = {0.8f, 0.45f, 0.2f};
    skv_fill_def fill = skv_default_fill_def();
    fill.inside = inside_disc;
    fill.user = disc;
    fill.vx = 0.5f;
    int expected = skv_fill_count(terrain, 0.01f, &fill);
    /* One particle per spacing^2. */
    assert_true(fabs(expected * 1e-4 / (acos(-1) * 0.04) - 1) < 0.02);
    skv_placed placed;
    assert_int_equal(skv_world_fill(world, &fill, &placed, NULL), SKV_OK);
    assert_int_equal(placed.added, expected);
    assert_int_equal(placed.first, 0);
    fill = skv_default_fill_def();
    fill.x1 = fill.y1 = 0.3f;
    fill.limit = 17;
    assert_int_equal(skv_fill_count(terrain, 0.01f, &fill), 17);
    assert_int_equal(skv_world_fill(world, &fill, &placed, NULL), SKV_OK);
    assert_int_equal(placed.added, 17);
    assert_int_equal(placed.first, expected);
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < expected; i++)
        assert_true(hypotf(p.x[i] - 0.8f, p.y[i] - 0.45f) < 0.2005f && p.vx[i] == 0.5f);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

/* What flows out of an open side is gone; who stays keeps number and order. */
static void an_open_side_drains(void **unused)
{
    (void)unused;
    skv_terrain_def tank = skv_default_terrain_def();
    tank.open_sides = SKV_SIDE_RIGHT;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.03f;
    assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 1.6f, 0.4f);
    int before = skv_world_particle_count(world);
    fixture_run(world, 180);
    skv_particles p = skv_world_particles(world);
    assert_true(p.count < before / 2);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    for (int i = 1; i < p.count; i++)
        assert_true(p.id[i] > p.id[i - 1]);
    skv_world_destroy(world);
}

/* Memory that runs out at any point of creation or growth: an error, no leak, a usable world. */
static int live, until_failure;

static void *failing_allocate(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    if (until_failure-- <= 0)
        return NULL;
    live++;
    return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void failing_release(void *memory, void *user)
{
    (void)user;
    live--;
    free(memory);
}

static void running_out_of_memory_is_clean(void **unused)
{
    (void)unused;
    const skv_allocator hooks = {failing_allocate, failing_release, NULL};
    skv_set_allocator(&hooks);
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.05f;
    def.threads = 1;
    bool complete = false;
    for (int allowed = 0; !complete && allowed < 1000; allowed++) {
        until_failure = allowed;
        skv_world *world = NULL;
        skv_result result = skv_world_create(&def, &world, NULL);
        if (result == SKV_OK) {
            skv_fill_def fill = skv_default_fill_def();
            fill.y1 = 0.4f;
            result = skv_world_fill(world, &fill, NULL, NULL);
            if (result != SKV_OK)
                assert_int_equal(skv_world_particle_count(world), 0);
            if (result == SKV_OK)
                result = skv_world_step(world, 1.0f / 60, NULL);
            complete = result == SKV_OK;
        }
        if (!complete)
            assert_int_equal(result, SKV_ERROR_MEMORY);
        skv_world_destroy(world);
        assert_int_equal(live, 0);
    }
    assert_true(complete);
    skv_set_allocator(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_definitions_are_refused),
        cmocka_unit_test(a_refused_world_leaves_the_terrain),
        cmocka_unit_test(hostile_numbers_change_nothing),
        cmocka_unit_test(a_step_takes_the_times_it_names),
        cmocka_unit_test(allowed_violence_is_survived),
        cmocka_unit_test(misuse_reaches_the_handler),
        cmocka_unit_test(facts_are_right),
        cmocka_unit_test(filling_respects_shape_limit_and_count),
        cmocka_unit_test(an_open_side_drains),
        cmocka_unit_test(running_out_of_memory_is_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
