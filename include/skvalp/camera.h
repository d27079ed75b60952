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

/** How far a camera goes: from the whole world, zoom 1, to a part of it. */
#define SKV_CAMERA_MAX_ZOOM 64

/** For reading; made by the functions below. */
typedef struct skv_camera {
    double scale;                     /**< view pixels a metre, > 0 */
    double origin_x, origin_y;        /**< the view pixel of the world's origin */
    int width, height;                /**< of the view, pixels, >= 1 */
    double world_width, world_height; /**< m */
    double centre_x, centre_y;        /**< the point of the world in the middle of the view, m */
    double zoom; /**< 1: the whole world as large as fits; at most SKV_CAMERA_MAX_ZOOM */
    int margin;  /**< view pixels that stay free beyond each side of the world */
} skv_camera;

/** Shows a whole world of the given size in metres (> 0), centred, as large as fits a view of the
 * given size in pixels; sizes below one pixel count as one. */
SKV_API skv_camera skv_camera_fit(int width, int height, double world_width, double world_height);

/** Shows as much of a world as fills the view, without bars beside it: the choice for a wide world
 * on an upright screen. Centred; pan moves it. */
SKV_API skv_camera skv_camera_fill(int width, int height, double world_width, double world_height);

/** Shows a world from near: `zoom` times as large as fits, with (centre_x, centre_y) in the middle.
 * What is out of bounds gives way: the zoom keeps to 1..SKV_CAMERA_MAX_ZOOM, and no side of the
 * world comes further in than it must. So a view that changes its size keeps what it shows:
 * skv_camera_at(new_width, new_height, ..., old.centre_x, old.centre_y, old.zoom). */
SKV_API skv_camera skv_camera_at(int width, int height, double world_width, double world_height,
                                 double centre_x, double centre_y, double zoom);

/** The same with a margin: what lies on a side of the world, a lid for example, is seen whole. At
 * most an eighth of the view's shorter side counts. */
SKV_API skv_camera skv_camera_apart(int margin, int width, int height, double world_width,
                                    double world_height, double centre_x, double centre_y,
                                    double zoom);

/** Zooms by a factor (> 0) about a view pixel, which goes on showing the same point of the world
 * as long as the bounds of skv_camera_at allow. */
SKV_API void skv_camera_zoom(skv_camera *camera, double factor, double px, double py);

/** Moves the picture by so many view pixels, within the same bounds. */
SKV_API void skv_camera_pan(skv_camera *camera, double dx, double dy);

/** The point of the world, in metres, at a view pixel, and the view pixel of such a point. */
SKV_API void skv_camera_to_world(const skv_camera *camera, double px, double py, double *x,
                                 double *y);
SKV_API void skv_camera_to_view(const skv_camera *camera, double x, double y, double *px,
                                double *py);

#ifdef __cplusplus
}
#endif
#endif
