/* The look of bodies: each as what things of its density are made of. Invariant: every eye tells
 * the materials of a palette apart, and each stands out against water and air. */
#include "render/body_look.h"

#include <math.h>

#define RGBA(code)                                                                                 \
    {(float)((code) >> 16 & 255) / 255, (float)((code) >> 8 & 255) / 255,                          \
     (float)((code) & 255) / 255, 1}

enum { CORK, WOOD, ICE, BRICK, STEEL, MATERIALS };

static const skv_body_look looks[][MATERIALS] = {
    [SKV_PALETTE_DARK] = {[CORK] = {RGBA(0xf0d2a0), RGBA(0x4d371a)},
                          [WOOD] = {RGBA(0xb98550), RGBA(0x33200e)},
                          [ICE] = {RGBA(0xe2f5fc), RGBA(0x2c5a72)},
                          [BRICK] = {RGBA(0xa83c28), RGBA(0x330f08)},
                          [STEEL] = {RGBA(0x8e9aa8), RGBA(0x171c22)}},
    [SKV_PALETTE_LIGHT] = {[CORK] = {RGBA(0xf0d2a0), RGBA(0x4d371a)},
                           [WOOD] = {RGBA(0xc0905a), RGBA(0x33200e)},
                           [ICE] = {RGBA(0xe4f6fd), RGBA(0x2c5a72)},
                           [BRICK] = {RGBA(0xa83c28), RGBA(0x330f08)},
                           [STEEL] = {RGBA(0x8e9aa8), RGBA(0x171c22)}},
    [SKV_PALETTE_CONTRAST] = {[CORK] = {RGBA(0xffe08a), RGBA(0x000000)},
                              [WOOD] = {RGBA(0xf4b050), RGBA(0x000000)},
                              [ICE] = {RGBA(0xe0f8ff), RGBA(0x000000)},
                              [BRICK] = {RGBA(0xf05038), RGBA(0x000000)},
                              [STEEL] = {RGBA(0xb4bcc8), RGBA(0x000000)}}};

/* kg/m^2: up to which density things are mostly made of what. Ice is 917, and only what is about as
 * heavy is ice; what else hardly floats or just sinks is wood. */
static const struct {
    float most;
    int material;
} made_of[] = {{350, CORK},  {900, WOOD},   {935, ICE},
               {1300, WOOD}, {4000, BRICK}, {INFINITY, STEEL}};

const skv_body_look *skv_look_body(skv_palette palette, float density)
{
    int i = 0;
    while (density > made_of[i].most)
        i++;
    return &looks[palette][made_of[i].material];
}
