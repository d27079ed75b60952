/* Pictures of a field: values on a grid, contour lines, streamlines.
 *
 * Invariant: a contour crosses a grid edge at a place that the edge's two values alone decide, so
 * pieces of neighbouring cells meet.
 */
#include "base/assert.h"
#include "measure/contour.h"
#include "measure/survey.h"

#include <math.h>

enum { GRID_MAX = 4096 };

static bool grid_is_sane(const skv_grid *g)
{
    return g->columns >= 2 && g->columns <= GRID_MAX && g->rows >= 2 && g->rows <= GRID_MAX &&
           isfinite(g->x) && isfinite(g->y) && g->step > 0 && isfinite(g->step);
}

static double quantity_of(const skv_local *local, skv_quantity quantity)
{
    switch (quantity) {
    case SKV_QUANTITY_PRESSURE:
        return local->pressure;
    case SKV_QUANTITY_SPEED:
        return sqrt(local->vx * local->vx + local->vy * local->vy);
    case SKV_QUANTITY_DENSITY:
        return local->density;
    case SKV_QUANTITY_VELOCITY_X:
        return local->vx;
    case SKV_QUANTITY_VELOCITY_Y:
        return local->vy;
    }
    return (double)NAN;
}

skv_result skv_survey_field(const skv_survey *survey, skv_quantity quantity, const skv_grid *grid,
                            float *values, skv_error *error)
{
    SKV_ASSERT_OR(survey && grid && values, SKV_ERROR_VALUE);
    if (!grid_is_sane(grid))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "field: the grid needs 2 to %d columns and rows and a step above 0",
                        GRID_MAX);
    if ((unsigned)quantity > SKV_QUANTITY_VELOCITY_Y)
        return skv_fail(error, SKV_ERROR_VALUE, "field: there is no quantity %d", (int)quantity);
    for (int row = 0; row < grid->rows; row++) {
        for (int column = 0; column < grid->columns; column++) {
            skv_local local =
                skv_survey_at(survey, grid->x + column * grid->step, grid->y + row * grid->step);
            double value = local.wet ? quantity_of(&local, quantity) : (double)NAN;
            values[row * grid->columns + column] = (float)value;
        }
    }
    return SKV_OK;
}

skv_contour_cell skv_contour_cell_at(const skv_grid *grid, const float *values, double level,
                                     int column, int row)
{
    const float *low = values + (ptrdiff_t)row * grid->columns + column, *up = low + grid->columns;
    return (skv_contour_cell){grid->x + column * grid->step,
                              grid->y + row * grid->step,
                              grid->step,
                              {(double)low[0], (double)low[1], (double)up[1], (double)up[0]},
                              level};
}

skv_point skv_contour_crossing(const skv_contour_cell *c, int edge)
{
    static const int corner_x[4] = {0, 1, 1, 0}, corner_y[4] = {0, 0, 1, 1};
    int from = edge, to = (edge + 1) % 4;
    /* From the lower corner to the higher one, whichever cell asks. */
    if (corner_x[to] < corner_x[from] || corner_y[to] < corner_y[from]) {
        from = to;
        to = edge;
    }
    double share = (c->level - c->value[from]) / (c->value[to] - c->value[from]);
    return (skv_point){
        (float)(c->x + c->step * (corner_x[from] + share * (corner_x[to] - corner_x[from]))),
        (float)(c->y + c->step * (corner_y[from] + share * (corner_y[to] - corner_y[from])))};
}

/* From the edge where the boundary, walked counterclockwise, falls to the nearest one after it
 * where it rises. In a saddle that joins the high corners where the middle is high, and parts them
 * where it is not. */
int skv_contour_pieces(const skv_contour_cell *c, skv_contour_piece pieces[2])
{
    bool high[4];
    double middle = 0;
    for (int i = 0; i < 4; i++) {
        high[i] = c->value[i] >= c->level;
        middle += c->value[i] / 4;
    }
    if (isnan(middle))
        return 0;
    int count = 0;
    for (int edge = 0; edge < 4; edge++) {
        if (high[edge] || !high[(edge + 1) % 4])
            continue;
        bool saddle = high[(edge + 3) % 4] && !high[(edge + 2) % 4];
        int leave = (edge + 1) % 4;
        while (!(high[leave] && !high[(leave + 1) % 4]))
            leave = (leave + 1) % 4;
        if (saddle && middle >= c->level)
            leave = (leave + 2) % 4;
        pieces[count++] = (skv_contour_piece){leave, edge};
    }
    return count;
}

int skv_contours(const skv_grid *grid, const float *values, double level, skv_segment *segments,
                 int capacity)
{
    SKV_ASSERT_OR(grid && values && grid_is_sane(grid) && (segments || capacity <= 0), 0);
    int found = 0;
    for (int row = 0; row + 1 < grid->rows; row++) {
        for (int column = 0; column + 1 < grid->columns; column++) {
            skv_contour_cell cell = skv_contour_cell_at(grid, values, level, column, row);
            skv_contour_piece pieces[2];
            int count = skv_contour_pieces(&cell, pieces);
            for (int i = 0; i < count; i++, found++) {
                if (found >= capacity)
                    continue;
                skv_point a = skv_contour_crossing(&cell, pieces[i].from);
                skv_point b = skv_contour_crossing(&cell, pieces[i].to);
                segments[found] = (skv_segment){a.x, a.y, b.x, b.y};
            }
        }
    }
    return found;
}

int skv_streamline(const skv_survey *survey, double x, double y, double step, skv_point *points,
                   int capacity)
{
    SKV_ASSERT_OR(survey && points && isfinite(x) && isfinite(y) && isfinite(step) && step != 0, 0);
    const double rest = 1e-6;
    int count = 0;
    while (count < capacity) {
        skv_local here = skv_survey_at(survey, x, y);
        double speed = sqrt(here.vx * here.vx + here.vy * here.vy);
        if (!here.wet)
            break;
        points[count++] = (skv_point){(float)x, (float)y};
        if (speed < rest)
            break;
        skv_local half =
            skv_survey_at(survey, x + step / 2 * here.vx / speed, y + step / 2 * here.vy / speed);
        double half_speed = sqrt(half.vx * half.vx + half.vy * half.vy);
        if (!half.wet || half_speed < rest)
            break;
        x += step * half.vx / half_speed;
        y += step * half.vy / half_speed;
    }
    return count;
}
