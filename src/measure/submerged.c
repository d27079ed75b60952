/* How much of a body is under water: of each row across gravity all if there is fluid before both
 * of its ends, half if before one; walls aside. Invariant: 0 where it touches no fluid, 1 where all
 * around it is fluid; no hollow of it counts, nor what is in there. */
#include "base/assert.h"
#include "base/exact.h"
#include "measure/survey.h"

#include <math.h>

/* Rows are so far apart at most, and a side is asked for fluid so far before it, spacings. */
#define STEP   0.25
#define BEFORE 0.5

/* Half of what fill is there under water: the body takes two fifths of the kernel. */
#define WET 0.3

/* The outline in the axes of the rows: `along` goes with gravity. */
typedef struct laid_out {
    double x_across, y_across; /* of a step across, in the world; along is (y_across, -x_across) */
    double across[SKV_MAX_CORNERS], along[SKV_MAX_CORNERS];
    int corners;
    double first, last; /* of the rows */
} laid_out;

static void lay_out(laid_out *o, const skv_survey *survey, const skv_body *body)
{
    const double c = skv_cos((double)body->angle), n = skv_sin((double)body->angle);
    const double g =
        sqrt(survey->gravity_x * survey->gravity_x + survey->gravity_y * survey->gravity_y);
    o->x_across = g > 0 ? -survey->gravity_y / g : 1;
    o->y_across = g > 0 ? survey->gravity_x / g : 0;
    o->corners = body->corners;
    o->first = INFINITY;
    o->last = -INFINITY;
    for (int i = 0; i < body->corners; i++) {
        double ax = (double)body->outline[2 * i], ay = (double)body->outline[2 * i + 1];
        double x = (double)body->x + c * ax - n * ay, y = (double)body->y + n * ax + c * ay;
        o->across[i] = x * o->x_across + y * o->y_across;
        o->along[i] = x * o->y_across - y * o->x_across;
        o->first = skv_min(o->first, o->along[i]);
        o->last = skv_max(o->last, o->along[i]);
    }
}

/* Where a row crosses the outline, in order: from outside to inside and out again. */
static int cross(const laid_out *o, double row, double at[SKV_MAX_CORNERS])
{
    int count = 0;
    for (int i = 0; i < o->corners; i++) {
        int k = (i + 1) % o->corners;
        if ((o->along[i] > row) == (o->along[k] > row))
            continue;
        double share = (row - o->along[i]) / (o->along[k] - o->along[i]);
        double here = o->across[i] + share * (o->across[k] - o->across[i]);
        int place = count++;
        for (; place > 0 && at[place - 1] > here; place--)
            at[place] = at[place - 1];
        at[place] = here;
    }
    return count;
}

/* Adds whether there is fluid before an end of a row, or above that, for another body may stand
 * beside it. What stands at a wall tells nothing there. */
static void look(const laid_out *o, const skv_survey *survey, double across, double along, int *wet,
                 int *seen)
{
    bool fluid = false, begun = false;
    for (; !fluid && along > o->first - 2 * survey->spacing; along -= survey->spacing) {
        double x = across * o->x_across + along * o->y_across;
        double y = across * o->y_across - along * o->x_across;
        if (!begun && skv_survey_solid(survey, x, y) == 1)
            return;
        begun = true;
        fluid = skv_survey_at(survey, x, y).fill > WET;
    }
    *wet += fluid;
    *seen += 1;
}

double skv_survey_submerged(const skv_survey *survey, const skv_body *body)
{
    SKV_ASSERT_OR(survey && body, 0);
    laid_out o;
    lay_out(&o, survey, body);
    const double before = BEFORE * survey->spacing;
    const int rows = (int)((o.last - o.first) / (STEP * survey->spacing)) + 1;
    double all = 0, under = 0;
    for (int r = 0; r < rows; r++) {
        double at[SKV_MAX_CORNERS], row = o.first + (r + 0.5) / rows * (o.last - o.first);
        int count = cross(&o, row, at);
        double wide = 0;
        int wet = 0, seen = 0;
        for (int i = 0; i + 1 < count; i += 2)
            wide += at[i + 1] - at[i];
        if (count > 0) {
            look(&o, survey, at[0] - before, row, &wet, &seen);
            look(&o, survey, at[count - 1] + before, row, &wet, &seen);
        }
        all += wide;
        under += seen > 0 ? wide * wet / seen : 0;
    }
    return all > 0 ? under / all : 0;
}
