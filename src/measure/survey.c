/* Looking at the fluid: a sorted copy of the particles, and averages around a point.
 *
 * Invariant: particles lie in the arrays cell by cell, within a cell in creation order, so every
 * sum over a neighbourhood has the same order, and the same bits, on every machine.
 */
#include "measure/survey.h"

#include "base/assert.h"
#include "base/exact.h"
#include "base/memory.h"
#include "model/kernel.h"
#include "skvalp/particles.h"

#include <math.h>
#include <string.h>

/* The spiky kernel along a straight line at distance d < 1 (Simpson's rule). */
static double along_line(double d)
{
    enum { STEPS = 64 };
    double half = sqrt(1 - d * d), sum = 0;
    for (int i = 0; i <= STEPS; i++) {
        double y = half * i / STEPS, q = 1 - sqrt(d * d + y * y);
        double weight = i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2;
        sum += weight * skv_kernel_density(SKV_KERNEL_SPIKY, q);
    }
    return 2 * sum * half / (3 * STEPS);
}

/* The shares of the kernel that lie beyond a straight line at distance i/SOLID_TABLE (two points of
 * Gauss a step). Without libm, so that readings have the same bits on every machine. */
static void tabulate_beyond_line(double share[SOLID_TABLE + 1])
{
    const double gauss = 0.5773502691896258, step = 1.0 / SOLID_TABLE;
    share[SOLID_TABLE] = 0;
    for (int i = SOLID_TABLE - 1; i >= 0; i--) {
        double middle = (i + 0.5) * step, away = gauss * step / 2;
        double slice = (along_line(middle - away) + along_line(middle + away)) * step / 2;
        share[i] = share[i + 1] + slice * SKV_SPIKY_WHOLE / SKV_PI;
    }
}

skv_result skv_survey_create(skv_survey **out, skv_error *error)
{
    SKV_ASSERT_OR(out, SKV_ERROR_VALUE);
    *out = skv_calloc(1, sizeof **out);
    if (!*out)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a survey");
    (*out)->time_before = -1;
    tabulate_beyond_line((*out)->solid_share);
    return SKV_OK;
}

static void free_particles(skv_survey *s)
{
    void *const arrays[] = {s->x,        s->y,      s->vx,        s->vy,    s->pressure,
                            s->from_x,   s->from_y, s->now_x,     s->now_y, s->before_x,
                            s->before_y, s->id,     s->id_before, s->mass};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        skv_free(arrays[i]);
}

void skv_survey_destroy(skv_survey *survey)
{
    if (!survey)
        return;
    skv_terrain_destroy(survey->terrain);
    free_particles(survey);
    skv_free(survey->cell_start);
    skv_free(survey);
}

/* Makes room; what was known of the look before is lost where the arrays have to grow. */
static skv_result reserve_particles(skv_survey *s, int count, skv_error *error)
{
    if (count <= s->capacity)
        return SKV_OK;
    size_t capacity = (size_t)(count > 2 * s->capacity ? count : 2 * s->capacity);
    skv_survey fresh = {0};
    float **floats[] = {&fresh.x,        &fresh.y,        &fresh.vx,       &fresh.vy,
                        &fresh.pressure, &fresh.from_x,   &fresh.from_y,   &fresh.now_x,
                        &fresh.now_y,    &fresh.before_x, &fresh.before_y, &fresh.mass};
    bool complete = true;
    for (size_t i = 0; i < sizeof floats / sizeof *floats; i++)
        complete = (*floats[i] = skv_calloc(capacity, sizeof(float))) && complete;
    fresh.id = skv_calloc(capacity, sizeof *fresh.id);
    fresh.id_before = skv_calloc(capacity, sizeof *fresh.id_before);
    if (!complete || !fresh.id || !fresh.id_before) {
        free_particles(&fresh);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a survey of %d particles",
                        count);
    }
    size_t known = (size_t)s->count;
    if (known) {
        memcpy(fresh.now_x, s->now_x, known * sizeof *fresh.now_x);
        memcpy(fresh.now_y, s->now_y, known * sizeof *fresh.now_y);
        memcpy(fresh.id, s->id, known * sizeof *fresh.id);
    }
    free_particles(s);
    s->count_before = 0;
    s->time_before = -1;
    s->x = fresh.x;
    s->y = fresh.y;
    s->vx = fresh.vx;
    s->vy = fresh.vy;
    s->pressure = fresh.pressure;
    s->mass = fresh.mass;
    s->from_x = fresh.from_x;
    s->from_y = fresh.from_y;
    s->now_x = fresh.now_x;
    s->now_y = fresh.now_y;
    s->before_x = fresh.before_x;
    s->before_y = fresh.before_y;
    s->id = fresh.id;
    s->id_before = fresh.id_before;
    s->capacity = (int)capacity;
    return SKV_OK;
}

/* Cells of the smoothing radius; wider ones where a fine fluid stands in a huge world. */
static skv_result reserve_cells(skv_survey *s, double width, double height, skv_error *error)
{
    double cell = s->h;
    while ((width / cell + 1) * (height / cell + 1) > MAX_SURVEY_CELLS)
        cell *= 2;
    int columns = (int)(width / cell) + 1, rows = (int)(height / cell) + 1;
    if (columns * rows > s->cell_capacity) {
        int *cells = skv_calloc((size_t)columns * (size_t)rows + 1, sizeof *cells);
        if (!cells)
            return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the cells of a survey");
        skv_free(s->cell_start);
        s->cell_start = cells;
        s->cell_capacity = columns * rows;
    }
    s->cell = cell;
    s->columns = columns;
    s->rows = rows;
    return SKV_OK;
}

static int clamp_cell(double value, int count)
{
    return value < 0 ? 0 : value >= count ? count - 1 : (int)value;
}

static int cell_of(const skv_survey *s, float x, float y)
{
    return clamp_cell((double)y / s->cell, s->rows) * s->columns +
           clamp_cell((double)x / s->cell, s->columns);
}

cell_range skv_survey_cells(const skv_survey *s, double x0, double y0, double x1, double y1)
{
    return (cell_range){clamp_cell(x0 / s->cell, s->columns), clamp_cell(x1 / s->cell, s->columns),
                        clamp_cell(y0 / s->cell, s->rows), clamp_cell(y1 / s->cell, s->rows)};
}

/* Notes where the particle that was sorted to `at` came from. Both looks hold ascending ids, so
 * walking them side by side, with *before in the older one, finds who is in both. */
static void trace_back(skv_survey *s, int at, uint32_t id, int *before)
{
    s->from_x[at] = s->from_y[at] = NAN;
    if (s->time_before < 0)
        return;
    while (*before < s->count_before && s->id_before[*before] < id)
        ++*before;
    if (*before == s->count_before || s->id_before[*before] != id)
        return;
    s->from_x[at] = s->before_x[*before];
    s->from_y[at] = s->before_y[*before];
    double dx = (double)s->x[at] - (double)s->from_x[at];
    double dy = (double)s->y[at] - (double)s->from_y[at];
    s->travel = skv_max(s->travel, sqrt(dx * dx + dy * dy));
}

/* `masses` by the number of a fluid. */
static void sort(skv_survey *s, const skv_particles *particles, const float masses[])
{
    int before = 0;
    s->travel = 0;
    s->mixed = false;
    int cells = s->columns * s->rows;
    memset(s->cell_start, 0, ((size_t)cells + 1) * sizeof *s->cell_start);
    for (int i = 0; i < particles->count; i++)
        s->cell_start[cell_of(s, particles->x[i], particles->y[i]) + 1]++;
    for (int c = 0; c < cells; c++)
        s->cell_start[c + 1] += s->cell_start[c];
    /* Filling moves each start to its cell's end, which is the next cell's start. */
    for (int i = 0; i < particles->count; i++) {
        int at = s->cell_start[cell_of(s, particles->x[i], particles->y[i])]++;
        s->x[at] = particles->x[i];
        s->y[at] = particles->y[i];
        s->vx[at] = particles->vx[i];
        s->vy[at] = particles->vy[i];
        s->pressure[at] = particles->pressure[i];
        s->mass[at] = particles->fluid ? masses[particles->fluid[i]] : 1;
        s->mixed |= s->mass[at] != 1;
        trace_back(s, at, particles->id[i], &before);
    }
    memmove(s->cell_start + 1, s->cell_start, (size_t)cells * sizeof *s->cell_start);
    s->cell_start[0] = 0;
}

static void swap_floats(float **a, float **b)
{
    float *kept = *a;
    *a = *b;
    *b = kept;
}

/* The present look becomes the one before. */
static void remember(skv_survey *s, bool same_world)
{
    uint32_t *ids = s->id_before;
    s->id_before = s->id;
    s->id = ids;
    swap_floats(&s->before_x, &s->now_x);
    swap_floats(&s->before_y, &s->now_y);
    s->count_before = s->count;
    s->time_before = same_world ? s->time : -1;
}

void skv_survey_forget(skv_survey *s)
{
    s->count = 0;
    s->time = -1;
}

skv_result skv_survey_take(skv_survey *s, const skv_world *world, skv_error *error)
{
    return skv_survey_take_with(s, world, NULL, error);
}

skv_result skv_survey_take_with(skv_survey *s, const skv_world *world, const float *pressure,
                                skv_error *error)
{
    SKV_ASSERT_OR(s && world, SKV_ERROR_VALUE);
    skv_particles particles = skv_world_particles(world);
    particles.pressure = pressure ? pressure : particles.pressure;
    const skv_terrain *terrain = skv_world_terrain(world);
    bool same_world = s->terrain == terrain && skv_world_time(world) >= s->time;
    double width = (double)skv_terrain_width(terrain);
    double height = (double)skv_terrain_height(terrain);
    skv_result result = reserve_particles(s, particles.count, error);
    double h_before = s->h;
    s->h = (double)skv_world_smoothing_radius(world);
    if (result == SKV_OK)
        result = reserve_cells(s, width, height, error);
    if (result != SKV_OK) {
        s->h = h_before;
        return result;
    }
    /* Of a moment that is looked at again, what was before it stays. */
    if (!same_world || skv_world_time(world) > s->time)
        remember(s, same_world);
    float gx, gy;
    skv_world_gravity(world, &gx, &gy);
    s->gravity_x = (double)gx;
    s->gravity_y = (double)gy;
    if (terrain != s->terrain) {
        skv_terrain_destroy(s->terrain);
        s->terrain = skv_terrain_share(terrain);
    }
    s->time = skv_world_time(world);
    s->spacing = (double)skv_world_spacing(world);
    s->density = (double)skv_world_fluid(world)->density;
    s->count = particles.count;
    size_t bytes = (size_t)particles.count * sizeof(float);
    if (bytes) {
        memcpy(s->now_x, particles.x, bytes);
        memcpy(s->now_y, particles.y, bytes);
        memcpy(s->id, particles.id, (size_t)particles.count * sizeof *s->id);
    }
    float masses[SKV_MAX_FLUIDS];
    const skv_liquid *liquid;
    for (int i = 0; (liquid = skv_world_liquid(world, i)); i++)
        masses[i] = liquid->density / skv_world_fluid(world)->density;
    sort(s, &particles, masses);
    return SKV_OK;
}

double skv_survey_solid(const skv_survey *s, double x, double y)
{
    double d = (double)skv_terrain_distance(s->terrain, (float)x, (float)y) / s->h;
    if (!(d > 0))
        return 1;
    if (d >= 1)
        return 0;
    int i = (int)(d * SOLID_TABLE);
    double part = d * SOLID_TABLE - i;
    return s->solid_share[i] * (1 - part) + s->solid_share[i + 1] * part;
}

/* Sums with the weight q^2 over the particles around a point, offsets in h. */
typedef struct moments {
    int count;
    double weight, mass, x, y, xx, xy, yy;
    double value[3], value_x[3], value_y[3]; /* pressure, vx, vy; times the offsets */
} moments;

static void add_particle(moments *m, const skv_survey *s, int i, double dx, double dy, double w)
{
    double values[3] = {(double)s->pressure[i], (double)s->vx[i], (double)s->vy[i]};
    m->count++;
    m->weight += w;
    m->mass += w * (double)s->mass[i];
    m->x += w * dx;
    m->y += w * dy;
    m->xx += w * dx * dx;
    m->xy += w * dx * dy;
    m->yy += w * dy * dy;
    for (int k = 0; k < 3; k++) {
        m->value[k] += w * values[k];
        m->value_x[k] += w * dx * values[k];
        m->value_y[k] += w * dy * values[k];
    }
}

static moments look_around(const skv_survey *s, double x, double y)
{
    moments m = {0};
    double inv_h = 1 / s->h;
    cell_range cells = skv_survey_cells(s, x - s->h, y - s->h, x + s->h, y + s->h);
    for (int row = cells.row0; row <= cells.row1; row++) {
        int begin = s->cell_start[row * s->columns + cells.column0];
        int end = s->cell_start[row * s->columns + cells.column1 + 1];
        for (int i = begin; i < end; i++) {
            double dx = ((double)s->x[i] - x) * inv_h, dy = ((double)s->y[i] - y) * inv_h;
            double r2 = dx * dx + dy * dy;
            if (r2 < 1) {
                double q = 1 - sqrt(r2);
                add_particle(&m, s, i, dx, dy, skv_kernel_density(SKV_KERNEL_SPIKY, q));
            }
        }
    }
    return m;
}

/* The value at offset 0 of the weighted least-squares plane; the weighted mean where the points do
 * not span one. */
static double plane_at_origin(const moments *m, int k)
{
    enum { ENOUGH = 6 };
    double mean = m->value[k] / m->weight;
    /* Central moments. */
    double cx = m->x / m->weight, cy = m->y / m->weight;
    double xx = m->xx / m->weight - cx * cx, xy = m->xy / m->weight - cx * cy;
    double yy = m->yy / m->weight - cy * cy;
    double determinant = xx * yy - xy * xy;
    if (m->count < ENOUGH || !(determinant > 1e-5))
        return mean;
    double vx = m->value_x[k] / m->weight - cx * mean, vy = m->value_y[k] / m->weight - cy * mean;
    double slope_x = (vx * yy - vy * xy) / determinant;
    double slope_y = (vy * xx - vx * xy) / determinant;
    return mean - slope_x * cx - slope_y * cy;
}

/* Share of the free space around a point that is fluid, for the kernel sum found there. */
static double fill_of(const skv_survey *s, double weight, double solid)
{
    double eta = s->h / s->spacing;
    double share = weight * SKV_SPIKY_WHOLE / (SKV_PI * eta * eta);
    return solid < 0.98 ? share / (1 - solid) : 0;
}

double skv_survey_fill(const skv_survey *s, double x, double y)
{
    double weight = 0, inv_h = 1 / s->h;
    cell_range cells = skv_survey_cells(s, x - s->h, y - s->h, x + s->h, y + s->h);
    for (int row = cells.row0; row <= cells.row1; row++) {
        int begin = s->cell_start[row * s->columns + cells.column0];
        int end = s->cell_start[row * s->columns + cells.column1 + 1];
        for (int i = begin; i < end; i++) {
            double dx = ((double)s->x[i] - x) * inv_h, dy = ((double)s->y[i] - y) * inv_h;
            double r2 = dx * dx + dy * dy;
            if (r2 < 1) {
                double q = 1 - sqrt(r2);
                weight += skv_kernel_density(SKV_KERNEL_SPIKY, q);
            }
        }
    }
    return weight > 0 ? fill_of(s, weight, skv_survey_solid(s, x, y)) : 0;
}

double skv_survey_mean_mass(const skv_survey *s, double x, double y)
{
    moments m = look_around(s, x, y);
    return m.weight > 0 ? m.mass / m.weight : 1;
}

skv_local skv_survey_at(const skv_survey *s, double x, double y)
{
    skv_local local = {0};
    SKV_ASSERT_OR(s && isfinite(x) && isfinite(y), local);
    if (!s->terrain)
        return local;
    moments m = look_around(s, x, y);
    local.particles = m.count;
    if (m.count == 0)
        return local;
    double solid = skv_survey_solid(s, x, y);
    local.fill = fill_of(s, m.weight, solid);
    local.density = local.fill * (m.mass / m.weight) * s->density;
    local.wet = local.fill >= 0.5;
    local.pressure = plane_at_origin(&m, 0);
    local.vx = plane_at_origin(&m, 1);
    local.vy = plane_at_origin(&m, 2);
    return local;
}

/* A surface is looked for along a ray. */
typedef struct ray {
    const skv_survey *survey;
    double x, y, ux, uy;
} ray;

static double fill_on_ray(const ray *r, double distance)
{
    return skv_survey_fill(r->survey, r->x + distance * r->ux, r->y + distance * r->uy);
}

/* Spray has no depth. */
static bool has_depth(const ray *r, double distance, double h)
{
    for (int i = 1; i <= 4; i++) {
        double inside = distance - i * h / 4;
        if (inside < 0)
            return i > 1;
        if (fill_on_ray(r, inside) < 0.5)
            return false;
    }
    return true;
}

/* Cuts the part [*begin, *end] of a ray to where its coordinate lies in [low, high]. */
static void clip(double from, double direction, double low, double high, double *begin, double *end)
{
    if (direction == 0) {
        if (from < low || from > high)
            *end = -1;
        return;
    }
    double a = (low - from) / direction, b = (high - from) / direction;
    *begin = skv_max(*begin, skv_min(a, b));
    *end = skv_min(*end, skv_max(a, b));
}

bool skv_survey_surface(const skv_survey *s, double x0, double y0, double x1, double y1,
                        double *distance)
{
    SKV_ASSERT_OR(s && distance && isfinite(x0) && isfinite(y0) && isfinite(x1) && isfinite(y1),
                  false);
    double dx = x1 - x0, dy = y1 - y0, length = sqrt(dx * dx + dy * dy);
    if (!s->terrain || !(length > 0))
        return false;
    ray r = {s, x0, y0, dx / length, dy / length};
    /* There is no fluid farther than h from the world. */
    double begin = 0, end = length, step = s->h / 4;
    clip(x0, r.ux, -s->h, (double)skv_terrain_width(s->terrain) + s->h, &begin, &end);
    clip(y0, r.uy, -s->h, (double)skv_terrain_height(s->terrain) + s->h, &begin, &end);
    if (end < begin)
        return false;
    int steps = (int)ceil((end - begin) / step);
    for (int k = 0; k <= steps; k++) {
        double inner = skv_max(end - k * step, begin);
        if (fill_on_ray(&r, inner) < 0.5 || !has_depth(&r, inner, s->h))
            continue;
        double outer = skv_min(inner + step, end);
        for (int i = 0; i < 24; i++) {
            double middle = (inner + outer) / 2;
            if (fill_on_ray(&r, middle) < 0.5)
                outer = middle;
            else
                inner = middle;
        }
        *distance = inner;
        return true;
    }
    return false;
}
