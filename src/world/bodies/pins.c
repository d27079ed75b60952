/* Bodies that turn about a pin, and motors that turn them.
 *
 * A pinned body has one way to move: it turns. So its angle says where it is and its spin how fast
 * its centre of mass goes, and an impulse changes the spin alone, by its moment about the pin. What
 * the pin bears needs no rounds, and no body leaves its pin by a share of a pixel, whatever water,
 * plates and hands do to it. Its inertia is that about the pin.
 *
 * Invariant: a pinned body's place and velocity follow from its pin, its angle and its spin.
 */
#include "base/exact.h"
#include "world/bodies/bodies.h"

static void hang(skv_rigid *r)
{
    r->arm_x = r->cos * r->at_x - r->sin * r->at_y;
    r->arm_y = r->sin * r->at_x + r->cos * r->at_y;
    r->x = r->pin_x + r->arm_x;
    r->y = r->pin_y + r->arm_y;
    r->inertia += r->mass * (r->at_x * r->at_x + r->at_y * r->at_y);
    skv_rigid_swing(r);
}

void skv_rigid_free(skv_rigid *r)
{
    double mass = 1 / r->mass, inertia = 1 / r->inertia;
    r->mobility = (r->fixed && !r->held) || r->asleep ? (skv_mobility){0}
                  : r->pinned                         ? skv_mobility_about_pin(r, inertia)
                  : r->fixed                          ? (skv_mobility){.xx = mass, .yy = mass}
                             : (skv_mobility){.xx = mass, .yy = mass, .tt = inertia};
}

void skv_rigid_derive(skv_rigid *r)
{
    const skv_outline *o = &r->shape->outline;
    double density = r->fixed ? skv_max((double)r->density, (double)SKV_STEEL) : (double)r->density;
    r->mass = density * o->area;
    r->inertia = density * o->inertia;
    r->cos = skv_cos(r->angle);
    r->sin = skv_sin(r->angle);
    if (r->pinned)
        hang(r);
    skv_rigid_free(r);
}

void skv_rigid_pin(skv_rigid *r, double x, double y)
{
    double rx = r->x - x, ry = r->y - y;
    r->pinned = true;
    r->pin_x = x;
    r->pin_y = y;
    r->at_x = r->cos * rx + r->sin * ry;
    r->at_y = r->cos * ry - r->sin * rx;
    skv_rigid_derive(r);
}

void skv_rigid_put(skv_rigid *r, double x, double y, double angle)
{
    r->x = x;
    r->y = y;
    r->angle = angle;
    skv_rigid_derive(r);
    if (!r->pinned)
        return;
    r->pin_x = x - r->arm_x;
    r->pin_y = y - r->arm_y;
    skv_rigid_derive(r);
}

/* Towards the motor's speed, as far as its torque goes: what is in the way stops it afterwards. */
void skv_bodies_drive_motors(skv_bodies *bodies, double dt)
{
    for (int k = 0; k < bodies->count; k++) {
        skv_rigid *r = &bodies->body[k];
        if (!(r->motor_torque > 0))
            continue;
        double most = dt * (double)r->motor_torque * r->mobility.tt;
        double missing = (double)r->motor_speed - r->spin;
        r->spin += skv_min(skv_max(missing, -most), most);
        skv_rigid_swing(r);
    }
}
