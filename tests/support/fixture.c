/* Worlds that several tests use. Invariant: they depend on their arguments alone. */
#include "support/fixture.h"

#include "base/bytes.h"
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

void fixture_add_liquids(skv_world_def *def, int count)
{
    for (int i = 0; i < count; i++) {
        skv_liquid *liquid = &def->liquids[def->liquid_count++];
        *liquid = skv_default_liquid();
        skv_format(liquid->name, sizeof liquid->name, "the %d.", def->liquid_count + 1);
    }
}

void fixture_mix_fluids(skv_world *world)
{
    int fluids = skv_world_frame(world).fluid_count;
    for (int i = 0; i < skv_world_particle_count(world); i++) {
        uint8_t fluid = (uint8_t)(i % fluids);
        assert_int_equal(skv_world_set_fluids(world, i, 1, &fluid, NULL), SKV_OK);
    }
}

skv_world_def fixture_def(skv_law law, skv_solver_kind solver, float viscosity, float spacing,
                          int threads)
{
    skv_world_def def = skv_default_world_def();
    def.fluid = skv_default_fluid_def(law);
    def.fluid.spacing = spacing;
    def.threads = threads;
    def.solver = solver;
    def.sleep = false;
    def.fluid.viscosity_linear = def.fluid.viscosity_quadratic = viscosity;
    return def;
}

static skv_world *make(const skv_world_def *def)
{
    skv_world *world;
    skv_error error;
    if (skv_world_create(def, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return world;
}

const skv_world_def *fixture_host(int threads)
{
    static skv_world_def host;
    host = skv_default_world_def();
    host.threads = threads;
    return &host;
}

int fixture_fill(skv_world *world, float x0, float y0, float x1, float y1)
{
    return fixture_fill_with(world, x0, y0, x1, y1, 0);
}

int fixture_fill_with(skv_world *world, float x0, float y0, float x1, float y1, int fluid)
{
    skv_fill_def def = skv_default_fill_def();
    def.x0 = x0;
    def.y0 = y0;
    def.x1 = x1;
    def.y1 = y1;
    def.fluid = fluid;
    skv_placed placed;
    skv_error error;
    if (skv_world_fill(world, &def, &placed, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return placed.added;
}

skv_world *fixture_tank(skv_law law, float spacing, int threads)
{
    skv_world_def def = fixture_def(law, SKV_SOLVER_FAST, 0, spacing, threads);
    return make(&def);
}

skv_world *fixture_tank_with(skv_law law, skv_solver_kind solver, float spacing)
{
    skv_world_def def = fixture_def(law, solver, 0, spacing, 1);
    return make(&def);
}

skv_world *fixture_dam_of(const skv_world_def *def)
{
    skv_world *world = make(def);
    fixture_fill(world, 0, 0, 0.4f, 0.7f);
    return world;
}

static skv_world *make_sleeping_pool(float spacing, int threads)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 2, spacing, threads);
    def.sleep = true;
    skv_world *world = make(&def);
    fixture_fill(world, 0, 0, 1.6f, 0.3f);
    for (int f = 0; f < 3600 && skv_world_awake_count(world) > 0; f++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    return world;
}

skv_world *fixture_sleeping_pool(float spacing, int threads)
{
    static skv_world *asleep; /* until another is wanted: it takes a second or two to fall asleep */
    if (!asleep || skv_world_spacing(asleep) != spacing || skv_world_threads(asleep) != threads) {
        skv_world_destroy(asleep);
        asleep = make_sleeping_pool(spacing, threads);
    }
    skv_world *copy;
    assert_int_equal(skv_world_copy(asleep, fixture_host(threads), &copy, NULL), SKV_OK);
    return copy;
}

skv_world *fixture_dam(skv_law law, float spacing, int threads)
{
    skv_world_def def = fixture_def(law, SKV_SOLVER_FAST, 0, spacing, threads);
    return fixture_dam_of(&def);
}

skv_world *fixture_blob(skv_law law, skv_solver_kind solver, float viscosity)
{
    skv_world_def def = fixture_def(law, solver, viscosity, 0.012f, 1);
    def.gravity_y = 0;
    skv_world *world = make(&def);
    fixture_fill(world, 0.7f, 0.35f, 0.9f, 0.55f);
    return world;
}

double fixture_wall_weight(double distance)
{
    return fmin(1, fmax(0, 1 - 0.5 * distance));
}

double fixture_wall_layer(const skv_world *world, double level)
{
    const skv_terrain *terrain = skv_world_terrain(world);
    float s = skv_world_spacing(world), top = (float)level - 3 * skv_world_smoothing_radius(world);
    skv_particles p = skv_world_particles(world);
    double particles = 0, points = 0;
    for (int i = 0; i < p.count; i++)
        if (p.y[i] < top)
            particles +=
                fixture_wall_weight((double)(skv_terrain_distance(terrain, p.x[i], p.y[i]) / s));
    const int parts = 8; /* sample points a spacing */
    float step = s / (float)parts;
    for (float y = 0.5f * step; y < top; y += step) {
        for (float x = 0.5f * step; x < skv_terrain_width(terrain); x += step) {
            float distance = skv_terrain_distance(terrain, x, y);
            points += distance > 0 ? fixture_wall_weight((double)(distance / s)) : 0;
        }
    }
    return particles * parts * parts / points;
}

void fixture_take_over(skv_world *slow, const skv_world *fast)
{
    skv_particles p = skv_world_particles(fast);
    for (int i = 0; i < p.count; i++)
        assert_int_equal(skv_world_add_particle(slow, p.x[i], p.y[i], p.vx[i], p.vy[i], NULL),
                         SKV_OK);
    if (p.fluid)
        assert_int_equal(skv_world_set_fluids(slow, 0, p.count, p.fluid, NULL), SKV_OK);
    memcpy(slow->state.warm_lambda, fast->state.warm_lambda, (size_t)p.count * sizeof(float));
    slow->load = fast->load;
    slow->substeps = fast->substeps;
}

void fixture_expect_same_particles(const skv_world *fast, const skv_world *slow, float dt)
{
    skv_particles p = skv_world_particles(fast), q = skv_world_particles(slow);
    assert_int_equal(p.count, q.count);
    double most = 2e-5 * (double)skv_world_smoothing_radius(fast);
    for (int i = 0; i < p.count; i++) {
        assert_true(hypot((double)(p.x[i] - q.x[i]), (double)(p.y[i] - q.y[i])) < most);
        assert_true(hypot((double)(p.vx[i] - q.vx[i]), (double)(p.vy[i] - q.vy[i])) <
                    most / (double)dt);
    }
}

void fixture_expect_same_substep(skv_world *fast, skv_world *slow)
{
    fixture_take_over(slow, fast);
    float dt = 1.0f / 60 / (float)skv_world_substeps_per_frame(fast);
    assert_int_equal(skv_world_step(fast, dt, NULL), SKV_OK);
    assert_int_equal(skv_world_step(slow, dt, NULL), SKV_OK);
    fixture_expect_same_particles(fast, slow, dt);
    skv_world_destroy(fast);
    skv_world_destroy(slow);
}

/* FNV-1a. */
uint64_t fixture_hash(const skv_particles *particles)
{
    const skv_particles *p = particles;
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < p->count; i++) {
        float values[] = {p->x[i], p->y[i], p->vx[i], p->vy[i]};
        uint8_t bytes[sizeof values];
        memcpy(bytes, values, sizeof values);
        for (size_t k = 0; k < sizeof bytes; k++)
            hash = (hash ^ bytes[k]) * 1099511628211u;
    }
    return hash;
}

skv_packing fixture_packing(const skv_world *world)
{
    skv_packing packing;
    assert_int_equal(skv_world_packing(world, &packing, NULL), SKV_OK);
    return packing;
}

skv_body_id fixture_add_body(skv_world *world, const skv_body_def *def)
{
    skv_body_id id;
    skv_error error = {0};
    if (skv_world_add_body(world, def, &id, NULL, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return id;
}

skv_world *fixture_shaft(float depth, bool sleep, int threads, skv_instruction_set set)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.025f, threads);
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = 160;
    terrain.height = 320;
    def.instruction_set = set;
    def.sleep = sleep;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    if (depth > 0)
        fixture_fill(world, 0, 0, 0.4f, depth);
    return world;
}

skv_body_id fixture_add_brick(skv_world *world, float x, float y, float density)
{
    skv_body_def brick = skv_default_body_def();
    brick.density = density;
    brick.x = x;
    brick.y = y;
    return fixture_add_body(world, &brick);
}

void fixture_add_stack(skv_world *world)
{
    for (int i = 0; i < FIXTURE_BRICKS; i++)
        fixture_add_brick(world, 0.2f, 0.0502f + (float)i * 0.1002f, 1900);
}

skv_body fixture_body(const skv_world *world, skv_body_id id)
{
    skv_body body;
    assert_true(skv_world_body(world, id, &body));
    return body;
}

void fixture_run(skv_world *world, int frames)
{
    for (int i = 0; i < frames; i++)
        assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
}

void fixture_assert_near(double actual, double expected, double tolerance, const char *file,
                         int line)
{
    if (fabs(actual - expected) <= tolerance)
        return;
    print_error("%.9g is not %.9g +- %.3g\n", actual, expected, tolerance);
    _fail(file, line);
}

skv_instrument fixture_instrument(skv_lab *lab, skv_instrument_kind kind, double window, double x0,
                                  double y0, double x1, double y1)
{
    skv_instrument_def def = skv_default_instrument_def(kind);
    def.x0 = x0;
    def.y0 = y0;
    def.x1 = x1;
    def.y1 = y1;
    def.window = window;
    skv_instrument id;
    assert_int_equal(skv_lab_add(lab, &def, &id, NULL), SKV_OK);
    return id;
}

fixture_saved fixture_save(const skv_world *world, bool with_terrain)
{
    fixture_saved saved = {.size = skv_world_snapshot_size(world, with_terrain)};
    saved.bytes = malloc(saved.size);
    assert_int_equal(skv_world_save(world, with_terrain, saved.bytes, saved.size, NULL), SKV_OK);
    return saved;
}

void fixture_expect_goes_on(skv_world *world, int frames)
{
    fixture_saved state = fixture_save(world, false), whole = fixture_save(world, true);
    skv_world *copy, *loaded;
    assert_int_equal(skv_world_copy(world, fixture_host(2), &copy, NULL), SKV_OK);
    assert_int_equal(skv_world_load(whole.bytes, whole.size, fixture_host(1), &loaded, NULL),
                     SKV_OK);
    assert_true(skv_world_hash(copy) == skv_world_hash(world));
    fixture_run(world, frames);
    fixture_run(copy, frames);
    fixture_run(loaded, frames);
    uint64_t hash = skv_world_hash(world);
    assert_true(skv_world_hash(copy) == hash);
    assert_true(skv_world_hash(loaded) == hash);
    assert_int_equal(skv_world_restore(world, state.bytes, state.size, NULL), SKV_OK);
    fixture_run(world, frames);
    assert_true(skv_world_hash(world) == hash);
    skv_world_destroy(copy);
    skv_world_destroy(loaded);
    free(state.bytes);
    free(whole.bytes);
}

void fixture_seal(fixture_saved saved)
{
    enum { CHECKSUM_AT = 24 };
    uint64_t sum = skv_hash_bytes(SKV_HASH_BEGIN, saved.bytes, CHECKSUM_AT);
    sum = skv_hash_bytes(sum, saved.bytes + CHECKSUM_AT + 8, saved.size - CHECKSUM_AT - 8);
    skv_put(&(skv_writer){saved.bytes, CHECKSUM_AT}, sum, 8);
}

static uint64_t hash_after(fixture_run_of *run, int threads, skv_instruction_set set)
{
    skv_world *world = run(threads, set);
    uint64_t hash = skv_world_hash(world);
    skv_world_destroy(world);
    return hash;
}

void fixture_expect_same_bits(fixture_run_of *run)
{
    uint64_t hash = hash_after(run, 1, SKV_ISA_BEST);
    assert_true(hash_after(run, 3, SKV_ISA_BEST) == hash);
    assert_true(hash_after(run, 2, SKV_ISA_SCALAR) == hash);
    if (long_tests()) {
        assert_true(hash_after(run, 5, SKV_ISA_BEST) == hash);
        assert_true(hash_after(run, 1, SKV_ISA_SCALAR) == hash);
    }
}
