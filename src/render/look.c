/* The look: the two palettes. Invariant: fluid, wall and background differ clearly in brightness as
 * well as in hue, so that the picture reads without colour vision too. */
#include "render/look.h"

#include <math.h>

#define RGB(code)                                                                                  \
    {(float)((code) >> 16 & 255) / 255, (float)((code) >> 8 & 255) / 255,                          \
     (float)((code) & 255) / 255}
#define RGBA(code, alpha)                                                                          \
    {(float)((code) >> 16 & 255) / 255, (float)((code) >> 8 & 255) / 255,                          \
     (float)((code) & 255) / 255, alpha}

static const skv_palette dark_palette = {
    .sky = RGB(0x1b2434),
    .ground = RGB(0x10151f),
    .shade = RGB(0x090c12),
    .wall = RGB(0x56606f),
    .wall_edge = RGB(0x8b96a6),
    .shallow = RGB(0x2a83f6),
    .middle = RGB(0x8a4df0),
    .deep = RGB(0xffffff),
    .surface = RGB(0xa9dcff),
    .tracer = RGBA(0xffffff, 0.92f),
    .hand = RGBA(0xffffff, 0.5f),
};

static const skv_palette light_palette = {
    .sky = RGB(0xf4f8fb),
    .ground = RGB(0xdde7ef),
    .shade = RGB(0xb9c6d2),
    .wall = RGB(0x6d7887),
    .wall_edge = RGB(0x4d5866),
    .shallow = RGB(0x2277e8),
    .middle = RGB(0x7c3fe0),
    .deep = RGB(0xffffff),
    .surface = RGB(0x8fd0ff),
    .tracer = RGBA(0xffffff, 0.92f),
    .hand = RGBA(0x1b2434, 0.45f),
};

const skv_palette *skv_look_palette(int dark)
{
    return dark ? &dark_palette : &light_palette;
}

double skv_look_line(const skv_camera *camera)
{
    return fmax(fmin(camera->width, camera->height) / 720.0, 1);
}
