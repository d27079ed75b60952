/** @file
 * Camera: where the world is in a view. Between view pixels (from the upper left corner, y down, as
 * toolkits count them) and metres (from the world's lower left corner, y up). Plain values without
 * a state: every call is thread-safe.
 */
#ifndef SKVALP_CAMERA_H
#define SKVALP_CAMERA_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct skv_camera {
    double scale;              /**< view pixels a metre, > 0 */
    double origin_x, origin_y; /**< the view pixel of the world's origin */
    int width, height;         /**< of the view, pixels, >= 1 */
} skv_camera;

/** Shows a whole world of the given size in metres (> 0), centred, as large as fits a view of the
 * given size in pixels; sizes below one pixel count as one. */
SKV_API skv_camera skv_camera_fit(int width, int height, double world_width, double world_height);

/** The point of the world, in metres, at a view pixel. */
SKV_API void skv_camera_to_world(const skv_camera *camera, double px, double py, double *x,
                                 double *y);

#ifdef __cplusplus
}
#endif
#endif
