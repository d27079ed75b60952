/* How many substeps a frame takes: by the load that is there, not the greatest that may come.
 *
 * What substeps must carry is the greatest mean of p/rho + v^2/2 of all tiles; in a still pool that
 * is g times its depth, as the rule of docs/model.md expects. Most of the time water is shallower
 * and slower than that, and fewer substeps compress it no more. More are taken at once, fewer after
 * a look at the loads since the last one.
 *
 * The pressure of fluid at rest is its excess of density over dt^2: with another number of substeps
 * it would find itself too dense or too loose, and breathe. So the stiffness moves in small steps,
 * and a substep's pressure is made as stiff: weaker, or with a warm start. Invariant: the fluid is
 * never stiffer than its substeps allow; all of this follows from the particles alone, in their
 * order.
 */
#include "calm/load.h"

#include "base/exact.h"
#include "base/memory.h"
#include "world/air/air.h"
#include "world/fluids.h"
#include "world/world_internal.h"

#include <math.h>
#include <string.h>

#define EARTH_GRAVITY 9.81
#define FRAMES        60    /* a second: how often loads are measured */
#define LOOKS         4     /* a second */
#define ROUNDING      1e-6  /* of a sum of substeps, relative to what is between two looks */
#define MOST_LOAD     1e12f /* m^2/s^2: of what has blown up; a snapshot holds it */
/* Of the rule's substeps: given back when less is needed. Fewer changes, and a gravity that
 * trembles would change them to and fro. */
#define SPARE_SUBSTEPS (2.0f / 3)
#define MARGIN         1.2f   /* that fewer substeps must have: waves come back */
#define SOFTER         0.995f /* a frame: a pool of 0.45 m then sinks at 0.01 m/s */
#define STIFFER        1.1f   /* a frame */
#define FULL_SHARE     0.25f  /* of a tile: fewer particles press on little */

double skv_load_of_depth(float gravity, float depth, float head)
{
    double g = (double)gravity > EARTH_GRAVITY ? (double)gravity : EARTH_GRAVITY;
    return g * (double)depth + (double)head;
}

static float gravity_of(const skv_world *world)
{
    float x = world->gravity_x, y = world->gravity_y;
    return sqrtf(x * x + y * y);
}

/* Clavet's fluid is another one with substeps of another length, and keeps them. */
static bool is_followed(const skv_world *world)
{
    return !world->substeps_fixed && world->fluid.law == SKV_LAW_CALIBRATED;
}

/* Takes what is as stiff as so many of the rule's substeps. */
static void take(skv_world *world, int cold)
{
    int substeps = skv_world_warm_substeps(world, cold);
    world->due *= (double)substeps / world->substeps;
    world->substeps = substeps;
}

void skv_load_begin(skv_world *world, int substeps)
{
    world->load = (skv_load){.most = substeps, .wanted = substeps, .stiffness = (float)substeps};
    world->substeps = world->substeps_fixed ? substeps : skv_world_warm_substeps(world, substeps);
}

float skv_load_stiffness(const skv_world *world)
{
    return world->load.stiffness / (float)world->substeps;
}

/* A tile's particles, added up. */
struct skv_tile_load {
    float load;
    int count;
};

skv_result skv_load_create(skv_world *world, skv_error *error)
{
    world->tile_loads =
        skv_calloc((size_t)skv_tile_count(&world->tiling), sizeof *world->tile_loads);
    return world->tile_loads ? SKV_OK
                             : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for loads");
}

void skv_load_destroy(skv_world *world)
{
    skv_free(world->tile_loads);
}

/* The greatest load that there is. */
static float measure(const skv_world *world)
{
    const skv_state *p = &world->state;
    const skv_tiling *tiling = &world->tiling;
    skv_tile_load *tiles = world->tile_loads;
    int count = skv_tile_count(tiling);
    memset(tiles, 0, (size_t)count * sizeof *tiles);
    float volume = 1 / world->fluid.density;
    const float *masses = skv_world_masses(world);
    for (int i = 0; i < p->count; i++) {
        skv_tile_load *tile = &tiles[skv_tile_number(tiling, p->x[i], p->y[i])];
        float squared = p->vx[i] * p->vx[i] + p->vy[i] * p->vy[i];
        float pressure = masses ? p->pressure[i] / masses[i] : p->pressure[i];
        tile->load += volume * pressure + 0.5f * squared;
        tile->count++;
    }
    float across = SKV_TILE_SIZE * world->fluid.radius_ratio, few = FULL_SHARE * across * across;
    float most = (float)skv_load_of_depth(gravity_of(world), world->h, 0);
    most = skv_maxf(most, skv_emitted_head(&world->acting));
    for (int t = 0; t < count; t++)
        if (tiles[t].count > 0)
            most = skv_maxf(most, tiles[t].load / skv_maxf((float)tiles[t].count, few));
    if (world->air)
        most += volume * (float)world->air->lift;
    return most < MOST_LOAD ? most : MOST_LOAD; /* also of what is no number */
}

/* Sees to it that a load is borne; the fluid becomes as stiff by and by. */
static void bear(skv_world *world, float load)
{
    skv_load *l = &world->load;
    l->peak = skv_maxf(l->peak, load);
    if (l->wanted == l->most)
        return;
    int needed = skv_world_substep_rule(world, (double)load);
    if (needed > l->wanted)
        l->wanted = needed < l->most ? needed : l->most;
    if (skv_world_warm_substeps(world, l->wanted) > world->substeps)
        take(world, l->wanted);
}

/* What is as dense and another time as stiff has been pushed that much more. */
static void stiffen(skv_world *world, float stiffness)
{
    float times = stiffness / world->load.stiffness;
    world->load.stiffness = stiffness;
    for (int i = 0; times != 1 && i < world->state.count; i++)
        world->state.warm_lambda[i] *= times * times;
}

/* At once, and the stiffness too: where g dt^2 stays, so does the fluid. */
void skv_load_expect(skv_world *world, int needed)
{
    skv_load *l = &world->load;
    int before = l->most;
    if (needed <= before && (float)needed > SPARE_SUBSTEPS * (float)before)
        return;
    bool at_most = l->wanted == before;
    l->most = needed;
    if (needed > before && !at_most && is_followed(world)) {
        float times = (float)needed / (float)before;
        bear(world, measure(world) * times * times);
        stiffen(world, skv_minf(l->stiffness * times, (float)l->wanted));
        return;
    }
    l->wanted = at_most || l->wanted > needed ? needed : l->wanted;
    take(world, l->wanted);
    stiffen(world, (float)l->wanted);
}

/* The added fluid is as deep as it reaches along gravity, and a weight that is put down at once
 * presses twice. */
void skv_load_add(skv_world *world, int count)
{
    const skv_state *p = &world->state;
    if (!is_followed(world) || world->load.wanted == world->load.most)
        return;
    float lowest = INFINITY, highest = -INFINITY;
    for (int i = p->count - count; i < p->count; i++) {
        float height = p->x[i] * world->gravity_x + p->y[i] * world->gravity_y;
        lowest = skv_minf(lowest, height);
        highest = skv_maxf(highest, height);
    }
    /* One by one they weigh little, and would be measured as often. */
    if (highest > lowest)
        bear(world, measure(world) + 2 * (highest - lowest));
}

void skv_load_rest(skv_world *world, float depth)
{
    skv_load *l = &world->load;
    if (!is_followed(world))
        return;
    float head = skv_acting_head(&world->acting, skv_terrain_width(world->terrain),
                                 skv_terrain_height(world->terrain));
    double load = skv_load_of_depth(gravity_of(world), depth, head);
    int needed = skv_world_substep_rule(world, (double)MARGIN * load);
    if (needed >= l->wanted)
        return;
    l->wanted = needed;
    l->stiffness = (float)needed;
    take(world, needed);
}

/* Whether one of `a_second` moments lies between two times, or on the later one. */
static bool has_come(double before, double now, int a_second)
{
    return floor(now * a_second + ROUNDING) > floor(before * a_second + ROUNDING);
}

/* A step towards the stiffness of the substeps that are wanted. */
static void change_stiffness(skv_world *world)
{
    skv_load *l = &world->load;
    float wanted = (float)l->wanted;
    if (l->stiffness == wanted)
        return;
    l->stiffness = l->stiffness < wanted ? skv_minf(STIFFER * l->stiffness, wanted)
                                         : skv_maxf(SOFTER * l->stiffness, wanted);
    take(world, (int)ceil((double)skv_maxf(l->stiffness, wanted)));
}

void skv_load_follow(skv_world *world, double before)
{
    bool asleep = world->sleep.stepped == 0;
    if (asleep || !is_followed(world) || !has_come(before, world->time, FRAMES))
        return;
    skv_load *l = &world->load;
    bear(world, measure(world));
    if (has_come(before, world->time, LOOKS)) {
        int needed = skv_world_substep_rule(world, (double)(MARGIN * l->peak));
        l->wanted = needed < l->wanted ? needed : l->wanted;
        l->peak = 0;
    }
    change_stiffness(world);
}
