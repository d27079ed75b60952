/* The rows against the reference, one whole substep after the other from the same state: both laws,
 * walls by images and without, at slants and in corners; hands and force fields, emitters, drains
 * and open sides; mixtures of masses. What differs is rounding: the rows' is single precision. */
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

enum { WIDTH = 160, HEIGHT = 90, SUBSTEPS = 40, MOST_STOPS = 1000, MOST_MIXED = 4000 };

#define PIXEL 0.01f

typedef struct kind {
    const char *name;
    skv_law law;
    bool images;
    float viscosity;
    bool free;           /* of walls within reach */
    unsigned open_sides; /* and a tap and two drains, if there are any */
    bool driven;         /* by hands and force fields */
    /* Those of the particles, mixed; then the solver alone takes the substeps, and nobody comes or
     * goes. 0: all the same. */
    float mass[3];
    float sigma[3]; /* of their linear viscosity, 1/s; all 0: as the fluid's */
    bool layered;   /* or the first of them below */
} kind;

static const kind kinds[] = {
    {.name = "calibrated, free", .free = true, .viscosity = 3},
    {.name = "clavet, free", .law = SKV_LAW_CLAVET, .free = true, .viscosity = 3},
    {.name = "calibrated", .driven = true},
    {.name = "calibrated, images", .images = true, .driven = true},
    {.name = "clavet", .law = SKV_LAW_CLAVET, .driven = true},
    {.name = "calibrated, viscous", .viscosity = 2},
    {.name = "calibrated, images, viscous", .images = true, .viscosity = 2},
    {.name = "clavet, viscous", .law = SKV_LAW_CLAVET, .viscosity = 2},
    {.name = "calibrated, open", .open_sides = SKV_SIDE_RIGHT},
    {.name = "calibrated, images, open", .images = true, .open_sides = SKV_SIDE_RIGHT},
    {.name = "clavet, open", .law = SKV_LAW_CLAVET, .open_sides = SKV_SIDE_RIGHT},
    {.name = "mixed, free", .free = true, .viscosity = 3, .mass = {0.5f, 1, 2}},
    {.name = "mixed", .driven = true, .mass = {0.5f, 1, 2}},
    {.name = "mixed, images", .images = true, .driven = true, .mass = {0.5f, 1, 2}},
    {.name = "mixed, images, viscous", .images = true, .viscosity = 2, .mass = {0.5f, 1, 2}},
    {.name = "mixed, clavet", .law = SKV_LAW_CLAVET, .driven = true, .mass = {0.5f, 1, 2}},
    {.name = "mixed, clavet, viscous", .law = SKV_LAW_CLAVET, .viscosity = 2, .mass = {0.5f, 1, 2}},
    {.name = "mixed, of their own viscosity",
     .viscosity = 2,
     .mass = {0.5f, 1, 2},
     .sigma = {0, 4, 100}},
    {.name = "mixed, images, of their own viscosity",
     .images = true,
     .mass = {0.5f, 1, 2},
     .sigma = {0, 4, 100}},
    {.name = "mixed, clavet, of their own viscosity",
     .law = SKV_LAW_CLAVET,
     .mass = {0.5f, 1, 2},
     .sigma = {0, 4, 100}},
    {.name = "layers, images, of their own viscosity",
     .images = true,
     .layered = true,
     .mass = {1, 1, 1},
     .sigma = {40, 0, 2}},
    {.name = "layers", .layered = true, .mass = {13.6f, 1, 0.1f}},
    {.name = "layers, images", .images = true, .layered = true, .mass = {13.6f, 1, 0.1f}},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* A slanted shelf with a grey edge, a disc, and the corner between a block and the floor. */
static int solid_at(int x, int y)
{
    int shelf = 128 + 51 * (9 - abs(3 * x + 4 * y - 330));
    int disc = 128 + 6 * (100 - (x - 100) * (x - 100) - (y - 20) * (y - 20));
    int block = x > 60 && x < 70 && y < 15 ? 255 : 0;
    int most = x < 60 && shelf > disc ? shelf : disc;
    most = most > block ? most : block;
    return most < 0 ? 0 : most > 255 ? 255 : most;
}

static skv_world *make_world(const kind *k, skv_solver_kind solver)
{
    static uint8_t coverage[WIDTH * HEIGHT];
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            coverage[y * WIDTH + x] = (uint8_t)(k->free ? 0 : solid_at(x, y));
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = WIDTH;
    terrain.height = HEIGHT;
    terrain.pixel_size = PIXEL;
    terrain.coverage = coverage;
    terrain.open_sides = k->open_sides;
    skv_world_def def = fixture_def(k->law, solver, k->viscosity, 0.02f, 1);
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    def.fluid.wall_images = k->images;
    def.fluid.viscosity_quadratic = 100 * k->viscosity; /* so that some pairs reach its bound */
    def.fluid.adhesion = 0.5f;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

static void fill(const kind *k, skv_world *world)
{
    if (k->free)
        fixture_fill(world, 0.4f, 0.3f, 0.8f, 0.7f);
    else
        fixture_fill(world, 0, 0, k->open_sides ? 1.6f : 1, 0.6f);
    int count = skv_world_particle_count(world);
    float vx = k->open_sides ? 2 : 0.5f;
    assert_int_equal(skv_world_add_velocity(world, 0, count / 2, vx, 1, NULL), SKV_OK);
}

/* A finger that pulls and carries, and three fields, of which each number does something. Their
 * edges, at which they begin at once, lie outside. */
static void drive(skv_world *world)
{
    skv_hand hand = skv_default_hand();
    hand.x = 0.5f;
    hand.y = 0.3f;
    hand.vx = 1.5f;
    hand.vy = 0.5f;
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    const skv_force forces[] = {
        {.area = skv_box(-1, -1, 3, 3), .ax = 3, .ay = 1},
        {.area = skv_circle(0.9f, 0.2f, 3), .toward_x = 1, .toward_y = 0.35f, .attraction = 20},
        {.area = skv_box(-1, -2, 2, 3), .wind_x = 1, .drag = 4, .spin = 3},
    };
    assert_int_equal(skv_world_set_forces(world, forces, 3, NULL), SKV_OK);
}

static void let_flow(skv_world *world)
{
    const skv_emitter tap = {.x = 0.8f, .y = 0.8f, .vx = 2, .vy = -1, .width = 0.1f, .dye = 1};
    assert_int_equal(skv_world_set_emitters(world, &tap, 1, NULL), SKV_OK);
    const skv_drain drains[] = {{.area = skv_circle(0.2f, 0.1f, 0.05f), .rate = 0.2f},
                                {.area = skv_box(1.2f, 0, 1.3f, 0.1f)}};
    assert_int_equal(skv_world_set_drains(world, drains, 2, NULL), SKV_OK);
}

static void begin(const kind *k, skv_world *world)
{
    float g = k->free ? 2 : 9.81f;
    assert_int_equal(skv_world_set_gravity(world, 1, -g, NULL), SKV_OK);
    if (k->driven)
        drive(world);
    if (k->open_sides)
        let_flow(world);
}

/* Puts `slow` into the state of `fast`, which has as many particles. */
static void follow(skv_world *slow, const skv_world *fast)
{
    const skv_state *from = &fast->state;
    const skv_state *to = &slow->state;
    size_t bytes = (size_t)from->count * sizeof(float);
    assert_int_equal(to->count, from->count);
    assert_memory_equal(to->id, from->id, (size_t)from->count * sizeof *to->id);
    memcpy(to->x, from->x, bytes);
    memcpy(to->y, from->y, bytes);
    memcpy(to->vx, from->vx, bytes);
    memcpy(to->vy, from->vy, bytes);
    memcpy(to->warm_lambda, from->warm_lambda, bytes);
    memset(to->clearance, 0, bytes);
    slow->load = fast->load;
    slow->substeps = fast->substeps;
}

/* Places at which a wall by images has stopped a particle. There it slides on along the wall or not
 * by how its place is rounded, so neither it nor what is within two radii of it can be compared. */
typedef struct stops {
    int count;
    float x[MOST_STOPS], y[MOST_STOPS];
} stops;

static float wall_distance(const skv_world *world, float x, float y)
{
    float nx, ny;
    return skv_terrain_normal(world->terrain, x, y, &nx, &ny);
}

static void find_stops(stops *found, const skv_world *world)
{
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++) {
        if (wall_distance(world, p.x[i], p.y[i]) > 1.1f * world->boundary.margin)
            continue;
        assert_true(found->count < MOST_STOPS);
        found->x[found->count] = p.x[i];
        found->y[found->count++] = p.y[i];
    }
}

static bool is_beside(const stops *found, float x, float y, float distance)
{
    for (int i = 0; i < found->count; i++)
        if (hypotf(found->x[i] - x, found->y[i] - y) < distance)
            return true;
    return false;
}

/* At the edge of contact a particle has all of the friction or none, by how its place is rounded.
 */
static bool is_at_the_edge(const skv_world *world, float x, float y)
{
    float inside = world->boundary.contact_distance - wall_distance(world, x, y);
    return fabsf(inside) < 2e-6f * world->h;
}

static double heaviest(const kind *k)
{
    double most = fmax((double)k->mass[0], fmax((double)k->mass[1], (double)k->mass[2]));
    return most > 0 ? most : 1;
}

/* Places and ways in h, pressures in that of a density of 1, of the heaviest fluid: each is a few
 * roundings of a place, which is up to 27 h from the origin. Returns how many particles were
 * compared. */
static int expect_same(const kind *k, int substep, const skv_world *fast, const skv_world *slow)
{
    skv_particles p = skv_world_particles(fast), q = skv_world_particles(slow);
    const double h = (double)fast->h, dt = 1.0 / 60 / fast->substeps, most = 1e-5;
    const double density = (double)fast->fluid.density * heaviest(k);
    const double modulus = density * (h / dt) * (h / dt);
    static stops found;
    int compared = 0;
    found.count = 0;
    if (k->images) {
        find_stops(&found, fast);
        find_stops(&found, slow);
    }
    assert_int_equal(p.count, q.count);
    for (int i = 0; i < p.count; i++) {
        double apart = hypot((double)(p.x[i] - q.x[i]), (double)(p.y[i] - q.y[i])) / h;
        double faster = hypot((double)(p.vx[i] - q.vx[i]), (double)(p.vy[i] - q.vy[i])) * dt / h;
        double pressed = fabs((double)(p.pressure[i] - q.pressure[i])) / modulus;
        if (is_at_the_edge(fast, p.x[i], p.y[i]) || is_beside(&found, p.x[i], p.y[i], 2 * fast->h))
            continue;
        compared++;
        if (!(apart < most && faster < most && pressed < most))
            fail_msg("%s, substep %d: particle %d at (%.3f, %.3f) is %.2g h off, %.2g in its way, "
                     "%.2g in its pressure",
                     k->name, substep, i, (double)p.x[i], (double)p.y[i], apart, faster, pressed);
    }
    return compared;
}

/* What walls have given in the last step, in the ways of as many particles as there are. */
static void expect_same_impulse(const kind *k, const skv_world *fast, const skv_world *slow)
{
    skv_wall_impulse a = skv_world_wall_impulse(fast), b = skv_world_wall_impulse(slow);
    const double s = (double)fast->fluid.spacing, mass = (double)fast->fluid.density * s * s;
    const double way = 60 * fast->substeps * (double)fast->h * fast->state.count * mass;
    double off = hypot(a.x - b.x, a.y - b.y) / way, turned = fabs(a.moment - b.moment) / way;
    if (!(off < 1e-5 && turned < 1e-5))
        fail_msg("%s: walls gave (%g, %g) and (%g, %g) N s, moments %g and %g", k->name, a.x, a.y,
                 b.x, b.y, a.moment, b.moment);
}

/* A substep, of several masses by the solver alone. */
static void take_substep(const kind *k, skv_world *world)
{
    static float mass[MOST_MIXED], drag[MOST_MIXED];
    if (!(k->mass[0] > 0)) {
        assert_int_equal(skv_world_step(world, 1.0f / 60 / (float)world->substeps, NULL), SKV_OK);
        return;
    }
    const skv_constants constants = skv_world_make_constants(world);
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    skv_solver_step step = skv_world_describe_step(world, &constants, forces);
    assert_true(step.particles.count <= MOST_MIXED);
    for (int i = 0; i < step.particles.count; i++) {
        int fluid = k->layered ? 3 * i / step.particles.count : (i * 7 + i / 5) % 3;
        mass[i] = k->mass[fluid];
        drag[i] = k->mass[fluid] * k->sigma[fluid];
    }
    step.particles.mass = mass;
    if (k->sigma[0] + k->sigma[1] > 0)
        step.particles.drag = drag;
    const skv_solver_type *type = world->solver->type;
    assert_int_equal(type->reserve(world->solver, &step, NULL), SKV_OK);
    skv_impulse given = type->advance(world->solver, &step);
    const double s = (double)world->fluid.spacing, dt = (double)constants.dt;
    double scale = (double)world->fluid.density * s * s / dt;
    world->wall_impulse =
        (skv_wall_impulse){scale * given.x, scale * given.y, scale * given.moment};
}

static void check(const kind *k)
{
    skv_world *fast = make_world(k, SKV_SOLVER_FAST), *slow = make_world(k, SKV_SOLVER_REFERENCE);
    fill(k, fast);
    fill(k, slow);
    begin(k, fast);
    begin(k, slow);
    int64_t compared = 0, all = 0;
    for (int substep = 0; substep < SUBSTEPS; substep++) {
        follow(slow, fast);
        take_substep(k, fast);
        take_substep(k, slow);
        compared += expect_same(k, substep, fast, slow);
        expect_same_impulse(k, fast, slow);
        all += skv_world_particle_count(fast);
    }
    assert_true((double)compared > (k->images ? 0.5 : 0.95) * (double)all);
    if (k->open_sides) {
        skv_flow flow = skv_world_flow(fast), other = skv_world_flow(slow);
        assert_true(flow.emitted > 0 && flow.drained > 0 && flow.left > 0);
        assert_memory_equal(&flow, &other, sizeof flow);
    }
    skv_world_destroy(fast);
    skv_world_destroy(slow);
}

static void the_rows_do_what_the_reference_does(void **unused)
{
    (void)unused;
    for (int k = 0; k < KINDS; k++)
        check(&kinds[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rows_do_what_the_reference_does),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
