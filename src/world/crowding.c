/* How crowded a snapshot's particles are. Pairs within a smoothing radius are what a substep costs:
 * 20 000 particles in two millimetres have 200 million of them. Invariant: squares are told apart
 * exactly, so that a world of any size is judged alike.
 */
#include "world/crowding.h"

#include "base/memory.h"
#include "world/snapshot.h"

#include <math.h>

typedef struct square {
    int32_t x, y;
    int count; /* 0: free */
} square;

/* The squares that hold particles: open addressing in a power of two. */
typedef struct squares {
    square *list;
    uint32_t mask;
} squares;

static bool make_squares(squares *s, int particles)
{
    uint32_t room = 16;
    while (room < 2 * (uint32_t)particles)
        room *= 2;
    *s = (squares){skv_calloc(room, sizeof *s->list), room - 1};
    return s->list != NULL;
}

/* Counts a particle; returns how many its square has now. */
static int count_in(squares *s, int32_t x, int32_t y)
{
    uint32_t place = ((uint32_t)x * 0x9e3779b1u) ^ ((uint32_t)y * 0x85ebca6bu);
    place ^= place >> 15;
    for (;; place++) {
        square *here = &s->list[place & s->mask];
        if (here->count == 0)
            *here = (square){x, y, 0};
        if (here->x == x && here->y == y)
            return ++here->count;
    }
}

/* Positions lie within 100 m, and a spacing is 0.1 mm at least. */
static int most_in_a_square(const skv_snapshot *s, squares *all)
{
    double per_metre = 1 / ((double)s->def.fluid.spacing * (double)s->def.fluid.radius_ratio);
    skv_reader x = s->particles, y = s->particles;
    y.at += (size_t)s->count * sizeof(float);
    int most = 0;
    for (int i = 0; i < s->count; i++) {
        int32_t column = (int32_t)floor((double)skv_get_float(&x) * per_metre);
        int32_t row = (int32_t)floor((double)skv_get_float(&y) * per_metre);
        int count = count_in(all, column, row);
        most = count > most ? count : most;
    }
    return most;
}

skv_result skv_snapshot_ask(const void *data, size_t size, int *particles, double *crowding,
                            skv_error *error)
{
    skv_snapshot snapshot;
    squares all;
    skv_result result = skv_snapshot_read(data, size, &snapshot, error);
    if (result != SKV_OK)
        return result;
    if (!make_squares(&all, snapshot.count))
        return skv_fail(error, SKV_ERROR_MEMORY, "snapshot: no memory to look into it");
    double ratio = (double)snapshot.def.fluid.radius_ratio;
    *particles = snapshot.count;
    *crowding = most_in_a_square(&snapshot, &all) / (ratio * ratio);
    skv_free(all.list);
    return SKV_OK;
}
