/** @file
 * Areas: regions of the plane, as plain data.
 */
#ifndef SKVALP_AREA_H
#define SKVALP_AREA_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SKV_MAX_CORNERS 64 /**< of an area's polygon */

/** A region of the plane, to ask for particles or to act on them: plain data, made by one of the
 * functions below. What is not finite, a circle of negative radius, and a polygon of fewer than 3
 * or more than SKV_MAX_CORNERS corners contain nothing. */
typedef enum skv_area_kind {
    SKV_AREA_CIRCLE,
    SKV_AREA_BOX,
    SKV_AREA_POLYGON,
    SKV_AREA_SWEPT_CIRCLE
} skv_area_kind;
typedef struct skv_area {
    skv_area_kind kind;
    float x0, y0, x1, y1; /**< box: two opposite corners; circle: its centre first; swept circle:
                             the two ends of its way; m */
    float radius;         /**< of a circle, m */
    int count;            /**< corners of a polygon */
    float corners[2 * SKV_MAX_CORNERS]; /**< x, y, x, y, ..., m */
} skv_area;

SKV_API skv_area skv_circle(float x, float y, float radius);
/** All that a circle covers on a straight way from (x0, y0) to (x1, y1): the stroke of a brush. */
SKV_API skv_area skv_swept_circle(float x0, float y0, float x1, float y1, float radius);
SKV_API skv_area skv_box(float x0, float y0, float x1, float y1);
/** `count` corners of two floats each, which are copied; the last is joined to the first. A point
 * is inside if a line from it to far away crosses an odd number of sides. */
SKV_API skv_area skv_polygon(const float *corners, int count);

#ifdef __cplusplus
}
#endif
#endif
