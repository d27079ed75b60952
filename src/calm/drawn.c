/* Drawn surfaces as lines from column to column.
 *
 * Invariant: places stand from left to right, each in its column, so lines between them meet and
 * the surface is one height over each place.
 */
#include "calm/drawn.h"

#include "base/exact.h"

#include <math.h>
#include <stddef.h>

void skv_drawn_note(const skv_drawn_surface *surface, int column, float across, float height)
{
    skv_drawn_place *place = &surface->places[column - surface->first];
    if (!place->known || height > place->height)
        *place = (skv_drawn_place){across, height, true};
}

bool skv_drawn_is_uneven(const skv_drawn_surface *surface, float difference)
{
    float highest = -INFINITY, lowest = INFINITY;
    for (int k = 0; k < surface->count; k++)
        if (surface->places[k].known) {
            highest = skv_maxf(highest, surface->places[k].height);
            lowest = skv_minf(lowest, surface->places[k].height);
        }
    return highest - lowest > difference;
}

bool skv_drawn_is_gentle(const skv_drawn_surface *surface)
{
    int before = -1;
    for (int k = 0; k < surface->count; k++) {
        if (!surface->places[k].known)
            continue;
        float step = before < 0 ? 0 : surface->places[k].height - surface->places[before].height;
        float most = SKV_DRAWN_STEEPEST * surface->width * (float)(k - before);
        if (k - before > 2 || fabsf(step) > most)
            return false;
        before = k;
    }
    return surface->count - before <= 2;
}

/* The slope of the line between two places, which may be one. They may lie so close together that
 * the step in which heights were looked for is steep. */
static float slope_between(const skv_drawn_place *p, const skv_drawn_place *q)
{
    float slope = q == p ? 0 : (q->height - p->height) / (q->across - p->across);
    return skv_maxf(skv_minf(slope, SKV_DRAWN_STEEPEST), -SKV_DRAWN_STEEPEST);
}

/* The next place that is known, from a place on; null: there is none. */
static const skv_drawn_place *find_known(const skv_drawn_surface *surface, int from)
{
    for (int k = from; k < surface->count; k++)
        if (surface->places[k].known)
            return &surface->places[k];
    return NULL;
}

void skv_drawn_bridge(const skv_drawn_surface *surface)
{
    const skv_drawn_place *before = find_known(surface, 0);
    for (int k = 0; before && k < surface->count; k++) {
        skv_drawn_place *place = &surface->places[k];
        if (place->known) {
            before = place;
            continue;
        }
        const skv_drawn_place *after = find_known(surface, k + 1);
        place->across = ((float)(surface->first + k) + 0.5f) * surface->width;
        place->height = before->height + slope_between(before, after ? after : before) *
                                             (place->across - before->across);
    }
}

void skv_drawn_look(const skv_drawn_surface *surface, float across, float *height, float *slope)
{
    int last = surface->count - 1;
    float column = floorf(across / surface->width) - (float)surface->first;
    int k = (int)skv_maxf(skv_minf(column, (float)last), 0);
    if (k > 0 && (k == last || across < surface->places[k].across))
        k--;
    const skv_drawn_place *p = &surface->places[k], *q = &surface->places[k < last ? k + 1 : k];
    *slope = slope_between(p, q);
    *height = p->height + *slope * (across - p->across);
}
