/* The look: palettes and scales. Invariant: fluid against walls has a contrast of 3:1 or more in
 * grey, every eye tells the fluids of a palette apart, and scales grow in lightness from one end to
 * the other, so that the picture reads without colour vision too. */
#include "render/look.h"

#include <math.h>
#include <string.h>

#define EARTH_GRAVITY 9.81
#define SCALE_COLORS  9

#define RGB(code)                                                                                  \
    {(float)((code) >> 16 & 255) / 255, (float)((code) >> 8 & 255) / 255,                          \
     (float)((code) & 255) / 255}
#define RGBA(code, alpha)                                                                          \
    {(float)((code) >> 16 & 255) / 255, (float)((code) >> 8 & 255) / 255,                          \
     (float)((code) & 255) / 255, alpha}

static const skv_colors palettes[] =
    {
        [SKV_PALETTE_DARK] =
            {
                .sky = RGB(0x17202e),
                .ground = RGB(0x0b1018),
                .shade = RGB(0x05070b),
                .wall = RGB(0x222933),
                .wall_edge = RGB(0x596678),
                .shallow = RGB(0x5cc8f2),
                .deep = RGB(0x2078cc),
                .surface = RGB(0xe4f8ff),
                .light = RGB(0xd3f2ff),
                .outline = RGB(0xf2f8ff),
                .relief = 1,
                .foam = 0.7f,
                .murk = {2.0f, 1.15f, 0.8f},
                .dyes = {RGB(0xf2487c), RGB(0xe0a92e), RGB(0xb8f05a), RGB(0xb674b0)},
                .fluids = {RGB(0xf9da0e), RGB(0xf05b30), RGB(0xc4fea0), RGB(0xccb0fa),
                           RGB(0xf09c66), RGB(0x8b9184), RGB(0x43fae4)},
                .bubble = RGBA(0xffffff, 0.6f),
                .ink = RGBA(0xffffff, 0.92f),
                .faint = RGBA(0xc8d6e8, 0.16f),
                .figures = RGBA(0xf2f6fa, 1),
                .plate = RGBA(0x05080d, 0.62f),
                .marks = {RGBA(0xffffff, 0.75f), RGBA(0xffffff, 0.85f), RGBA(0x7ee7a0, 0.9f),
                          RGBA(0xffa27d, 0.9f), RGBA(0xc3d4ff, 0.9f), RGBA(0xffe27a, 0.95f),
                          RGBA(0xff6b6b, 0.95f)},
                .halo = RGBA(0x05080d, 0.5f),
            },
        [SKV_PALETTE_LIGHT] =
            {
                .sky = RGB(0xf8fbfd),
                .ground = RGB(0xe9f0f6),
                .shade = RGB(0xc9d4de),
                .wall = RGB(0xd6dee7),
                .wall_edge = RGB(0x223040),
                .shallow = RGB(0x2274c2),
                .deep = RGB(0x0c468f),
                .surface = RGB(0x0a3a78),
                .light = RGB(0x9fd4f7),
                .outline = RGB(0x16202c),
                .relief = 0.7f,
                .foam = 0.55f,
                .murk = {1.6f, 1.1f, 0.8f},
                .dyes = {RGB(0xb81b56), RGB(0xac6608), RGB(0x14521a), RGB(0x521a66)},
                .fluids = {RGB(0x9a6501), RGB(0x96220d), RGB(0x24572f), RGB(0xb512cf),
                           RGB(0x7e674f), RGB(0x595663), RGB(0x1c7d81)},
                .bubble = RGBA(0xffffff, 0.6f),
                .ink = RGBA(0xffffff, 0.92f),
                .faint = RGBA(0x1b2434, 0.14f),
                .figures = RGBA(0x10161e, 1),
                .plate = RGBA(0xffffff, 0.78f),
                .marks = {RGBA(0x1b2434, 0.75f), RGBA(0x1b2434, 0.85f), RGBA(0x0c6b35, 0.9f),
                          RGBA(0xa63a0c, 0.9f), RGBA(0x2a3f8f, 0.9f), RGBA(0x6a4a00, 0.95f),
                          RGBA(0xb3121d, 0.95f)},
                .halo = RGBA(0xffffff, 0.6f),
            },
        [SKV_PALETTE_CONTRAST] =
            {
                .sky = RGB(0x000000),
                .ground = RGB(0x000000),
                .shade = RGB(0x000000),
                .wall = RGB(0xffffff),
                .wall_edge = RGB(0x000000),
                .shallow = RGB(0x1274e8),
                .deep = RGB(0x1274e8),
                .surface = RGB(0xffffff),
                .light = RGB(0xffffff),
                .outline = RGB(0x000000),
                .relief = 0,
                .foam = 0,
                .murk = {1, 1, 1},
                .dyes = {RGB(0xd23f73), RGB(0xc3880d), RGB(0x206b14), RGB(0x932c99)},
                .fluids =
                    {RGB(0xb0882e), RGB(0xad2b26), RGB(0x678660), RGB(0x8858a9), RGB(0xae630f),
                     RGB(0x919291), RGB(0x0e7465)},
                .ink = RGBA(0xffffff, 1),
                .faint = RGBA(0xffffff, 0.4f),
                .figures = RGBA(0xffffff, 1),
                .plate = RGBA(0x000000, 1),
                .marks = {RGBA(0xffffff, 1), RGBA(0xffffff, 1), RGBA(0xffff00, 1),
                          RGBA(0xffff00, 1), RGBA(0xffff00, 1), RGBA(0xffff00, 1),
                          RGBA(0xff9d9d, 1)},
                .halo = RGBA(0x000000, 1),
            },
};

const skv_colors *skv_look_colors(skv_palette palette)
{
    return &palettes[palette];
}

/* Even steps of lightness, CIE L* 52 to 96, so that walls of the dark palette stand off the lower
 * end: the thesis' blue, purple, white; violet, red, yellow; blue, green, yellow. */
static const float pressure_scale[SCALE_COLORS][3] = {RGB(0x1e78f2), RGB(0x6182fe), RGB(0x8c8dff),
                                                      RGB(0xaf9afe), RGB(0xcca7fe), RGB(0xe6b5ff),
                                                      RGB(0xfcc5fe), RGB(0xfedcf8), RGB(0xfcf4f9)};
static const float speed_scale[SCALE_COLORS][3] = {RGB(0xa05fce), RGB(0xbd6bc6), RGB(0xd679bc),
                                                   RGB(0xf484a5), RGB(0xfe9c88), RGB(0xfeb57f),
                                                   RGB(0xffcc7b), RGB(0xfee386), RGB(0xf9f6c5)};
static const float density_scale[SCALE_COLORS][3] = {RGB(0x2286a6), RGB(0x0798a9), RGB(0x09a9a8),
                                                     RGB(0x11bba1), RGB(0x3fcb93), RGB(0x70d97b),
                                                     RGB(0xa5e558), RGB(0xd2ee58), RGB(0xf9f676)};

void skv_look_scale(skv_view view, double place, float color[3])
{
    const float(*scale)[3] = view == SKV_VIEW_PRESSURE  ? pressure_scale
                             : view == SKV_VIEW_DENSITY ? density_scale
                                                        : speed_scale;
    double at = fmin(fmax(place, 0), 1) * (SCALE_COLORS - 1);
    int i = at < SCALE_COLORS - 1 ? (int)at : SCALE_COLORS - 2;
    float share = (float)(at - i);
    for (int k = 0; k < 3; k++)
        color[k] = scale[i][k] + share * (scale[i + 1][k] - scale[i][k]);
}

/* The place in a palette's list of fluids whose colour suits a material; -1: none does. */
static int place_of_material(const skv_liquid *liquid)
{
    static const struct {
        const char *name;
        int place;
    } fitting[] = {{"oil", 0}, {"honey", 4}, {"mercury", 5}};
    const skv_material *material;
    for (int i = 0; (material = skv_material_info(i)); i++)
        for (size_t k = 0; k < sizeof fitting / sizeof *fitting; k++)
            if (strcmp(material->name, fitting[k].name) == 0 &&
                material->density == liquid->density && material->viscosity == liquid->viscosity)
                return fitting[k].place;
    return -1;
}

/* A fluid's place in a palette's list: what suits its material, if it is the first that it suits;
 * else the first from its own number on that suits no other and was not given to one before it. The
 * first fluid has only what suits its material, or -1. */
static int place_of(const skv_frame *frame, int number)
{
    int given[SKV_MAX_FLUIDS] = {-1};
    bool taken[SKV_MAX_FLUIDS - 1] = {false};
    for (int i = 0; i < frame->fluid_count; i++) {
        given[i] = place_of_material(&frame->fluids[i]);
        if (given[i] >= 0 && taken[given[i]])
            given[i] = -1;
        if (given[i] >= 0)
            taken[given[i]] = true;
    }
    for (int i = 1; i < frame->fluid_count && i <= number; i++) {
        int place = i - 1;
        while (given[i] < 0 && taken[place])
            place = (place + 1) % (SKV_MAX_FLUIDS - 1);
        if (given[i] < 0)
            given[i] = place;
        taken[given[i]] = true;
    }
    return number < frame->fluid_count ? given[number] : number - 1;
}

bool skv_look_fluid(const skv_colors *colors, const skv_frame *frame, int number, float color[3])
{
    int own = number < frame->fluid_count ? frame->fluids[number].color : -1;
    int place = own < 0 ? place_of(frame, number) : 0;
    for (int k = 0; k < 3; k++)
        color[k] = own >= 0     ? (float)(own >> (16 - 8 * k) & 255) / 255
                   : place >= 0 ? colors->fluids[place][k]
                                : sqrtf(colors->shallow[k] * colors->deep[k]);
    return place >= 0;
}

double skv_look_line(const skv_camera *camera)
{
    return fmax(fmin(camera->width, camera->height) / 720.0, 1);
}

double skv_look_depth(const skv_frame *frame)
{
    float lowest, highest;
    skv_terrain_free_range(frame->terrain, &lowest, &highest);
    double spacing = (double)frame->spacing, free_area = skv_terrain_free_area(frame->terrain);
    double fluid_area = frame->particles.count * spacing * spacing;
    double filled = free_area > 0 ? fluid_area / free_area : 1;
    double height = (double)highest - (double)lowest;
    return fmax(fmax(1.6 * sqrt(fmin(filled, 1)), 0.3) * height, spacing);
}

double skv_look_speed(const skv_frame *frame)
{
    double gravity = hypot((double)frame->gravity_x, (double)frame->gravity_y);
    return sqrt(2 * fmax(gravity, 0.1 * EARTH_GRAVITY) * skv_look_depth(frame));
}
