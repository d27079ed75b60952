/* A region of the plane: a box, and in it a circle, one that is swept along a way, or a polygon. */
#ifndef SKV_BASE_REGION_H
#define SKV_BASE_REGION_H

#include <stdbool.h>

typedef struct skv_region {
    float x0, y0, x1, y1; /* the box; nothing lies in it if x0 > x1 */
    float x, y, radius;   /* the circle; none if the radius is negative ... */
    float way_x, way_y;   /* ... and the way along which it is swept */
    const float *corners; /* of the polygon, x, y, x, y, ... */
    int count;            /* of corners; 0: no polygon */
} skv_region;

/* Whether the region holds a point of its box. A polygon holds a point from which a line to the
 * right crosses an odd number of sides. */
bool skv_region_cut(const skv_region *region, float x, float y);

static inline bool skv_region_holds(const skv_region *r, float x, float y)
{
    return x >= r->x0 && x <= r->x1 && y >= r->y0 && y <= r->y1 && skv_region_cut(r, x, y);
}

#endif
