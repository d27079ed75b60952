/* Springs between the particles of a fluid with a shear modulus, with which it keeps its shape
 * (Clavet, Beaudoin and Poulin 2005, chapter 5; docs/springs.md).
 *
 * They act before a substep, on where the particles will be when they have gone on as they go: what
 * two of them push each other by becomes a change of their velocities. So walls meet springs as
 * they meet gravity, and both solvers have the same ones.
 *
 * Invariant: springs lie in the order of their ends' numbers, and are summed up in it on one
 * thread; so the same springs give the same bits on any number of threads, and what the two ends of
 * a spring get is opposite.
 */
#include "world/springs/springs.h"

#include "base/arrays.h"
#include "base/memory.h"
#include "base/simd.h"

#include <math.h>
#include <string.h>

/* A spring that is longer breaks, in h: what is so far apart is in two pieces. Jelly that hits a
 * floor faster than its own waves keeps 99 of 100 springs so; with 1.5 it loses a third. */
#define BREAKS 3.0f

/* m: what lies closer has no direction to be pushed in. */
#define LEAST_DISTANCE 1e-9f

enum { LANES = 8 };

/* What the springs of a fluid do in a substep. */
typedef struct law {
    float push;  /* k dt/2, 1/s */
    float yield; /* share of the length */
    float gives; /* share of what is beyond that; 0: elastic */
} law;

typedef struct pushing {
    const skv_springs *springs;
    const skv_state *state;
    skv_pushed at;
    float inv_h, reach; /* 1/m, and m at which springs break */
    float *length;      /* null: nothing changes */
    law laws[SKV_MAX_FLUIDS];
    bool broke;
} pushing;

bool skv_world_is_springy(const skv_world *world)
{
    for (int i = 1; i < world->fluid_count; i++)
        if (skv_liquid_is_springy(&world->liquids[i]))
            return true;
    return false;
}

int skv_springs_rule(const skv_world *world)
{
    int most = 0;
    for (int i = 1; i < world->fluid_count; i++) {
        const skv_liquid *liquid = &world->liquids[i];
        if (!skv_liquid_is_springy(liquid))
            continue;
        int needed =
            skv_spring_rule(&world->fluid, (double)liquid->shear_modulus, (double)liquid->density);
        most = needed > most ? needed : most;
    }
    return most;
}

/* ---- Pushing --------------------------------------------------------------------------------- */

static law make_law(const skv_world *world, const skv_liquid *liquid, float dt)
{
    double stiffness = skv_spring_stiffness(&world->fluid, (double)liquid->shear_modulus,
                                            (double)liquid->density, (double)dt);
    return (law){.push = (float)(stiffness / 2 / (double)dt),
                 .yield = liquid->yield,
                 .gives = skv_minf(1, liquid->plasticity * dt)};
}

/* Springs that are beyond reach, or as long at rest as h, have length 0 from here on: they are
 * broken, and push no more. */
static void break_springs(pushing *p, int spring, int count, const float *distance, float *push)
{
    for (int l = 0; l < count; l++) {
        float length = p->springs->length[spring + l];
        if (distance[l] < p->reach && length * p->inv_h < 1)
            continue;
        push[l] = 0;
        p->broke = true;
        if (p->length)
            p->length[spring + l] = 0;
    }
}

/* Pushes the ends of up to eight springs that follow each other, from one particle. */
static void push_some(pushing *p, int from, int spring, int count, const law *of, float *sum_x,
                      float *sum_y)
{
    const int *to = p->springs->to + spring;
    float x[LANES] = {0}, y[LANES] = {0}, length[LANES], distance[LANES], push[LANES];
    for (int l = 0; l < count; l++) {
        x[l] = p->at.x[to[l]] - p->at.x[from];
        y[l] = p->at.y[to[l]] - p->at.y[from];
    }
    const v8 vx = v8_load(x), vy = v8_load(y), zero = v8_set(0);
    v8 rest = v8_load(p->springs->length + spring);
    v8 r = v8_sqrt(v8_add(v8_mul(vx, vx), v8_mul(vy, vy)));
    r = v8_max(r, v8_set(LEAST_DISTANCE));
    if (of->gives > 0) {
        v8 bears = v8_mul(v8_set(of->yield), rest), off = v8_sub(r, rest);
        v8 over = v8_max(v8_sub(off, bears), zero);
        v8 under = v8_max(v8_sub(v8_sub(zero, off), bears), zero);
        rest = v8_add(rest, v8_mul(v8_set(of->gives), v8_sub(over, under)));
        v8_store(length, rest);
        for (int l = 0; l < count && p->length; l++)
            p->length[spring + l] = length[l];
    }
    v8 near = v8_sub(v8_set(1), v8_mul(rest, v8_set(p->inv_h)));
    v8 part = v8_mul(v8_mul(v8_set(of->push), near), v8_div(v8_sub(rest, r), r));
    v8_store(push, part);
    if (v8_any_below(v8_set(p->reach), r) || v8_any_below(near, zero)) {
        v8_store(distance, r);
        break_springs(p, spring, count, distance, push);
    }
    for (int l = 0; l < count; l++) {
        float px = push[l] * x[l], py = push[l] * y[l];
        *sum_x -= px;
        *sum_y -= py;
        p->at.dvx[to[l]] += px;
        p->at.dvy[to[l]] += py;
    }
}

static void push_all(pushing *p)
{
    const skv_springs *s = p->springs;
    size_t bytes = (size_t)p->state->count * sizeof(float);
    memset(p->at.dvx, 0, bytes);
    memset(p->at.dvy, 0, bytes);
    for (int i = 0; i < s->particles; i++) {
        int end = s->first[i + 1];
        const law *of = &p->laws[p->state->fluid[i]];
        float x = 0, y = 0;
        for (int k = s->first[i]; k < end; k += LANES)
            push_some(p, i, k, end - k < LANES ? end - k : LANES, of, &x, &y);
        p->at.dvx[i] += x;
        p->at.dvy[i] += y;
    }
}

static pushing make_pushing(const skv_world *world, float dt, const skv_pushed *at)
{
    const skv_state *state = &world->state;
    for (int i = 0; i < state->count; i++) {
        at->x[i] = state->x[i] + dt * state->vx[i];
        at->y[i] = state->y[i] + dt * state->vy[i];
    }
    pushing p = {.springs = world->springs,
                 .state = state,
                 .at = *at,
                 .inv_h = 1 / world->h,
                 .reach = BREAKS * world->h};
    for (int i = 0; i < world->fluid_count; i++)
        p.laws[i] = make_law(world, &world->liquids[i], dt);
    return p;
}

/* Keeps those that a function wants; their order stays. */
typedef bool wanted(const skv_world *world, int from, int spring);

static void keep(skv_world *world, wanted *wants)
{
    skv_springs *s = world->springs;
    int kept = 0, begin = 0;
    for (int i = 0; i < s->particles; i++) {
        int end = s->first[i + 1];
        s->first[i] = kept;
        for (int k = begin; k < end; k++) {
            if (!wants(world, i, k))
                continue;
            s->to[kept] = s->to[k];
            s->length[kept++] = s->length[k];
        }
        begin = end;
    }
    s->first[s->particles] = s->count = kept;
}

static bool is_whole(const skv_world *world, int from, int spring)
{
    (void)from;
    return world->springs->length[spring] > 0;
}

static void tell(const skv_world *world, float dt, const skv_pushed *pushed)
{
    pushing p = make_pushing(world, dt, pushed);
    push_all(&p);
}

skv_result skv_springs_ask(skv_spring_pushes *pushes, const skv_world *world, float dt,
                           const skv_pushed **pushed, skv_error *error)
{
    int count = world->state.count;
    *pushed = NULL;
    if (!world->springs || world->springs->count == 0)
        return SKV_OK;
    if (count > pushes->room) {
        size_t room = (size_t)count;
        const skv_array arrays[] = {
            SKV_ARRAY(pushes->pushed.x, room, 0),
            SKV_ARRAY(pushes->pushed.y, room, 0),
            SKV_ARRAY(pushes->pushed.dvx, room, 0),
            SKV_ARRAY(pushes->pushed.dvy, room, 0),
        };
        if (!skv_arrays_grow(&pushes->block, arrays, sizeof arrays / sizeof *arrays))
            return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for what springs push");
        pushes->room = count;
    }
    tell(world, dt, &pushes->pushed);
    *pushed = &pushes->pushed;
    return SKV_OK;
}

/* Changes the velocities of particles that move by what has been found. */
static void add_pushes(const skv_world *world, bool partial)
{
    const skv_state *state = &world->state;
    const skv_pushed *pushed = &world->springs->pushed;
    for (int i = 0; i < state->count; i++) {
        if (partial && state->part[i] != SKV_MOVES)
            continue;
        state->vx[i] += pushed->dvx[i];
        state->vy[i] += pushed->dvy[i];
    }
}

void skv_springs_push(skv_world *world, float dt, bool partial)
{
    skv_springs *s = world->springs;
    if (!skv_world_is_springy(world) || s->count == 0)
        return;
    pushing p = make_pushing(world, dt, &s->pushed);
    p.length = s->length;
    push_all(&p);
    add_pushes(world, partial);
    if (p.broke)
        keep(world, is_whole);
}

void skv_springs_hold(const skv_world *world, float dt)
{
    if (!skv_world_is_springy(world) || world->springs->count == 0)
        return;
    tell(world, dt, &world->springs->pushed);
    add_pushes(world, false);
}

/* ---- Who goes -------------------------------------------------------------------------------- */

static bool stays(const skv_world *world, int from, int spring)
{
    const uint8_t *unrest = world->state.unrest;
    return unrest[from] != SKV_LEAVING && unrest[world->springs->to[spring]] != SKV_LEAVING;
}

void skv_springs_forget(skv_world *world)
{
    skv_springs *s = world->springs;
    if (!s || s->particles == 0)
        return;
    keep(world, stays);
    int left = 0;
    for (int i = 0; i < s->particles; i++) {
        s->number[i] = left;
        s->first[left] = s->first[i];
        s->bonded[left] = s->bonded[i];
        left += world->state.unrest[i] != SKV_LEAVING;
    }
    for (int k = 0; k < s->count; k++)
        s->to[k] = s->number[s->to[k]];
    s->particles = left;
    s->first[left] = s->count;
}

static bool is_one_piece(const skv_world *world, int from, int spring)
{
    const skv_state *p = &world->state;
    int to = world->springs->to[spring];
    return p->fluid[from] == p->fluid[to] &&
           !(skv_boundary_has_thin(&world->boundary) &&
             skv_boundary_occluded(&world->boundary, p->x[from], p->y[from], 0, p->x[to], p->y[to],
                                   0));
}

void skv_springs_renew(skv_world *world, int particle)
{
    if (world->springs && particle < world->springs->particles)
        world->springs->bonded[particle] = 0;
}

void skv_springs_part(skv_world *world)
{
    if (world->springs)
        keep(world, is_one_piece);
}

/* ---- Room ------------------------------------------------------------------------------------ */

static skv_result reserve_particles(skv_springs *s, int count, skv_error *error)
{
    if (count <= s->particle_room)
        return SKV_OK;
    int more = 2 * s->particle_room, capacity = count > more ? count : more;
    size_t room = (size_t)capacity, had = s->particle_room ? (size_t)s->particles + 1 : 0;
    const skv_array arrays[] = {
        SKV_ARRAY(s->first, room + 1, had), SKV_ARRAY(s->bonded, room, had ? had - 1 : 0),
        SKV_ARRAY(s->pushed.x, room, 0),    SKV_ARRAY(s->pushed.y, room, 0),
        SKV_ARRAY(s->pushed.dvx, room, 0),  SKV_ARRAY(s->pushed.dvy, room, 0),
        SKV_ARRAY(s->number, room, 0),      SKV_ARRAY(s->mark, room, 0),
        SKV_ARRAY(s->many, room, 0),
    };
    if (!skv_arrays_grow(&s->particle_block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for springs of %d particles",
                        count);
    s->particle_room = capacity;
    return SKV_OK;
}

static skv_result reserve_springs(skv_springs *s, int count, skv_error *error)
{
    if (count <= s->room && s->block)
        return SKV_OK;
    int more = s->room + s->room / 2, room = count > more ? count : more;
    /* Eight of a particle's lengths are read at once, so there is room behind the last. */
    const skv_array arrays[] = {
        SKV_ARRAY(s->to, (size_t)room, (size_t)s->count),
        SKV_ARRAY(s->length, (size_t)room + LANES, (size_t)s->count),
    };
    if (!skv_arrays_grow(&s->block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d springs", count);
    s->room = room;
    return SKV_OK;
}

skv_result skv_springs_reserve(skv_springs *s, int particles, int count, skv_error *error)
{
    skv_result result = reserve_particles(s, particles, error);
    return result == SKV_OK ? reserve_springs(s, count, error) : result;
}

void skv_springs_destroy(skv_springs *s)
{
    if (!s)
        return;
    if (s->can_find)
        skv_neighbours_destroy(&s->near);
    skv_free(s->particle_block);
    skv_free(s->block);
    skv_free(s);
}

void skv_springs_take_over(skv_world *world, skv_springs *springs)
{
    skv_springs_destroy(world->springs);
    world->springs = springs;
}

size_t skv_springs_bytes(const skv_springs *s)
{
    if (!s)
        return 0;
    size_t by_particle = 1 + 4 * sizeof(int) + 4 * sizeof(float),
           by_spring = sizeof(int) + sizeof(float);
    return sizeof *s + (size_t)s->particle_room * by_particle + (size_t)s->room * by_spring;
}

/* ---- Snapshots and hashes -------------------------------------------------------------------- */

void skv_springs_save(skv_writer *writer, const skv_springs *s)
{
    int count = s ? s->count : 0, particles = s ? s->particles : 0;
    skv_put(writer, (uint64_t)particles, 4);
    for (int i = 0; i < particles; i++)
        skv_put(writer, s->bonded[i], 1);
    skv_put(writer, (uint64_t)count, 4);
    for (int i = 0, k = 0; k < count; i++) {
        for (; k < s->first[i + 1]; k++) {
            skv_put(writer, (uint64_t)i, 4);
            skv_put(writer, (uint64_t)s->to[k], 4);
            skv_put_float(writer, s->length[k]);
        }
    }
}

typedef struct saved_spring {
    uint64_t from, to;
    float length;
} saved_spring;

static saved_spring read_spring(skv_reader *r)
{
    saved_spring one = {.from = skv_get(r, 4), .to = skv_get(r, 4)};
    one.length = skv_get_float(r);
    return one;
}

skv_result skv_springs_check(skv_reader *r, float most_length, int *particles, skv_error *error)
{
    uint64_t known = skv_get(r, 4), strange = known > SKV_MAX_PARTICLES;
    for (uint64_t i = 0; i < known && !strange && !r->failed; i++)
        strange = skv_get(r, 1) > 1;
    uint64_t count = skv_get(r, 4), of_one = 0;
    saved_spring last = {0};
    if (strange || r->failed)
        return skv_fail(error, SKV_ERROR_VALUE, "snapshot: a spring has values that none can have");
    *particles = (int)known;
    for (uint64_t k = 0; k < count; k++) {
        saved_spring one = read_spring(r);
        of_one = k > 0 && one.from == last.from ? of_one + 1 : 1;
        bool follows = k == 0 || one.from > last.from || (of_one > 1 && one.to > last.to);
        if (r->failed || !follows || one.from >= one.to || one.to >= known ||
            of_one > SKV_MOST_SPRINGS || !(one.length > 0 && one.length <= most_length))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "snapshot: a spring has values that none can have");
        last = one;
    }
    return SKV_OK;
}

skv_result skv_springs_load(skv_reader r, skv_springs **springs, skv_error *error)
{
    int particles = (int)skv_get(&r, 4);
    skv_reader bonded = r;
    r.at += (size_t)particles;
    int count = (int)skv_get(&r, 4);
    *springs = NULL;
    skv_springs *s = skv_calloc(1, sizeof *s);
    if (!s)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for springs");
    skv_result result = skv_springs_reserve(s, particles, count, error);
    if (result != SKV_OK) {
        skv_springs_destroy(s);
        return result;
    }
    int from = 0;
    for (; s->count < count; s->count++) {
        saved_spring one = read_spring(&r);
        for (; from < (int)one.from; from++)
            s->first[from + 1] = s->count;
        s->to[s->count] = (int)one.to;
        s->length[s->count] = one.length;
    }
    for (; from < particles; from++)
        s->first[from + 1] = s->count;
    for (int i = 0; i < particles; i++)
        s->bonded[i] = (uint8_t)skv_get(&bonded, 1);
    s->particles = particles;
    *springs = s;
    return SKV_OK;
}

uint64_t skv_springs_hash(uint64_t hash, const skv_springs *s)
{
    for (int i = 0; i < s->particles; i++) {
        for (int k = s->first[i]; k < s->first[i + 1]; k++) {
            uint8_t bytes[12];
            skv_writer w = {bytes, 0};
            skv_put(&w, (uint64_t)i, 4);
            skv_put(&w, (uint64_t)s->to[k], 4);
            skv_put_float(&w, s->length[k]);
            hash = skv_hash_bytes(hash, bytes, sizeof bytes);
        }
    }
    return hash;
}
