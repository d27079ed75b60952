/* Camera: between view pixels (y down) and metres (y up). Invariant: scale and origin follow from
 * the view's and the world's sizes, the centre and the zoom, all of them within their bounds; so
 * every pixel has a point in the world. */
#include "skvalp/camera.h"

#include "base/assert.h"

static double clamp(double value, double low, double high)
{
    return value > low ? (value < high ? value : high) : low;
}

/* The centre nearest to the wanted one with which no bar is wider than it must be; all in m. */
static double bounded_centre(double wanted, double world, double shown, double margin)
{
    return shown < world + 2 * margin
               ? clamp(wanted, 0.5 * shown - margin, world - 0.5 * shown + margin)
               : 0.5 * world;
}

/* Everything else from sizes, centre and zoom. */
static void place(skv_camera *camera, double centre_x, double centre_y, double zoom)
{
    int shorter = camera->width < camera->height ? camera->width : camera->height;
    int widest = shorter / 8;
    double margin = clamp(camera->margin, 0, widest);
    double scale_x = (camera->width - 2 * margin) / camera->world_width;
    double scale_y = (camera->height - 2 * margin) / camera->world_height;
    camera->zoom = clamp(zoom, 1, SKV_CAMERA_MAX_ZOOM);
    camera->scale = camera->zoom * (scale_x < scale_y ? scale_x : scale_y);
    margin /= camera->scale;
    camera->centre_x =
        bounded_centre(centre_x, camera->world_width, camera->width / camera->scale, margin);
    camera->centre_y =
        bounded_centre(centre_y, camera->world_height, camera->height / camera->scale, margin);
    camera->origin_x = 0.5 * camera->width - camera->scale * camera->centre_x;
    camera->origin_y = 0.5 * camera->height + camera->scale * camera->centre_y;
}

skv_camera skv_camera_apart(int margin, int width, int height, double world_width,
                            double world_height, double centre_x, double centre_y, double zoom)
{
    skv_camera camera = {.width = width < 1 ? 1 : width,
                         .height = height < 1 ? 1 : height,
                         .world_width = world_width,
                         .world_height = world_height,
                         .margin = margin};
    SKV_ASSERT_OR(
        world_width > 0 && world_height > 0,
        (skv_camera){
            .scale = 1, .width = 1, .height = 1, .world_width = 1, .world_height = 1, .zoom = 1});
    place(&camera, centre_x, centre_y, zoom);
    return camera;
}

skv_camera skv_camera_at(int width, int height, double world_width, double world_height,
                         double centre_x, double centre_y, double zoom)
{
    return skv_camera_apart(0, width, height, world_width, world_height, centre_x, centre_y, zoom);
}

skv_camera skv_camera_fit(int width, int height, double world_width, double world_height)
{
    return skv_camera_at(width, height, world_width, world_height, 0, 0, 1);
}

skv_camera skv_camera_fill(int width, int height, double world_width, double world_height)
{
    skv_camera camera = skv_camera_fit(width, height, world_width, world_height);
    double across = camera.width / (camera.scale * camera.world_width);
    double upwards = camera.height / (camera.scale * camera.world_height);
    place(&camera, 0.5 * camera.world_width, 0.5 * camera.world_height,
          across > upwards ? across : upwards);
    return camera;
}

void skv_camera_zoom(skv_camera *camera, double factor, double px, double py)
{
    SKV_ASSERT(camera && camera->world_width > 0 && factor > 0);
    double x = 0, y = 0;
    skv_camera_to_world(camera, px, py, &x, &y);
    double before = camera->zoom;
    double after = clamp(before * factor, 1, SKV_CAMERA_MAX_ZOOM);
    place(camera, x + (camera->centre_x - x) * before / after,
          y + (camera->centre_y - y) * before / after, after);
}

void skv_camera_pan(skv_camera *camera, double dx, double dy)
{
    SKV_ASSERT(camera && camera->world_width > 0);
    place(camera, camera->centre_x - dx / camera->scale, camera->centre_y + dy / camera->scale,
          camera->zoom);
}

void skv_camera_to_world(const skv_camera *camera, double px, double py, double *x, double *y)
{
    SKV_ASSERT(camera && camera->scale > 0 && x && y);
    *x = (px - camera->origin_x) / camera->scale;
    *y = (camera->origin_y - py) / camera->scale;
}

void skv_camera_to_view(const skv_camera *camera, double x, double y, double *px, double *py)
{
    SKV_ASSERT(camera && camera->scale > 0 && px && py);
    *px = camera->origin_x + x * camera->scale;
    *py = camera->origin_y - y * camera->scale;
}
