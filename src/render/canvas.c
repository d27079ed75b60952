/* Canvas: from metres to view pixels and from roles to colours. Invariant: pixels count from the
 * lower left corner, as strokes do. */
#include "render/canvas.h"

#include <math.h>

#include "base/exact.h"

float skv_overlay_x(const skv_camera *camera, double x)
{
    return (float)(camera->origin_x + camera->scale * x);
}

float skv_overlay_y(const skv_camera *camera, double y)
{
    return (float)(camera->height - camera->origin_y + camera->scale * y);
}

const float *skv_overlay_ink(const skv_overlay_scene *scene)
{
    static const float dark[4] = {0.04f, 0.06f, 0.09f, 0.85f};
    return scene->legend->shown ? dark : scene->colors->ink;
}

void skv_stroke_paint(skv_stroke *stroke, const float color[4], double share)
{
    for (int i = 0; i < 4; i++)
        stroke->color[i] = (uint8_t)lround(255 * (double)color[i] * (i == 3 ? share : 1));
}

double skv_overlay_step(const skv_camera *camera, double pixels)
{
    double least = pixels / camera->scale;
    if (least <= 0.1 && least > 0.01)
        return 0.1;
    double decade = skv_decade(least);
    double figure = least / decade;
    return decade * (figure <= 1 ? 1 : figure <= 2 ? 2 : figure <= 5 ? 5 : 10);
}
