/* Picture to contour. Invariant: a segment ends on its cell's edges, never on a corner, so every
 * pixel centre is strictly inside or outside; a cell's ends meet those of its neighbours exactly.
 */
#include "terrain/contour.h"

#include "terrain/terrain.h"

#include <string.h>

void skv_coverage_fill(const skv_terrain_def *def, skv_coverage *coverage)
{
    const int rim = SKV_TERRAIN_RIM;
    for (int y = 0; y < coverage->rows; y++) {
        uint8_t *row = coverage->bytes + (size_t)y * (size_t)coverage->columns;
        bool above = y >= def->height + rim, below = y < rim;
        bool open = (below && (def->open_sides & SKV_SIDE_BOTTOM)) ||
                    (above && (def->open_sides & SKV_SIDE_TOP));
        /* An open side is open along its whole length, past the corners too. */
        if (open)
            continue;
        memset(row, def->open_sides & SKV_SIDE_LEFT ? 0 : 255, (size_t)rim);
        memset(row + rim + def->width, def->open_sides & SKV_SIDE_RIGHT ? 0 : 255, (size_t)rim);
        if (above || below)
            memset(row + rim, 255, (size_t)def->width);
        else if (def->coverage)
            memcpy(row + rim, def->coverage + (size_t)(y - rim) * (size_t)def->width,
                   (size_t)def->width);
    }
}

/* Between pixels side by side: those of two rows, or of one row and the same a pixel farther on. */
static unsigned edges_between(const uint8_t *some, const uint8_t *others, int count)
{
    unsigned edges = 0;
    for (int x = 0; x < count; x++)
        edges += skv_is_solid(some[x]) != skv_is_solid(others[x]);
    return edges;
}

skv_result skv_coverage_check(const skv_coverage *coverage, skv_error *error)
{
    size_t columns = (size_t)coverage->columns;
    if (2 * columns * (size_t)coverage->rows <= SKV_TERRAIN_MAX_EDGE)
        return SKV_OK; /* there is no room for more */
    unsigned edges = 0;
    for (int y = 0; y < coverage->rows; y++) {
        const uint8_t *row = coverage->bytes + (size_t)y * columns;
        edges += edges_between(row, row + 1, coverage->columns - 1);
        if (y + 1 < coverage->rows)
            edges += edges_between(row, row + columns, coverage->columns);
    }
    if (edges <= SKV_TERRAIN_MAX_EDGE)
        return SKV_OK;
    return skv_fail(
        error, SKV_ERROR_LIMIT,
        "terrain: %u sides of pixels part solid from air; at most %d may: draw fewer or "
        "smoother walls, or a smaller picture",
        edges, SKV_TERRAIN_MAX_EDGE);
}

unsigned skv_cell_corners(const skv_coverage *coverage, int x, int y)
{
    const uint8_t *low = coverage->bytes + (size_t)y * (size_t)coverage->columns + (size_t)x;
    const uint8_t *high = low + coverage->columns;
    return (unsigned)skv_is_solid(low[0]) | (unsigned)skv_is_solid(low[1]) << 1 |
           (unsigned)skv_is_solid(high[1]) << 2 | (unsigned)skv_is_solid(high[0]) << 3;
}

/* The cell's edges, counter-clockwise from the bottom. */
enum { BOTTOM, RIGHT, TOP, LEFT };

/* For every set of solid corners the pairs of edges that are joined. In the two saddles, 5 and 10,
 * each segment cuts off a corner of air. */
static const struct {
    uint8_t count;
    uint8_t edges[4];
} joins[16] = {
    {0, {0}},
    {1, {LEFT, BOTTOM}},
    {1, {BOTTOM, RIGHT}},
    {1, {LEFT, RIGHT}},
    {1, {RIGHT, TOP}},
    {2, {BOTTOM, RIGHT, TOP, LEFT}},
    {1, {BOTTOM, TOP}},
    {1, {LEFT, TOP}},
    {1, {TOP, LEFT}},
    {1, {TOP, BOTTOM}},
    {2, {LEFT, BOTTOM, RIGHT, TOP}},
    {1, {TOP, RIGHT}},
    {1, {RIGHT, LEFT}},
    {1, {RIGHT, BOTTOM}},
    {1, {BOTTOM, LEFT}},
    {0, {0}},
};

int skv_cell_segments(const skv_coverage *coverage, int x, int y, skv_wall_segment segments[2])
{
    const uint8_t *low = coverage->bytes + (size_t)y * (size_t)coverage->columns + (size_t)x;
    const uint8_t *high = low + coverage->columns;
    unsigned corners = skv_cell_corners(coverage, x, y);
    float left = (float)x, bottom = (float)y;
    int count = joins[corners].count;
    for (int i = 0; i < count; i++) {
        float ends[2][2];
        for (int k = 0; k < 2; k++) {
            float *end = ends[k];
            end[0] = left;
            end[1] = bottom;
            switch (joins[corners].edges[2 * i + k]) {
            case BOTTOM:
                end[0] += skv_crossing(low[0], low[1]);
                break;
            case RIGHT:
                end[0] += 1;
                end[1] += skv_crossing(low[1], high[1]);
                break;
            case TOP:
                end[0] += skv_crossing(high[0], high[1]);
                end[1] += 1;
                break;
            default:
                end[1] += skv_crossing(low[0], high[0]);
                break;
            }
        }
        segments[i] = (skv_wall_segment){ends[0][0], ends[0][1], ends[1][0], ends[1][1]};
    }
    return count;
}
