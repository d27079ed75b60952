/* What walls give the fluid, checked against what the fluid gets: the change of its momentum is
 * what gravity, hands and walls give it, in both solvers and with both laws. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static double mass_of(const skv_world *world)
{
    double s = (double)skv_world_spacing(world);
    return (double)skv_world_fluid(world)->density * s * s;
}

static void momentum_of(const skv_world *world, double *x, double *y)
{
    skv_particles p = skv_world_particles(world);
    double mass = mass_of(world);
    *x = *y = 0;
    for (int i = 0; i < p.count; i++) {
        *x += mass * (double)p.vx[i];
        *y += mass * (double)p.vy[i];
    }
}

/* What a hand that only pulls gives in one substep. */
static void pull_of(const skv_world *world, const skv_hand *hand, double dt, double *x, double *y)
{
    skv_particles p = skv_world_particles(world);
    double radius = (double)hand->radius;
    *x = *y = 0;
    for (int i = 0; i < p.count; i++) {
        double rx = ((double)hand->x - (double)p.x[i]) / radius;
        double ry = ((double)hand->y - (double)p.y[i]) / radius;
        double share = 1 - (rx * rx + ry * ry);
        double pulled = dt * (double)hand->attraction * share * share * 32 / 9;
        *x += share > 0 ? mass_of(world) * pulled * rx : 0;
        *y += share > 0 ? mass_of(world) * pulled * ry : 0;
    }
}

/* A dam that breaks against a slanted shelf, pulled at by a hand; substep by substep. */
static void check_balance(skv_law law, skv_solver_kind solver)
{
    skv_world_def def = fixture_def(law, solver, 0, 0.02f, 2);
    skv_world *world = fixture_dam_of(&def);
    skv_hand hand = skv_default_hand();
    hand.x = 0.3f;
    hand.y = 0.2f;
    hand.friction = hand.follow = 0;
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    assert_int_equal(skv_world_set_gravity(world, 2, -9.81f, NULL), SKV_OK);
    double all = mass_of(world) * skv_world_particle_count(world), given = 0, worst = 0;
    for (int step = 0; step < 300; step++) {
        double dt = 1.0 / 60 / skv_world_substeps_per_frame(world);
        double x0, y0, x1, y1, pull_x, pull_y;
        momentum_of(world, &x0, &y0);
        pull_of(world, &hand, dt, &pull_x, &pull_y);
        int64_t substeps = skv_world_substep_count(world);
        assert_int_equal(skv_world_step(world, (float)dt, NULL), SKV_OK);
        momentum_of(world, &x1, &y1);
        if (skv_world_substep_count(world) != substeps + 1)
            continue;
        skv_wall_impulse walls = skv_world_wall_impulse(world);
        worst = fmax(worst, fabs(x1 - x0 - 2 * all * dt - pull_x - walls.x));
        worst = fmax(worst, fabs(y1 - y0 + 9.81 * all * dt - pull_y - walls.y));
        given += hypot(walls.x, walls.y);
    }
    /* What rounding makes of velocities of some m/s, up or down. */
    assert_true(worst < 1e-7 * all);
    assert_true(given > 0.1 * all);
    skv_world_destroy(world);
}

static void momentum_is_balanced(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        check_balance((skv_law)law, SKV_SOLVER_FAST);
        check_balance((skv_law)law, SKV_SOLVER_REFERENCE);
    }
}

/* Water at rest: walls carry its weight, under its centre. */
static void walls_carry_the_weight(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world *world = fixture_tank_with(SKV_LAW_CALIBRATED, (skv_solver_kind)solver, 0.03f);
        int count = fixture_fill(world, 0, 0, 1.6f, 0.3f), frames = 60;
        fixture_run(world, 120);
        skv_wall_impulse sum = {0};
        for (int f = 0; f < frames; f++) {
            fixture_run(world, 1);
            skv_wall_impulse now = skv_world_wall_impulse(world);
            sum.x += now.x;
            sum.y += now.y;
            sum.moment += now.moment;
        }
        double weight = 9.81 * mass_of(world) * count * frames / 60;
        assert_near(sum.y, weight, 0.002 * weight);
        assert_near(sum.x, 0, 0.002 * weight);
        assert_near(sum.moment, 0.8 * weight, 0.002 * weight);
        skv_world_destroy(world);
    }
}

static void threads_give_the_same_impulse(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_wall_impulse first = {0};
        for (int threads = 1; threads <= 7; threads += 2) {
            skv_world_def def =
                fixture_def(SKV_LAW_CALIBRATED, (skv_solver_kind)solver, 1, 0.02f, threads);
            skv_world *world = fixture_dam_of(&def);
            fixture_run(world, 20);
            skv_wall_impulse walls = skv_world_wall_impulse(world);
            if (threads == 1)
                first = walls;
            assert_memory_equal(&walls, &first, sizeof walls);
            skv_world_destroy(world);
        }
        assert_true(first.x != 0 && first.y != 0 && first.moment != 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(momentum_is_balanced),
        cmocka_unit_test(walls_carry_the_weight),
        cmocka_unit_test(threads_give_the_same_impulse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
