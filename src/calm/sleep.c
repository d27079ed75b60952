/* Sleep: regions whose particles have been still for a while are not stepped.
 *
 * Space is cut into tiles of 2 h. A particle is restless or calm; a tile is
 *   awake   if it or a tile beside it has a restless particle, or will have one within the call:
 *           its particles are stepped;
 *   held    if it is beside an awake tile: its particles take part where they lie, but do not move;
 *   asleep  otherwise: its particles are not looked at.
 * So around every restless particle at least 2 h of fluid are free to follow it, and the 2 h beyond
 * push back: enough that density and pressure of whatever moves are right.
 *
 * Every WINDOW there is a look round: the particles of a tile become calm if none has gone far and
 * they have not drifted on average. The average tells slow flow, which goes on, from the method's
 * jitter, which leads nowhere. Calm particles of an awake tile become restless at once when one
 * goes far or the tile sets in motion as a whole. A jerk is no motion: what was held lies under
 * forces that have changed meanwhile, and two tiles would wake each other by turns for ever. The
 * limits are in spacings and in sqrt(g s), the speed gained in falling half a spacing; how they
 * were found is in docs/notebook/2026-11-24-sleep.md.
 *
 * Bodies fall asleep at looks round, too, with the fluid in their reach: see world/bodies/rest.c.
 *
 * Invariant: a calm particle outside awake tiles has no velocity and does not move; who sleeps
 * depends on the particles alone, not on threads.
 */
#include "calm/sleep.h"

#include "base/exact.h"
#include "base/memory.h"
#include "world/air/air.h"
#include "world/bodies/bodies.h"
#include "world/emitters.h"
#include "world/world_internal.h"

#include <math.h>
#include <string.h>

#define WINDOW       1.0   /* s */
#define MOST_DRIFT   0.05f /* spacings in a window, a tile's average */
#define MOST_WAY     0.2f  /* spacings in a window, a particle's */
#define SETS_OUT     0.01f /* sqrt(g s): a tile's average speed */
#define JERK         0.01f /* spacings, a tile's average: what was held jerks by less when let go */
#define FALL_GRAVITY 9.81f /* m/s^2 of that scale, whatever the world's gravity */
#define WAY_MARGIN   1.5f  /* how much faster than it is a particle may get within a call */

/* A tile's state. */
enum { ASLEEP, HELD, AWAKE, RESTLESS };

skv_result skv_sleep_create(skv_world *world, bool allowed, skv_error *error)
{
    skv_sleep *s = &world->sleep;
    s->allowed = allowed;
    if (!allowed)
        return SKV_OK;
    s->tiles = skv_calloc((size_t)skv_tile_count(&world->tiling), sizeof *s->tiles);
    return s->tiles ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for sleep");
}

void skv_sleep_destroy(skv_world *world)
{
    skv_free(world->sleep.tiles);
}

static void set_unrest(skv_world *world, int particle, skv_unrest unrest)
{
    uint8_t *place = &world->state.unrest[particle];
    world->sleep.calm += (unrest == SKV_CALM) - (*place == SKV_CALM);
    *place = (uint8_t)unrest;
}

void skv_sleep_wake(skv_world *world, int particle)
{
    set_unrest(world, particle, SKV_NEWLY_RESTLESS);
}

void skv_sleep_wake_all(skv_world *world)
{
    for (int i = 0; i < world->state.count; i++)
        skv_sleep_wake(world, i);
    skv_bodies_wake_all(world);
}

static skv_tile *tile_of(const skv_world *world, int i)
{
    const skv_state *p = &world->state;
    return &world->sleep.tiles[skv_tile_number(&world->tiling, p->x[i], p->y[i])];
}

void skv_sleep_leave(skv_world *world, int particle)
{
    const skv_state *p = &world->state;
    bool asleep = p->unrest[particle] == SKV_CALM && p->vx[particle] == 0 && p->vy[particle] == 0;
    world->sleep.stepped -= !asleep;
    set_unrest(world, particle, SKV_LEAVING);
}

/* Fingers and the mouths of emitters wake whom they reach. */
static void wake_for_acting(skv_world *world)
{
    const skv_state *p = &world->state;
    for (int k = 0; k < world->acting.emitter_count; k++) {
        const skv_emitter *e = &world->acting.emitters[k];
        float corners[8];
        if (world->acting.streams[k].pauses)
            continue;
        skv_region mouth = skv_mouth(e, world->h, corners);
        for (int i = 0; i < p->count; i++)
            if (skv_region_holds(&mouth, p->x[i], p->y[i]))
                skv_sleep_wake(world, i);
    }
    for (int k = 0; k < world->acting.hand_count; k++) {
        const skv_hand *hand = &world->acting.hands[k];
        for (int i = 0; !hand->body && i < p->count; i++) {
            float x = p->x[i] - hand->x, y = p->y[i] - hand->y;
            if (x * x + y * y < hand->radius * hand->radius)
                skv_sleep_wake(world, i);
        }
    }
}

/* Marks the tiles on a restless particle's way within `dt`, on which forces may lead it `astray`.
 */
static void mark_way(skv_world *world, int i, float dt, float astray)
{
    const skv_tiling *t = &world->tiling;
    const skv_state *p = &world->state;
    float way_x = (WAY_MARGIN * p->vx[i] + world->gravity_x * dt) * dt;
    float way_y = (WAY_MARGIN * p->vy[i] + world->gravity_y * dt) * dt;
    int left = skv_tile_at(p->x[i] + skv_minf(way_x, 0) - astray, t->per_metre, t->columns);
    int right = skv_tile_at(p->x[i] + skv_maxf(way_x, 0) + astray, t->per_metre, t->columns);
    int bottom = skv_tile_at(p->y[i] + skv_minf(way_y, 0) - astray, t->per_metre, t->rows);
    int top = skv_tile_at(p->y[i] + skv_maxf(way_y, 0) + astray, t->per_metre, t->rows);
    for (int row = bottom; row <= top; row++)
        for (int column = left; column <= right; column++)
            world->sleep.tiles[row * t->columns + column].state = RESTLESS;
}

/* Raises the tiles beside those of state `from` or higher to `to`, which is lower. */
static void spread(const skv_world *world, int from, int to)
{
    skv_tile *tiles = world->sleep.tiles;
    const skv_tiling *t = &world->tiling;
    for (int row = 0; row < t->rows; row++) {
        for (int column = 0; column < t->columns; column++) {
            const skv_tile *here = &tiles[row * t->columns + column];
            if (here->state < from)
                continue;
            for (int r = row ? row - 1 : 0; r <= row + 1 && r < t->rows; r++) {
                for (int c = column ? column - 1 : 0; c <= column + 1 && c < t->columns; c++) {
                    skv_tile *beside = &tiles[r * t->columns + c];
                    beside->state = beside->state > to ? beside->state : to;
                }
            }
        }
    }
}

static void clear(const skv_world *world)
{
    int count = skv_tile_count(&world->tiling);
    for (int t = 0; t < count; t++)
        world->sleep.tiles[t].state = ASLEEP;
}

void skv_sleep_begin_disturbance(skv_world *world)
{
    if (world->sleep.allowed)
        clear(world);
}

void skv_sleep_disturb(skv_world *world, int particle)
{
    if (world->sleep.allowed)
        tile_of(world, particle)->state = RESTLESS;
}

void skv_sleep_end_disturbance(skv_world *world)
{
    if (world->sleep.calm == 0)
        return;
    spread(world, RESTLESS, AWAKE);
    for (int i = 0; i < world->state.count; i++)
        if (tile_of(world, i)->state >= AWAKE)
            skv_sleep_wake(world, i);
}

/* Says what each particle does; those that do not move stop. */
static void give_parts(skv_world *world)
{
    skv_state *p = &world->state;
    world->sleep.stepped = 0;
    for (int i = 0; i < p->count; i++) {
        int state = tile_of(world, i)->state;
        p->part[i] = state >= AWAKE ? SKV_MOVES : state == HELD ? SKV_HELD : SKV_ABSENT;
        if (state >= AWAKE)
            world->sleep.stepped++;
        else
            p->vx[i] = p->vy[i] = 0;
    }
}

/* All are calm: the last motion ends. */
static void stop_all(skv_world *world)
{
    skv_state *p = &world->state;
    if (world->sleep.stepped == 0)
        return;
    memset(p->vx, 0, (size_t)p->count * sizeof *p->vx);
    memset(p->vy, 0, (size_t)p->count * sizeof *p->vy);
    world->sleep.stepped = 0;
}

int skv_sleep_plan(skv_world *world, float dt, bool *partial)
{
    skv_sleep *s = &world->sleep;
    *partial = false;
    if (s->calm)
        wake_for_acting(world);
    bool sleepers = s->calm < world->state.count && skv_bodies_sleep(world);
    for (int i = 0; sleepers && i < world->state.count; i++)
        if (world->state.unrest[i] != SKV_CALM)
            skv_bodies_disturb(world, i, false);
    bool movers = skv_bodies_awake(world) > 0;
    for (int i = 0; s->calm && movers && i < world->state.count; i++)
        if (world->state.unrest[i] == SKV_CALM && skv_bodies_stir(world, i))
            skv_sleep_wake(world, i);
    for (int i = 0; s->calm && world->air && i < world->state.count; i++)
        if (skv_air_stirs(world, i))
            skv_sleep_wake(world, i);
    if (s->calm == 0)
        return s->stepped = world->state.count;
    *partial = true;
    if (s->calm == world->state.count) {
        stop_all(world);
        return 0;
    }
    clear(world);
    float astray = skv_acting_strength(&world->acting) * dt * dt;
    for (int i = 0; i < world->state.count; i++)
        if (world->state.unrest[i] != SKV_CALM)
            mark_way(world, i, dt, astray);
    spread(world, RESTLESS, AWAKE);
    spread(world, AWAKE, HELD);
    give_parts(world);
    return s->stepped;
}

/* Adds up what the tiles' particles did. */
static void sum_up(skv_world *world)
{
    skv_sleep *s = &world->sleep;
    const skv_state *p = &world->state;
    for (int t = 0; t < skv_tile_count(&world->tiling); t++)
        s->tiles[t] = (skv_tile){0};
    for (int i = 0; i < p->count; i++) {
        skv_tile *tile = tile_of(world, i);
        float x = p->x[i] - p->anchor_x[i], y = p->y[i] - p->anchor_y[i];
        tile->count++;
        tile->moved_x += x;
        tile->moved_y += y;
        tile->speed_x += p->vx[i];
        tile->speed_y += p->vy[i];
        tile->farthest = skv_maxf(tile->farthest, x * x + y * y);
        if (p->unrest[i] == SKV_NEWLY_RESTLESS)
            tile->state = RESTLESS;
    }
}

/* Whether the average of vectors with this sum is longer than `most`. */
static bool is_longer(const skv_tile *tile, float x, float y, float most)
{
    float limit = most * (float)tile->count;
    return x * x + y * y > limit * limit;
}

/* Marks the tiles that are in motion. */
static void judge(const skv_world *world, bool look_round)
{
    const skv_sleep *s = &world->sleep;
    float spacing = world->fluid.spacing;
    float sets_out = SETS_OUT * sqrtf(FALL_GRAVITY * spacing);
    for (int t = 0; t < skv_tile_count(&world->tiling); t++) {
        skv_tile *tile = &s->tiles[t];
        bool drifts =
            look_round && is_longer(tile, tile->moved_x, tile->moved_y, MOST_DRIFT * spacing);
        bool sets_off =
            is_longer(tile, tile->speed_x, tile->speed_y, sets_out) &&
            (look_round || is_longer(tile, tile->moved_x, tile->moved_y, JERK * spacing));
        if (drifts || sets_off || tile->farthest > MOST_WAY * MOST_WAY * spacing * spacing)
            tile->state = RESTLESS;
    }
}

/* Bodies come to rest with the fluid within their reach, or not at all. */
static void judge_bodies(skv_world *world)
{
    for (int i = 0; i < world->state.count; i++)
        if (tile_of(world, i)->state == RESTLESS)
            skv_bodies_disturb(world, i, true);
    skv_bodies_come_to_rest(world);
    skv_bodies_show(world);
}

void skv_sleep_watch(skv_world *world, float dt)
{
    skv_sleep *s = &world->sleep;
    if (!s->allowed || (s->stepped == 0 && !skv_bodies_awake(world)))
        return;
    s->watched += (double)dt;
    bool look_round = s->watched >= WINDOW;
    skv_bodies_watch(world, MOST_DRIFT * world->fluid.spacing);
    if (!look_round && s->calm == 0)
        return;
    sum_up(world);
    judge(world, look_round);
    if (look_round && world->bodies)
        judge_bodies(world);
    skv_state *p = &world->state;
    for (int i = 0; i < p->count; i++) {
        bool restless = tile_of(world, i)->state == RESTLESS ||
                        (look_round && world->bodies && skv_bodies_stir(world, i));
        if (look_round) {
            set_unrest(world, i, restless ? SKV_RESTLESS : SKV_CALM);
            p->anchor_x[i] = p->x[i];
            p->anchor_y[i] = p->y[i];
        } else if (restless && p->unrest[i] == SKV_CALM) {
            set_unrest(world, i, SKV_NEWLY_RESTLESS);
        }
    }
    if (look_round)
        s->watched = 0;
}
