/* Where walls are so thin that fluid would reach across them.
 *
 * A wall is thin where the way through it along its normal is shorter than 0.6 smoothing radii and
 * the way around it is long. Edges and corners of thick walls are not thin, however short a way
 * cuts them off, nor are the last two radii before an upper end and the last eight before any
 * other free end: under water an end must not part what flows round it.
 */
#ifndef SKV_TERRAIN_THIN_WALLS_H
#define SKV_TERRAIN_THIN_WALLS_H

#include "skvalp/terrain.h"

typedef struct skv_thin_walls skv_thin_walls;

/* Finds a terrain's thin walls; *thin is null if it has none. `terrain` is only read during the
 * call. */
skv_result skv_thin_walls_create(const skv_terrain *terrain, float radius, skv_thin_walls **thin,
                                 skv_error *error);
void skv_thin_walls_destroy(skv_thin_walls *thin);

/* True if a thin wall may be within the radius of a point, in m; false where none is within one and
 * a half radii. Any point. */
bool skv_near_thin_wall(const skv_thin_walls *thin, float x, float y);

#endif
