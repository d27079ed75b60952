/* Channels that join vessels and are too narrow for the fluid's particles. */
#ifndef SKV_SCENE_CHANNELS_H
#define SKV_SCENE_CHANNELS_H

#include "scene/scene_data.h"

/* Spacings: in narrower channels particles rest like grains, and levels do not meet; and how wide a
 * channel is to be, for there is little to be gained beyond. */
#define SKV_CHANNEL_NARROW 3.0
#define SKV_CHANNEL_WIDE   4.0

/* The width in m of the narrowest channel in which the fluid gets stuck, of those that alone join
 * two vessels and that water may come to; 0 if there is none, or no memory to find it. */
double skv_scene_narrow_channel(const skv_scene *scene);

#endif
