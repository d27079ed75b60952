/* How much of a body is under water. Invariant: 0 where it touches no fluid, 1 where all around it
 * is fluid. */
#include "base/assert.h"
#include "base/exact.h"
#include "measure/survey.h"

#include <math.h>

/* Points of an outline are so far apart at most, and asked for fluid so far before it, spacings. */
#define STEP   0.5
#define BEFORE 0.5

/* Half of what fill is there under water: the body takes two fifths of the kernel. */
#define WET 0.3

/* The outline as far as it is wet, point after point: twice its area. */
typedef struct wet_part {
    double area, first_x, first_y, last_x, last_y;
    bool any, dry;
} wet_part;

static void add_point(wet_part *part, bool wet, double x, double y)
{
    part->dry |= !wet;
    if (!wet)
        return;
    if (part->any)
        part->area += part->last_x * y - x * part->last_y;
    part->first_x = part->any ? part->first_x : x;
    part->first_y = part->any ? part->first_y : y;
    part->last_x = x;
    part->last_y = y;
    part->any = true;
}

double skv_survey_submerged(const skv_survey *survey, const skv_body *body)
{
    SKV_ASSERT_OR(survey && body, 0);
    const double s = survey->spacing, c = skv_cos((double)body->angle),
                 n = skv_sin((double)body->angle);
    wet_part part = {0};
    for (int i = 0; i < body->corners; i++) {
        int k = (i + 1) % body->corners;
        double ax = (double)body->outline[2 * i], ay = (double)body->outline[2 * i + 1];
        double dx = (double)body->outline[2 * k] - ax, dy = (double)body->outline[2 * k + 1] - ay;
        double length = sqrt(dx * dx + dy * dy);
        int pieces = (int)(length / (STEP * s)) + 1;
        for (int p = 0; p < pieces; p++) {
            double at = (p + 0.5) / pieces, x = ax + at * dx, y = ay + at * dy;
            double out = length > 0 ? BEFORE * s / length : 0;
            double far_x = x + out * dy, far_y = y - out * dx;
            skv_local around = skv_survey_at(survey, (double)body->x + c * far_x - n * far_y,
                                             (double)body->y + n * far_x + c * far_y);
            add_point(&part, around.fill > WET, x, y);
        }
    }
    if (!part.dry)
        return part.any ? 1 : 0;
    double area = part.area + part.last_x * part.first_y - part.first_x * part.last_y;
    return skv_min(skv_max(area / 2 / (double)body->area, 0), 1);
}
