/* Springs: how far a block of jelly sags, that it keeps momentum and its springs, that clay stays
 * dented, that what may be asked for stays bounded, and what becomes of springs whose ends go.
 */
#include "measure/wall_force.h"
#include "world/jelly.h"
#include "world/springs/springs.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_PAIRS = 2500 }; /* of a block, that a test lists */

static double centre(const skv_world *world)
{
    return skv_world_fluid_stats(world, 1).centre_y;
}

/* Without weight it takes the shape that its surface wants; then it gets its weight. A column that
 * can spread has the plane modulus 4 G: it shortens by rho g (H - y)/4G, and its centre sinks by
 * rho g H^2/12G. */
static void a_block_sags_as_far_as_theory_says(void **unused)
{
    (void)unused;
    static const float spacings[] = {JELLY_SPACING, 0.0075f};
    for (int i = 0; i < 2; i++) {
        skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, spacings[i]);
        def.gravity_y = 0;
        skv_world *world = jelly_block(&def, 0);
        fixture_run(world, 150);
        double before = centre(world), height = 2 * before;
        assert_int_equal(skv_world_set_gravity(world, 0, -9.81f, NULL), SKV_OK);
        fixture_run(world, 420);
        double expected = 1000 * 9.81 * height * height / (12 * (double)jelly_numbers[0]);
        assert_near((before - centre(world)) / expected, 1, 0.1);
        assert_true(skv_world_stats(world).rms_speed < 0.005);
        skv_world_destroy(world);
    }
}

/* What springs give, computed anew in double precision. */
static void push_anew(const skv_world *world, double dt, double *dvx, double *dvy)
{
    const skv_springs *s = world->springs;
    const skv_state *p = &world->state;
    double h = (double)world->h, eta = (double)world->fluid.radius_ratio;
    double k = 320 / 3.14159265358979 * (double)jelly_numbers[0] / (1000 * eta * eta * h * h);
    for (int a = 0; a < s->particles; a++) {
        for (int n = s->first[a]; n < s->first[a + 1]; n++) {
            int b = s->to[n];
            double x = (double)p->x[b] - (double)p->x[a] + dt * (double)(p->vx[b] - p->vx[a]);
            double y = (double)p->y[b] - (double)p->y[a] + dt * (double)(p->vy[b] - p->vy[a]);
            double r = hypot(x, y), rest = (double)s->length[n];
            double push = dt * k / 2 * (1 - rest / h) * (rest - r);
            dvx[a] -= push * x / r;
            dvy[a] -= push * y / r;
            dvx[b] += push * x / r;
            dvy[b] += push * y / r;
        }
    }
}

static void springs_push_as_the_model_says(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    skv_world *world = jelly_block(&def, 0);
    fixture_run(world, 20);
    int count = skv_world_particle_count(world), springs = 0;
    for (int i = 0; i < world->springs->particles; i++)
        springs += world->springs->first[i + 1] - world->springs->first[i];
    assert_int_equal(springs, skv_world_spring_count(world));
    assert_in_range(springs, 11 * count, 14 * count);
    double *dv = calloc(2 * (size_t)count, sizeof *dv), most = 0;
    skv_spring_pushes pushes = {0};
    const skv_pushed *pushed;
    float dt = 1.0f / 360;
    push_anew(world, (double)dt, dv, dv + count);
    assert_int_equal(skv_springs_ask(&pushes, world, dt, &pushed, NULL), SKV_OK);
    for (int i = 0; i < count; i++)
        most = fmax(most, hypot(dv[i], dv[count + i]));
    assert_true(most > 0.01);
    for (int i = 0; i < count; i++) {
        assert_near((double)pushed->dvx[i], dv[i], 1e-4 * most);
        assert_near((double)pushed->dvy[i], dv[count + i], 1e-4 * most);
    }
    free(pushes.block);
    free(dv);
    skv_world_destroy(world);
}

static void momentum_stays(void **unused)
{
    (void)unused;
    static const float *const kinds[] = {jelly_numbers, clay_numbers, goo_numbers};
    for (int k = 0; k < 3; k++) {
        skv_world_def def = jelly_def(kinds[k], SKV_SOLVER_FAST, JELLY_SPACING);
        def.gravity_y = 0;
        skv_world *world = jelly_block(&def, 0.35f);
        int count = skv_world_particle_count(world);
        assert_int_equal(skv_world_add_velocity(world, 0, count / 2, 0.5f, 0.2f, NULL), SKV_OK);
        skv_stats before = skv_world_stats(world);
        fixture_run(world, 60);
        skv_stats after = skv_world_stats(world);
        double whole = hypot(before.momentum_x, before.momentum_y);
        assert_true(hypot(after.momentum_x - before.momentum_x,
                          after.momentum_y - before.momentum_y) < 1e-6 * whole);
        skv_world_destroy(world);
    }
}

static skv_world *run_medley(int threads, skv_instruction_set set)
{
    skv_world *world = jelly_medley(SKV_SOLVER_FAST, threads, set);
    fixture_run(world, 60);
    assert_true(skv_world_spring_count(world) > 1000);
    return world;
}

static void bits_are_the_same_everywhere(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_medley);
}

/* Both go on from what single precision has kept of the same substeps. */
static void solvers_agree(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    skv_world *fast = jelly_block(&def, 0.3f);
    def.solver = SKV_SOLVER_REFERENCE;
    skv_world *slow = jelly_block(&def, 0.3f);
    fixture_run(fast, 3);
    fixture_run(slow, 3);
    assert_int_equal(skv_world_spring_count(fast), skv_world_spring_count(slow));
    skv_particles a = skv_world_particles(fast), b = skv_world_particles(slow);
    for (int i = 0; i < a.count; i++) {
        assert_near((double)a.x[i], (double)b.x[i], 1e-6);
        assert_near((double)a.y[i], (double)b.y[i], 1e-6);
    }
    skv_world_destroy(fast);
    skv_world_destroy(slow);
}

static double fastest_of_drop(const float *numbers, skv_law law, double *rms)
{
    skv_world_def def = jelly_def(numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    if (law == SKV_LAW_CLAVET) {
        def.fluid = skv_default_fluid_def(law);
        def.fluid.spacing = JELLY_SPACING;
    }
    skv_world *world = jelly_block(&def, 0.3f);
    double most = 0;
    for (int f = 0; f < 150; f++) {
        fixture_run(world, 1);
        most = fmax(most, skv_world_stats(world).max_speed);
    }
    *rms = skv_world_stats(world).rms_speed;
    assert_int_equal(skv_world_stats(world).not_finite, 0);
    skv_world_destroy(world);
    return most;
}

/* A block that falls by 0.3 m, to 2.4 m/s, is at no time faster than water that does, whatever its
 * springs, and has calmed down two seconds later. */
static void all_that_is_allowed_stays_bounded(void **unused)
{
    (void)unused;
    static const float moduli[] = {1, 300, 20000}, ends[] = {0, 1}, flows[] = {0, 2, 100};
    for (int law = 0; law < 2; law++) {
        const float none[] = {0, 0, 0};
        skv_law kind = law ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED;
        double rms, water = fastest_of_drop(none, kind, &rms);
        for (int i = 0; i < 3 * 2 * 3; i++) {
            const float numbers[] = {moduli[i / 6], ends[i / 3 % 2], flows[i % 3]};
            assert_true(fastest_of_drop(numbers, kind, &rms) < 1.2 * water);
            assert_true(rms < 0.5);
        }
    }
}

/* So does a fluid of a hundredth or twenty times the density of water beside it, and one that is
 * stepped too seldom for its springs. */
static void springs_are_as_stiff_as_substeps_allow(void **unused)
{
    (void)unused;
    static const float densities[] = {10, 20000};
    for (int i = 0; i < 4; i++) {
        const float stiff[] = {20000, 0.1f, 0};
        skv_world_def def = jelly_def(stiff, SKV_SOLVER_FAST, JELLY_SPACING);
        def.liquids[0].density = densities[i % 2];
        def.substeps = i < 2 ? 0 : 6;
        skv_world *world = jelly_block(&def, 0);
        assert_true(i >= 2 || skv_world_substeps_per_frame(world) > (i ? 5 : 50));
        fixture_run(world, 60);
        skv_stats stats = skv_world_stats(world);
        assert_int_equal(stats.not_finite, 0);
        assert_true(stats.rms_speed < 0.5);
        skv_world_destroy(world);
    }
}

/* Runs until a falling block has hit the floor and risen again, and returns how far it rose. */
static double bounce(skv_world *world)
{
    double lowest = centre(world), highest = 0;
    for (int f = 0; f < 60; f++) {
        fixture_run(world, 1);
        double now = centre(world);
        highest = now < lowest ? 0 : fmax(highest, now);
        lowest = fmin(lowest, now);
    }
    return highest - lowest;
}

static void jelly_bounces_and_keeps_its_springs(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    skv_world *world = jelly_block(&def, 0.3f);
    fixture_run(world, 1);
    int springs = skv_world_spring_count(world);
    assert_true(bounce(world) > 0.05);
    assert_int_equal(skv_world_spring_count(world), springs);
    fixture_run(world, 180);
    /* It has its shape again, less what it sags by. */
    assert_near(2 * centre(world), (double)JELLY_SIDE, 0.1 * (double)JELLY_SIDE);
    skv_world_destroy(world);
}

static void clay_stays_dented(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(clay_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    skv_world *world = jelly_block(&def, 0.3f);
    assert_true(bounce(world) < 0.03);
    fixture_run(world, 60);
    double dented = centre(world);
    assert_true(2 * dented < 0.8 * (double)JELLY_SIDE);
    assert_int_equal(skv_world_set_gravity(world, 0, 0, NULL), SKV_OK);
    fixture_run(world, 120);
    assert_true(2 * centre(world) < 0.9 * (double)JELLY_SIDE);
    skv_world_destroy(world);
}

/* Two blocks that touch: of jelly they part again, of goo they are one. */
static void goo_joins_what_it_touches(void **unused)
{
    (void)unused;
    for (int i = 0; i < 2; i++) {
        skv_world_def def =
            jelly_def(i ? goo_numbers : jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
        def.gravity_y = 0;
        skv_world *world = jelly_block(&def, 0.3f);
        fixture_run(world, 2);
        int count = skv_world_particle_count(world);
        fixture_fill_with(world, 0.94f, 0.3f, 0.94f + JELLY_SIDE, 0.3f + JELLY_SIDE, 1);
        int more = skv_world_particle_count(world) - count;
        assert_int_equal(skv_world_add_velocity(world, count, more, -0.2f, 0, NULL), SKV_OK);
        fixture_run(world, 30);
        const skv_springs *s = world->springs;
        int between = 0;
        for (int a = 0; a < count; a++)
            for (int k = s->first[a]; k < s->first[a + 1]; k++)
                between += s->to[k] >= count;
        assert_true(i ? between > 20 : between == 0);
        skv_world_destroy(world);
    }
}

typedef struct pair {
    uint32_t from, to; /* ids */
    float length;
} pair;

/* The springs of a world, by ids: `room` for them at least. */
static int list_pairs(const skv_world *world, pair *pairs)
{
    const skv_springs *s = world->springs;
    const uint32_t *id = world->state.id;
    int count = 0;
    for (int a = 0; a < s->particles; a++)
        for (int k = s->first[a]; k < s->first[a + 1]; k++)
            pairs[count++] = (pair){id[a], id[s->to[k]], s->length[k]};
    assert_int_equal(count, s->count);
    return count;
}

/* Whether all springs are such as were there before, in their order. */
static void expect_some_of(const skv_world *world, const pair *before, int count)
{
    pair now[MOST_PAIRS];
    int left = list_pairs(world, now), at = 0;
    for (int i = 0; i < left; i++, at++) {
        while (at < count && !(before[at].from == now[i].from && before[at].to == now[i].to))
            at++;
        assert_true(at < count && before[at].length == now[i].length);
    }
}

static void springs_go_with_their_ends(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    def.gravity_y = 0;
    skv_world *world = jelly_block(&def, 0.3f);
    assert_int_equal(skv_world_spring_count(world), 0);
    fixture_run(world, 1);
    pair before[MOST_PAIRS];
    int springs = list_pairs(world, before), removed;
    skv_area half = skv_box(0, 0, 0.8f, 0.9f);
    assert_int_equal(skv_world_remove_area(world, &half, &removed, NULL), SKV_OK);
    assert_true(removed > 50);
    assert_in_range(skv_world_spring_count(world), springs * 3 / 10, springs / 2);
    expect_some_of(world, before, springs);
    int all_before = springs;
    /* One that is water now has none, and jelly again it has them again. */
    springs = skv_world_spring_count(world);
    uint8_t fluid = 0;
    assert_int_equal(skv_world_set_fluids(world, 30, 1, &fluid, NULL), SKV_OK);
    int fewer = skv_world_spring_count(world);
    assert_in_range(springs - fewer, 8, 30);
    expect_some_of(world, before, all_before);
    fluid = 1;
    assert_int_equal(skv_world_set_fluids(world, 30, 1, &fluid, NULL), SKV_OK);
    fixture_run(world, 1);
    assert_in_range(skv_world_spring_count(world), springs - 3, springs + 3);
    skv_area all = skv_box(0, 0, 1.6f, 0.9f);
    assert_int_equal(skv_world_remove_area(world, &all, &removed, NULL), SKV_OK);
    assert_int_equal(skv_world_spring_count(world), 0);
    fixture_run(world, 1);
    skv_world_destroy(world);
}

/* A wall that is painted through jelly parts it, however thin. */
static void walls_part_springs(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    def.gravity_y = 0;
    skv_world *world = jelly_block(&def, 0.3f);
    fixture_run(world, 1);
    const skv_brush_stroke cut = {.x0 = 0.8f, .y0 = 0, .x1 = 0.8f, .y1 = 0.9f, .radius = 0.003f};
    skv_terrain *painted;
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &cut, 1, &painted, NULL), SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, painted, NULL, NULL), SKV_OK);
    const skv_springs *s = world->springs;
    const skv_state *p = &world->state;
    assert_true(s->count > 1000);
    for (int a = 0; a < s->particles; a++)
        for (int k = s->first[a]; k < s->first[a + 1]; k++)
            assert_true((p->x[a] < 0.8f) == (p->x[s->to[k]] < 0.8f));
    skv_world_destroy(world);
}

static void a_jelly_falls_asleep_and_wakes(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    def.sleep = true;
    skv_world *world = jelly_block(&def, 0);
    for (int f = 0; f < 1200 && skv_world_awake_count(world) > 0; f++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    double before = centre(world);
    assert_int_equal(skv_world_set_gravity(world, 0, -4, NULL), SKV_OK);
    fixture_run(world, 60);
    assert_true(centre(world) > before + 0.001);
    skv_world_destroy(world);
}

/* The floor bears a block's weight, half of it through its springs. */
static void instruments_feel_springs(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    skv_world *world = jelly_block(&def, 0);
    fixture_run(world, 240);
    skv_force_meter meter = {0};
    skv_wall_force force;
    double sum = 0, s = (double)JELLY_SPACING;
    for (int f = 0; f < 60; f++) {
        fixture_run(world, 1);
        assert_int_equal(skv_force_measure(&meter, world, -0.1, -0.1, 1.7, 0.05, &force, NULL),
                         SKV_OK);
        sum += force.fy / 60;
    }
    double weight = 9.81 * 1000 * s * s * skv_world_particle_count(world);
    assert_near(sum / weight, -1, 0.03);
    skv_force_free(&meter);
    skv_world_destroy(world);
}

static void what_is_no_spring_is_refused(void **unused)
{
    (void)unused;
    static const struct {
        float numbers[3];
        const char *message;
    } wrong[] = {
        {{-1, 0, 0}, "fluids[0].shear_modulus: is out of range; allowed is 0..20000 Pa"},
        {{20001, 0, 0}, "fluids[0].shear_modulus: is out of range; allowed is 0..20000 Pa"},
        {{NAN, 0, 0}, "fluids[0].shear_modulus: is out of range; allowed is 0..20000 Pa"},
        {{100, 1.01f, 0}, "fluids[0].yield: is out of range; allowed is 0..1"},
        {{100, 0, 101}, "fluids[0].plasticity: is out of range; allowed is 0..100 1/s"},
        {{0, 0, 1}, "fluids[0].plasticity: needs springs that give way; add a shear_modulus, Pa"},
        {{100, 0, INFINITY}, "fluids[0].plasticity: is out of range; allowed is 0..100 1/s"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        skv_world_def def = jelly_def(wrong[i].numbers, SKV_SOLVER_FAST, JELLY_SPACING);
        skv_world *world;
        skv_error error;
        assert_int_equal(skv_world_create(&def, &world, &error), SKV_ERROR_VALUE);
        assert_string_equal(error.text, wrong[i].message);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_sags_as_far_as_theory_says),
        cmocka_unit_test(springs_push_as_the_model_says),
        cmocka_unit_test(momentum_stays),
        cmocka_unit_test(bits_are_the_same_everywhere),
        cmocka_unit_test(solvers_agree),
        cmocka_unit_test(all_that_is_allowed_stays_bounded),
        cmocka_unit_test(springs_are_as_stiff_as_substeps_allow),
        cmocka_unit_test(jelly_bounces_and_keeps_its_springs),
        cmocka_unit_test(clay_stays_dented),
        cmocka_unit_test(goo_joins_what_it_touches),
        cmocka_unit_test(springs_go_with_their_ends),
        cmocka_unit_test(walls_part_springs),
        cmocka_unit_test(a_jelly_falls_asleep_and_wakes),
        cmocka_unit_test(instruments_feel_springs),
        cmocka_unit_test(what_is_no_spring_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
