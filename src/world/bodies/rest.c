/* Sleep of bodies: who lies still for a while is not moved, as fluid is not (calm/sleep.c).
 *
 * A body is still as long as no point of it goes farther than fluid at rest may drift from where it
 * was at sleep's last look round. One that has been still since then falls asleep, unless what it
 * touches, or the fluid within reach, is not at rest. Asleep it has no velocity, nothing pushes it,
 * contacts with walls and with others that sleep are not looked for, and fluid may sleep beside it
 * as beside a wall. It wakes by whatever awake touches it, by fluid that wakes within its reach, by
 * a hand that takes hold of it, and by whatever a host changes.
 *
 * Invariant: no contact is between one that is awake and one that sleeps; so what contacts bear
 * among sleepers stays as it is, and wakes with them.
 */
#include "world/bodies/bodies.h"

#include <math.h>

void skv_rigid_wake(skv_rigid *r)
{
    r->still = false;
    if (!r->asleep)
        return;
    r->asleep = false;
    skv_rigid_free(r);
}

void skv_bodies_wake_all(skv_world *world)
{
    for (int k = 0; k < skv_world_has_bodies(world); k++)
        skv_rigid_wake(&world->bodies->body[k]);
}

int skv_bodies_awake(const skv_world *world)
{
    int count = 0;
    for (int k = 0; k < skv_world_has_bodies(world); k++)
        count += skv_rigid_is_awake(&world->bodies->body[k]);
    return count;
}

bool skv_bodies_sleep(const skv_world *world)
{
    bool any = false;
    for (int k = 0; k < skv_world_has_bodies(world); k++)
        any = any || world->bodies->body[k].asleep;
    return any;
}

bool skv_bodies_stir(const skv_world *world, int particle)
{
    const skv_state *p = &world->state;
    for (int k = 0; k < skv_world_has_bodies(world); k++) {
        const skv_rigid *r = &world->bodies->body[k];
        if (skv_rigid_is_awake(r) && skv_rigid_stirs(r, p->x[particle], p->y[particle], world->h))
            return true;
    }
    return false;
}

void skv_bodies_disturb(skv_world *world, int particle, bool look_round)
{
    const skv_state *p = &world->state;
    for (int k = 0; k < skv_world_has_bodies(world); k++) {
        skv_rigid *r = &world->bodies->body[k];
        bool waits = look_round ? r->still : r->asleep;
        if (waits && skv_rigid_stirs(r, p->x[particle], p->y[particle], world->h))
            skv_rigid_wake(r);
    }
}

bool skv_bodies_wake_touched(skv_body_contacts *contacts)
{
    bool woken = false;
    for (int k = 0; k < contacts->count; k++) {
        skv_rigid *a = contacts->list[k].a, *b = contacts->list[k].b;
        if (!b || a->asleep == b->asleep)
            continue;
        skv_rigid_wake(a->asleep ? a : b);
        woken = true;
    }
    return woken;
}

void skv_bodies_watch(skv_world *world, float most)
{
    for (int k = 0; k < skv_world_has_bodies(world); k++) {
        skv_rigid *r = &world->bodies->body[k];
        double x = r->x - r->anchor.x, y = r->y - r->anchor.y;
        double turned = fabs(r->angle - r->anchor.turn) * r->shape->outline.reach;
        r->still = r->still && sqrt(x * x + y * y) + turned <= (double)most;
    }
}

/* Whether others wait for it to come to rest. */
static bool is_restless(const skv_rigid *r)
{
    return skv_rigid_is_awake(r) && !r->still;
}

/* What touches somebody restless is not still. */
static void spread_unrest(skv_bodies *bodies)
{
    for (bool spreads = true; spreads;) {
        spreads = false;
        for (int k = 0; k < bodies->contacts.count; k++) {
            skv_rigid *a = bodies->contacts.list[k].a, *b = bodies->contacts.list[k].b;
            if (!b || is_restless(a) == is_restless(b))
                continue;
            skv_rigid *other = is_restless(a) ? b : a;
            spreads = spreads || other->still;
            other->still = false;
        }
    }
}

/* Some are driven by what the world does not see coming to rest. */
static bool may_sleep(const skv_world *world, const skv_rigid *r)
{
    return !r->fixed && !r->hosted && !(r->motor_torque > 0) && !world->air;
}

void skv_bodies_come_to_rest(skv_world *world)
{
    skv_bodies *bodies = world->bodies;
    for (int k = 0; k < bodies->count; k++)
        bodies->body[k].still = bodies->body[k].still && may_sleep(world, &bodies->body[k]);
    spread_unrest(bodies);
    for (int k = 0; k < bodies->count; k++) {
        skv_rigid *r = &bodies->body[k];
        if (r->asleep)
            continue;
        r->asleep = r->still;
        r->still = may_sleep(world, r);
        r->anchor = (skv_motion){r->x, r->y, r->angle};
        if (r->asleep) {
            r->vx = r->vy = r->spin = 0;
            skv_rigid_free(r);
        }
    }
}
