/* Finding out whether a particle is near a place, for many places: cells as wide as the reach, in a
 * hash table with chains. Invariant: the answer is about places alone; neither hash nor order of
 * the chains shows. */
#include "world/occupancy.h"

#include "base/memory.h"

#include <math.h>

struct place {
    float x, y;
    int next; /* in the slot, as in `head` */
};

static int cell_of(float position, float reach)
{
    return (int)floor((double)(position / reach));
}

static unsigned slot_of(const skv_occupancy *o, int column, int row)
{
    unsigned key = (unsigned)column * 0x9e3779b1u ^ (unsigned)row * 0x85ebca6bu;
    return (key ^ key >> 15) & o->mask;
}

skv_result skv_occupancy_create(skv_occupancy *o, const skv_state *state, const skv_region *region,
                                int more, float reach, skv_error *error)
{
    int within = 0;
    for (int i = 0; i < state->count; i++)
        within += skv_region_holds(region, state->x[i], state->y[i]);
    *o = (skv_occupancy){.reach = reach, .mask = 1023, .capacity = within + more};
    while (o->mask < (unsigned)o->capacity)
        o->mask = 2 * o->mask + 1;
    o->head = skv_calloc((size_t)o->mask + 1, sizeof *o->head);
    o->places = skv_calloc((size_t)o->capacity, sizeof *o->places);
    if (!o->head || !o->places) {
        skv_occupancy_destroy(o);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the places of %d particles",
                        o->capacity);
    }
    for (int i = 0; i < state->count; i++)
        if (skv_region_holds(region, state->x[i], state->y[i]))
            skv_occupy(o, state->x[i], state->y[i]);
    return SKV_OK;
}

void skv_occupancy_destroy(skv_occupancy *o)
{
    skv_free(o->head);
    skv_free(o->places);
    *o = (skv_occupancy){0};
}

static bool is_parted(const skv_occupancy *o, const struct place *p, float x, float y)
{
    return o->boundary && skv_boundary_occluded(o->boundary, p->x, p->y, 0, x, y, 0);
}

bool skv_is_occupied(const skv_occupancy *o, float x, float y)
{
    int column = cell_of(x, o->reach), row = cell_of(y, o->reach);
    for (int r = row - 1; r <= row + 1; r++) {
        for (int c = column - 1; c <= column + 1; c++) {
            int number = o->head[slot_of(o, c, r)];
            while (number) {
                const struct place *p = &o->places[number - 1];
                float dx = p->x - x, dy = p->y - y;
                if (dx * dx + dy * dy < o->reach * o->reach && !is_parted(o, p, x, y))
                    return true;
                number = p->next;
            }
        }
    }
    return false;
}

void skv_occupy(skv_occupancy *o, float x, float y)
{
    int *head = &o->head[slot_of(o, cell_of(x, o->reach), cell_of(y, o->reach))];
    o->places[o->count] = (struct place){x, y, *head};
    *head = ++o->count;
}
