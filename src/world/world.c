/* A world's lifetime and its plain setters and getters. Invariant: here alone it is known that
 * there are several solvers. */
#include "base/assert.h"
#include "base/defs.h"
#include "base/exact.h"
#include "base/memory.h"
#include "skvalp/frame.h"
#include "world/air/air.h"
#include "world/bodies/bodies.h"
#include "world/fluids.h"
#include "world/parameters.h"
#include "world/springs/springs.h"
#include "world/world_internal.h"

skv_result skv_world_reserve(skv_world *world, int count, skv_error *error)
{
    int before = world->state.capacity;
    skv_result result = skv_state_reserve(&world->state, count, error);
    if (result == SKV_OK && world->state.capacity > before) {
        world->array_moves++;
        if (before &&
            world->busy != SKV_AT_WORK) /* what emitters need is not for the host to know */
            skv_world_say(world,
                          "the room for %d particles had to grow to %d; a larger capacity in the "
                          "definition spares that",
                          before, world->state.capacity);
    }
    return result;
}

skv_result skv_world_admit_fluids(skv_world *world, skv_error *error)
{
    if (world->state.several)
        return SKV_OK;
    skv_result result = skv_state_admit_fluids(&world->state, error);
    world->array_moves += result == SKV_OK;
    return result;
}

void skv_world_revise(skv_world *world)
{
    if (++world->revision == 0)
        world->revision = 1;
}

void skv_world_append(skv_world *world, float x, float y, float vx, float vy, int dye, int fluid)
{
    skv_state *s = &world->state;
    int i = s->count++;
    s->x[i] = x;
    s->y[i] = y;
    s->vx[i] = vx;
    s->vy[i] = vy;
    s->pressure[i] = 0;
    s->warm_lambda[i] = 0;
    s->clearance[i] = 0;
    s->id[i] = world->next_id++;
    s->anchor_x[i] = x;
    s->anchor_y[i] = y;
    s->unrest[i] = SKV_NEWLY_RESTLESS;
    s->dye[i] = (uint8_t)dye;
    if (s->several) {
        s->fluid[i] = (uint8_t)fluid;
        s->mass[i] = skv_mass_of(world, fluid);
        s->drag[i] = skv_drag_of(world, fluid);
    }
    world->sleep.stepped++;
    skv_world_revise(world);
}

static skv_result get_pool(skv_world *world, const skv_world_def *def, skv_error *error)
{
    world->shares_pool = def->pool != NULL;
    world->pool = def->pool;
    if (def->pool)
        return SKV_OK;
    return def->tasks.run ? skv_pool_create_lent(&def->tasks, &world->pool, error)
                          : skv_pool_create(def->threads, &world->pool, error);
}

static skv_result build(skv_world *world, const skv_world_def *def, skv_error *error)
{
    static const skv_solver_type *const types[] = {
        [SKV_SOLVER_FAST] = &skv_rows_solver,
        [SKV_SOLVER_REFERENCE] = &skv_reference_solver,
    };
    const skv_terrain *terrain = world->terrain;
    const skv_solver_type *type = types[def->solver];
    skv_result result = get_pool(world, def, error);
    if (result == SKV_OK)
        result = skv_wall_map_create(terrain, world->h, world->fluid.spacing,
                                     skv_law_kernel(world->fluid.law), world->pool, &world->walls,
                                     error);
    if (result == SKV_OK)
        result = skv_wall_map_shade(world->walls, terrain, world->pool, error);
    if (result == SKV_OK && skv_has_images(&world->fluid))
        result = skv_wall_map_add_images(world->walls, terrain, world->pool, error);
    if (result == SKV_OK) {
        const skv_fluid_def *fluid = &world->fluid;
        float pixel = skv_terrain_pixel_size(terrain);
        world->boundary = (skv_boundary){
            .terrain = terrain,
            .walls = world->walls,
            .margin = skv_minf(0.1f * fluid->spacing, 0.5f * pixel),
            .contact_distance = skv_contact_distance(fluid),
            .unit = 1,
            .per_unit = 1,
        };
        const skv_solver_def solver = {
            .x1 = skv_terrain_width(terrain),
            .y1 = skv_terrain_height(terrain),
            .h = world->h,
            .instruction_set = def->instruction_set,
            .per_square = fluid->radius_ratio * fluid->radius_ratio,
            .boundary = &world->boundary,
        };
        result = type->create(&solver, &world->solver, error);
    }
    if (result == SKV_OK)
        result = skv_sleep_create(world, def->sleep && type->holds, error);
    if (result == SKV_OK)
        result = skv_load_create(world, error);
    if (result == SKV_OK && def->liquid_count > 0)
        result = skv_world_admit_fluids(world, error);
    if (result == SKV_OK && def->capacity > 0)
        result = skv_world_reserve(world, def->capacity, error);
    return result;
}

const char *skv_instruction_set_name(skv_instruction_set set)
{
    SKV_ASSERT_OR(set >= SKV_ISA_BEST && set <= SKV_ISA_WASM, NULL);
    return skv_rows_instruction_set(set);
}

skv_result skv_world_create(const skv_world_def *def, skv_world **out, skv_error *error)
{
    SKV_ASSERT_OR(def && out, SKV_ERROR_VALUE);
    *out = NULL;
    skv_world_def own;
    SKV_ASSERT_INITIALISED(def, skv_open_world_def(def, &own), SKV_ERROR_VALUE);
    skv_result result = skv_check_world_def(def, error);
    if (result != SKV_OK)
        return result;
    skv_world *world = skv_calloc(1, sizeof *world);
    if (!world)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a world");
    world->terrain = def->terrain;
    if (!world->terrain) {
        skv_terrain_def tank = skv_default_terrain_def();
        result = skv_terrain_create(&tank, &world->terrain, error);
    }
    if (result == SKV_OK) {
        world->revision = 1;
        world->log = def->log;
        world->log_user = def->log_user;
        world->fluid = def->fluid;
        skv_world_put_liquids(world, def);
        world->gravity_x = def->gravity_x;
        world->gravity_y = def->gravity_y;
        world->depth = def->depth;
        skv_world_put_emission(world, def);
        world->h = def->fluid.spacing * def->fluid.radius_ratio;
        float extent = skv_extent_along_gravity(world);
        world->filled = def->depth > 0 ? def->depth / extent : 1;
        world->substeps_fixed = def->substeps > 0;
        skv_load_begin(world, world->substeps_fixed ? def->substeps : skv_substeps_needed(world));
        world->tiling = skv_make_tiling(world->h, skv_terrain_width(world->terrain),
                                        skv_terrain_height(world->terrain));
        result = build(world, def, error);
    }
    if (result != SKV_OK) {
        if (def->terrain)
            world->terrain = NULL; /* stays the caller's */
        skv_world_destroy(world);
        return result;
    }
    *out = world;
    return SKV_OK;
}

void skv_world_destroy(skv_world *world)
{
    SKV_ASSERT(!world || skv_may_step(world));
    if (!world)
        return;
    if (!world->shares_pool)
        skv_pool_destroy(world->pool);
    skv_sleep_destroy(world);
    skv_load_destroy(world);
    skv_bodies_destroy(world->bodies);
    skv_springs_destroy(world->springs);
    skv_air_destroy(world->air);
    if (world->solver)
        world->solver->type->destroy(world->solver);
    skv_wall_map_destroy(world->walls);
    skv_terrain_destroy(world->terrain);
    skv_state_free(&world->state);
    skv_free(world->events.list);
    skv_free(world);
}

int skv_world_particle_count(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->state.count;
}

int skv_world_substeps_per_frame(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->substeps;
}

int skv_world_threads(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return skv_pool_threads(world->pool);
}

double skv_world_time(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->time;
}

int64_t skv_world_substep_count(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->steps;
}

int skv_world_awake_count(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    int restless = world->state.count - world->sleep.calm;
    return skv_bodies_awake(world) +
           (restless > world->sleep.stepped ? restless : world->sleep.stepped);
}

float skv_world_spacing(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->fluid.spacing;
}

float skv_world_smoothing_radius(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->h;
}

const skv_fluid_def *skv_world_fluid(const skv_world *world)
{
    SKV_ASSERT_OR(world, NULL);
    return &world->fluid;
}

void skv_world_gravity(const skv_world *world, float *gx, float *gy)
{
    SKV_ASSERT_OR(world && gx && gy, );
    *gx = world->gravity_x;
    *gy = world->gravity_y;
}

const skv_terrain *skv_world_terrain(const skv_world *world)
{
    SKV_ASSERT_OR(world, NULL);
    return world->terrain;
}

uint32_t skv_world_revision(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->revision + world->array_moves;
}

skv_particles skv_world_particles(const skv_world *world)
{
    SKV_ASSERT_OR(world, (skv_particles){0});
    const skv_state *s = &world->state;
    return (skv_particles){.count = s->count,
                           .x = s->x,
                           .y = s->y,
                           .vx = s->vx,
                           .vy = s->vy,
                           .pressure = s->pressure,
                           .clearance = s->clearance,
                           .id = s->id,
                           .dye = s->dye,
                           .fluid = s->fluid};
}

skv_frame skv_world_frame(const skv_world *world)
{
    SKV_ASSERT_OR(world, (skv_frame){0});
    return (skv_frame){
        .time = skv_world_time(world),
        .particles = skv_world_particles(world),
        .awake = skv_world_awake_count(world),
        .terrain = world->terrain,
        .spacing = world->fluid.spacing,
        .smoothing_radius = world->h,
        .density = world->fluid.density,
        .gravity_x = world->gravity_x,
        .gravity_y = world->gravity_y,
        .fluids = world->liquids,
        .fluid_count = world->fluid_count,
        .bodies = world->bodies ? world->bodies->shown : NULL,
        .body_count = skv_world_has_bodies(world),
    };
}
