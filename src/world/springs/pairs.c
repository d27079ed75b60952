/* Which pairs get springs. A particle that is new gets one to each neighbour of its fluid, as long
 * as it is at that moment. Later on only plastic fluids get more, wherever two of their particles
 * come within h of each other: what touches an elastic one does not join it.
 *
 * Invariant: what is found follows from the particles and the springs alone, in their order; and
 * nothing has changed until all the room that it takes is there.
 */
#include "base/memory.h"
#include "world/springs/springs.h"

#include <math.h>
#include <string.h>

/* Substeps between looks for what is new, and for what plastic fluids have come to touch: a pair
 * that comes within h has a weak spring at first, and looking costs a particle as much as five
 * times its springs. */
enum { NEW_EVERY = 4, TOUCHED_EVERY = 16 };

typedef struct finding {
    const skv_world *world;
    skv_springs *springs;
    int count; /* of particles with springs */
} finding;

/* Lists the particles of fluids with springs, and where they are; false if no pair of them can be
 * due. */
static bool list_particles(finding *f)
{
    const skv_world *world = f->world;
    const skv_state *p = &world->state;
    skv_springs *s = f->springs;
    bool springy[SKV_MAX_FLUIDS], due = false, touched = world->steps % TOUCHED_EVERY == 0;
    for (int i = 0; i < world->fluid_count; i++)
        springy[i] = i > 0 && skv_liquid_is_springy(&world->liquids[i]);
    for (int i = 0; i < p->count; i++) {
        int fluid = p->fluid[i];
        if (!springy[fluid])
            continue;
        due |= !s->bonded[i] || (touched && world->liquids[fluid].plasticity > 0);
        s->number[f->count] = i;
        s->pushed.x[f->count] = p->x[i];
        s->pushed.y[f->count++] = p->y[i];
    }
    return due;
}

/* Makes lists of neighbours that nothing is missing from: what was there before must not matter. */
static skv_result list_neighbours(const finding *f, skv_error *error)
{
    const skv_world *world = f->world;
    skv_springs *s = f->springs;
    skv_result result = SKV_OK;
    if (!s->can_find)
        result = skv_neighbours_create(&s->near, 0, 0, skv_terrain_width(world->terrain),
                                       skv_terrain_height(world->terrain), world->h,
                                       &world->boundary, error);
    s->can_find |= result == SKV_OK;
    if (result == SKV_OK)
        result = skv_neighbours_reserve(&s->near, f->count, error);
    if (result != SKV_OK)
        return result;
    skv_neighbours_build(&s->near, s->pushed.x, s->pushed.y, f->count, world->h);
    if (s->near.wanted <= s->near.list_capacity)
        return SKV_OK;
    result = skv_neighbours_reserve(&s->near, f->count, error);
    if (result == SKV_OK)
        skv_neighbours_build(&s->near, s->pushed.x, s->pushed.y, f->count, world->h);
    return result;
}

static bool is_due(const finding *f, int a, int b)
{
    const skv_state *p = &f->world->state;
    const uint8_t *bonded = f->springs->bonded;
    return p->fluid[a] == p->fluid[b] &&
           (!bonded[a] || !bonded[b] || f->world->liquids[p->fluid[a]].plasticity > 0);
}

/* Puts a number among rising ones; if there is no more room, the highest goes. */
static void put_in(int *list, int *count, int number)
{
    int at = *count;
    if (at == SKV_MOST_SPRINGS && list[at - 1] < number)
        return;
    at = at == SKV_MOST_SPRINGS ? at - 1 : (*count)++;
    for (; at > 0 && list[at - 1] > number; at--)
        list[at] = list[at - 1];
    list[at] = number;
}

/* A particle's springs that are due: the numbers of their other ends, rising. Returns how many. */
static int find_due(const finding *f, int listed, int due[SKV_MOST_SPRINGS])
{
    const skv_springs *s = f->springs;
    int a = s->number[listed], count = 0, had = s->first[a + 1] - s->first[a];
    for (int k = s->first[a]; k < s->first[a + 1]; k++)
        s->mark[s->to[k]] = a + 1;
    for (int k = s->near.start[listed]; k < s->near.start[listed + 1]; k++) {
        int other = s->near.list[k];
        if (other > listed && s->mark[s->number[other]] != a + 1 && is_due(f, a, s->number[other]))
            put_in(due, &count, s->number[other]);
    }
    return count < SKV_MOST_SPRINGS - had ? count : SKV_MOST_SPRINGS - had;
}

/* Counts them; of each particle, too. */
static int count_due(const finding *f)
{
    skv_springs *s = f->springs;
    int due[SKV_MOST_SPRINGS], all = 0;
    memset(s->mark, 0, (size_t)s->particles * sizeof *s->mark);
    for (int i = 0; i < f->count; i++)
        all += s->many[i] = find_due(f, i, due);
    return all;
}

static float distance_of(const skv_state *p, int a, int b)
{
    float x = p->x[b] - p->x[a], y = p->y[b] - p->y[a];
    return sqrtf(x * x + y * y);
}

/* Writes a particle's springs so that they end at a place, from the last one on, with those that
 * are due; those that it had lie before, and have not been overwritten. Returns where they begin.
 */
static int write_back(const finding *f, int listed, int end)
{
    skv_springs *s = f->springs;
    int due[SKV_MOST_SPRINGS], a = s->number[listed];
    int left = s->many[listed] ? find_due(f, listed, due) : 0, had = s->first[a + 1];
    while (left > 0 || had > s->first[a]) {
        bool old = left == 0 || (had > s->first[a] && s->to[had - 1] > due[left - 1]);
        float length = old ? s->length[--had] : distance_of(&f->world->state, a, due[--left]);
        s->to[--end] = old ? s->to[had] : due[left];
        s->length[end] = length;
    }
    return end;
}

/* All of them, of the last particle first. */
static void write_all(const finding *f, int count)
{
    skv_springs *s = f->springs;
    int listed = f->count - 1, end = s->count = count;
    for (int i = s->particles - 1; i >= 0; i--) {
        int ends = end;
        if (listed >= 0 && s->number[listed] == i)
            end = write_back(f, listed--, end);
        s->first[i + 1] = ends;
    }
}

static skv_result find(skv_world *world, skv_error *error)
{
    finding f = {.world = world, .springs = world->springs};
    if (!list_particles(&f))
        return SKV_OK;
    skv_result result = list_neighbours(&f, error);
    if (result != SKV_OK)
        return result;
    int due = count_due(&f), count = world->springs->count + due;
    if (due > 0) {
        result = skv_springs_reserve(world->springs, world->state.count, count, error);
        if (result != SKV_OK)
            return result;
        write_all(&f, count);
    }
    for (int k = 0; k < f.count; k++)
        world->springs->bonded[world->springs->number[k]] = 1;
    return SKV_OK;
}

skv_result skv_springs_prepare(skv_world *world, skv_error *error)
{
    int count = world->state.count;
    if (!skv_world_is_springy(world))
        return SKV_OK;
    if (!world->springs)
        world->springs = skv_calloc(1, sizeof *world->springs);
    skv_springs *s = world->springs;
    if (!s)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for springs");
    skv_result result = skv_springs_reserve(s, count, s->count, error);
    if (result != SKV_OK)
        return result;
    for (; s->particles < count; s->particles++) {
        s->first[s->particles + 1] = s->count;
        s->bonded[s->particles] = 0;
    }
    return world->steps % NEW_EVERY == 0 ? find(world, error) : SKV_OK;
}
