/* Emitters and drains at work: before each substep rows of particles appear, and others go.
 *
 * An emitter counts the way of its fluid; whenever that is a row's, a row appears, as far from the
 * line as it would have come by now. The rate is exact, whatever the substep. What keeps the rows
 * in order is the mouth: there the solver gives all fluid the emitter's velocity, so that no row
 * waits for the one before. Invariant: every particle that comes or goes is one event and is
 * counted once.
 */
#include "world/flow.h"

#include "base/assert.h"
#include "base/exact.h"
#include "world/add.h"
#include "world/area.h"
#include "world/emitters.h"
#include "world/remove.h"

#include <math.h>
#include <string.h>

/* An emitter pauses where the fluid around its mouth has more than so many times the pressure that
 * the substeps are made for: what it would press into a full vessel could not be held. */
#define MOST_PRESSURE 2

static bool is_full(const skv_world *world)
{
    return !world->emission_replaces && world->state.count >= world->emission_limit;
}

/* The box around a piece of an emitter's way, `half` to either side of its middle, and a little
 * more for rounding. */
static skv_region box_along(const skv_world *world, const skv_emitter *e,
                            const skv_emitter_rows *rows, float from, float to, float half)
{
    float dx = (float)rows->dx, dy = (float)rows->dy, slack = 0.01f * world->h;
    float aside_x = fabsf(half * dy) + slack, aside_y = fabsf(half * dx) + slack;
    return (skv_region){.x0 = e->x + skv_minf(from * dx, to * dx) - aside_x,
                        .y0 = e->y + skv_minf(from * dy, to * dy) - aside_y,
                        .x1 = e->x + skv_maxf(from * dx, to * dx) + aside_x,
                        .y1 = e->y + skv_maxf(from * dy, to * dy) + aside_y};
}

/* A row that is due: its places, and which of them are in solid, outside, or too close to a
 * particle. */
typedef struct due_row {
    float x[SKV_MOST_COLUMNS], y[SKV_MOST_COLUMNS];
    bool taken[SKV_MOST_COLUMNS];
} due_row;

/* Marks what a particle takes of a row. */
static void take_places(const skv_world *world, int i, const skv_emitter *e,
                        const skv_emitter_rows *rows, due_row *r)
{
    float x = world->state.x[i], y = world->state.y[i];
    float reach = SKV_LEAST_SPACING * world->fluid.spacing;
    double aside = ((double)y - (double)e->y) * rows->dx - ((double)x - (double)e->x) * rows->dy;
    double column = (aside + 0.5 * (double)e->width) / rows->apart;
    double around = (double)reach / rows->apart + 2;
    int first = (int)skv_max(column - around, 0);
    int last = (int)skv_min(column + around, rows->columns - 1);
    for (int k = first; k <= last; k++) {
        float dx = x - r->x[k], dy = y - r->y[k];
        if (!r->taken[k] && dx * dx + dy * dy < reach * reach)
            r->taken[k] = !skv_boundary_occluded(&world->boundary, x, y, 0, r->x[k], r->y[k], 0);
    }
}

static void find_places(const skv_world *world, const skv_emitter *e, const skv_stream *stream,
                        const skv_emitter_rows *rows, due_row *r)
{
    for (int k = 0; k < rows->columns; k++) {
        skv_emitter_place(e, rows, stream->way, stream->odd, k, &r->x[k], &r->y[k]);
        r->taken[k] = skv_world_is_blocked(world, r->x[k], r->y[k]);
    }
    float reach = SKV_LEAST_SPACING * world->fluid.spacing, way = (float)stream->way;
    skv_region near = box_along(world, e, rows, way - reach, way + reach, 0.5f * e->width + reach);
    const skv_state *s = &world->state;
    for (int i = skv_next_in_box(s, &near, 0); i < s->count; i = skv_next_in_box(s, &near, i + 1))
        take_places(world, i, e, rows, r);
}

/* How many of `wanted` particles may come; the oldest go for them, if that is the rule. */
static int make_way(skv_world *world, int number, int wanted)
{
    int room = world->emission_limit - world->state.count;
    if (wanted <= room)
        return wanted;
    if (!world->emission_replaces)
        return room > 0 ? room : 0;
    world->acting.flow.replaced += skv_world_remove_oldest(world, wanted - room, number);
    return wanted;
}

static void emit_row(skv_world *world, int number, const skv_emitter_rows *rows)
{
    const skv_emitter *e = &world->acting.emitters[number];
    skv_stream *stream = &world->acting.streams[number];
    due_row r;
    find_places(world, e, stream, rows, &r);
    int free = 0;
    for (int k = 0; k < rows->columns; k++)
        free += !r.taken[k];
    int count = make_way(world, number, free);
    memmove(stream->recent + 1, stream->recent, sizeof stream->recent - sizeof *stream->recent);
    stream->recent[0] = world->next_id;
    for (int k = 0, left = count; left > 0; k++) {
        if (r.taken[k])
            continue;
        skv_events_add(&world->events, SKV_EVENT_EMITTED, world->next_id,
                       world->acting.emitter_ids[number]);
        skv_world_append(world, r.x[k], r.y[k], e->vx, e->vy, e->dye, e->fluid);
        left--;
    }
    if (count < rows->columns)
        skv_events_add(&world->events, SKV_EVENT_BLOCKED, SKV_NO_PARTICLE,
                       world->acting.emitter_ids[number]);
    skv_world_say_if_full(world);
    world->acting.flow.emitted += count;
    world->acting.flow.blocked += rows->columns - count;
    stream->odd = !stream->odd;
}

/* A particle's place in a mouth: along it, from its line on, and aside, from its middle. */
typedef struct inside {
    float along, aside;
} inside;

static inside place_in(const skv_emitter *e, float dx, float dy, float x, float y)
{
    float rx = x - e->x, ry = y - e->y;
    return (inside){rx * dx + ry * dy, ry * dx - rx * dy};
}

/* Moves a particle out of the mouth by the nearest side that is free. */
static void put_out(skv_world *world, int i, const skv_emitter *e, float dx, float dy, inside at)
{
    skv_state *s = &world->state;
    float margin = SKV_LEAST_SPACING * world->fluid.spacing, half = 0.5f * e->width + margin;
    /* Ways out: back, to either side, forwards. */
    const float ways[4] = {margin + at.along, half - at.aside, half + at.aside,
                           world->h - at.along};
    const float nx[4] = {-dx, -dy, dy, dx}, ny[4] = {-dy, dx, -dx, dy};
    int best = -1;
    for (int k = 0; k < 4; k++) {
        if ((best < 0 || ways[k] < ways[best]) &&
            !skv_world_is_blocked(world, s->x[i] + ways[k] * nx[k], s->y[i] + ways[k] * ny[k]))
            best = k;
    }
    if (best < 0)
        return;
    s->x[i] += ways[best] * nx[best];
    s->y[i] += ways[best] * ny[best];
    s->clearance[i] = 0;
    float inwards = s->vx[i] * nx[best] + s->vy[i] * ny[best];
    if (inwards < 0) {
        s->vx[i] -= inwards * nx[best];
        s->vy[i] -= inwards * ny[best];
    }
}

/* The row in the mouth that a particle belongs to, the newest is 0; -1 if to none. */
static int row_of(const skv_stream *stream, skv_particle_id id)
{
    for (int k = 0; k < SKV_RECENT_ROWS; k++)
        if (id >= stream->recent[k])
            return k;
    return -1;
}

/* Moves a particle of the emitter's forward to where its row is. */
static void catch_up(skv_world *world, int i, const skv_emitter_rows *rows, float lag)
{
    skv_state *s = &world->state;
    float x = s->x[i] + lag * (float)rows->dx, y = s->y[i] + lag * (float)rows->dy;
    if (skv_world_is_blocked(world, x, y))
        return;
    s->x[i] = x;
    s->y[i] = y;
    s->clearance[i] = 0;
}

/* Keeps the mouth in order. The emitter's own fluid is not pressed back. Other fluid is kept out:
 * under water it would come in from behind and beside, be carried along, and leave no room for what
 * is to come. What has been in the mouth from the start goes ahead. */
static void keep_order(skv_world *world, int number, const skv_emitter_rows *rows)
{
    const skv_emitter *e = &world->acting.emitters[number];
    const skv_stream *stream = &world->acting.streams[number];
    const skv_state *s = &world->state;
    float length = skv_minf(world->h, (float)stream->travelled);
    float dx = (float)rows->dx, dy = (float)rows->dy;
    float margin = SKV_LEAST_SPACING * world->fluid.spacing, half = 0.5f * e->width + margin;
    skv_region near = box_along(world, e, rows, -margin, length, half);
    for (int i = skv_next_in_box(s, &near, 0); i < s->count; i = skv_next_in_box(s, &near, i + 1)) {
        inside at = place_in(e, dx, dy, s->x[i], s->y[i]);
        if (!(at.along > -margin && at.along < length && fabsf(at.aside) < half))
            continue;
        int row = row_of(stream, s->id[i]);
        float lag = (float)(stream->way + row * rows->way) - at.along;
        if (row < 0)
            put_out(world, i, e, dx, dy, at);
        else if (lag > 0)
            catch_up(world, i, rows, lag);
    }
}

/* Whether the fluid around a mouth is pressed too hard for more to come. */
static bool is_pressed(const skv_world *world, const skv_emitter *e, const skv_emitter_rows *rows)
{
    const skv_state *s = &world->state;
    float h = world->h, half = 0.5f * e->width + h;
    double sum = 0;
    int count = 0;
    skv_region near = box_along(world, e, rows, -h, 2 * h, half);
    for (int i = skv_next_in_box(s, &near, 0); i < s->count; i = skv_next_in_box(s, &near, i + 1)) {
        inside at = place_in(e, (float)rows->dx, (float)rows->dy, s->x[i], s->y[i]);
        if (at.along > -h && at.along < 2 * h && fabsf(at.aside) < half) {
            sum += (double)(s->several ? s->pressure[i] / s->mass[i] : s->pressure[i]);
            count++;
        }
    }
    /* Of all the substeps that there may be: more are on their way. */
    double more = (double)world->load.most / world->substeps;
    double design = more * more * (double)world->constants.design_pressure;
    return sum > MOST_PRESSURE * design * count;
}

/* Lets an emitter begin anew once it may go on. */
static void pause_emitter(skv_world *world, int number, const skv_emitter_rows *rows)
{
    skv_stream *stream = &world->acting.streams[number];
    double way = stream->way;
    bool odd = stream->odd;
    *stream = skv_new_stream(world->next_id);
    stream->pauses = true;
    stream->odd = odd;
    for (stream->way = way; stream->way >= rows->way; stream->way -= rows->way) {
        skv_events_add(&world->events, SKV_EVENT_BLOCKED, SKV_NO_PARTICLE,
                       world->acting.emitter_ids[number]);
        world->acting.flow.blocked += rows->columns;
    }
}

/* m/s; a speed that the solver would not allow is none. */
static double speed_of(const skv_world *world, const skv_emitter *e)
{
    return (double)skv_minf(skv_emitter_speed(e), world->constants.max_speed);
}

static void emit(skv_world *world, float dt)
{
    for (int k = 0; k < world->acting.emitter_count; k++) {
        const skv_emitter *e = &world->acting.emitters[k];
        skv_stream *stream = &world->acting.streams[k];
        double way = speed_of(world, e) * (double)dt;
        if (!(way > 0))
            continue;
        skv_emitter_rows rows = skv_emitter_lay_out(e, world->fluid.spacing);
        stream->travelled += way;
        stream->way += way;
        stream->pauses = is_full(world) || is_pressed(world, e, &rows);
        if (stream->pauses) {
            pause_emitter(world, k, &rows);
            continue;
        }
        keep_order(world, k, &rows);
        while (stream->way >= rows.way) {
            stream->way -= rows.way;
            emit_row(world, k, &rows);
        }
    }
}

/* Particles and events that emitters may add in a substep, at most. */
static int most_emitted(const skv_world *world, float dt, int *rows)
{
    int most = 0;
    *rows = 0;
    for (int k = 0; k < world->acting.emitter_count; k++) {
        const skv_emitter *e = &world->acting.emitters[k];
        double speed = speed_of(world, e);
        if (!(speed > 0))
            continue;
        skv_emitter_rows one = skv_emitter_lay_out(e, world->fluid.spacing);
        int due = (int)((world->acting.streams[k].way + speed * (double)dt) / one.way) + 1;
        most += due * one.columns;
        *rows += due;
    }
    return most;
}

skv_result skv_world_let_flow(skv_world *world, float dt, skv_error *error)
{
    int rows, most = most_emitted(world, dt, &rows);
    int room = world->emission_limit - world->state.count;
    skv_result result =
        skv_events_reserve(&world->events, world->state.count + 2 * most + rows, error);
    if (result == SKV_OK)
        result = skv_world_make_room(world, room < 0 ? 0 : most < room ? most : room, error);
    if (result != SKV_OK)
        return result;
    skv_world_remove_drained(world, dt);
    emit(world, dt);
    return SKV_OK;
}

skv_flow skv_world_flow(const skv_world *world)
{
    SKV_ASSERT_OR(world, (skv_flow){0});
    return world->acting.flow;
}
