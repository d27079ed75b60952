/* Bodies in snapshots (docs/snapshot.md). Invariant: what has been let through may be a world's,
 * and a world that goes on with it gives the same bits: whatever else it needs follows from it. */
#include "world/bodies/bodies.h"

#include "base/exact.h"
#include "base/memory.h"

#include <string.h>

/* How many numbers of a body may change, and where they are. */
enum { MOVING = 6 };
static double *moving(skv_rigid *r, int which)
{
    double *const numbers[MOVING] = {&r->x, &r->y, &r->angle, &r->vx, &r->vy, &r->spin};
    return numbers[which];
}

static void exchange_outline(skv_port *port, skv_outline *o)
{
    skv_exchange_count(port, &o->corners, SKV_MAX_CORNERS);
    for (int i = 0; i < 2 * o->corners; i++)
        skv_exchange_double(port, &o->corner[i / 2][i % 2]);
}

/* Where it is pinned, and what drives it there. */
enum { PIN = 4 };
static double *pin(skv_rigid *r, int which)
{
    double *const numbers[PIN] = {&r->pin_x, &r->pin_y, &r->at_x, &r->at_y};
    return numbers[which];
}

/* Where sleep has last looked at it, if it has been still since. */
enum { ANCHOR = 3 };
static double *anchor(skv_rigid *r, int which)
{
    double *const numbers[ANCHOR] = {&r->anchor.x, &r->anchor.y, &r->anchor.turn};
    return numbers[which];
}

enum { IS_FIXED = 1, IS_PINNED = 2, IS_HELD = 4, IS_HOSTED = 8, IS_ASLEEP = 16, IS_STILL = 32 };

static void exchange_body(skv_port *port, skv_rigid *r, skv_outline *outline)
{
    uint64_t id = r->id, held = (r->fixed ? IS_FIXED : 0u) | (r->pinned ? IS_PINNED : 0u) |
                                (r->held ? IS_HELD : 0u) | (r->hosted ? IS_HOSTED : 0u) |
                                (r->asleep ? IS_ASLEEP : 0u) | (r->still ? IS_STILL : 0u);
    skv_exchange(port, &id, 4);
    r->id = (skv_body_id)id;
    exchange_outline(port, outline);
    for (int i = 0; i < MOVING; i++)
        skv_exchange_double(port, moving(r, i));
    skv_exchange_float(port, &r->density);
    skv_exchange_float(port, &r->friction);
    skv_exchange_float(port, &r->restitution);
    skv_exchange(port, &held, 1);
    r->fixed = held & IS_FIXED;
    r->pinned = held & IS_PINNED;
    r->held = held & IS_HELD;
    r->hosted = held & IS_HOSTED;
    r->asleep = held & IS_ASLEEP;
    r->still = held & IS_STILL;
    if (r->still)
        for (int i = 0; i < ANCHOR; i++)
            skv_exchange_double(port, anchor(r, i));
    if (!r->pinned)
        return;
    for (int i = 0; i < PIN; i++)
        skv_exchange_double(port, pin(r, i));
    skv_exchange_float(port, &r->motor_speed);
    skv_exchange_float(port, &r->motor_torque);
}

/* What is said before the bodies: the next name, whether somebody has set one, and how many. */
typedef struct head {
    uint64_t next_id, set;
    int count;
} head;

static void exchange_head(skv_port *port, head *h)
{
    skv_exchange(port, &h->next_id, 4);
    skv_exchange(port, &h->set, 1);
    skv_exchange_count(port, &h->count, SKV_MAX_BODIES);
}

/* What a contact bore in the last substep, and how many did. */
static void exchange_touch(skv_port *port, skv_body_touch *touch)
{
    uint64_t a = touch->a, b = touch->b, rim = (uint64_t)touch->rim;
    skv_exchange(port, &a, 4);
    skv_exchange(port, &b, 4);
    skv_exchange(port, &rim, 2);
    *touch =
        (skv_body_touch){(skv_body_id)a, (skv_body_id)b, (int)rim, touch->normal, touch->along};
    skv_exchange_double(port, &touch->normal);
    skv_exchange_double(port, &touch->along);
}

bool skv_bodies_are_watched(const skv_bodies *bodies)
{
    bool still = false;
    for (int k = 0; bodies && k < bodies->count; k++)
        still = still || bodies->body[k].still;
    return still;
}

void skv_bodies_save(skv_writer *writer, const skv_bodies *bodies)
{
    skv_port port = {.to = writer};
    skv_bodies *b = (skv_bodies *)bodies; /* only read */
    exchange_head(&port, &(head){b->next_id, b->set, b->count});
    for (int k = 0; k < b->count; k++)
        exchange_body(&port, &b->body[k], &b->body[k].shape->outline);
    if (b->touches > 0)
        skv_exchange_count(&port, &b->touches, SKV_MOST_CONTACTS);
    for (int k = 0; k < b->touches; k++)
        exchange_touch(&port, &b->touch[k]);
}

static bool is_sane(skv_rigid *r, const skv_outline *o, float spacing)
{
    static const double most[MOVING] = {1e6, 1e6, 1e9, 1e6, 1e6, 1e9};
    bool sane = o->corners >= 3 && skv_outline_check(o, spacing, NULL) == SKV_OK;
    for (int i = 0; i < MOVING; i++)
        sane = sane && skv_within(*moving(r, i), -most[i], most[i]);
    for (int i = 0; i < PIN; i++)
        sane = sane && skv_within(*pin(r, i), -1e6, 1e6);
    for (int i = 0; i < ANCHOR; i++)
        sane = sane && skv_within(*anchor(r, i), -1e9, 1e9);
    sane = sane && (r->still || !r->asleep) && !(r->still && (r->fixed || r->hosted)) &&
           !(r->asleep && (r->vx != 0 || r->vy != 0 || r->spin != 0));
    sane = sane && (r->fixed || !r->held) && !(r->hosted && (r->fixed || r->pinned));
    sane = sane && skv_within((double)r->motor_speed, -1000, 1000) &&
           skv_within((double)r->motor_torque, 0, r->fixed ? 0 : 1e6);
    return sane && skv_within((double)r->density, 10, 50000) &&
           skv_within((double)r->friction, 0, 10) && skv_within((double)r->restitution, 0, 1);
}

static skv_result refuse(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_VALUE, "snapshot: a body has values that none can have");
}

/* Whether touches are in their order, and none bears what no body could. */
static bool check_touches(skv_port *port)
{
    int count = 0;
    skv_body_touch before = {0};
    bool sane = skv_exchange_count(port, &count, SKV_MOST_CONTACTS);
    for (int k = 0; k < count && sane; k++) {
        skv_body_touch touch = {0};
        exchange_touch(port, &touch);
        sane = touch.rim < SKV_MOST_RIM && skv_touch_precedes(&before, &touch) &&
               skv_within(touch.normal, 0, 1e18) && skv_within(touch.along, -1e18, 1e18);
        before = touch;
    }
    return sane;
}

skv_result skv_bodies_check(skv_reader *reader, float spacing, bool with_touches, skv_error *error)
{
    skv_port port = {.from = reader};
    head h = {0};
    exchange_head(&port, &h);
    skv_body_id before = 0;
    for (int k = 0; k < h.count; k++) {
        skv_rigid r = {0};
        skv_outline outline = {0};
        exchange_body(&port, &r, &outline);
        skv_outline_measure(&outline);
        if (reader->failed || !is_sane(&r, &outline, spacing) || r.id <= before ||
            r.id >= h.next_id)
            return refuse(error);
        before = r.id;
    }
    if (with_touches && !check_touches(&port))
        return refuse(error);
    return SKV_OK;
}

/* A shape of that outline: one that the world has, or a new one beside those of a list. */
static skv_result find_shape(const skv_world *world, const skv_bodies *list, const skv_outline *o,
                             skv_body_shape **shape, skv_error *error)
{
    for (int k = 0; k < skv_world_has_bodies(world); k++) {
        skv_body_shape *had = world->bodies->body[k].shape;
        if (had->outline.corners == o->corners &&
            memcmp(had->outline.corner, o->corner, (size_t)o->corners * sizeof *o->corner) == 0) {
            had->owners++;
            *shape = had;
            return SKV_OK;
        }
    }
    return skv_body_shape_create(world, list, o, shape, error);
}

skv_result skv_bodies_load(const skv_world *world, skv_reader reader, bool with_touches,
                           skv_bodies **bodies, skv_error *error)
{
    skv_port port = {.from = &reader};
    head h = {0};
    skv_bodies *b = skv_bodies_create();
    *bodies = NULL;
    if (!b)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for bodies");
    exchange_head(&port, &h);
    b->next_id = (skv_body_id)h.next_id;
    b->set = h.set != 0;
    for (int k = 0; k < h.count; k++) {
        skv_rigid *r = &b->body[k];
        skv_outline outline = {0};
        exchange_body(&port, r, &outline);
        skv_outline_measure(&outline);
        skv_result result = find_shape(world, b, &outline, &r->shape, error);
        if (result != SKV_OK) {
            skv_bodies_destroy(b);
            return result;
        }
        skv_rigid_derive(r);
        b->count++;
    }
    if (with_touches)
        skv_exchange_count(&port, &b->touches, SKV_MOST_CONTACTS);
    for (int k = 0; k < b->touches; k++)
        exchange_touch(&port, &b->touch[k]);
    *bodies = b;
    return SKV_OK;
}
