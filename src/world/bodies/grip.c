/* Hands that hold bodies by a point.
 *
 * A spring without swing draws the point to the hand and gives it the hand's velocity, with as much
 * mass as moves there: of the body, the lever counted, and of the fluid that has to make way, taken
 * as what the body displaces, of the fluid that lies on it; the layer that moves with the body
 * anyway (bodies/layer.c) is a part of that. It is taken at the substep's end, so it is stable
 * whatever its frequency, and two hands at one body take their turns. Contacts come after it and
 * undo what leads into a wall. What is longer than the spring that the hand's strength stretches
 * pulls no more, so against the hand a body is never faster than half of that length times the
 * frequency.
 *
 * A hand goes on with its velocity until the next is told, else the body would lag by half of what
 * it goes between two.
 *
 * A fixed body is held, too: a gate, a piston, a wave maker. It goes along as if it were of steel,
 * has no weight, meets no walls and does not turn, unless it is pinned; fluid and bodies resist it
 * as far as the hand's strength goes. It stops where it is let go.
 *
 * Invariant: hands act in their order; who lets go of what is not fixed leaves it what velocity it
 * has.
 */
#include "base/exact.h"
#include "world/bodies/bodies.h"
#include "world/hands.h"

#include <math.h>

/* m/s: a hand's speed, for what is fixed. Faster steel would hammer water in a closed room. */
#define FIXED_MOST 0.5

/* Cuts a vector to a length. */
static void cut(double *x, double *y, double most)
{
    double length = sqrt(*x * *x + *y * *y);
    if (length > most) {
        *x *= most / length;
        *y *= most / length;
    }
}

/* The same of something pinned, at (rx, ry) beside its pin: it can only turn. */
static void turn(skv_rigid *r, double rx, double ry, double dvx, double dvy, double most)
{
    double square = rx * rx + ry * ry;
    if (!(square > 0))
        return;
    double length = sqrt(square), tt = r->mobility.tt;
    double impulse = (rx * dvy - ry * dvx) / (length * tt * square);
    r->spin += skv_min(skv_max(impulse, -most), most) * length * tt;
    skv_rigid_swing(r);
}

/* Gives the point (rx, ry) beside the centre of mass another velocity, by an impulse there that is
 * cut to `most`. */
static void change(skv_rigid *r, double rx, double ry, double dvx, double dvy, double most)
{
    if (r->pinned) {
        turn(r, rx + r->arm_x, ry + r->arm_y, dvx, dvy, most);
        return;
    }
    const skv_mobility *m = &r->mobility;
    double xx = m->xx + ry * (m->tt * ry - 2 * m->xt), yy = m->yy + rx * (m->tt * rx + 2 * m->yt);
    double xy = m->xy + rx * m->xt - ry * m->yt - m->tt * rx * ry;
    double area = xx * yy - xy * xy;
    double x = (yy * dvx - xy * dvy) / area, y = (xx * dvy - xy * dvx) / area;
    cut(&x, &y, most);
    skv_rigid_push(r, x, y, rx * y - ry * x);
}

/* What the impulse of a spring, of a mass `moved` and so stiff and damped, makes of the velocity
 * (vx, vy) of what it draws back by (x, y): the body's and of the layer that moves with it, which
 * is heavier across long sides. */
static void spring(const skv_rigid *r, double moved, double stiff, double damped, double x,
                   double y, double *vx, double *vy)
{
    double turned = r->inertia * r->mobility.tt / r->mass; /* of what is pinned */
    double xx = moved * (r->pinned ? turned : r->mobility.xx);
    double yy = moved * (r->pinned ? turned : r->mobility.yy);
    double xy = moved * (r->pinned ? 0 : r->mobility.xy);
    double to_x = *vx - stiff * (xx * x + xy * y), to_y = *vy - stiff * (xy * x + yy * y);
    xx = 1 + damped * xx;
    yy = 1 + damped * yy;
    xy *= damped;
    double area = xx * yy - xy * xy;
    *vx = (yy * to_x - xy * to_y) / area;
    *vy = (xx * to_y - xy * to_x) / area;
}

static void pull(skv_rigid *r, const skv_hand *hand, double dt)
{
    double strength = (double)hand->attraction, follow = (double)hand->follow;
    if (strength <= 0 || follow <= 0)
        return;
    double rx = r->cos * (double)hand->at_x - r->sin * (double)hand->at_y;
    double ry = r->sin * (double)hand->at_x + r->cos * (double)hand->at_y;
    double away_x = r->x + rx - (double)hand->x, away_y = r->y + ry - (double)hand->y;
    double hand_x = (double)hand->vx, hand_y = (double)hand->vy;
    if (r->fixed)
        cut(&hand_x, &hand_y, FIXED_MOST);
    double vx = r->vx - r->spin * ry - hand_x, vy = r->vy + r->spin * rx - hand_y;
    double displaced = r->around * r->shape->outline.area, moved = r->mass + displaced;
    double turns = dt * follow, wanted_x = vx, wanted_y = vy;
    if (r->fixed)
        strength *= displaced / moved;
    cut(&away_x, &away_y, strength / (follow * follow));
    spring(r, moved, turns * follow, turns * (2 + turns), away_x, away_y, &wanted_x, &wanted_y);
    change(r, rx, ry, wanted_x - vx, wanted_y - vy, dt * strength * moved);
    if (r->fixed && !r->pinned)
        return;
    double lever = 1 + r->mass * (rx * rx + ry * ry) / r->inertia;
    r->spin /= 1 + dt * (double)hand->friction * lever;
    if (r->pinned)
        skv_rigid_swing(r);
}

void skv_bodies_take_hold(skv_world *world)
{
    for (int k = 0; k < world->bodies->count; k++) {
        skv_rigid *r = &world->bodies->body[k];
        bool held = false;
        for (int i = 0; i < world->acting.hand_count; i++)
            held = held || world->acting.hands[i].body == r->id;
        if (held)
            skv_rigid_wake(r);
        held = held && r->fixed;
        if (r->held && !held)
            r->vx = r->vy = r->spin = 0;
        r->held = held;
        skv_rigid_free(r);
    }
}

/* Not beyond where a hand may be. */
static float move_on(float at, float speed, double dt)
{
    return (float)skv_max(skv_min((double)at + dt * (double)speed, 1000), -1000);
}

void skv_bodies_follow_hands(skv_world *world, double dt)
{
    for (int i = 0; i < world->acting.hand_count; i++) {
        skv_hand *hand = &world->acting.hands[i];
        for (int k = 0; hand->body && k < world->bodies->count; k++) {
            skv_rigid *r = &world->bodies->body[k];
            if (r->id == hand->body)
                pull(r, hand, dt);
        }
        if (hand->body) {
            hand->x = move_on(hand->x, hand->vx, dt);
            hand->y = move_on(hand->y, hand->vy, dt);
        }
    }
}

/* ---- In snapshots and commands --------------------------------------------------------------- */

bool skv_hands_hold_bodies(const skv_acting *acting)
{
    for (int i = 0; i < acting->hand_count; i++)
        if (acting->hands[i].body)
            return true;
    return false;
}

void skv_exchange_held(skv_port *port, skv_hand *hand)
{
    uint64_t body = hand->body;
    skv_exchange(port, &body, 4);
    hand->body = (skv_body_id)body;
    skv_exchange_float(port, &hand->at_x);
    skv_exchange_float(port, &hand->at_y);
}

skv_result skv_exchange_holds(skv_port *port, skv_acting *acting, skv_error *error)
{
    for (int i = 0; i < acting->hand_count; i++)
        skv_exchange_held(port, &acting->hands[i]);
    return skv_check_hands(acting->hands, acting->hand_count, error);
}
