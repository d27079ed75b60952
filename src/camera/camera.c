/* Camera: between view pixels (y down) and metres (y up). Invariant: a camera's scale is positive,
 * so that every pixel has a point in the world. */
#include "skvalp/camera.h"

#include "base/assert.h"

skv_camera skv_camera_fit(int width, int height, double world_width, double world_height)
{
    SKV_ASSERT_OR(world_width > 0 && world_height > 0,
                  (skv_camera){.scale = 1, .width = 1, .height = 1});
    skv_camera camera = {.width = width < 1 ? 1 : width, .height = height < 1 ? 1 : height};
    double scale_x = camera.width / world_width;
    double scale_y = camera.height / world_height;
    camera.scale = scale_x < scale_y ? scale_x : scale_y;
    camera.origin_x = 0.5 * (camera.width - camera.scale * world_width);
    camera.origin_y = 0.5 * (camera.height + camera.scale * world_height);
    return camera;
}

void skv_camera_to_world(const skv_camera *camera, double px, double py, double *x, double *y)
{
    SKV_ASSERT(camera && camera->scale > 0 && x && y);
    *x = (px - camera->origin_x) / camera->scale;
    *y = (camera->origin_y - py) / camera->scale;
}
