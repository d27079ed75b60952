/* Emitters and drains as data. Invariant: a row of an emitter takes the area that flows off between
 * two rows, so rows are as dense as fluid at rest, whatever the width. */
#include "world/emitters.h"

#include "base/exact.h"
#include "base/fields.h"
#include "world/area.h"
#include "world/dye.h"
#include "world/liquids.h"
#include "world/world_internal.h"

#include <math.h>

#define MOUTH 1.0f /* h: how far the emitter's velocity is kept up */

skv_result skv_check_emitters(const skv_emitter *emitters, int count, int fluids, skv_error *error)
{
    if (count < 0 || count > SKV_MAX_EMITTERS)
        return skv_fail(error, SKV_ERROR_LIMIT, "%d emitters; allowed is 0..%d", count,
                        SKV_MAX_EMITTERS);
    for (int i = 0; i < count; i++) {
        const skv_emitter *e = &emitters[i];
        if (!skv_within((double)e->x, -100, 100) || !skv_within((double)e->y, -100, 100) ||
            !skv_within((double)e->vx, -20, 20) || !skv_within((double)e->vy, -20, 20) ||
            !skv_within((double)e->width, (double)1e-4f, 100))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "emitter %d: a place within 100 m, velocities of +-20 m/s and a width "
                            "of 0.0001..100 m are allowed",
                            i);
        skv_result result = skv_check_dye(e->dye, error);
        if (result == SKV_OK)
            result = skv_check_fluid(e->fluid, fluids, error);
        if (result != SKV_OK)
            return result;
    }
    return SKV_OK;
}

skv_result skv_check_drains(const skv_drain *drains, int count, skv_error *error)
{
    if (count < 0 || count > SKV_MAX_DRAINS)
        return skv_fail(error, SKV_ERROR_LIMIT, "%d drains; allowed is 0..%d", count,
                        SKV_MAX_DRAINS);
    for (int i = 0; i < count; i++) {
        if (!skv_area_is_sane(&drains[i].area) || !skv_within((double)drains[i].rate, 0, 10000))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "drain %d: a finite area and a rate of 0..10000 m^2/s are allowed", i);
    }
    return SKV_OK;
}

skv_stream skv_new_stream(skv_particle_id next)
{
    skv_stream stream = {.pauses = true};
    for (int i = 0; i < SKV_RECENT_ROWS; i++)
        stream.recent[i] = next;
    return stream;
}

float skv_emitter_speed(const skv_emitter *e)
{
    return sqrtf(e->vx * e->vx + e->vy * e->vy);
}

skv_region skv_mouth(const skv_emitter *e, float h, float corners[8])
{
    float speed = skv_emitter_speed(e), dx = e->vx / speed, dy = e->vy / speed;
    float half = 0.5f * e->width, length = MOUTH * h;
    for (int i = 0; i < 4; i++) {
        float aside = i == 0 || i == 3 ? -half : half, ahead = i < 2 ? 0 : length;
        corners[2 * i] = e->x + ahead * dx - aside * dy;
        corners[2 * i + 1] = e->y + ahead * dy + aside * dx;
    }
    skv_region r = {.x0 = corners[0],
                    .y0 = corners[1],
                    .x1 = corners[0],
                    .y1 = corners[1],
                    .radius = -1,
                    .corners = corners,
                    .count = 4};
    for (int i = 1; i < 4; i++) {
        r.x0 = skv_minf(r.x0, corners[2 * i]);
        r.x1 = skv_maxf(r.x1, corners[2 * i]);
        r.y0 = skv_minf(r.y0, corners[2 * i + 1]);
        r.y1 = skv_maxf(r.y1, corners[2 * i + 1]);
    }
    return r;
}

void skv_make_mouth_force(const skv_emitter *e, float h, skv_external_force *force)
{
    *force =
        (skv_external_force){.field = true, .unit = 1, .softness = h * h, .vx = e->vx, .vy = e->vy};
    force->region = skv_mouth(e, h, force->corners);
    force->follow = 1;
}

skv_emitter_rows skv_emitter_lay_out(const skv_emitter *e, float spacing)
{
    double s = (double)spacing, width = (double)e->width, speed = (double)skv_emitter_speed(e);
    int columns = (int)(width / (s * sqrt(2 / sqrt(3.0))) + 0.5);
    columns = columns < 1 ? 1 : columns < SKV_MOST_COLUMNS ? columns : SKV_MOST_COLUMNS;
    double apart = width / columns;
    return (skv_emitter_rows){columns, apart, s * s / apart, (double)e->vx / speed,
                              (double)e->vy / speed};
}

bool skv_emitter_is_wide(const skv_emitter *e, float spacing, char *text, size_t size)
{
    float most = SKV_MOST_COLUMNS * spacing;
    if (!(e->width > most))
        return false;
    char width[32], allowed[32];
    skv_format_float((double)e->width, width);
    skv_format_float((double)most, allowed);
    skv_format(text, size,
               "is %s m wide; allowed are %d spacings, %s m, so make it narrower or choose fewer "
               "particles",
               width, SKV_MOST_COLUMNS, allowed);
    return true;
}

void skv_emitter_place(const skv_emitter *e, const skv_emitter_rows *rows, double way, bool odd,
                       int column, float *x, float *y)
{
    double aside = (column + (odd ? 0.75 : 0.25)) * rows->apart - 0.5 * (double)e->width;
    *x = (float)((double)e->x + way * rows->dx - aside * rows->dy);
    *y = (float)((double)e->y + way * rows->dy + aside * rows->dx);
}

/* ---- Snapshots ------------------------------------------------------------------------------- */

static void exchange_emitter(skv_port *port, skv_emitter *e, skv_stream *stream)
{
    float *const numbers[] = {&e->x, &e->y, &e->vx, &e->vy, &e->width};
    for (int i = 0; i < 5; i++)
        skv_exchange_float(port, numbers[i]);
    skv_exchange_contents(port, &e->dye, &e->fluid);
    skv_exchange_double(port, &stream->travelled);
    skv_exchange_double(port, &stream->way);
    uint64_t odd = stream->odd;
    skv_exchange(port, &odd, 1);
    stream->odd = odd != 0;
    for (int i = 0; i < SKV_RECENT_ROWS; i++) {
        uint64_t id = stream->recent[i];
        skv_exchange(port, &id, 4);
        stream->recent[i] = (skv_particle_id)id;
    }
}

static void exchange_totals(skv_port *port, skv_flow *flow)
{
    int64_t *const totals[] = {&flow->emitted, &flow->drained, &flow->left, &flow->replaced,
                               &flow->blocked};
    for (int i = 0; i < 5; i++) {
        uint64_t total = (uint64_t)*totals[i];
        skv_exchange(port, &total, 8);
        *totals[i] = (int64_t)(total & INT64_MAX);
    }
}

skv_result skv_exchange_flow(skv_port *port, skv_acting *a, int fluids, skv_error *error)
{
    bool sane = skv_exchange_count(port, &a->emitter_count, SKV_MAX_EMITTERS);
    for (int i = 0; i < a->emitter_count; i++) {
        exchange_emitter(port, &a->emitters[i], &a->streams[i]);
        sane = skv_within(a->streams[i].way, 0, 100) &&
               skv_within(a->streams[i].travelled, 0, 1e12) && sane;
    }
    sane = skv_exchange_count(port, &a->drain_count, SKV_MAX_DRAINS) && sane;
    for (int i = 0; i < a->drain_count; i++) {
        skv_exchange_area(port, &a->drains[i].area);
        skv_exchange_float(port, &a->drains[i].rate);
        skv_exchange_double(port, &a->drainable[i]);
        sane = skv_within(a->drainable[i], 0, 1e12) && sane;
    }
    exchange_totals(port, &a->flow);
    if (!sane)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "snapshot: it holds emitters or drains that no world has");
    skv_result result = skv_check_emitters(a->emitters, a->emitter_count, fluids, error);
    return result == SKV_OK ? skv_check_drains(a->drains, a->drain_count, error) : result;
}
