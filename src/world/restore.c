/* Worlds from snapshots. Invariant: a world changes only after everything that can fail has
 * succeeded. */
#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "terrain/terrain.h"
#include "world/air/air.h"
#include "world/bodies/bodies.h"
#include "world/fluids.h"
#include "world/liquids.h"
#include "world/parameters.h"
#include "world/snapshot.h"
#include "world/springs/springs.h"

/* What a world was built around. The rest can change while it runs, and comes with the snapshot. */
static const skv_parameter fixed[] = {SKV_P_SOLVER,
                                      SKV_P_SLEEP,
                                      SKV_P_FLUID_LAW,
                                      SKV_P_FLUID_SPACING,
                                      SKV_P_FLUID_RADIUS_RATIO,
                                      SKV_P_FLUID_WALL_IMAGES};

static skv_result check_match(const skv_world *world, const skv_snapshot *s, skv_error *error)
{
    skv_world_def own = skv_world_describe(world);
    if (s->terrain_hash != world->terrain->hash)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "snapshot: it is of a world with another terrain; make the world with the "
                        "same picture");
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++) {
        double theirs = skv_parameter_load(&s->def, fixed[i]);
        double ours = skv_parameter_load(&own, fixed[i]);
        if (theirs != ours)
            return skv_fail(error, SKV_ERROR_VALUE,
                            "snapshot: %s is %.9g there and %.9g here; make the world with the "
                            "same",
                            skv_world_field((int)fixed[i])->path, theirs, ours);
    }
    return SKV_OK;
}

/* Takes over all that a snapshot says of a world's future but its particles. */
static void take_facts(skv_world *world, const skv_snapshot *s)
{
    skv_world_put_fluid(world, &s->def.fluid, s->ramp);
    skv_world_put_liquids(world, &s->def);
    world->gravity_x = s->def.gravity_x;
    world->gravity_y = s->def.gravity_y;
    world->depth = s->def.depth;
    world->compression = s->compression;
    skv_world_put_emission(world, &s->def);
    world->substeps = s->def.substeps;
    world->substeps_fixed = s->substeps_fixed;
    world->load = s->load;
    world->filled = s->filled;
    world->due = s->due;
    world->time = s->time;
    world->steps = s->steps;
    world->next_id = s->next_id;
    world->acting = s->acting;
    world->wall_impulse = (skv_wall_impulse){0};
    world->events.count = 0;
    world->events.dropped = 0;
}

static void take_sleep(skv_world *world, const skv_snapshot *s)
{
    skv_sleep *sleep = &world->sleep;
    sleep->watched = s->watched;
    sleep->stepped = s->stepped;
    sleep->calm = 0;
    for (int i = 0; i < s->count; i++)
        sleep->calm += world->state.unrest[i] == SKV_CALM;
}

static skv_result put_state(skv_world *world, const skv_snapshot *s, skv_error *error)
{
    skv_result result = skv_world_reserve(world, s->count, error);
    if (result == SKV_OK && s->with_fluids)
        result = skv_world_admit_fluids(world, error);
    skv_bodies *bodies = NULL;
    if (result == SKV_OK && s->with_bodies)
        result = skv_bodies_load(world, s->bodies, s->with_touches, &bodies, error);
    skv_springs *springs = NULL;
    if (result == SKV_OK && (s->liquid_extras & SKV_WITH_SPRINGS))
        result = skv_springs_load(s->springs, &springs, error);
    skv_air *air = NULL;
    if (result == SKV_OK && s->with_air)
        result = skv_air_load(world, s->air, &air, error);
    if (result != SKV_OK) {
        skv_springs_destroy(springs);
        skv_bodies_destroy(bodies);
        return result;
    }
    skv_bodies_take_over(world, bodies);
    skv_springs_take_over(world, springs);
    skv_air_take_over(world, air);
    skv_snapshot_particles(s, &world->state);
    take_facts(world, s);
    take_sleep(world, s);
    skv_world_revise(world);
    return SKV_OK;
}

skv_result skv_world_restore(skv_world *world, const void *data, size_t size, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world) && data, SKV_ERROR_VALUE);
    skv_snapshot snapshot;
    skv_result result = skv_snapshot_read(data, size, &snapshot, error);
    if (result == SKV_OK)
        result = check_match(world, &snapshot, error);
    return result == SKV_OK ? put_state(world, &snapshot, error) : result;
}

/* Makes the world that a snapshot is of; takes over the terrain in any case. */
static skv_result build(const skv_snapshot *s, skv_terrain *terrain, const skv_world_def *host,
                        skv_world **world, skv_error *error)
{
    skv_world_def def = s->def;
    def.terrain = terrain;
    def.threads = host->threads;
    def.pool = host->pool;
    def.tasks = host->tasks;
    def.instruction_set = host->instruction_set;
    def.capacity = host->capacity;
    def.log = host->log;
    def.log_user = host->log_user;
    skv_result result = skv_world_create(&def, world, error);
    if (result != SKV_OK) {
        skv_terrain_destroy(terrain);
        return result;
    }
    result = check_match(*world, s, error);
    if (result == SKV_OK)
        result = put_state(*world, s, error);
    if (result != SKV_OK) {
        skv_world_destroy(*world);
        *world = NULL;
    }
    return result;
}

static skv_result build_terrain(const skv_snapshot *s, skv_terrain **terrain, skv_error *error)
{
    skv_terrain_def def = s->terrain;
    uint8_t *coverage = skv_calloc((size_t)def.width * (size_t)def.height, 1);
    if (!coverage)
        return skv_fail(error, SKV_ERROR_MEMORY, "snapshot: no memory for its terrain");
    def.coverage = coverage;
    skv_result result = SKV_OK;
    if (!skv_snapshot_picture(s, coverage))
        result = skv_fail(error, SKV_ERROR_FORMAT, "snapshot: its terrain's picture is damaged");
    if (result == SKV_OK)
        result = skv_terrain_create(&def, terrain, error);
    skv_free(coverage);
    return result;
}

/* What is the host's of a definition; the default for null. Null if it was not initialised. */
static const skv_world_def *open_host(const skv_world_def *host, skv_world_def *own)
{
    *own = skv_default_world_def();
    return host ? skv_open_world_def(host, own) : own;
}

skv_result skv_world_load(const void *data, size_t size, const skv_world_def *host,
                          skv_world **world, skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    *world = NULL;
    SKV_ASSERT_OR(data, SKV_ERROR_VALUE);
    skv_world_def own;
    SKV_ASSERT_INITIALISED(host, open_host(host, &own), SKV_ERROR_VALUE);
    skv_snapshot snapshot;
    skv_result result = skv_snapshot_read(data, size, &snapshot, error);
    if (result != SKV_OK)
        return result;
    if (!snapshot.with_terrain)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "snapshot: it holds no terrain; save it with one, or restore it into its "
                        "world");
    skv_terrain *terrain = NULL;
    result = build_terrain(&snapshot, &terrain, error);
    return result == SKV_OK ? build(&snapshot, terrain, host, world, error) : result;
}

skv_result skv_world_copy(const skv_world *world, const skv_world_def *host, skv_world **copy,
                          skv_error *error)
{
    SKV_ASSERT_OR(copy, SKV_ERROR_VALUE);
    *copy = NULL;
    SKV_ASSERT_OR(skv_may_step(world), SKV_ERROR_VALUE);
    skv_world_def own;
    SKV_ASSERT_INITIALISED(host, open_host(host, &own), SKV_ERROR_VALUE);
    size_t size = skv_world_snapshot_size(world, false);
    uint8_t *bytes = skv_calloc(size, 1);
    if (!bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a copy of a world");
    skv_snapshot snapshot;
    skv_result result = skv_world_save(world, false, bytes, size, error);
    if (result == SKV_OK)
        result = skv_snapshot_read(bytes, size, &snapshot, error);
    if (result == SKV_OK)
        result = build(&snapshot, skv_terrain_share(world->terrain), host, copy, error);
    skv_free(bytes);
    return result;
}
