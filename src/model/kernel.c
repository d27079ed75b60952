/* The smooth kernel along a straight line. Invariant: sqrt and the exact logarithm alone, so it is
 * the same on every machine. */
#include "model/kernel.h"

#include <math.h>

/* W = 1 - 6r^2 + 8r^3 - 3r^4, integrated along the line from its middle to the radius, twice,
 * against int W. */
double skv_kernel_fall(double distance)
{
    double y2 = distance * distance, c2 = 1 - y2;
    if (!(c2 > 0))
        return 0;
    double c = sqrt(c2), logarithm = distance > 0 ? skv_log((c + 1) / distance) : 0;
    double square = c * (c2 / 3 + y2);
    double cube = c / 4 + 0.375 * y2 * (c + y2 * logarithm);
    double fourth = c * (c2 * c2 / 5 + 2 * y2 * c2 / 3 + y2 * y2);
    return 2 * (c - 6 * square + 8 * cube - 3 * fourth) / (SKV_PI / SKV_SMOOTH_WHOLE);
}
