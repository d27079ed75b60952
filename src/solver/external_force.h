/* What acts on the velocities of fluid in a place, the same in every solver's units and axes: a
 * finger, or a field that is alike in all of a region. */
#ifndef SKV_SOLVER_EXTERNAL_FORCE_H
#define SKV_SOLVER_EXTERNAL_FORCE_H

#include "base/region.h"

#include <math.h>

/* In a solver's lengths, and speeds per substep. */
typedef struct skv_external_force {
    float x, y;             /* the point that it pulls towards */
    float attraction;       /* speed gained a substep, by a finger at half the radius */
    float vx, vy;           /* a velocity to take */
    float friction, follow; /* shares of the velocity lost and taken a substep, 0..1; a finger's at
                               its centre */
    float inv_radius;       /* a finger's */
    /* A field's: */
    skv_region region;        /* m, in the world's axes */
    float corners[8];         /* room for the region's, if it has four */
    float unit;               /* m in the solver's length */
    float gain_x, gain_y;     /* velocity gained a substep */
    float spin;               /* of the velocity to take, rad a substep ... */
    float middle_x, middle_y; /* ... about this point */
    float softness;           /* square of the distance within which the attraction fades */
    bool swapped;             /* the solver's x is the world's y */
    bool field;               /* it is one; else a finger */
} skv_external_force;

static inline void skv_swap(float *a, float *b)
{
    float kept = *a;
    *a = *b;
    *b = kept;
}

/* A force of the world's, in units of h and substeps of dt, as a solver sees it whose axes may be
 * swapped. */
static inline skv_external_force skv_external_force_seen(const skv_external_force *force, float h,
                                                         float inv_h, float dt, bool swapped)
{
    skv_external_force p = *force;
    float *const lengths[] = {&p.x, &p.y, &p.middle_x, &p.middle_y};
    float *const speeds[] = {&p.vx, &p.vy, &p.gain_x, &p.gain_y, &p.attraction};
    for (int i = 0; i < 4; i++)
        *lengths[i] *= inv_h;
    for (int i = 0; i < 5; i++)
        *speeds[i] = *speeds[i] * dt * inv_h;
    p.inv_radius *= h;
    p.spin *= swapped ? -dt : dt;
    p.unit = h;
    p.softness *= inv_h * inv_h;
    p.swapped = swapped;
    if (swapped) {
        skv_swap(&p.x, &p.y);
        skv_swap(&p.middle_x, &p.middle_y);
        skv_swap(&p.vx, &p.vy);
        skv_swap(&p.gain_x, &p.gain_y);
    }
    return p;
}

/* Thesis, section 3.5. */
static inline void skv_finger_on(const skv_external_force *force, float x, float y, float *vx,
                                 float *vy)
{
    float rx = (force->x - x) * force->inv_radius, ry = (force->y - y) * force->inv_radius;
    float share = 1 - (rx * rx + ry * ry);
    if (!(share > 0))
        return;
    /* The pull grows from zero at the point, where a direction would be arbitrary, and fades out
     * towards the radius; 32/9 makes it 1 at half the radius. */
    float fade = share * share, pulled = force->attraction * fade * (32.0f / 9.0f);
    float slow = force->friction * fade, carry = force->follow * fade;
    *vx += pulled * rx - slow * *vx + carry * (force->vx - *vx);
    *vy += pulled * ry - slow * *vy + carry * (force->vy - *vy);
}

static inline void skv_field_on(const skv_external_force *force, float x, float y, float *vx,
                                float *vy)
{
    float metres_x = x * force->unit, metres_y = y * force->unit;
    if (force->swapped ? !skv_region_holds(&force->region, metres_y, metres_x)
                       : !skv_region_holds(&force->region, metres_x, metres_y))
        return;
    float rx = force->x - x, ry = force->y - y;
    float pulled = force->attraction / sqrtf(rx * rx + ry * ry + force->softness);
    *vx += force->gain_x + pulled * rx;
    *vy += force->gain_y + pulled * ry;
    *vx += force->follow * (force->vx - force->spin * (y - force->middle_y) - *vx);
    *vy += force->follow * (force->vy + force->spin * (x - force->middle_x) - *vy);
}

/* Algorithm 2 without gravity for a particle at (x, y), of all forces in turn. */
static inline void skv_apply_external_forces(const skv_external_force *forces, int count, float x,
                                             float y, float *vx, float *vy)
{
    for (int i = 0; i < count; i++) {
        if (forces[i].field)
            skv_field_on(&forces[i], x, y, vx, vy);
        else
            skv_finger_on(&forces[i], x, y, vx, vy);
    }
}

#endif
