/* Asking whether points lie in an area. */
#ifndef SKV_WORLD_AREA_H
#define SKV_WORLD_AREA_H

#include "skvalp/world.h"

/* An area that has been checked, and its bounds. */
typedef struct skv_bounds {
    const skv_area *area;
    float x0, y0, x1, y1; /* nothing lies in it if x0 > x1 */
} skv_bounds;

skv_bounds skv_area_bounds(const skv_area *area);
bool skv_is_within(const skv_bounds *bounds, float x, float y);

#endif
