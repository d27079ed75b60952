/* A world's lifetime and its plain setters and getters.
 *
 * Invariant: state.count <= capacity, and all particle arrays lie in one block, so growing either
 * succeeds as a whole or leaves the world as it was.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "base/memory.h"
#include "world/frame.h"

#include <math.h>
#include <string.h>

/* Substeps are given back when less than this share of them is needed. */
#define SPARE_SUBSTEPS (2.0f / 3)

/* Addresses of the state's float arrays, for allocating and moving them alike. */
enum { FLOAT_ARRAYS = 26 };

static void float_arrays(skv_world *world, float **arrays[FLOAT_ARRAYS])
{
    skv_state *s = &world->state;
    float **list[FLOAT_ARRAYS] = {
        &s->x,
        &s->y,
        &s->vx,
        &s->vy,
        &s->wx,
        &s->wy,
        &s->dx,
        &s->dy,
        &s->density,
        &s->near_density,
        &s->gradient_x,
        &s->gradient_y,
        &s->push,
        &s->near_push,
        &s->pressure,
        &s->wall_near,
        &s->f1x,
        &s->wall_density,
        &s->f1y,
        &s->f2x,
        &s->f2y,
        &s->clearance,
        &s->normal_x,
        &s->normal_y,
        &world->sleep.anchor_x,
        &world->sleep.anchor_y,
    };
    memcpy(arrays, list, sizeof list);
}

skv_result skv_world_reserve(skv_world *world, int count, skv_error *error)
{
    if (count <= world->capacity)
        return SKV_OK;
    if (count > SKV_MAX_PARTICLES)
        return skv_fail(error, SKV_ERROR_LIMIT, "%d particles are too many; at most %d are allowed",
                        count, SKV_MAX_PARTICLES);
    int capacity = count > world->capacity * 2 ? count : world->capacity * 2;
    if (capacity > SKV_MAX_PARTICLES)
        capacity = SKV_MAX_PARTICLES;
    /* Arrays that start at the same offset in a page fight for the same cache sets: an odd number
     * of cache lines between them spreads them out. */
    size_t stride = (((size_t)capacity + 15) / 16 | 1) * 16;
    size_t arrays_total = FLOAT_ARRAYS + 4; /* depth, id, unrest and members besides */
    float *block = skv_calloc(stride * arrays_total, sizeof *block);
    if (!block)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
    float **arrays[FLOAT_ARRAYS];
    float_arrays(world, arrays);
    size_t used = (size_t)world->state.count * sizeof(float);
    for (int i = 0; i < FLOAT_ARRAYS; i++) {
        float *array = block + stride * (size_t)i;
        if (used)
            memcpy(array, *arrays[i], used);
        *arrays[i] = array;
    }
    float *rest = block + stride * FLOAT_ARRAYS;
    uint32_t *id = (uint32_t *)(void *)(rest + stride);
    int *unrest = (int *)(void *)(rest + 2 * stride);
    if (used) {
        memcpy(id, world->state.id, used);
        memcpy(unrest, world->sleep.unrest, used);
    }
    world->state.depth = rest;
    world->state.id = id;
    world->sleep.unrest = unrest;
    world->sleep.members = (int *)(void *)(rest + 3 * stride);
    skv_free(world->block);
    world->block = block;
    world->capacity = capacity;
    return SKV_OK;
}

void skv_world_append(skv_world *world, float x, float y, float vx, float vy)
{
    skv_state *s = &world->state;
    int i = s->count++;
    s->x[i] = x;
    s->y[i] = y;
    s->vx[i] = vx;
    s->vy[i] = vy;
    s->pressure[i] = 0;
    s->clearance[i] = 0;
    s->id[i] = world->next_id++;
    world->sleep.anchor_x[i] = x;
    world->sleep.anchor_y[i] = y;
    world->sleep.unrest[i] = SKV_NEWLY_RESTLESS;
    world->sleep.stepped++;
    world->lists_current = false;
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
    const skv_terrain *terrain = world->terrain;
    float width = skv_terrain_width(terrain), height = skv_terrain_height(terrain);
    float margin = 2 * world->h;
    skv_result result = get_pool(world, def, error);
    if (result == SKV_OK)
        result = skv_wall_map_create(terrain, world->h, world->fluid.spacing,
                                     skv_law_kernel(world->fluid.law), &world->walls, error);
    if (result == SKV_OK)
        result = skv_wall_map_shade(world->walls, terrain, error);
    if (result == SKV_OK && world->solver == SKV_SOLVER_REFERENCE)
        result = skv_neighbours_create(&world->neighbours, -margin, -margin, width + margin,
                                       height + margin, world->h, error);
    if (result == SKV_OK && world->solver == SKV_SOLVER_REFERENCE)
        skv_cut_pairs_at_walls(world, &world->neighbours);
    if (result == SKV_OK && world->solver == SKV_SOLVER_FAST) {
        /* Rows lie across the longer side: the more rows, the more evenly threads share them. */
        world->rows_swapped = width > height;
        float along = world->rows_swapped ? height : width;
        float across = world->rows_swapped ? width : height;
        float per_square = world->fluid.radius_ratio * world->fluid.radius_ratio;
        result =
            skv_rows_create(along / world->h, across / world->h, per_square, &world->rows, error);
    }
    if (result == SKV_OK)
        result = skv_sleep_create(world, def->sleep && world->solver == SKV_SOLVER_FAST, error);
    if (result == SKV_OK && def->capacity > 0)
        result = skv_world_reserve(world, def->capacity, error);
    return result;
}

/* How far the free region goes along gravity, m. */
static float extent_along_gravity(const skv_world *world)
{
    float gx = world->gravity_x, gy = world->gravity_y, lowest, highest;
    float size = sqrtf(gx * gx + gy * gy);
    skv_terrain_free_range(world->terrain, &lowest, &highest);
    if (!(size > 0))
        return highest - lowest;
    return (fabsf(gx) * skv_terrain_width(world->terrain) + fabsf(gy) * (highest - lowest)) / size;
}

static int substeps_needed(const skv_world *world)
{
    float gx = world->gravity_x, gy = world->gravity_y;
    return skv_substep_rule(&world->fluid, sqrtf(gx * gx + gy * gy),
                            world->filled * extent_along_gravity(world));
}

/* Follows the gravity that has been set. The pressure of a fluid at rest is its excess of density
 * over dt^2: where g dt^2 stays, so does the fluid. Fewer substeps only if a good part can be
 * spared, so that a gravity that trembles does not change them to and fro. */
static void adapt_substeps(skv_world *world)
{
    if (world->substeps_fixed)
        return;
    int needed = substeps_needed(world);
    if (needed <= world->substeps && (float)needed > SPARE_SUBSTEPS * (float)world->substeps)
        return;
    world->due *= (double)needed / world->substeps;
    world->substeps = needed;
}

skv_result skv_world_create(const skv_world_def *def, skv_world **out, skv_error *error)
{
    SKV_ASSERT_OR(def && out, SKV_ERROR_VALUE);
    *out = NULL;
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
        world->fluid = def->fluid;
        world->solver = def->solver;
        world->gravity_x = def->gravity_x;
        world->gravity_y = def->gravity_y;
        world->h = def->fluid.spacing * def->fluid.radius_ratio;
        float pixel = skv_terrain_pixel_size(world->terrain);
        world->wall_clearance = skv_minf(0.1f * def->fluid.spacing, 0.5f * pixel);
        float extent = extent_along_gravity(world);
        world->filled = def->depth > 0 ? def->depth / extent : 1;
        world->substeps = def->substeps;
        world->substeps_fixed = def->substeps > 0;
        if (!world->substeps_fixed)
            world->substeps = substeps_needed(world);
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
    if (!world)
        return;
    if (!world->shares_pool)
        skv_pool_destroy(world->pool);
    skv_sleep_destroy(world);
    skv_neighbours_destroy(&world->neighbours);
    skv_rows_destroy(world->rows);
    skv_wall_map_destroy(world->walls);
    skv_terrain_destroy(world->terrain);
    skv_free(world->block);
    skv_free(world);
}

skv_hand skv_default_hand(void)
{
    return (skv_hand){.radius = 0.15f, .attraction = 60, .friction = 6, .follow = 6};
}

skv_result skv_world_set_hands(skv_world *world, const skv_hand *hands, int count, skv_error *error)
{
    SKV_ASSERT_OR(world && (hands || count == 0), SKV_ERROR_VALUE);
    if (count < 0 || count > SKV_MAX_HANDS)
        return skv_fail(error, SKV_ERROR_LIMIT, "%d hands; allowed is 0..%d", count, SKV_MAX_HANDS);
    for (int i = 0; i < count; i++) {
        const skv_hand *h = &hands[i];
        if (!skv_within((double)h->x, -1000, 1000) || !skv_within((double)h->y, -1000, 1000) ||
            !skv_within((double)h->vx, -1000, 1000) || !skv_within((double)h->vy, -1000, 1000))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "hand %d: position or velocity is not finite or beyond 1000 m or m/s",
                            i);
        if (!skv_within((double)h->radius, 1e-6, 100) ||
            !skv_within((double)h->attraction, -10000, 10000) ||
            !skv_within((double)h->friction, 0, 10000) || !skv_within((double)h->follow, 0, 10000))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "hand %d: radius (0..100 m], attraction +-10000 m/s^2, friction and "
                            "follow 0..10000 1/s are allowed",
                            i);
    }
    if (count)
        memcpy(world->hands, hands, (size_t)count * sizeof *hands);
    world->hand_count = count;
    return SKV_OK;
}

skv_result skv_world_set_gravity(skv_world *world, float gx, float gy, skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!skv_within((double)gx, -1000, 1000) || !skv_within((double)gy, -1000, 1000))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "gravity: (%g, %g) is out of range; allowed is -1000..1000 m/s^2",
                        (double)gx, (double)gy);
    if (gx != world->gravity_x || gy != world->gravity_y)
        skv_sleep_wake_all(world);
    world->gravity_x = gx;
    world->gravity_y = gy;
    adapt_substeps(world);
    return SKV_OK;
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
    return world->sleep.stepped;
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

skv_particles skv_world_particles(const skv_world *world)
{
    SKV_ASSERT_OR(world, (skv_particles){0});
    const skv_state *s = &world->state;
    return (skv_particles){s->count, s->x, s->y, s->vx, s->vy, s->pressure, s->id};
}
