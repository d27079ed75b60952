/* Several fluids by their mass, taken through the solvers' own interface: layers stay and weigh on
 * the floor what they weigh, a light one does not boil, what no wall touches keeps its momentum,
 * and masses that are all the same change nothing. */
#include "support/fixture.h"
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

/* A world, of which only the particles and the solver are used, and its particles' masses. */
typedef struct mixture {
    skv_world *world;
    int cold; /* substeps of the rule, as stiff as which the fluid is */
    float mass[MOST];
    skv_impulse given; /* by walls in the last call, m */
} mixture;

static skv_world *make_tank(const skv_fluid_def *fluid, skv_solver_kind solver, float gravity)
{
    static uint8_t coverage[PIXELS * PIXELS];
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
}

/* Two layers, which are settled as if they were one. */
static mixture *layers(skv_solver_kind solver, float below, float above)
{
    static mixture m;
    const skv_fluid_def fluid = fluid_of(SKV_LAW_CALIBRATED, 0);
    m.world = make_tank(&fluid, solver, (float)EARTH);
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
    m.world = make_tank(fluid, solver, 0);
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

static void advance(mixture *m, int frames, const float *mass)
{
    skv_world *w = m->world;
    const skv_solver_type *type = w->solver->type;
    skv_constants constants = skv_make_constants(&w->fluid, 1.0f / 60 / (float)w->substeps);
    skv_set_stiffness(&constants, (float)m->cold / (float)w->substeps);
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    skv_solver_step step = skv_world_describe_step(w, &constants, forces);
    step.particles.mass = mass;
    for (int n = 0; n < frames * w->substeps; n++) {
        assert_int_equal(type->reserve(w->solver, &step, NULL), SKV_OK);
        m->given = type->advance(w->solver, &step);
    }
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
    advance(m, 8 * 60, m->mass);
    assert_int_equal(count_astray(m, below), 0);
    assert_near(m->given.y / weight_in_a_substep(m), 1, 0.005);
    assert_near(speed_of(m), 0, calm);
    return m;
}

static void a_little_lighter_fluid_stays_above(void **unused)
{
    (void)unused;
    mixture *m = rest(SKV_SOLVER_REFERENCE, 1, 0.9f, 0.005);
    assert_near(floor_pressure(m, 1), 1, 0.04);
    skv_world_destroy(m->world);
}

static void a_much_lighter_fluid_lies_calm_above(void **unused)
{
    (void)unused;
    mixture *m = rest(SKV_SOLVER_REFERENCE, 1, 0.1f, 0.008);
    skv_world_destroy(m->world);
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

static void expect_momentum(skv_solver_kind solver, skv_law law, float viscosity)
{
    const skv_fluid_def fluid = fluid_of(law, viscosity);
    mixture *m = blob(solver, &fluid, 1, 0.2f);
    momentum before = momentum_of(m);
    advance(m, 18, m->mass);
    momentum after = momentum_of(m);
    assert_true(m->given.x == 0 && m->given.y == 0);
    assert_near(after.x / after.mass, before.x / before.mass, 1e-7);
    assert_near(after.y / after.mass, before.y / before.mass, 1e-7);
    skv_world_destroy(m->world);
}

static void what_no_wall_touches_keeps_its_momentum(void **unused)
{
    (void)unused;
    expect_momentum(SKV_SOLVER_REFERENCE, SKV_LAW_CALIBRATED, 0);
    expect_momentum(SKV_SOLVER_REFERENCE, SKV_LAW_CALIBRATED, 20);
    expect_momentum(SKV_SOLVER_REFERENCE, SKV_LAW_CLAVET, 20);
}

/* The hash after some frames of a dam that breaks in a tank; mass 0: none is given. Writes the mean
 * pressure. */
static uint64_t hash_of(skv_solver_kind solver, skv_law law, bool images, float mass,
                        double *pressure)
{
    static mixture m;
    skv_fluid_def fluid = fluid_of(law, 2);
    fluid.wall_images = images;
    m.world = make_tank(&fluid, solver, (float)EARTH);
    m.cold = skv_substep_rule(&fluid, EARTH * 2 * (double)LAYER);
    fill(&m, 0, 0, LAYER, 2 * LAYER, mass);
    advance(&m, 12, mass > 0 ? m.mass : NULL);
    skv_particles p = skv_world_particles(m.world);
    uint64_t hash = fixture_hash(&p);
    *pressure = 0;
    for (int i = 0; i < p.count; i++)
        *pressure += (double)p.pressure[i] / p.count;
    skv_world_destroy(m.world);
    return hash;
}

/* By a power of two, which rounds nothing. */
static void a_fluid_alone_moves_the_same_by_any_mass(void **unused)
{
    (void)unused;
    const skv_law laws[] = {SKV_LAW_CALIBRATED, SKV_LAW_CALIBRATED, SKV_LAW_CLAVET};
    for (int k = 0; k < 3; k++) {
        double none, one, four;
        uint64_t hash = hash_of(SKV_SOLVER_REFERENCE, laws[k], k == 0, 0, &none);
        assert_true(hash == hash_of(SKV_SOLVER_REFERENCE, laws[k], k == 0, 1, &one));
        assert_true(hash == hash_of(SKV_SOLVER_REFERENCE, laws[k], k == 0, 4, &four));
        assert_true(one == none && four == 4 * none);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_little_lighter_fluid_stays_above),
        cmocka_unit_test(a_much_lighter_fluid_lies_calm_above),
        cmocka_unit_test(what_no_wall_touches_keeps_its_momentum),
        cmocka_unit_test(a_fluid_alone_moves_the_same_by_any_mass),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
