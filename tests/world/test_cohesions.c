/* Cohesion by fluid: both solvers alike, with all momentum kept; drops of several fluids in one
 * world pulse as fast and press as hard as their own cohesion has it, whoever is beside them; equal
 * ones change no bit; the same bits on any threads and instruction sets; substeps and snapshots. */
#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#define WIDTH  1.2f
#define HEIGHT 0.6f

#define WATERS (8 * 9.81f)

/* A definition with two liquids of these cohesions, as heavy as the first. */
static skv_world_def define(skv_solver_kind solver, float spacing, float first, float second)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, spacing, 1);
    fixture_add_liquids(&def, 2);
    def.liquids[0].cohesion = first;
    def.liquids[1].cohesion = second;
    return def;
}

/* The tank of a definition; a density other than 0 is the first liquid's. */
static skv_world *make(skv_world_def def, float density)
{
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = (int)(WIDTH / terrain.pixel_size + 0.5f);
    terrain.height = (int)(HEIGHT / terrain.pixel_size + 0.5f);
    if (density > 0)
        def.liquids[0].density = density;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

/* Three fluids side by side, which break as dams do, and a drop of each that hangs from the
 * ceiling. */
static void fill_three(skv_world *world)
{
    fixture_fill_with(world, 0, 0, 0.15f, 0.2f, 0);
    fixture_fill_with(world, 0.15f, 0, 0.25f, 0.2f, 1);
    fixture_fill_with(world, 0.25f, 0, 0.35f, 0.2f, 2);
    for (int fluid = 0; fluid < 3; fluid++) {
        float x = 0.5f + 0.2f * (float)fluid;
        fixture_fill_with(world, x, HEIGHT - 0.03f, x + 0.1f, HEIGHT, fluid);
    }
}

static void rows_agree_with_the_reference(void **unused)
{
    (void)unused;
    for (int density = 1000; density > 500; density -= 300) {
        for (int frames = 1; frames < 20; frames += 6) {
            skv_world *fast = make(define(SKV_SOLVER_FAST, 0.015f, 500, 0), (float)density);
            skv_world *slow = make(define(SKV_SOLVER_REFERENCE, 0.015f, 500, 0), (float)density);
            fill_three(fast);
            fixture_run(fast, frames);
            fixture_expect_same_substep(fast, slow);
        }
    }
}

static void make_weightless(skv_world *world)
{
    assert_int_equal(skv_world_set(world, "gravity.y", "0", NULL), SKV_OK);
}

/* A weightless drop of three fluids, beside no wall. */
static void momentum_stays(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world *world = make(define((skv_solver_kind)solver, 0.015f, 300, 0), 500);
        make_weightless(world);
        fixture_fill_with(world, 0.2f, 0.2f, 0.4f, 0.4f, 0);
        fixture_mix_fluids(world);
        fixture_run(world, 20);
        skv_particles p = skv_world_particles(world);
        double x = 0, y = 0, most = 0;
        for (int i = 0; i < p.count; i++) {
            double mass = p.fluid[i] == 1 ? 0.5 : 1;
            x += mass * (double)p.vx[i];
            y += mass * (double)p.vy[i];
            most += mass * hypot((double)p.vx[i], (double)p.vy[i]);
        }
        assert_true(most / p.count > 0.005); /* it moves */
        assert_true(hypot(x, y) < 1e-7 * most);
        skv_world_destroy(world);
    }
}

/* ---- Drops ----------------------------------------------------------------------------------- */

#define RADIUS 0.12f

typedef struct oval {
    float x, wide, high;
} oval;

static bool is_inside(float x, float y, void *user)
{
    const oval *o = user;
    x = (x - o->x) / o->wide;
    y = (y - HEIGHT / 2) / o->high;
    return x * x + y * y < 1;
}

/* A drop about x, a little wider than high. */
static void add_drop(skv_world *world, float x, int fluid)
{
    oval shape = {x, RADIUS * 1.1f, RADIUS / 1.1f};
    skv_fill_def fill = skv_default_fill_def();
    fill.inside = is_inside;
    fill.user = &shape;
    fill.fluid = fluid;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
}

/* What a fluid's particles look like: the squares of their distances from their middle along both
 * axes, on average, and the pressure near x in the middle of the tank, Pa m. */
typedef struct look {
    int count;
    double xx, yy, pressure;
} look;

static look look_at(const skv_world *world, int fluid, double near)
{
    skv_particles p = skv_world_particles(world);
    double x = 0, y = 0, inside = 0;
    look seen = {0};
    for (int i = 0; i < p.count; i++) {
        if (p.fluid[i] != fluid)
            continue;
        double px = (double)p.x[i] - near, py = (double)p.y[i] - (double)HEIGHT / 2;
        seen.count++;
        x += px;
        y += py;
        seen.xx += px * px;
        seen.yy += py * py;
        if (hypot(px, py) < (double)RADIUS / 2) {
            seen.pressure += (double)p.pressure[i];
            inside++;
        }
    }
    assert_true(seen.count > 0 && inside > 0);
    seen.xx = seen.xx / seen.count - x * x / seen.count / seen.count;
    seen.yy = seen.yy / seen.count - y * y / seen.count / seen.count;
    seen.pressure /= inside;
    return seen;
}

typedef struct heard {
    double frequency; /* rad/s, of two half swings */
    double pressure;  /* Pa m, mean of that time */
} heard;

/* Lets drops of fluids 1 and 2 ring, weightless, and listens to one. */
static heard listen(float first, float second, int fluid)
{
    skv_world_def def = define(SKV_SOLVER_FAST, 0.01f, first, second);
    def.substeps = 24; /* so that all are as stiff */
    skv_world *world = make(def, 0);
    make_weightless(world);
    add_drop(world, 0.3f, 1);
    add_drop(world, 0.9f, 2);
    double sum = 0, before = 0, from = 0, to = 0;
    int frames = 0, through = 0;
    while (through < 3) {
        assert_true(++frames < 600);
        fixture_run(world, 1);
        look seen = look_at(world, fluid, fluid == 1 ? 0.3 : 0.9);
        double now = seen.xx - seen.yy;
        sum += seen.pressure;
        if (frames > 1 && now * before < 0) {
            to = frames - now / (now - before);
            from = through++ ? from : to;
        }
        before = now;
    }
    skv_world_destroy(world);
    return (heard){2 * 3.14159265358979 * 60 / (to - from), sum / frames};
}

static void expect_near(double a, double b, double most)
{
    if (!(fabs(a / b - 1) < most))
        fail_msg("%g instead of %g", a, b);
}

/* The tension that a drop's pressure tells, after Laplace, is that of its ringing, after Rayleigh;
 * so far as a few hundred particles do, as in `skvalp lab ringing`. */
static void expect_one_tension(heard drop)
{
    double r = (double)RADIUS, rings = 1000 * r * r * r * drop.frequency * drop.frequency / 6;
    expect_near(drop.pressure * r, rings, 0.15);
}

/* Each as if the other one were such, too. */
static void drops_ring_by_their_own_cohesion(void **unused)
{
    (void)unused;
    const float much = 240, little = 60;
    heard strong = listen(much, little, 1), both_strong = listen(much, much, 1);
    heard weak = listen(much, little, 2), both_weak = listen(little, little, 2);
    expect_near(strong.frequency, both_strong.frequency, 0.02);
    expect_near(strong.pressure, both_strong.pressure, 0.1);
    expect_near(weak.frequency, both_weak.frequency, 0.02);
    expect_near(weak.pressure, both_weak.pressure, 0.1);
    expect_one_tension(strong);
    expect_one_tension(weak);
    assert_true(strong.frequency > 1.4 * weak.frequency);
    assert_true(strong.pressure > 2 * weak.pressure);
}

/* The radius squared of a disc of as many particles, on average, over theirs: 1 for a disc, 0.76
 * for a block twice as wide as high. */
static double roundness(const skv_world *world, int fluid, double near)
{
    look seen = look_at(world, fluid, near);
    double s = (double)skv_world_spacing(world);
    return seen.count * s * s / (2 * 3.14159265358979) / (seen.xx + seen.yy);
}

/* Of two weightless blocks that of mercury draws together, and oil without any does not. */
static void mercury_is_round_beside_oil(void **unused)
{
    (void)unused;
    skv_world_def def = define(SKV_SOLVER_FAST, 0.015f, 300, 0);
    def.liquids[0].density = 13600;
    def.liquids[1].density = 900;
    skv_world *world = make(def, 0);
    make_weightless(world);
    fixture_fill_with(world, 0.15f, 0.22f, 0.45f, 0.37f, 1);
    fixture_fill_with(world, 0.75f, 0.22f, 1.05f, 0.37f, 2);
    fixture_run(world, 120);
    assert_true(roundness(world, 1, 0.3) > 0.9);
    assert_true(roundness(world, 2, 0.9) < 0.5);
    skv_world_destroy(world);
}

/* ---- What does not change -------------------------------------------------------------------- */

static uint64_t hash_of_three(float first, float second)
{
    skv_world *world = make(define(SKV_SOLVER_FAST, 0.015f, first, second), 700);
    fill_three(world);
    fixture_run(world, 20);
    uint64_t hash = skv_world_hash(world);
    skv_world_destroy(world);
    return hash;
}

/* Who has as much as the first has it by another way, and neither rows nor reference are told. */
static void equal_cohesions_change_no_bit(void **unused)
{
    (void)unused;
    uint64_t hash = hash_of_three(-1, -1);
    assert_true(hash_of_three(WATERS, WATERS) == hash);
    assert_true(hash_of_three(-1, 0) != hash);
    assert_true(hash_of_three(-1, 100) != hash);
}

/* A pool that settles and a dam that breaks, of fluid 1 or of the first, with so much for it. */
static uint64_t hash_of_one(int fluid, float cohesion)
{
    skv_world_def def = define(SKV_SOLVER_FAST, 0.015f, -1, -1);
    if (fluid)
        def.liquids[0].cohesion = cohesion;
    else
        def.fluid.cohesion = cohesion;
    skv_world *world = make(def, 0);
    fixture_fill_with(world, 0, 0, WIDTH, 0.15f, fluid);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    fixture_fill_with(world, 0, 0.15f, 0.2f, 0.4f, fluid);
    fixture_run(world, 20);
    skv_particles p = skv_world_particles(world);
    uint64_t hash = fixture_hash(&p);
    skv_world_destroy(world);
    return hash;
}

static void one_alone_does_what_the_first_would_do(void **unused)
{
    (void)unused;
    assert_true(hash_of_one(1, 300) == hash_of_one(0, 300));
    assert_true(hash_of_one(1, 200) != hash_of_one(0, 300));
}

static void expect_told(const skv_world *world, float first, float second, float third)
{
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    const skv_constants constants = skv_world_make_constants(world);
    skv_solver_particles p = skv_world_describe_step(world, &constants, forces).particles;
    if (first == second && second == third) {
        assert_null(p.cohesion);
        return;
    }
    assert_non_null(p.fluid);
    assert_true(p.cohesion[0] == first && p.cohesion[1] == second && p.cohesion[2] == third);
}

/* Who has none of their own follows the first, while it runs, too. */
static void cohesions_follow_the_first(void **unused)
{
    (void)unused;
    skv_world *world = make(define(SKV_SOLVER_FAST, 0.015f, -1, 100), 0);
    assert_int_equal(skv_world_set(world, "fluid.cohesion", "50", NULL), SKV_OK);
    expect_told(world, 0.5f, 0.5f, 1);
    assert_int_equal(skv_world_set(world, "fluid.cohesion", "200", NULL), SKV_OK);
    expect_told(world, 1, 1, 0.5f);
    assert_int_equal(skv_world_set(world, "fluid.cohesion", "100", NULL), SKV_OK);
    expect_told(world, 1, 1, 1);
    assert_true(skv_world_liquid(world, 0)->cohesion == 100);
    assert_true(skv_world_liquid(world, 1)->cohesion == -1);
    assert_true(skv_world_liquid(world, 2)->cohesion == 100);
    skv_world_destroy(world);
    world = make(define(SKV_SOLVER_FAST, 0.015f, 0, 0), 0);
    assert_int_equal(skv_world_set(world, "fluid.cohesion", "0", NULL), SKV_OK);
    expect_told(world, 1, 1, 1);
    skv_world_destroy(world);
}

static int substeps_with(float all, float own)
{
    skv_world_def def = define(SKV_SOLVER_FAST, 0.004f, -1, own);
    def.fluid.cohesion = all;
    def.depth = 0.01f;
    skv_world *world = make(def, 0);
    int substeps = skv_world_substeps_per_frame(world);
    skv_world_destroy(world);
    return substeps;
}

static void substeps_go_by_the_greatest(void **unused)
{
    (void)unused;
    int needed = substeps_with(500, -1);
    assert_true(needed > substeps_with(50, -1) + 5);
    assert_int_equal(substeps_with(50, 500), needed);
    assert_int_equal(substeps_with(500, 50), needed);
}

static skv_world *run_three(int threads, skv_instruction_set set)
{
    skv_world_def def = define(SKV_SOLVER_FAST, 0.008f, 300, 0);
    def.threads = threads;
    def.instruction_set = set;
    skv_world *world = make(def, 700);
    fill_three(world);
    fixture_run(world, 20);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_three);
}

static void snapshots_keep_them(void **unused)
{
    (void)unused;
    skv_world *world = make(define(SKV_SOLVER_FAST, 0.015f, 300, -1), 700), *copy;
    fill_three(world);
    fixture_run(world, 10);
    fixture_saved b = fixture_save(world, true);
    assert_int_equal(skv_world_load(b.bytes, b.size, fixture_host(1), &copy, NULL), SKV_OK);
    assert_true(skv_world_liquid(copy, 1)->cohesion == 300);
    assert_true(skv_world_liquid(copy, 2)->cohesion == -1);
    skv_world_destroy(copy);
    free(b.bytes);
    fixture_expect_goes_on(world, 10);
    skv_world_destroy(world);

    /* Of worlds that have none nothing is written of it. */
    world = make(define(SKV_SOLVER_FAST, 0.015f, -1, -1), 0);
    fixture_saved without = fixture_save(world, false);
    skv_world_destroy(world);
    world = make(define(SKV_SOLVER_FAST, 0.015f, -1, 0), 0);
    fixture_saved with = fixture_save(world, false);
    skv_world_destroy(world);
    assert_int_equal(with.size, without.size + 8);
    free(with.bytes);
    free(without.bytes);
}

static void wrong_cohesions_are_refused(void **unused)
{
    (void)unused;
    static const float wrong[] = {-2, -0.5f, 500.5f, INFINITY, NAN};
    for (int i = 0; i < 5; i++) {
        skv_world_def def = define(SKV_SOLVER_FAST, 0.03f, wrong[i], 0);
        skv_world *world;
        skv_error error = {0};
        assert_int_equal(skv_world_create(&def, &world, &error), SKV_ERROR_VALUE);
        assert_string_equal(error.text, "fluids[0].cohesion: is out of range; allowed is "
                                        "0..500 m/s^2, and -1 for that of the first fluid");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_agree_with_the_reference),
        cmocka_unit_test(momentum_stays),
        cmocka_unit_test(drops_ring_by_their_own_cohesion),
        cmocka_unit_test(mercury_is_round_beside_oil),
        cmocka_unit_test(equal_cohesions_change_no_bit),
        cmocka_unit_test(one_alone_does_what_the_first_would_do),
        cmocka_unit_test(cohesions_follow_the_first),
        cmocka_unit_test(substeps_go_by_the_greatest),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(snapshots_keep_them),
        cmocka_unit_test(wrong_cohesions_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
