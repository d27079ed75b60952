/* Where the particles of a scene's fluid begin: as many as its drawn area holds, laid in rows. */
#ifndef SKV_SCENE_LAY_H
#define SKV_SCENE_LAY_H

#include "scene/water.h"

/* Sets a water's area, and where it begins and ends, from everything else. SKV_ERROR_MEMORY if
 * there is none. */
skv_result skv_lay_measure(skv_water *water, const skv_terrain *terrain, skv_error *error);

/* Lays exactly `count` particles into a measured water, from the bottom up: x and y have room for
 * that many. The spacing says how high a row is. */
skv_result skv_lay(const skv_water *water, const skv_terrain *terrain, float spacing, int count,
                   float *x, float *y, skv_error *error);

#endif
