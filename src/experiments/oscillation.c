/* Period and decay of a swing. Invariant: an extreme belongs to the stretch between two crossings,
 * so noise that does not cross the rest value changes nothing. */
#include "experiments/oscillation.h"

#include <math.h>

enum { MAX_CROSSINGS = 64 };

oscillation skv_oscillation_read(const double *times, const double *values, int count, double rest,
                                 int half_periods)
{
    double crossing[MAX_CROSSINGS], extreme[MAX_CROSSINGS];
    int crossings = 0;
    double farthest = 0;
    for (int i = 0; i < count && crossings < MAX_CROSSINGS; i++) {
        double now = values[i] - rest;
        if (i > 0) {
            double before = values[i - 1] - rest;
            if ((before < 0) != (now < 0)) {
                extreme[crossings] = farthest;
                crossing[crossings++] =
                    times[i - 1] + (times[i] - times[i - 1]) * before / (before - now);
                farthest = 0;
            }
        }
        if (fabs(now) > fabs(farthest))
            farthest = now;
    }
    oscillation result = {(double)NAN, (double)NAN, (double)NAN};
    if (crossings >= 1)
        result.first_crossing = crossing[0];
    if (crossings >= 3) {
        int used = crossings - 1 < half_periods ? crossings - 1 : half_periods;
        result.period = 2 * (crossing[used] - crossing[0]) / used;
        result.amplitude1 = extreme[2] / extreme[0];
    }
    return result;
}
