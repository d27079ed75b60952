/** @file
 * Marks: what tools show over the picture of a world: the ring of a hand, a brush's outline, the
 * line that a wall will follow. Plain data in metres; a renderer gives every role its colours, so
 * that a mark can be seen on any background.
 */
#ifndef SKVALP_MARK_H
#define SKVALP_MARK_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum skv_mark_shape {
    SKV_MARK_POINT,  /**< a dot of a few pixels at (x0, y0) */
    SKV_MARK_CIRCLE, /**< a ring of `radius` about (x0, y0), faintly filled */
    SKV_MARK_SEGMENT /**< a line from (x0, y0) to (x1, y1) */
} skv_mark_shape;

/** What a mark is for. */
typedef enum skv_mark_role {
    SKV_MARK_HAND,   /**< holds fluid */
    SKV_MARK_BRUSH,  /**< where a tool would work */
    SKV_MARK_SOURCE, /**< gives fluid */
    SKV_MARK_SINK,   /**< takes fluid */
    SKV_MARK_WIND,   /**< blows fluid on */
    SKV_MARK_PROBE,  /**< measures */
    SKV_MARK_REFUSED /**< where a tool cannot work */
} skv_mark_role;

typedef struct skv_mark {
    skv_mark_shape shape;
    skv_mark_role role;
    float x0, y0, x1, y1; /**< m */
    float radius;         /**< m, of a circle */
    bool dashed;          /**< a circle's or a segment's line is broken: not yet done */
    int dye;              /**< a circle is full of this colour, as skv_dye_name; 0: hardly */
} skv_mark;

#ifdef __cplusplus
}
#endif
#endif
