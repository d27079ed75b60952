/* Queries: circle, box, polygon and ray, on particles at known places; the frame. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* Particles at (0.1 i, 0.1 j), i = 1..15, j = 1..8, row by row. */
static skv_world *grid_of_particles(void)
{
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    for (int j = 1; j <= 8; j++)
        for (int i = 1; i <= 15; i++)
            assert_int_equal(
                skv_world_add_particle(world, 0.1f * (float)i, 0.1f * (float)j, 0, 0, NULL),
                SKV_OK);
    return world;
}

static int count(const skv_world *world, skv_area area)
{
    int found[200];
    int all = skv_world_query(world, &area, found, 200);
    for (int i = 1; i < all; i++)
        assert_true(found[i] > found[i - 1]);
    assert_int_equal(skv_world_query(world, &area, NULL, 0), all);
    return all;
}

static void areas_hold_what_lies_in_them(void **unused)
{
    (void)unused;
    skv_world *world = grid_of_particles();
    assert_int_equal(count(world, skv_circle(0.5f, 0.5f, 0.11f)), 5);
    assert_int_equal(count(world, skv_circle(0.5f, 0.5f, 0.15f)), 9);
    assert_int_equal(count(world, skv_box(0.15f, 0.15f, 0.45f, 0.35f)), 6);
    assert_int_equal(count(world, skv_box(0.45f, 0.35f, 0.15f, 0.15f)), 6);
    /* An L: four by two below, two by two above its left end. */
    const float corner[] = {0.15f, 0.15f, 0.55f, 0.15f, 0.55f, 0.35f,
                            0.35f, 0.35f, 0.35f, 0.55f, 0.15f, 0.55f};
    assert_int_equal(count(world, skv_polygon(corner, 6)), 12);
    const float triangle[] = {0.05f, 0.05f, 0.53f, 0.05f, 0.05f, 0.53f};
    assert_int_equal(count(world, skv_polygon(triangle, 3)), 10);
    int first[2] = {-1, -1};
    skv_area box = skv_box(0.15f, 0.15f, 0.45f, 0.35f);
    assert_int_equal(skv_world_query(world, &box, first, 2), 6);
    assert_int_equal(first[0], 16);
    assert_int_equal(first[1], 17);
    skv_world_destroy(world);
}

static void nonsense_contains_nothing(void **unused)
{
    (void)unused;
    skv_world *world = grid_of_particles();
    const float bad[] = {0.1f, 0.1f, 0.9f, NAN, 0.1f, 0.9f};
    assert_int_equal(count(world, skv_circle(0.5f, 0.5f, -1)), 0);
    assert_int_equal(count(world, skv_circle(0.5f, 0.5f, NAN)), 0);
    assert_int_equal(count(world, skv_circle(0.5f, 0.5f, INFINITY)), 0);
    assert_int_equal(count(world, skv_box(0, NAN, 1, 1)), 0);
    assert_int_equal(count(world, skv_polygon(bad, 3)), 0);
    assert_int_equal(count(world, skv_polygon(bad, 2)), 0);
    assert_int_equal(count(world, skv_polygon(NULL, 5)), 0);
    const float all[2 * SKV_MAX_CORNERS + 2] = {0, 0, 0, 2, 2, 2, 2, 0};
    assert_int_not_equal(count(world, skv_polygon(all, SKV_MAX_CORNERS)), 0);
    assert_int_equal(count(world, skv_polygon(all, SKV_MAX_CORNERS + 1)), 0);
    skv_area many = skv_polygon(all, 4);
    many.count = SKV_MAX_CORNERS + 1;
    assert_int_equal(count(world, many), 0);
    assert_int_equal(count(world, (skv_area){.kind = (skv_area_kind)7, .radius = 1}), 0);
    skv_world_destroy(world);
}

static void a_ray_meets_wall_and_fluid(void **unused)
{
    (void)unused;
    skv_world *world = grid_of_particles();
    double radius = 0.02 / sqrt(acos(-1));
    /* Along a row of particles, and on to the right wall. */
    skv_ray ray = skv_world_ray(world, 0.05f, 0.4f, 2.05f, 0.4f);
    assert_true(ray.wall.found && ray.fluid.found);
    assert_near((double)ray.wall.x, 1.6, 1e-4);
    assert_near((double)ray.wall.share, 1.55 / 2, 1e-4);
    assert_near((double)ray.wall.nx, -1, 1e-4);
    assert_int_equal(ray.wall.particle, -1);
    assert_int_equal(ray.fluid.particle, 3 * 15);
    assert_near((double)ray.fluid.x, 0.1 - radius, 1e-6);
    assert_near((double)ray.fluid.nx, -1, 1e-3);
    /* Between two rows: no fluid. Upwards, not far enough for the wall. */
    ray = skv_world_ray(world, 0.05f, 0.45f, 2.05f, 0.45f);
    assert_true(ray.wall.found && !ray.fluid.found);
    ray = skv_world_ray(world, 0.75f, 0.05f, 0.75f, 0.85f);
    assert_true(!ray.wall.found && !ray.fluid.found);
    assert_true(ray.wall.share == 1 && ray.wall.y == 0.85f && ray.fluid.y == 0.85f);
    /* Away from a particle; from inside one; from inside solid; behind a wall. */
    assert_false(skv_world_ray(world, 0.05f, 0.4f, 0.0f, 0.4f).fluid.found);
    ray = skv_world_ray(world, 0.1f, 0.405f, 0.1f, 0.45f);
    assert_true(ray.fluid.found && ray.fluid.share == 0 && ray.fluid.ny == 1);
    ray = skv_world_ray(world, -0.1f, 0.4f, 1, 0.4f);
    assert_true(ray.wall.found && ray.wall.share == 0 && !ray.fluid.found);
    /* No way at all, and what is no ray. */
    assert_false(skv_world_ray(world, 0.15f, 0.15f, 0.15f, 0.15f).wall.found);
    assert_false(skv_world_ray(world, NAN, 0, 1, 1).wall.found);
    assert_false(skv_world_ray(world, 0.5f, 0.5f, INFINITY, 1).fluid.found);
    skv_world_destroy(world);
}

static void a_frame_shows_the_world_as_it_is(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    fixture_fill(world, 0, 0, 1.6f, 0.2f);
    assert_int_equal(skv_world_set_gravity(world, 1, -3, NULL), SKV_OK);
    assert_int_equal(skv_world_step(world, 0.1f, NULL), SKV_OK);
    skv_frame frame = skv_world_frame(world);
    skv_particles p = skv_world_particles(world);
    assert_true(frame.time == skv_world_time(world) && frame.time > 0);
    assert_int_equal(frame.particles.count, p.count);
    assert_true(frame.particles.x == p.x && frame.particles.pressure == p.pressure);
    assert_int_equal(frame.awake, p.count);
    assert_ptr_equal(frame.terrain, skv_world_terrain(world));
    assert_true(frame.spacing == 0.02f && frame.density == skv_world_fluid(world)->density);
    assert_true(frame.smoothing_radius == skv_world_smoothing_radius(world));
    assert_true(frame.gravity_x == 1 && frame.gravity_y == -3);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_hold_what_lies_in_them),
        cmocka_unit_test(nonsense_contains_nothing),
        cmocka_unit_test(a_ray_meets_wall_and_fluid),
        cmocka_unit_test(a_frame_shows_the_world_as_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
