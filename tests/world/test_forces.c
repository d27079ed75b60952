/* Force fields: what each kind does to the fluid in its area and to no other, with both solvers;
 * the substeps that they ask for; sleep, snapshots and threads. */
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

static skv_area everywhere(void)
{
    return skv_box(-100, -100, 100, 100);
}

static void set(skv_world *world, skv_force force)
{
    skv_error error;
    if (skv_world_set_forces(world, &force, 1, &error) != SKV_OK)
        fail_msg("%s", error.text);
}

/* A weightless tank with two blocks of fluid, one left and one right of x = 0.8. */
static skv_world *two_blocks(skv_solver_kind solver, int threads)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, 0.02f, threads);
    def.gravity_y = 0;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0.3f, 0.35f, 0.5f, 0.55f);
    fixture_fill(world, 1.1f, 0.35f, 1.3f, 0.55f);
    return world;
}

typedef struct mean {
    double x, y, vx, vy;
} mean;

/* Over the particles on one side of x = 0.8. */
static mean mean_of(const skv_world *world, bool right)
{
    skv_particles p = skv_world_particles(world);
    mean m = {0};
    int count = 0;
    for (int i = 0; i < p.count; i++) {
        if ((p.x[i] > 0.8f) != right)
            continue;
        count++;
        m.x += (double)p.x[i];
        m.y += (double)p.y[i];
        m.vx += (double)p.vx[i];
        m.vy += (double)p.vy[i];
    }
    assert_true(count > 50);
    return (mean){m.x / count, m.y / count, m.vx / count, m.vy / count};
}

static const skv_solver_kind solvers[] = {SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE};

static void an_acceleration_acts_in_its_area_alone(void **unused)
{
    (void)unused;
    const float triangle[] = {1.6f, 0.45f, 0.7f, 2, 0.7f, -2};
    const skv_area areas[] = {skv_box(0.8f, 0, 1.6f, 0.9f), skv_circle(1.2f, 0.45f, 0.4f),
                              skv_polygon(triangle, 3)};
    for (int k = 0; k < 2; k++) {
        for (int a = 0; a < 3; a++) {
            skv_world *world = two_blocks(solvers[k], 1);
            set(world, (skv_force){.area = areas[a], .ax = 0.3f, .ay = -0.7f});
            fixture_run(world, 30);
            mean right = mean_of(world, true), left = mean_of(world, false);
            assert_near(right.vx, 0.15, 1e-4);
            assert_near(right.vy, -0.35, 1e-4);
            assert_near(left.vx, 0, 1e-5);
            assert_near(left.vy, 0, 1e-5);
            skv_world_destroy(world);
        }
    }
}

static void attraction_is_as_strong_wherever_the_point_is(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        skv_world *world = two_blocks(solvers[k], 1);
        /* Far away, so that all directions are alike. */
        set(world, (skv_force){.area = skv_box(0.8f, 0, 1.6f, 0.9f),
                               .toward_x = 301.2f,
                               .toward_y = 400.45f,
                               .attraction = 0.5f});
        fixture_run(world, 30);
        mean right = mean_of(world, true), left = mean_of(world, false);
        assert_near(right.vx, 0.5 * 0.5 * 0.6, 2e-4);
        assert_near(right.vy, 0.5 * 0.5 * 0.8, 2e-4);
        assert_near(left.vx, 0, 1e-5);
        skv_world_destroy(world);

        /* A point in the midst gathers a disc around it, and the fluid there keeps still. */
        world = two_blocks(solvers[k], 1);
        set(world, (skv_force){.area = everywhere(),
                               .toward_x = 0.8f,
                               .toward_y = 0.45f,
                               .attraction = 9.81f,
                               .drag = 2});
        fixture_run(world, 300);
        skv_stats stats = skv_world_stats(world);
        double radius = sqrt(stats.particles * 0.02 * 0.02 / 3.14159);
        skv_area disc = skv_circle(0.8f, 0.45f, (float)(radius + 0.02));
        assert_int_equal(skv_world_query(world, &disc, NULL, 0), stats.particles);
        assert_near(stats.centre_x, 0.8, 0.003);
        assert_near(stats.centre_y, 0.45, 0.003);
        assert_true(stats.rms_speed < 0.03);
        skv_world_destroy(world);
    }
}

static void wind_is_caught_up_with(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        skv_world *world = two_blocks(solvers[k], 1);
        set(world,
            (skv_force){
                .area = skv_box(0.8f, 0, 1.6f, 0.9f), .wind_x = 0.2f, .wind_y = 0.1f, .drag = 3});
        fixture_run(world, 30);
        mean right = mean_of(world, true), left = mean_of(world, false);
        double share = 1 - exp(-3 * 0.5);
        assert_near(right.vx, 0.2 * share, 0.2 * 0.02);
        assert_near(right.vy, 0.1 * share, 0.1 * 0.02);
        assert_near(left.vx, 0, 1e-5);
        skv_world_destroy(world);
    }
}

/* Angular velocity of the fluid between two distances from a point. */
static double turning(const skv_world *world, double x, double y, double nearest, double farthest)
{
    skv_particles p = skv_world_particles(world);
    double moment = 0, inertia = 0;
    for (int i = 0; i < p.count; i++) {
        double rx = (double)p.x[i] - x, ry = (double)p.y[i] - y, r = hypot(rx, ry);
        if (r < nearest || r > farthest)
            continue;
        moment += rx * (double)p.vy[i] - ry * (double)p.vx[i];
        inertia += r * r;
    }
    assert_true(inertia > 0);
    return moment / inertia;
}

/* A weightless tank with a disc of fluid of radius 0.2 m in its middle. */
static skv_world *disc_in(float width, float height, skv_solver_kind solver)
{
    skv_terrain_def tank = skv_default_terrain_def();
    tank.pixel_size = 0.01f;
    tank.width = (int)lroundf(100 * width);
    tank.height = (int)lroundf(100 * height);
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, 0.02f, 1);
    def.gravity_y = 0;
    def.substeps = 5; /* the rule's: what turns gains on the wind by a share that goes with dt */
    assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_fill_def fill = skv_default_fill_def();
    skv_area disc = skv_circle(width / 2, height / 2, 0.2f);
    fill.area = &disc;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    assert_true(skv_world_particle_count(world) > 250);
    return world;
}

/* Fluid gains on a turning wind as on one that goes straight; and where it is held together it
 * turns at last like a solid: the circulation 2 pi r v grows with the square of the distance. In
 * wide tanks and in high ones, of which the fast solver swaps the axes. */
static void a_spin_turns_fluid_like_a_solid(void **unused)
{
    (void)unused;
    static const float sizes[][2] = {{1.2f, 0.8f}, {0.8f, 1.2f}};
    for (int k = 0; k < 3; k++) {
        float width = sizes[k / 2][0], height = sizes[k / 2][1];
        double x = (double)width / 2, y = (double)height / 2;
        skv_world *world = disc_in(width, height, solvers[k % 2]);
        skv_force force = {.area = skv_circle((float)x, (float)y, 0.4f), .drag = 3, .spin = 0.5f};
        set(world, force);
        fixture_run(world, 30);
        double share = 1 - exp(-3 * 0.5);
        assert_near(turning(world, x, y, 0, 1), 0.5 * share, 0.5 * 0.02);
        force.spin = -3;
        force.drag = 10;
        force.attraction = 9.81f;
        force.toward_x = (float)x;
        force.toward_y = (float)y;
        set(world, force);
        fixture_run(world, 90);
        assert_near(turning(world, x, y, 0, 0.1), -3, 0.1);
        assert_near(turning(world, x, y, 0.1, 0.15), -3, 0.1);
        assert_near(turning(world, x, y, 0.15, 1), -3, 0.1);
        skv_world_destroy(world);
    }
}

/* A force over everything and gravity are two names of the same. */
static void a_force_everywhere_is_gravity(void **unused)
{
    (void)unused;
    double height[2];
    for (int k = 0; k < 2; k++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 2, 0.02f, 1);
        skv_world *world;
        def.gravity_y = k ? 0 : -9.81f;
        assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
        fixture_fill(world, 0, 0, 0.4f, 0.6f);
        if (k)
            set(world, (skv_force){.area = everywhere(), .ay = -9.81f});
        fixture_run(world, 600);
        height[k] = skv_world_stats(world).centre_y;
        skv_world_destroy(world);
    }
    assert_near(height[1], height[0], 0.002);
}

static void strong_forces_get_their_substeps(void **unused)
{
    (void)unused;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.02f, 1);
    for (int fixed = 0; fixed < 2; fixed++) {
        def.substeps = fixed ? 5 : 0;
        skv_world *world;
        assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
        int before = skv_world_substeps_per_frame(world);
        set(world, (skv_force){.area = skv_circle(0.8f, 0.45f, 0.1f), .attraction = -1});
        assert_int_equal(skv_world_substeps_per_frame(world), before); /* a trifle */
        set(world, (skv_force){.area = everywhere(), .ax = 300});
        int strong = skv_world_substeps_per_frame(world);
        assert_int_equal(skv_world_set_forces(world, NULL, 0, NULL), SKV_OK);
        assert_int_equal(skv_world_substeps_per_frame(world), before);
        if (!fixed) {
            /* As gravity of that strength would, over the diagonal of the world. */
            assert_int_equal(skv_world_set_gravity(world, 300, 0, NULL), SKV_OK);
            int gravity = skv_world_substeps_per_frame(world);
            assert_in_range(strong, gravity, gravity * 5 / 4);
        } else {
            assert_int_equal(strong, before);
        }
        skv_world_destroy(world);
    }
    /* And hold the fluid together. */
    def.substeps = 0;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 0.6f, 0.6f);
    set(world, (skv_force){.area = skv_box(0, 0, 1.6f, 0.3f), .ax = 100, .ay = -100});
    fixture_run(world, 60);
    skv_stats stats = skv_world_stats(world);
    assert_int_equal(stats.escaped + stats.not_finite, 0);
    assert_true(fixture_packing(world).volume_ratio > 0.9);
    skv_world_destroy(world);
}

static void a_force_wakes_the_fluid_which_then_may_rest_in_it(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    double x = skv_world_stats(world).centre_x;
    set(world, (skv_force){.area = everywhere(), .ax = 1});
    fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), skv_world_particle_count(world));
    for (int f = 0; f < 3600 && skv_world_awake_count(world) > 0; f++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    /* It leans as the sum of both wants: slope 1/9.81, so the centre moves by L^2 slope / 12 H. */
    assert_near(skv_world_stats(world).centre_x - x, 1.6 * 1.6 / (12 * 9.81 * 0.3), 0.01);
    skv_world_destroy(world);
}

/* Where a force never lets fluid rest, it does not fall asleep. */
static void what_a_force_keeps_moving_stays_awake(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    set(world, (skv_force){.area = skv_circle(0.5f, 0.15f, 0.1f), .wind_x = 0.5f, .drag = 10});
    fixture_run(world, 600);
    skv_particles p = skv_world_particles(world);
    skv_area area = skv_circle(0.5f, 0.15f, 0.05f);
    int inside[200], count = skv_world_query(world, &area, inside, 200);
    double speed = 0;
    for (int i = 0; i < count; i++)
        speed += (double)p.vx[inside[i]] / count;
    assert_true(count > 10);
    if (!(speed > 0.05))
        fail_msg("%g", speed);
    skv_world_destroy(world);
}

static void the_future_is_the_same_for_threads_and_snapshots(void **unused)
{
    (void)unused;
    const float square[] = {1, 0, 1.6f, 0, 1.6f, 0.9f, 1, 0.9f};
    const skv_force forces[] = {
        {.area = skv_circle(0.4f, 0.2f, 0.2f), .wind_x = 2, .wind_y = 1, .drag = 10},
        {.area = skv_polygon(square, 4), .toward_x = 1.2f, .toward_y = 0.6f, .attraction = 30},
        {.area = skv_box(0, 0, 0.3f, 0.9f), .ay = 20, .drag = 2, .spin = 4}};
    for (int k = 0; k < 2; k++) {
        uint64_t hash[2];
        int frames = solvers[k] == SKV_SOLVER_REFERENCE && !long_tests() ? 5 : 20;
        for (int t = 0; t < 2; t++) {
            skv_world *world = two_blocks(solvers[k], t ? 3 : 1), *other;
            fixture_fill(world, 0, 0, 1.6f, 0.2f);
            assert_int_equal(skv_world_set_forces(world, forces, 3, NULL), SKV_OK);
            fixture_run(world, frames);
            assert_int_equal(skv_world_copy(world, fixture_host(2), &other, NULL), SKV_OK);
            int count;
            const skv_force *copied = skv_world_forces(other, &count);
            assert_int_equal(count, 3);
            assert_true(copied[1].area.corners[4] == 1.6f && copied[1].attraction == 30);
            assert_true(copied[2].spin == 4);
            fixture_run(world, frames);
            fixture_run(other, frames);
            hash[t] = skv_world_hash(world);
            assert_int_equal(skv_world_hash(other), hash[t]);
            skv_world_destroy(world);
            skv_world_destroy(other);
        }
        assert_int_equal(hash[0], hash[1]);
    }
}

static void nonsense_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = two_blocks(SKV_SOLVER_FAST, 1);
    skv_force good = {.area = everywhere(), .ax = 1};
    set(world, good);
    skv_force bad[9];
    for (int i = 0; i < 9; i++)
        bad[i] = good;
    bad[0].ax = NAN;
    bad[1].ay = 1001;
    bad[2].drag = -1;
    bad[3].wind_x = -101;
    bad[4].attraction = INFINITY;
    bad[5].area = skv_circle(0, 0, -1);
    bad[6].area = skv_polygon(NULL, 3);
    bad[7].spin = -100.5f;
    bad[8].spin = 1;
    bad[8].area = skv_circle(3e38f, 0, 3.4e38f);
    static const char no_area[] =
        "force 0: its area is none: not finite, or a polygon of less than 3 corners";
    static const char *const said[9] = {
        "force 0: ax nan is out of range; allowed is -1000..1000 m/s^2",
        "force 0: ay 1001 is out of range; allowed is -1000..1000 m/s^2",
        "force 0: drag -1 is out of range; allowed is 0..1000 1/s",
        "force 0: wind_x -101 is out of range; allowed is -100..100 m/s",
        "force 0: attraction inf is out of range; allowed is -1000..1000 m/s^2",
        no_area,
        no_area,
        "force 0: spin -100.5 is out of range; allowed is -100..100 rad/s",
        "force 0: its area is too large for a spin; at most 1000 m are allowed",
    };
    for (int i = 0; i < 9; i++) {
        skv_error error = {0};
        assert_int_equal(skv_world_set_forces(world, &bad[i], 1, &error), SKV_ERROR_VALUE);
        assert_string_equal(error.text, said[i]);
    }
    skv_force many[SKV_MAX_FORCES + 1] = {good};
    assert_int_equal(skv_world_set_forces(world, many, SKV_MAX_FORCES + 1, NULL), SKV_ERROR_LIMIT);
    assert_int_equal(skv_world_set_forces(world, many, SKV_MAX_FORCES, NULL), SKV_OK);
    set(world, good);
    int count;
    assert_true(skv_world_forces(world, &count)->ax == 1 && count == 1);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_acceleration_acts_in_its_area_alone),
        cmocka_unit_test(attraction_is_as_strong_wherever_the_point_is),
        cmocka_unit_test(wind_is_caught_up_with),
        cmocka_unit_test(a_spin_turns_fluid_like_a_solid),
        cmocka_unit_test(a_force_everywhere_is_gravity),
        cmocka_unit_test(strong_forces_get_their_substeps),
        cmocka_unit_test(a_force_wakes_the_fluid_which_then_may_rest_in_it),
        cmocka_unit_test(what_a_force_keeps_moving_stays_awake),
        cmocka_unit_test(the_future_is_the_same_for_threads_and_snapshots),
        cmocka_unit_test(nonsense_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
