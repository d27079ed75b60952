/* Several fluids by their mass, taken through the solvers' own interface: layers stay and weigh on
 * the floor what they weigh, a light one does not boil, momentum is kept or given by walls, masses
 * that are all the same change nothing, and mixtures have the same bits on any threads. */
#include "support/fixture.h"
#include "support/long.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { PIXELS = 160, MOST = 2000 };

#define PIXEL   0.0025f
#define WIDE    0.4f /* m; a tank's, which is as high */
#define LAYER   0.15f
#define SPACING 0.0155f
#define EARTH   9.81

static const skv_solver_kind solvers[] = {SKV_SOLVER_REFERENCE, SKV_SOLVER_FAST};

/* A world, of which only the particles and the solver are used, and its particles' masses. */
typedef struct mixture {
    skv_world *world;
    int cold; /* substeps of the rule, as stiff as which the fluid is */
    float mass[MOST];
    float drag[MOST];  /* sigma times the mass, 1/s */
    bool various;      /* they are told */
    skv_impulse given; /* by walls in the last call of take(), m */
} mixture;

/* With a thin wall of two pixels, which fluid passes above, if `thin`. */
static skv_world *make_tank(const skv_fluid_def *fluid, skv_solver_kind solver, float gravity,
                            bool thin)
{
    static uint8_t coverage[PIXELS * PIXELS];
    for (int y = 0; y < PIXELS / 4; y++)
        coverage[y * PIXELS + 70] = coverage[y * PIXELS + 71] = thin ? 255 : 0;
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = terrain.height = PIXELS;
    terrain.pixel_size = PIXEL;
    terrain.coverage = coverage;
    skv_world_def def = fixture_def(fluid->law, solver, 0, fluid->spacing, 1);
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    def.fluid = *fluid;
    def.gravity_y = -gravity;
    def.substeps = skv_warm_substeps(fluid, skv_substep_rule(fluid, EARTH * 2 * (double)LAYER));
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

static skv_fluid_def fluid_of(skv_law law, float viscosity)
{
    skv_fluid_def fluid = skv_default_fluid_def(law);
    fluid.spacing = SPACING;
    fluid.viscosity_linear = viscosity;
    return fluid;
}

static void fill(mixture *m, float x0, float y0, float x1, float y1, float mass)
{
    int before = skv_world_particle_count(m->world);
    int count = before + fixture_fill(m->world, x0, y0, x1, y1);
    assert_true(count <= MOST);
    for (int i = before; i < count; i++)
        m->mass[i] = mass;
    m->various = false;
}

/* Two layers, which are settled as if they were one. */
static mixture *layers(skv_solver_kind solver, float below, float above)
{
    static mixture m;
    const skv_fluid_def fluid = fluid_of(SKV_LAW_CALIBRATED, 0);
    m.world = make_tank(&fluid, solver, (float)EARTH, false);
    m.cold = skv_substep_rule(&fluid, EARTH * 2 * (double)LAYER);
    fill(&m, 0, 0, WIDE, LAYER, below);
    fill(&m, 0, LAYER, WIDE, 2 * LAYER, above);
    assert_int_equal(skv_world_settle(m.world, NULL), SKV_OK);
    return &m;
}

/* Two halves of a blob that run into each other, one of them upwards too. */
static mixture *blob(skv_solver_kind solver, const skv_fluid_def *fluid, float left, float right)
{
    static mixture m;
    m.world = make_tank(fluid, solver, 0, false);
    m.cold = skv_substep_rule(fluid, EARTH * 2 * (double)LAYER);
    fill(&m, 0.1f, 0.1f, 0.2f, 0.3f, left);
    fill(&m, 0.2f, 0.1f, 0.3f, 0.3f, right);
    skv_state *s = &m.world->state;
    for (int i = 0; i < s->count; i++) {
        s->vx[i] = s->x[i] < 0.2f ? 0.2f : -0.1f;
        s->vy[i] = s->x[i] < 0.2f ? 0 : 0.1f;
    }
    return &m;
}

/* Viscosities of both fluids, 1/s, which are told apart by their masses. */
static void give_drags(mixture *m, float first, float second)
{
    for (int i = 0; i < m->world->state.count; i++)
        m->drag[i] = m->mass[i] * (m->mass[i] == m->mass[0] ? first : second);
    m->various = first > 0 || second > 0;
}

/* What the solver is asked for: a substep of fluid that starts warm. */
static skv_solver_step describe(const mixture *m, skv_constants *constants,
                                skv_external_force forces[SKV_SOLVER_MOST_FORCES])
{
    const skv_world *w = m->world;
    *constants = skv_make_constants(&w->fluid, 0, 1.0f / 60 / (float)w->substeps);
    skv_set_stiffness(constants, (float)m->cold / (float)w->substeps);
    skv_solver_step step = skv_world_describe_step(w, constants, forces);
    step.particles.mass = m->mass;
    step.particles.drag = m->various ? m->drag : NULL;
    return step;
}

/* The sum of what walls give is left in `given`. */
static void take(mixture *m, skv_solver *solver, const skv_solver_step *step, int substeps)
{
    m->given = (skv_impulse){0};
    for (int n = 0; n < substeps; n++) {
        assert_int_equal(solver->type->reserve(solver, step, NULL), SKV_OK);
        skv_impulse given = solver->type->advance(solver, step);
        m->given.x += given.x;
        m->given.y += given.y;
    }
}

static void advance(mixture *m, int substeps)
{
    skv_constants constants;
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    const skv_solver_step step = describe(m, &constants, forces);
    take(m, m->world->solver, &step, substeps);
}

static double speed_of(const mixture *m)
{
    const skv_state *s = &m->world->state;
    double sum = 0;
    for (int i = 0; i < s->count; i++)
        sum += (double)(s->vx[i] * s->vx[i] + s->vy[i] * s->vy[i]);
    return sqrt(sum / s->count);
}

/* How many lie farther than two spacings on the wrong side of where two layers meet. */
static int count_astray(const mixture *m, float below)
{
    const skv_state *s = &m->world->state;
    int lower = 0, astray = 0;
    for (int i = 0; i < s->count; i++)
        lower += m->mass[i] == below;
    float level = (float)lower * SPACING * SPACING / WIDE;
    for (int i = 0; i < s->count; i++) {
        float over = s->y[i] - level;
        astray += m->mass[i] == below ? over > 2 * SPACING : over < -2 * SPACING;
    }
    return astray;
}

/* Of the layer above the floor's own, against that of what lies above it. */
static double floor_pressure(const mixture *m, float below)
{
    const skv_state *s = &m->world->state;
    double weight = 0, found = 0, expected = 0;
    for (int i = 0; i < s->count; i++)
        weight += (double)m->mass[i];
    weight *= EARTH * 1000 * (double)(SPACING * SPACING / WIDE);
    for (int i = 0; i < s->count; i++) {
        if (s->y[i] < SPACING || s->y[i] > 2.5f * SPACING)
            continue;
        found += (double)s->pressure[i];
        expected += weight - EARTH * 1000 * (double)(below * s->y[i]);
    }
    return found / expected;
}

/* The weight of all particles, in what walls must give in a substep to bear it. */
static double weight_in_a_substep(const mixture *m)
{
    double dt = 1.0 / 60 / m->world->substeps, sum = 0;
    for (int i = 0; i < m->world->state.count; i++)
        sum += (double)m->mass[i];
    return EARTH * sum * dt * dt;
}

/* Two layers after eight seconds, which then move by no more than `calm`, m/s. */
static mixture *rest(skv_solver_kind solver, float below, float above, double calm)
{
    mixture *m = layers(solver, below, above);
    advance(m, 8 * 60 * m->world->substeps - 1);
    advance(m, 1);
    assert_int_equal(count_astray(m, below), 0);
    assert_near(m->given.y / weight_in_a_substep(m), 1, 0.005);
    assert_near(speed_of(m), 0, calm);
    return m;
}

/* The first of the solvers that rest: the reference, which takes twenty times as long, in the long
 * form. */
static int first_at_rest(void)
{
    return long_tests() ? 0 : 1;
}

/* The pressure beside the floor is off as one fluid's is, which the lattice decides. */
static void a_little_lighter_fluid_stays_above(void **unused)
{
    (void)unused;
    for (int k = first_at_rest(); k < 2; k++) {
        mixture *m = rest(solvers[k], 1, 1, 0.005);
        double alone = floor_pressure(m, 1);
        skv_world_destroy(m->world);
        m = rest(solvers[k], 1, 0.9f, 0.005);
        assert_near(floor_pressure(m, 1), alone, 0.01);
        skv_world_destroy(m->world);
    }
}

static void a_much_lighter_fluid_lies_calm_above(void **unused)
{
    (void)unused;
    for (int k = first_at_rest(); k < 2; k++)
        skv_world_destroy(rest(solvers[k], 1, 0.1f, 0.008)->world);
}

typedef struct momentum {
    double x, y, mass;
} momentum;

static momentum momentum_of(const mixture *m)
{
    const skv_state *s = &m->world->state;
    momentum sum = {0};
    for (int i = 0; i < s->count; i++) {
        sum.x += (double)m->mass[i] * (double)s->vx[i];
        sum.y += (double)m->mass[i] * (double)s->vy[i];
        sum.mass += (double)m->mass[i];
    }
    return sum;
}

static void expect_momentum(skv_solver_kind solver, skv_law law, float viscosity, float left)
{
    const skv_fluid_def fluid = fluid_of(law, viscosity);
    mixture *m = blob(solver, &fluid, 1, 0.2f);
    momentum before = momentum_of(m);
    give_drags(m, left, 3 * left);
    advance(m, 18 * m->world->substeps);
    momentum after = momentum_of(m);
    assert_true(m->given.x == 0 && m->given.y == 0);
    assert_near(after.x / after.mass, before.x / before.mass, 1e-7);
    assert_near(after.y / after.mass, before.y / before.mass, 1e-7);
    skv_world_destroy(m->world);
}

static void what_no_wall_touches_keeps_its_momentum(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        expect_momentum(solvers[k], SKV_LAW_CALIBRATED, 0, 0);
        expect_momentum(solvers[k], SKV_LAW_CALIBRATED, 20, 0);
        expect_momentum(solvers[k], SKV_LAW_CLAVET, 20, 0);
        expect_momentum(solvers[k], SKV_LAW_CALIBRATED, 0, 20);
        expect_momentum(solvers[k], SKV_LAW_CLAVET, 0, 20);
    }
}

/* Heavy fluid over light fluid, which turn about each other, while all of it falls freely. */
static void what_turns_while_it_falls_keeps_its_momentum(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        static mixture m;
        const skv_fluid_def fluid = fluid_of(SKV_LAW_CALIBRATED, 0);
        m.world = make_tank(&fluid, solvers[k], (float)EARTH, false);
        m.cold = m.world->substeps;
        fill(&m, 0.1f, 0.15f, 0.3f, 0.25f, 0.5f);
        fill(&m, 0.1f, 0.25f, 0.3f, 0.35f, 1);
        advance(&m, 6 * m.world->substeps);
        momentum after = momentum_of(&m);
        assert_true(m.given.x == 0 && m.given.y == 0);
        assert_near(after.x / after.mass, 0, 1e-6);
        assert_near(after.y / after.mass, -EARTH * 0.1, 2e-6);
        const skv_state *s = &m.world->state;
        double sideways = 0;
        for (int i = 0; i < s->count; i++)
            sideways = fmax(sideways, fabs((double)s->vx[i]));
        assert_true(sideways > 0.02);
        skv_world_destroy(m.world);
    }
}

/* A dam of two fluids that breaks, over a thin wall. */
static mixture *dam(skv_solver_kind solver, const skv_fluid_def *fluid, float left, float right)
{
    static mixture m;
    m.world = make_tank(fluid, solver, (float)EARTH, true);
    m.cold = 2 * m.world->substeps; /* so that it starts warm */
    fill(&m, 0, 0, LAYER / 2, 2 * LAYER, left);
    fill(&m, LAYER / 2, 0, LAYER, 2 * LAYER, right);
    return &m;
}

/* Every other particle of the dam weighs 136 times as much as the rest. Half a second later their
 * mean speed is less than that of a fall from the dam's height. */
static void what_is_light_among_heavy_ones_is_not_shot_off(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        const skv_fluid_def fluid = fluid_of(SKV_LAW_CALIBRATED, 0);
        mixture *m = dam(solvers[k], &fluid, 1, 1);
        for (int i = 0; i < m->world->state.count; i++)
            m->mass[i] = i % 2 ? 13.6f : 0.1f;
        advance(m, 30 * m->world->substeps);
        assert_true(speed_of(m) < sqrt(2 * EARTH * 2 * (double)LAYER));
        skv_world_destroy(m->world);
    }
}

/* No particle is as fast as may be at most. */
static void walls_give_what_fluids_gain(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        skv_fluid_def fluid = fluid_of(SKV_LAW_CALIBRATED, 2);
        fluid.wall_friction = 0.3f;
        mixture *m = dam(solvers[k], &fluid, 3, 0.5f);
        int substeps = 20 * m->world->substeps;
        advance(m, substeps);
        double dt = 1.0 / 60 / m->world->substeps, weight = substeps * weight_in_a_substep(m);
        momentum after = momentum_of(m);
        assert_true(fabs(m->given.x) > 0.02 * weight);
        assert_near(m->given.x / weight, dt * after.x / weight, 2e-6);
        assert_near(m->given.y / weight, dt * after.y / weight + 1, 2e-6);
        skv_world_destroy(m->world);
    }
}

/* How a dam is taken: by the world's own solver, or by rows of other threads, instruction sets and
 * room for kept pairs. */
typedef struct manner {
    skv_solver_kind solver;
    skv_pool *pool;
    skv_instruction_set set;
    float kept; /* of the usual room; 0: the world's own */
} manner;

static void take_by(mixture *m, const manner *by, const skv_solver_step *step, int substeps)
{
    const skv_solver_def def = {
        .x1 = WIDE,
        .y1 = WIDE,
        .h = m->world->h,
        .instruction_set = by->set,
        .per_square = 9 * by->kept,
        .boundary = &m->world->boundary,
    };
    skv_solver *rows;
    assert_int_equal(skv_rows_solver.create(&def, &rows, NULL), SKV_OK);
    take(m, rows, step, substeps);
    skv_rows_solver.destroy(rows);
}

/* The hash of a dam after some frames; masses are times that, or if it is 0 there are none. Writes
 * the mean pressure. The rows hold one in ten of its particles. */
static uint64_t hash_of(const manner *by, const skv_fluid_def *fluid, float right, float times,
                        float sticky, double *pressure)
{
    static uint8_t part[MOST];
    mixture *m = dam(by->solver, fluid, times, times * right);
    skv_constants constants;
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    give_drags(m, sticky * times, 0);
    skv_solver_step step = describe(m, &constants, forces);
    for (int i = 0; i < MOST; i++)
        part[i] = i % 10 == 3 ? SKV_HELD : i % 50 == 7 ? SKV_ABSENT : SKV_MOVES;
    step.particles.mass = times > 0 ? m->mass : NULL;
    step.particles.part = by->solver == SKV_SOLVER_FAST ? part : NULL;
    step.pool = by->pool;
    if (by->kept > 0)
        take_by(m, by, &step, 16 * m->world->substeps);
    else
        take(m, m->world->solver, &step, 16 * m->world->substeps);
    skv_particles p = skv_world_particles(m->world);
    uint64_t hash = fixture_hash(&p);
    *pressure = 0;
    for (int i = 0; i < p.count; i++)
        *pressure += (double)p.pressure[i] / p.count;
    skv_world_destroy(m->world);
    return hash;
}

/* Both laws, walls by images and without. */
enum { KINDS = 3 };

static skv_fluid_def fluid_of_kind(int kind)
{
    skv_fluid_def fluid = fluid_of(kind == 2 ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED, 2);
    fluid.wall_images = kind == 0;
    return fluid;
}

/* By a power of two, which rounds nothing. */
static void a_fluid_alone_moves_the_same_by_any_mass(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2 * KINDS; k++) {
        const skv_fluid_def fluid = fluid_of_kind(k / 2);
        const manner by = {.solver = solvers[k % 2]};
        double none, one, four;
        uint64_t hash = hash_of(&by, &fluid, 1, 0, 0, &none);
        assert_true(hash == hash_of(&by, &fluid, 1, 1, 0, &one));
        assert_true(hash == hash_of(&by, &fluid, 1, 4, 0, &four));
        assert_true(one == none && four == 4 * none);
    }
}

static void expect_hash(uint64_t hash, const skv_fluid_def *fluid, float sticky, const manner *by)
{
    double pressure;
    assert_true(hash == hash_of(by, fluid, 0.3f, 1, sticky, &pressure));
}

/* What is told of each particle is as if the fluid had it, where no wall takes of it. */
static void a_viscosity_of_all_is_the_fluids(void **unused)
{
    (void)unused;
    for (int k = 0; k < 4; k++) {
        uint64_t hash[2];
        for (int told = 0; told < 2; told++) {
            const skv_fluid_def fluid =
                fluid_of(k < 2 ? SKV_LAW_CALIBRATED : SKV_LAW_CLAVET, told ? 0 : 20);
            mixture *m = blob(solvers[k % 2], &fluid, 1, 1);
            give_drags(m, told ? 20 : 0, 0);
            m->world->substeps = 8; /* the rule's are of the fluid */
            advance(m, 40);
            skv_particles p = skv_world_particles(m->world);
            hash[told] = fixture_hash(&p);
            skv_world_destroy(m->world);
        }
        assert_true(hash[0] == hash[1]);
    }
}

/* A shear wave in the left one of two fluids dies out if that is viscous, and not if the other is.
 */
static void drags_slow_their_own_fluid(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        double left[2];
        for (int sticky = 0; sticky < 2; sticky++) {
            const skv_fluid_def fluid = fluid_of(SKV_LAW_CALIBRATED, 0);
            mixture *m = blob(solvers[k], &fluid, 1, 0.999f);
            skv_state *s = &m->world->state;
            for (int i = 0; i < s->count; i++) {
                s->vx[i] = 0;
                s->vy[i] = s->x[i] < 0.2f ? 0.2f * sinf(125 * s->x[i]) : 0;
            }
            give_drags(m, sticky ? 60 : 0, sticky ? 0 : 60);
            m->world->substeps = 8;
            advance(m, 32);
            left[sticky] = 0;
            for (int i = 0; i < s->count; i++)
                left[sticky] += m->mass[i] == 1 ? (double)(s->vy[i] * sinf(125 * s->x[i])) : 0;
            skv_world_destroy(m->world);
        }
        if (left[1] > 0.25 * left[0] || left[0] < 2)
            fail_msg("%g beside %g", left[1], left[0]);
    }
}

static size_t bytes_of(const skv_world *world)
{
    return skv_rows_solver.memory(world->solver).particles;
}

/* Three floats a particle and the dummies beside it, two more where they are viscous, and none as
 * long as nobody gives masses. */
static void masses_take_memory_where_they_are(void **unused)
{
    (void)unused;
    const skv_fluid_def fluid = fluid_of(SKV_LAW_CALIBRATED, 0);
    mixture *m = dam(SKV_SOLVER_FAST, &fluid, 1, 2);
    skv_constants constants;
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    skv_solver_step step = describe(m, &constants, forces);
    step.particles.mass = NULL;
    take(m, m->world->solver, &step, 2);
    size_t before = bytes_of(m->world);
    step.particles.mass = m->mass;
    take(m, m->world->solver, &step, 2);
    size_t with = bytes_of(m->world);
    assert_true(with > before && (double)with < 1.2 * (double)before);
    take(m, m->world->solver, &step, 2);
    assert_int_equal(bytes_of(m->world), with);
    step.particles.drag = m->drag;
    take(m, m->world->solver, &step, 2);
    size_t viscous = bytes_of(m->world);
    assert_int_equal(3 * (viscous - with), 2 * (with - before));
    take(m, m->world->solver, &step, 2);
    assert_int_equal(bytes_of(m->world), viscous);
    skv_world_destroy(m->world);
}

static void mixtures_have_the_same_bits_everywhere(void **unused)
{
    (void)unused;
    for (int k = 0; k < KINDS; k++) {
        const skv_fluid_def fluid = fluid_of_kind(k);
        const float sticky = k > 0 ? 40 : 0; /* the left one, 1/s */
        double pressure;
        uint64_t hash =
            hash_of(&(manner){.solver = SKV_SOLVER_FAST}, &fluid, 0.3f, 1, sticky, &pressure);
        expect_hash(hash, &fluid, sticky, &(manner){.solver = SKV_SOLVER_FAST, .kept = 0.001f});
        for (skv_instruction_set set = SKV_ISA_SCALAR; set <= SKV_ISA_WASM; set++)
            if (skv_rows_instruction_set(set))
                expect_hash(hash, &fluid, sticky,
                            &(manner){.solver = SKV_SOLVER_FAST, .set = set, .kept = 1});
        for (int threads = 2; threads < 6; threads++) {
            manner by = {.solver = SKV_SOLVER_FAST, .kept = 1};
            assert_int_equal(skv_pool_create(threads, &by.pool, NULL), SKV_OK);
            expect_hash(hash, &fluid, sticky, &by);
            skv_pool_destroy(by.pool);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_little_lighter_fluid_stays_above),
        cmocka_unit_test(a_much_lighter_fluid_lies_calm_above),
        cmocka_unit_test(what_no_wall_touches_keeps_its_momentum),
        cmocka_unit_test(what_turns_while_it_falls_keeps_its_momentum),
        cmocka_unit_test(what_is_light_among_heavy_ones_is_not_shot_off),
        cmocka_unit_test(walls_give_what_fluids_gain),
        cmocka_unit_test(a_fluid_alone_moves_the_same_by_any_mass),
        cmocka_unit_test(a_viscosity_of_all_is_the_fluids),
        cmocka_unit_test(drags_slow_their_own_fluid),
        cmocka_unit_test(masses_take_memory_where_they_are),
        cmocka_unit_test(mixtures_have_the_same_bits_everywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
