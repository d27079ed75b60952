/* Filling a region with particles on the rest lattice.
 *
 * Invariant: a lattice is a function of the box, the spacing and the terrain alone, and it is
 * walked once, from the bottom up; the places found are kept and only then become particles, so a
 * fill succeeds as a whole or changes nothing, whatever `inside` answers.
 */
#include "base/assert.h"
#include "base/defs.h"
#include "base/exact.h"
#include "base/memory.h"
#include "terrain/terrain.h"
#include "world/add.h"
#include "world/area.h"
#include "world/bodies/bodies.h"
#include "world/dye.h"
#include "world/liquids.h"

#include <math.h>
#include <string.h>

enum { FILL_COOKIE = 0x4649 };

/* Particles of a fresh lattice are this far from walls, in spacings. */
#define WALL_GAP 0.3f
/* And of aligned lattices this far from other particles: where fills follow each other frame by
 * frame, closer ones would add up to a pressure that throws the fluid apart. */
#define BRUSH_SPACING 0.95f
/* Shift of each particle, in spacings: a perfect lattice would stand like a crystal. */
#define JITTER 0.02f

skv_fill_def skv_default_fill_def(void)
{
    return (skv_fill_def){
        .x1 = 100, .y1 = 100, .limit = -1, .cookie = SKV_COOKIE(FILL_COOKIE, skv_fill_def)};
}

void skv_fill_def_init(skv_fill_def *def, size_t size)
{
    const skv_fill_def standard = skv_default_fill_def();
    skv_def_init(def, size, &standard, sizeof standard);
}

static bool is_sane(const skv_fill_def *def)
{
    const float corners[4] = {def->x0, def->y0, def->x1, def->y1};
    for (int i = 0; i < 4; i++)
        if (!skv_within((double)corners[i], -100, 100))
            return false;
    return true;
}

/* A walk over the lattice. */
typedef struct walk {
    const skv_fill_def *def;
    const skv_terrain *terrain;
    const skv_world *world;        /* whose bodies are in the way; null: there are none */
    skv_region area;               /* only places in it */
    float spacing, x0, y0, x1, y1; /* the part of box and area that the terrain covers */
    const skv_occupancy *others;   /* null: there are none */
    uint32_t next_id;
    int limit; /* walk no farther than so many places */
    skv_placed placed;
    float clear_to; /* the row's x up to which no wall is near, as far as is known */
    bool keep;      /* the places found, not only their number */
    float *x;       /* capacity places' x, followed by as many y */
    int capacity;   /* of x */
    bool out_of_memory;
} walk;

static walk make_walk(const skv_terrain *terrain, float spacing, const skv_fill_def *def, int limit)
{
    skv_region all = {.x0 = -100, .y0 = -100, .x1 = 100, .y1 = 100, .radius = -1};
    skv_region area = def->area ? skv_area_region(def->area) : all;
    return (walk){.def = def,
                  .terrain = terrain,
                  .area = area,
                  .spacing = spacing,
                  .x0 = skv_maxf(skv_maxf(def->x0, area.x0), 0),
                  .y0 = skv_maxf(skv_maxf(def->y0, area.y0), 0),
                  .x1 = skv_minf(skv_minf(def->x1, area.x1), skv_terrain_width(terrain)),
                  .y1 = skv_minf(skv_minf(def->y1, area.y1), skv_terrain_height(terrain)),
                  .limit = def->limit >= 0 && def->limit < limit ? def->limit : limit};
}

static bool grow(walk *w)
{
    int capacity = w->capacity ? 2 * w->capacity : 1024;
    float *x = skv_calloc(2 * (size_t)capacity, sizeof *x);
    if (!x)
        return false;
    if (w->capacity) {
        size_t bytes = (size_t)w->capacity * sizeof *x;
        memcpy(x, w->x, bytes);
        memcpy(x + capacity, w->x + w->capacity, bytes);
    }
    skv_free(w->x);
    w->x = x;
    w->capacity = capacity;
    return true;
}

/* Whether a wall is too near to a place. A look at the distance tells how far the row is free, for
 * along it distances fall by at most the way. */
static bool is_blocked(walk *w, float x, float y)
{
    if (x <= w->clear_to)
        return false;
    float distance = skv_terrain_distance(w->terrain, x, y);
    if (w->world)
        distance = skv_minf(skv_bodies_distance(w->world, x, y), distance);
    float room = distance - WALL_GAP * w->spacing;
    w->clear_to = x + room - SKV_PIXEL_SLACK * skv_terrain_pixel_size(w->terrain);
    return room < 0;
}

/* Judges one place of the lattice. */
static void visit(walk *w, float x, float y)
{
    if (!skv_region_holds(&w->area, x, y) ||
        (w->def->inside && !w->def->inside(x, y, w->def->user)))
        return;
    if (is_blocked(w, x, y)) {
        w->placed.blocked++;
        return;
    }
    if (w->keep) {
        uint32_t id = w->next_id + (uint32_t)w->placed.added;
        x += w->spacing * (skv_scatter(2 * id) * JITTER);
        y += w->spacing * (skv_scatter(2 * id + 1) * JITTER);
        if (w->others && skv_is_occupied(w->others, x, y)) {
            w->placed.occupied++;
            return;
        }
        if (w->placed.added == w->capacity && !grow(w)) {
            w->out_of_memory = true;
            return;
        }
        w->x[w->placed.added] = x;
        w->x[w->capacity + w->placed.added] = y;
    }
    w->placed.added++;
}

static void take_walk(walk *w)
{
    double a = (double)w->spacing * sqrt(2 / sqrt(3.0)), b = a * sqrt(3.0) / 2;
    bool aligned = w->def->aligned;
    double left = aligned ? 0 : (double)w->x0, bottom = aligned ? 0 : (double)w->y0;
    int first_row = (int)skv_max(0, floor(((double)w->y0 - bottom) / b - 0.5));
    int first_column = (int)skv_max(0, floor(((double)w->x0 - left) / a - 0.75));
    for (int row = first_row;; row++) {
        float y = (float)(bottom + (row + 0.5) * b);
        if (!(y <= w->y1))
            return;
        w->clear_to = -1;
        for (int column = first_column;; column++) {
            float x = (float)(left + (column + (row % 2 ? 0.75 : 0.25)) * a);
            if (!(x <= w->x1))
                break;
            if (w->placed.added >= w->limit || w->out_of_memory)
                return;
            if (x >= w->x0 && y >= w->y0)
                visit(w, x, y);
        }
    }
}

int skv_fill_count(const skv_terrain *terrain, float spacing, const skv_fill_def *def)
{
    skv_fill_def own = skv_default_fill_def();
    SKV_ASSERT_OR(terrain, 0);
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &own, sizeof own), 0);
    if (!is_sane(def) || !skv_within((double)spacing, 1e-4, 100))
        return 0;
    skv_terrain *kept = skv_terrain_share(terrain); /* `inside` may give the world another */
    walk w = make_walk(kept, spacing, def, INT32_MAX);
    take_walk(&w);
    skv_terrain_destroy(kept);
    return w.placed.added;
}

/* Turns the places found into particles. */
static skv_result settle(skv_world *world, const walk *w, skv_error *error)
{
    if (w->out_of_memory)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a fill");
    skv_result result = skv_world_make_room(world, w->placed.added, error);
    for (int i = 0; i < w->placed.added && result == SKV_OK; i++)
        skv_world_append(world, w->x[i], w->x[w->capacity + i], w->def->vx, w->def->vy, w->def->dye,
                         w->def->fluid);
    if (result == SKV_OK)
        skv_world_note_added(world, w->placed.added);
    return result;
}

skv_result skv_world_fill(skv_world *world, const skv_fill_def *def, skv_placed *placed,
                          skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world), SKV_ERROR_VALUE);
    skv_fill_def own = skv_default_fill_def();
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &own, sizeof own), SKV_ERROR_VALUE);
    if (!is_sane(def))
        return skv_fail(error, SKV_ERROR_VALUE, "fill: the box is not finite or beyond 100 m");
    if (!skv_within((double)def->vx, -1000, 1000) || !skv_within((double)def->vy, -1000, 1000))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "fill: the velocity is not finite or beyond 1000 m/s");
    /* One more than there can be, so that too many are noticed. */
    walk w = make_walk(world->terrain, world->fluid.spacing, def, SKV_MAX_PARTICLES + 1);
    w.keep = true;
    w.world = world;
    w.next_id = world->next_id;
    skv_occupancy others = {0};
    skv_result result = skv_check_dye(def->dye, error);
    if (result == SKV_OK)
        result = skv_check_fluid(def->fluid, world->fluid_count, error);
    if (result == SKV_OK && world->state.count > 0) {
        const skv_region box = {.x0 = w.x0, .y0 = w.y0, .x1 = w.x1, .y1 = w.y1, .radius = -1};
        result = skv_world_find_taken(
            world, &box, 0, def->aligned ? BRUSH_SPACING : SKV_LEAST_SPACING, &others, error);
        w.others = &others;
    }
    if (result == SKV_OK) {
        skv_busy before = world->busy;
        world->busy = SKV_READ;
        take_walk(&w);
        world->busy = before;
        w.placed.first = w.placed.added ? world->next_id : SKV_NO_PARTICLE;
        result = settle(world, &w, error);
    }
    skv_occupancy_destroy(&others);
    skv_free(w.x);
    if (result == SKV_OK && placed)
        *placed = w.placed;
    return result;
}
