/* What a host does with air, and air in snapshots. Invariant: nothing changes on failure, and a
 * warm step finds all the memory that it needs. */
#include "world/air/air.h"

#include "base/arrays.h"
#include "base/assert.h"
#include "base/exact.h"
#include "base/fields.h"
#include "base/memory.h"

#include <math.h>

/* Pa m, and cells. */
#define MOST_PRESSURE 100000.0
enum { MOST_CELLS = 4000000 };

/* ---- Lifetime -------------------------------------------------------------------------------- */

static skv_result create(const skv_world *world, float pressure, skv_air **out, skv_error *error)
{
    const float cell = world->fluid.spacing;
    double columns = ceil((double)(skv_terrain_width(world->terrain) / cell)) + 2 * SKV_AIR_RIM;
    double rows = ceil((double)(skv_terrain_height(world->terrain) / cell)) + 2 * SKV_AIR_RIM;
    *out = NULL;
    if (columns * rows > MOST_CELLS)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "air: the world is too large for this spacing; use a larger spacing");
    skv_air *air = skv_calloc(1, sizeof *air);
    if (!air)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for air");
    air->pressure = pressure;
    air->cell = cell;
    air->columns = (int)columns;
    air->rows = (int)rows;
    air->cells = air->columns * air->rows;
    size_t room = (size_t)air->cells;
    const skv_array arrays[] = {
        SKV_ARRAY(air->walls, room, 0),       SKV_ARRAY(air->bare_walls, room, 0),
        SKV_ARRAY(air->room, room, 0),        SKV_ARRAY(air->bare_room, room, 0),
        SKV_ARRAY(air->open_room, room, 0),   SKV_ARRAY(air->fluid, room, 0),
        SKV_ARRAY(air->share, room, 0),       SKV_ARRAY(air->push, room, 0),
        SKV_ARRAY(air->work, room, 0),        SKV_ARRAY(air->label, room, 0),
        SKV_ARRAY(air->scratch, 3 * room, 0), SKV_ARRAY(air->held, room, 0),
        SKV_ARRAY(air->clear, room, 0),       SKV_ARRAY(air->before, room, 0),
    };
    if (!skv_arrays_grow(&air->block, arrays, sizeof arrays / sizeof *arrays)) {
        skv_free(air);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for air");
    }
    air->labels = SKV_FIRST_POCKET;
    *out = air;
    return SKV_OK;
}

void skv_air_destroy(skv_air *air)
{
    if (!air)
        return;
    skv_free(air->block);
    skv_free(air);
}

void skv_air_take_over(skv_world *world, skv_air *air)
{
    skv_air_destroy(world->air);
    world->air = air;
}

/* ---- Hosts ----------------------------------------------------------------------------------- */

skv_result skv_world_set_air(skv_world *world, float pressure, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world), SKV_ERROR_VALUE);
    if (!skv_within((double)pressure, 0, MOST_PRESSURE)) {
        char text[32];
        skv_format_float((double)pressure, text);
        return skv_fail(error, SKV_ERROR_VALUE,
                        "air: a pressure of %s Pa m is out of range; allowed is 0..%g Pa m", text,
                        MOST_PRESSURE);
    }
    if (pressure == skv_world_air(world))
        return SKV_OK;
    if (pressure > 0 && world->air) {
        world->air->pressure = pressure;
        world->air->lift = skv_min(world->air->lift, (double)pressure);
    } else {
        skv_air *air = NULL;
        skv_result result = pressure > 0 ? create(world, pressure, &air, error) : SKV_OK;
        if (result != SKV_OK)
            return result;
        skv_air_take_over(world, air);
    }
    skv_world_adapt_substeps(world);
    skv_sleep_wake_all(world);
    return SKV_OK;
}

float skv_world_air(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->air ? world->air->pressure : 0;
}

int skv_world_pockets(const skv_world *world, skv_pocket *pockets, int capacity)
{
    SKV_ASSERT_OR(world && (pockets || capacity <= 0), 0);
    const skv_air *air = world->air;
    int count = 0;
    for (int k = SKV_FIRST_POCKET; air && k < air->labels; k++) {
        const skv_piece *piece = &air->piece[k];
        if (!skv_air_is_pocket(air, piece))
            continue;
        if (count < capacity)
            pockets[count] =
                (skv_pocket){(float)(piece->x / piece->volume), (float)(piece->y / piece->volume),
                             (float)piece->volume, (float)skv_air_pressure_of(air, piece)};
        count++;
    }
    return count;
}

/* ---- Snapshots and hashes -------------------------------------------------------------------- */

/* Writes the labels in runs; returns one more than the greatest. */
static int put_labels(skv_writer *writer, const skv_air *air)
{
    const uint16_t *label = air->before;
    int labels = SKV_FIRST_POCKET;
    for (int c = 0, run = 0; c < air->cells; c += run) {
        for (run = 1; c + run < air->cells && run < UINT16_MAX && label[c + run] == label[c];)
            run++;
        skv_put(writer, label[c], 2);
        skv_put(writer, (uint64_t)run, 2);
        labels = label[c] < labels ? labels : label[c] + 1;
    }
    return labels;
}

/* Reads them, for nobody if `label` is null; 0 if they are none of so many cells. */
static int get_labels(skv_reader *r, uint16_t *label, int cells)
{
    int labels = SKV_FIRST_POCKET;
    for (int c = 0, run = 0; c < cells; c += run) {
        int is = (int)skv_get(r, 2);
        run = (int)skv_get(r, 2);
        if (run == 0 || run > cells - c || is >= SKV_AIR_LABELS)
            return 0;
        for (int k = 0; label && k < run; k++)
            label[c + k] = (uint16_t)is;
        labels = is < labels ? labels : is + 1;
    }
    return labels;
}

void skv_air_save(skv_writer *writer, const skv_air *air)
{
    skv_put_float(writer, air->pressure);
    skv_put(writer, air->begun, 1);
    skv_put_double(writer, air->lift);
    skv_put_double(writer, air->wanted_lift);
    skv_put(writer, (uint64_t)air->cells, 4);
    int labels = put_labels(writer, air);
    for (int k = SKV_FIRST_POCKET; k < labels; k++)
        skv_put_double(writer, air->amount[k]);
}

/* What a snapshot says but for labels and amounts. */
typedef struct saved_air {
    float pressure;
    bool begun;
    double lift, wanted_lift;
    int cells;
} saved_air;

static bool read_head(skv_reader *r, saved_air *saved)
{
    saved->pressure = skv_get_float(r);
    uint64_t begun = skv_get(r, 1);
    saved->begun = begun != 0;
    saved->lift = skv_get_double(r);
    saved->wanted_lift = skv_get_double(r);
    uint64_t cells = skv_get(r, 4);
    saved->cells = cells <= MOST_CELLS ? (int)cells : 0;
    double most = (double)saved->pressure;
    return !r->failed && begun <= 1 && most > 0 && most <= MOST_PRESSURE &&
           skv_within(saved->lift, 0, most) && skv_within(saved->wanted_lift, 0, most) &&
           saved->cells >= 1;
}

static skv_result refuse(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_VALUE, "snapshot: its air has values that none can have");
}

skv_result skv_air_check(skv_reader *r, skv_error *error)
{
    saved_air saved;
    int labels = read_head(r, &saved) ? get_labels(r, NULL, saved.cells) : 0;
    if (labels == 0)
        return refuse(error);
    for (int k = SKV_FIRST_POCKET; k < labels; k++)
        if (!skv_within(skv_get_double(r), 0, 1e6))
            return refuse(error);
    return r->failed ? refuse(error) : SKV_OK;
}

skv_result skv_air_load(const skv_world *world, skv_reader r, skv_air **out, skv_error *error)
{
    saved_air saved;
    read_head(&r, &saved);
    skv_air *air = NULL;
    skv_result result = create(world, saved.pressure, &air, error);
    *out = NULL;
    if (!air)
        return result;
    if (air->cells != saved.cells) {
        skv_air_destroy(air);
        return refuse(error);
    }
    air->begun = saved.begun;
    air->lift = saved.lift;
    air->wanted_lift = saved.wanted_lift;
    int labels = get_labels(&r, air->before, saved.cells);
    for (int k = SKV_FIRST_POCKET; k < labels; k++)
        air->amount[k] = skv_get_double(&r);
    air->labels = labels;
    *out = air;
    return SKV_OK;
}

uint64_t skv_air_hash(uint64_t hash, const skv_air *air)
{
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++) {
        if (!(air->amount[k] > 0))
            continue;
        uint8_t bytes[8];
        skv_writer w = {bytes, 0};
        skv_put_double(&w, air->amount[k]);
        hash = skv_hash_bytes(hash, bytes, sizeof bytes);
    }
    return hash;
}
