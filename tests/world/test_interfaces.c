/* How fluids push each other apart: by both solvers alike, with all momentum kept; that a drop of
 * oil stays in one piece on its way up through water, and fluids that were stirred part in a short
 * line; the same bits on any threads and instruction sets; and snapshots. */
#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#define WIDTH 0.6f

/* A tank with a second fluid of some density that pushes, and a third one as heavy as the first. */
static skv_world *make(skv_law law, skv_solver_kind solver, float spacing, float density,
                       float push, int threads, skv_instruction_set set)
{
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = (int)(WIDTH / terrain.pixel_size + 0.5f);
    terrain.height = 240;
    skv_world_def def = fixture_def(law, solver, 0, spacing, threads);
    fixture_add_liquids(&def, 2);
    def.instruction_set = set;
    def.liquids[0].density = density;
    def.liquids[0].interface_push = push;
    def.liquids[1].interface_push = push / 2;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

static skv_world *make_fast(float spacing, float density, float push)
{
    return make(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, spacing, density, push, 1, SKV_ISA_BEST);
}

/* Three fluids side by side, which break as dams do. */
static void fill_three(skv_world *world)
{
    fixture_fill_with(world, 0, 0, 0.15f, 0.2f, 0);
    fixture_fill_with(world, 0.15f, 0, 0.25f, 0.2f, 1);
    fixture_fill_with(world, 0.25f, 0, 0.35f, 0.2f, 2);
}

static void expect_same_substep(skv_law law, float density, int frames)
{
    skv_world *fast = make(law, SKV_SOLVER_FAST, 0.015f, density, 300, 1, SKV_ISA_BEST);
    skv_world *slow = make(law, SKV_SOLVER_REFERENCE, 0.015f, density, 300, 1, SKV_ISA_BEST);
    fill_three(fast);
    fixture_run(fast, frames);
    fixture_expect_same_substep(fast, slow);
}

static void rows_agree_with_the_reference(void **unused)
{
    (void)unused;
    for (int frames = 1; frames < 20; frames += 6) {
        expect_same_substep(SKV_LAW_CALIBRATED, 1000, frames);
        expect_same_substep(SKV_LAW_CALIBRATED, 700, frames);
        expect_same_substep(SKV_LAW_CLAVET, 1000, frames);
    }
}

/* A weightless drop of three fluids, beside no wall. */
static void momentum_stays(void **unused)
{
    (void)unused;
    static const skv_solver_kind solvers[] = {SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE};
    for (int k = 0; k < 2; k++) {
        skv_world *world = make(SKV_LAW_CALIBRATED, solvers[k], 0.015f, 500, 100, 1, SKV_ISA_BEST);
        assert_int_equal(skv_world_set(world, "gravity.y", "0", NULL), SKV_OK);
        fixture_fill_with(world, 0.2f, 0.2f, 0.4f, 0.4f, 0);
        fixture_mix_fluids(world);
        skv_particles p = skv_world_particles(world);
        int count = p.count;
        fixture_run(world, 20);
        p = skv_world_particles(world);
        double x = 0, y = 0, most = 0;
        for (int i = 0; i < count; i++) {
            double mass = p.fluid[i] == 1 ? 0.5 : 1;
            x += mass * (double)p.vx[i];
            y += mass * (double)p.vy[i];
            most += mass * hypot((double)p.vx[i], (double)p.vy[i]);
        }
        assert_true(most / count > 0.005); /* it moves */
        assert_true(hypot(x, y) < 1e-7 * most);
        skv_world_destroy(world);
    }
}

/* The greatest number of particles of fluid 1 that hang together, the next within 1.8 spacings. */
static int largest_piece(const skv_world *world)
{
    skv_particles p = skv_world_particles(world);
    double reach = 1.8 * (double)skv_world_spacing(world);
    int *open = malloc((size_t)p.count * sizeof *open), largest = 0;
    char *seen = calloc((size_t)p.count, 1);
    assert_true(open && seen);
    for (int first = 0; first < p.count; first++) {
        int size = 0, waiting = 0;
        if (p.fluid[first] == 1 && !seen[first])
            seen[open[waiting++] = first] = 1;
        while (waiting > 0) {
            int i = open[--waiting];
            size++;
            for (int j = 0; j < p.count; j++)
                if (p.fluid[j] == 1 && !seen[j] &&
                    hypot((double)(p.x[i] - p.x[j]), (double)(p.y[i] - p.y[j])) < reach)
                    seen[open[waiting++] = j] = 1;
        }
        largest = size > largest ? size : largest;
    }
    free(open);
    free(seen);
    return largest;
}

/* A drop of 60 particles of oil below water, until it has come to the surface: how many are not in
 * its largest piece. */
static int lost_on_the_way(float push)
{
    const float s = 0.0134f, radius = sqrtf(60 * s * s / 3.14159265f), depth = 0.4f;
    skv_world *world = make_fast(s, 900, push);
    fixture_fill_with(world, 0, 0, WIDTH, depth, 0);
    skv_particles p = skv_world_particles(world);
    const uint8_t oil = 1;
    for (int i = 0; i < p.count; i++)
        if (hypotf(p.x[i] - WIDTH / 2, p.y[i] - 0.1f) < radius)
            assert_int_equal(skv_world_set_fluids(world, i, 1, &oil, NULL), SKV_OK);
    int size = skv_world_fluid_stats(world, 1).particles, frames = 0;
    assert_in_range(size, 55, 66);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    while (skv_world_fluid_stats(world, 1).centre_y < (double)(depth - radius - 2 * s)) {
        assert_true(frames < 600);
        fixture_run(world, 10);
        frames += 10;
    }
    int lost = size - largest_piece(world);
    skv_world_destroy(world);
    return lost;
}

static void drops_stay_in_one_piece(void **unused)
{
    (void)unused;
    assert_int_equal(lost_on_the_way(50), 0);
    assert_true(lost_on_the_way(0) > 10);
}

/* Pairs of two fluids within 1.3 spacings, after oil and water that stood side by side have come
 * to lie on each other. */
static int length_of_the_line(float push)
{
    skv_world *world = make_fast(0.0134f, 900, push);
    fixture_fill_with(world, 0, 0, WIDTH / 2, 0.25f, 0);
    fixture_fill_with(world, WIDTH / 2, 0, WIDTH, 0.25f, 1);
    fixture_run(world, 600);
    skv_particles p = skv_world_particles(world);
    double reach = 1.3 * (double)skv_world_spacing(world);
    int pairs = 0;
    for (int i = 0; i < p.count; i++)
        for (int j = 0; j < i; j++)
            pairs += p.fluid[i] != p.fluid[j] &&
                     hypot((double)(p.x[i] - p.x[j]), (double)(p.y[i] - p.y[j])) < reach;
    skv_world_destroy(world);
    return pairs;
}

static void the_line_between_fluids_is_short(void **unused)
{
    (void)unused;
    int with = length_of_the_line(20), without = length_of_the_line(0);
    assert_true(with < 0.7 * without);
}

static skv_world *run_three(int threads, skv_instruction_set set)
{
    skv_world *world = make(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0.008f, 700, 100, threads, set);
    fill_three(world);
    fixture_run(world, 20);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_three);
}

static void snapshots_keep_the_push(void **unused)
{
    (void)unused;
    skv_world *world = make_fast(0.015f, 1000, 60), *copy;
    fill_three(world);
    fixture_run(world, 10);
    fixture_saved b = fixture_save(world, true);
    assert_int_equal(skv_world_load(b.bytes, b.size, fixture_host(1), &copy, NULL), SKV_OK);
    assert_true(skv_world_liquid(copy, 1)->interface_push == 60);
    assert_true(skv_world_liquid(copy, 2)->interface_push == 30);
    assert_true(skv_world_liquid(copy, 0)->interface_push == 0);
    skv_world_destroy(copy);
    free(b.bytes);
    fixture_expect_goes_on(world, 10);
    skv_world_destroy(world);
}

static void wrong_pushes_are_refused(void **unused)
{
    (void)unused;
    static const float wrong[] = {-1, 400.5f, INFINITY, NAN};
    for (int i = 0; i < 4; i++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.03f, 1);
        skv_world *world;
        skv_error error = {0};
        fixture_add_liquids(&def, 1);
        def.liquids[0].interface_push = wrong[i];
        assert_int_equal(skv_world_create(&def, &world, &error), SKV_ERROR_VALUE);
        assert_string_equal(error.text,
                            "fluids[0].interface_push: is out of range; allowed is 0..400 m/s^2");
        skv_terrain_destroy(def.terrain);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_agree_with_the_reference),
        cmocka_unit_test(momentum_stays),
        cmocka_unit_test(drops_stay_in_one_piece),
        cmocka_unit_test(the_line_between_fluids_is_short),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(snapshots_keep_the_push),
        cmocka_unit_test(wrong_pushes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
