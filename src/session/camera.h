/* The one camera there is: the whole world, centred, as large as fits. Shared with the renderer's
 * pictures without a window. */
#ifndef SKV_SESSION_CAMERA_H
#define SKV_SESSION_CAMERA_H

#include "skvalp/session.h"

/* Fits a world of the given size in metres into a view in pixels; sizes below one pixel count as
 * one. */
skv_camera skv_camera_fit(int width, int height, double world_width, double world_height);

#endif
