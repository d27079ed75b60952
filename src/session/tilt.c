/* What water in a device feels, of what its acceleration sensor says. Invariant: the slow part and
 * the quick part together are all that is felt, up to the wildest.
 *
 * A sensor at rest reads what holds it up: held upright, +9.81 m/s^2 along its y axis. Gravity as
 * the water feels it, shaking included, is the reverse. */
#include "skvalp/tilt.h"

#include <math.h>

#include "base/assert.h"

#define EARTH_GRAVITY 9.81
#define STRONGEST     2.0  /* times that, of gravity */
#define WILDEST       8.0  /* times that, of all that is felt */
#define STEADINESS    0.15 /* times that: less is no shaking, but a hand that holds still */
#define SMOOTHING     0.05 /* s */
#define LONGEST       0.1  /* s, of shaking at once */

/* From the device's axes to the screen's. */
static void turn(skv_orientation up, double *x, double *y)
{
    double a = *x, b = *y;
    switch (up) {
    case SKV_ORIENTATION_TOP:
        break;
    case SKV_ORIENTATION_LEFT:
        *x = b;
        *y = -a;
        break;
    case SKV_ORIENTATION_BOTTOM:
        *x = -a;
        *y = -b;
        break;
    case SKV_ORIENTATION_RIGHT:
        *x = -b;
        *y = a;
        break;
    }
}

/* Cuts a vector to a length. */
static void limit(double *x, double *y, double most)
{
    double length = hypot(*x, *y), cut = length > most ? most / length : 1;
    *x *= cut;
    *y *= cut;
}

skv_tilt_reading skv_tilt_feel(skv_tilt_filter *filter, double x, double y, double seconds,
                               skv_orientation up)
{
    SKV_ASSERT_OR(filter, (skv_tilt_reading){0});
    bool heard = isfinite(x) && isfinite(y) && isfinite(seconds);
    if (heard) {
        turn(up, &x, &y);
        x /= -EARTH_GRAVITY;
        y /= -EARTH_GRAVITY;
        limit(&x, &y, WILDEST);
        double share = filter->begun && seconds > 0 ? seconds / (seconds + SMOOTHING) : 1;
        filter->begun = true;
        filter->x += share * (x - filter->x);
        filter->y += share * (y - filter->y);
        x -= filter->x;
        y -= filter->y;
    }
    bool shaken = heard && seconds > 0 && hypot(x, y) >= STEADINESS;
    double speed = shaken ? EARTH_GRAVITY * fmin(seconds, LONGEST) : 0;
    skv_tilt_reading reading = {filter->x, filter->y, shaken ? speed * x : 0,
                                shaken ? speed * y : 0};
    limit(&reading.gravity_x, &reading.gravity_y, STRONGEST);
    return reading;
}
