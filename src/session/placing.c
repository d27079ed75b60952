/* Placing: where a new instrument begins. Invariant: a place is seen, lies in the open, never in a
 * wall, and so far from other instruments that each can be gripped, as far as there is such a one.
 */
#include "session/placing.h"

#include "session/stage.h"

#include <math.h>

#include "base/memory.h"

/* Shares of what is seen across: how far apart instruments begin, so that the discs that are drawn
 * for them, 22 pixels wide, are apart on a phone of 360; and how far from its edges. */
#define APART  0.08
#define MARGIN 0.03

/* How many of the particles that a square of three cells has in the bulk are there:
 * within the water, and where there is some. */
#define WITHIN 0.7
#define SOME   0.4

/* Counts of particles, in cells of half a smoothing radius. */
typedef struct cells {
    int *counts; /* null: there is no water, or no memory */
    int columns, rows;
    double size, full; /* m; particles in three by three of them in the bulk */
} cells;

/* What is looked for, and where. */
typedef struct search {
    const skv_picture *picture;
    double x, y; /* near this */
    double left, bottom, right, top, apart;
    double below; /* with so much water above it, m */
    cells water;
} search;

static int cell_at(double place, double size, int count)
{
    int at = (int)(place / size);
    return at < 0 ? 0 : at < count ? at : count - 1;
}

static cells count_particles(const skv_frame *frame, const skv_camera *camera)
{
    enum { MOST_CELLS = 1 << 22 }; /* in a huge world with fine water cells are larger */
    double size = (double)frame->smoothing_radius / 2, s = (double)frame->spacing;
    double wide = camera->world_width, high = camera->world_height;
    if (!(size > 0) || frame->particles.count == 0)
        return (cells){0};
    while ((wide / size + 1) * (high / size + 1) > MOST_CELLS)
        size *= 2;
    cells c = {.size = size, .full = 9 * size * size / (s * s)};
    c.columns = (int)(wide / size) + 1;
    c.rows = (int)(high / size) + 1;
    c.counts = skv_calloc((size_t)c.columns * (size_t)c.rows, sizeof *c.counts);
    for (int i = 0; c.counts && i < frame->particles.count; i++) {
        int column = cell_at((double)frame->particles.x[i], size, c.columns);
        int row = cell_at((double)frame->particles.y[i], size, c.rows);
        c.counts[row * c.columns + column]++;
    }
    return c;
}

/* How much water is round a place: 1 in the bulk. */
static double wetness(const cells *c, double x, double y)
{
    int column = cell_at(x, c->size, c->columns), row = cell_at(y, c->size, c->rows), sum = 0;
    for (int r = row - 1; r <= row + 1; r++)
        for (int k = column - 1; k <= column + 1; k++)
            sum += r >= 0 && k >= 0 && r < c->rows && k < c->columns ? c->counts[r * c->columns + k]
                                                                     : 0;
    return sum / c->full;
}

static bool is_wet(const search *s, double least, double x, double y)
{
    return s->water.counts && wetness(&s->water, x, y) >= least &&
           (s->below == 0 || wetness(&s->water, x, y + s->below) >= least);
}

/* Whether an instrument may begin there. */
static bool is_free(const search *s, double x, double y)
{
    if (x < s->left || y < s->bottom || x > s->right || y > s->top ||
        !(skv_terrain_distance(s->picture->frame.terrain, (float)x, (float)y) > 0))
        return false;
    for (int i = 0; i < s->picture->probe_count; i++) {
        const skv_instrument_def *def = &s->picture->probes[i].def;
        if (hypot(def->x0 - x, def->y0 - y) < s->apart)
            return false;
    }
    return true;
}

/* The particle nearest to the place that lies in so much water; false if there is none. */
static bool find_water(const search *s, double least, double *x, double *y)
{
    const skv_particles *p = &s->picture->frame.particles;
    double nearest = INFINITY;
    for (int i = 0; i < p->count; i++) {
        double px = (double)p->x[i], py = (double)p->y[i], way = hypot(px - s->x, py - s->y);
        if (way < nearest && is_wet(s, least, px, py) && is_free(s, px, py)) {
            nearest = way;
            *x = px;
            *y = py;
        }
    }
    return nearest < INFINITY;
}

/* The free place nearest to the one that is wanted, in rings round it. */
static bool find_free(const search *s, double *x, double *y)
{
    enum { RINGS = 64, DIRECTIONS = 16 };
    static const double cosines[] = {1, 0.924, 0.707, 0.383};
    for (int ring = 0; ring <= RINGS; ring++) {
        double radius = ring * s->apart / 4;
        for (int i = 0; i < (ring ? DIRECTIONS : 1); i++) {
            int k = i % 4, quarter = i / 4;
            double a = cosines[k], b = k ? cosines[4 - k] : 0;
            double dx = quarter == 0 ? a : quarter == 1 ? -b : quarter == 2 ? -a : b;
            double dy = quarter == 0 ? b : quarter == 1 ? a : quarter == 2 ? -b : -a;
            *x = s->x + radius * dx;
            *y = s->y + radius * dy;
            if (is_free(s, *x, *y))
                return true;
        }
    }
    return false;
}

/* The part of the world that is seen, but for a margin. */
static void look_at(search *s, const skv_camera *camera, double share)
{
    double wide = camera->width / camera->scale, high = camera->height / camera->scale;
    double margin = share * fmin(wide, high);
    s->left = fmax(camera->centre_x - wide / 2, 0) + margin;
    s->right = fmin(camera->centre_x + wide / 2, camera->world_width) - margin;
    s->bottom = fmax(camera->centre_y - high / 2, 0) + margin;
    s->top = fmin(camera->centre_y + high / 2, camera->world_height) - margin;
    s->apart = APART * fmin(wide, camera->world_width);
    s->x = (s->left + s->right) / 2;
    s->y = (s->bottom + s->top) / 2;
}

void skv_place(const skv_stage *stage, bool in_water, double *x, double *y)
{
    int side = stage->hover.known ? stage->hover.side : 0;
    skv_camera camera = skv_stage_camera(stage, side);
    search s = {.picture = skv_stage_picture(stage, side)};
    bool pointed = stage->hover.known && stage->hover.px >= 0 && stage->hover.py >= 0 &&
                   stage->hover.px <= camera.width && stage->hover.py <= camera.height;
    look_at(&s, &camera, pointed ? 0 : MARGIN);
    if (pointed) {
        skv_camera_to_world(&camera, stage->hover.px, stage->hover.py, &s.x, &s.y);
        s.x = fmin(fmax(s.x, s.left), s.right);
        s.y = fmin(fmax(s.y, s.bottom), s.top);
    }
    *x = s.x;
    *y = s.y;
    s.below = in_water ? (double)s.picture->frame.smoothing_radius : 0;
    s.water = count_particles(&s.picture->frame, &camera);
    bool there = pointed && is_free(&s, s.x, s.y) && (!in_water || is_wet(&s, WITHIN, s.x, s.y));
    bool water = !there && (!pointed || in_water) &&
                 (find_water(&s, WITHIN, x, y) || find_water(&s, SOME, x, y));
    if (!there && !water && !find_free(&s, x, y)) {
        *x = s.x;
        *y = s.y;
    }
    skv_free(s.water.counts);
}
