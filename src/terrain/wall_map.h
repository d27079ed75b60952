/* Wall density maps: what the solid adds to the density sums of a particle near it.
 *
 * For a smoothing radius h and a rest spacing s, with n0 = 1/s^2 and q = 1 - r/h, integrated over
 * the solid around a point: R = n0 * int W, Rn = n0 * int q^3, and the vectors
 * F1 = -(h/gain) grad R and F2 = -(h/3) grad Rn, which are n0 * int F r^ and n0 * int q^2 r^ with
 * r^ pointing away from the solid; W, F and gain are those of the pressure's kernel. R and F1 carry
 * its weight for walls. Stored on a grid of about h/10 and sampled bilinearly; bilinear samples of
 * central differences drive creeping flow, so the vectors are stored, not derived.
 */
#ifndef SKV_TERRAIN_WALL_MAP_H
#define SKV_TERRAIN_WALL_MAP_H

#include "base/kernels.h"
#include "skvalp/terrain.h"

typedef struct skv_wall_map skv_wall_map;

/* The six values at one point; all zero farther than h from any wall. */
typedef struct skv_wall_sample {
    float r, rn;    /* R, Rn: dimensionless */
    float f1x, f1y; /* F1: dimensionless */
    float f2x, f2y; /* F2: dimensionless */
} skv_wall_sample;

/* Builds the maps of a terrain for one h, s and kernel. `terrain` is only read during the call. */
skv_result skv_wall_map_create(const skv_terrain *terrain, float radius, float spacing,
                               skv_kernel pressure, skv_wall_map **map, skv_error *error);
void skv_wall_map_destroy(skv_wall_map *map);

/* Samples the maps. Returns false, with zeros, where no wall is within h. Any finite point. */
bool skv_wall_map_sample(const skv_wall_map *map, float x, float y, skv_wall_sample *sample);

/* Finds the thin walls of the map's terrain. Near them the sums then run over everything that a
 * point cannot see, the fluid behind the wall included: pairs are cut there, so the wall must stand
 * for all that they would have given. Once for a map; on failure it stays as it was. */
skv_result skv_wall_map_shade(skv_wall_map *map, const skv_terrain *terrain, skv_error *error);

/* True if any wall of the map is thin, and if one may be within h of a point: there alone pairs
 * must be asked whether they see each other. */
bool skv_wall_map_has_thin(const skv_wall_map *map);
bool skv_wall_map_near_thin(const skv_wall_map *map, float x, float y);

/* True if a thin wall stands between two places that are within h of each other. The same for both
 * orders. The bounds are lower bounds of the places' distances from walls, in m; 0: not known. */
bool skv_wall_map_occluded(const skv_wall_map *map, const skv_terrain *terrain, float ax, float ay,
                           float a_clearance, float bx, float by, float b_clearance);

/* Samples the maps near a thin wall, for a point at `distance` from a wall with the normal (nx,
 * ny). Samples on the other side of the wall must not be mixed in, so nearer than one and a half
 * cells the sums are those at that distance, scaled as beside a flat wall. */
bool skv_wall_map_sample_beside(const skv_wall_map *map, float x, float y, float distance, float nx,
                                float ny, skv_wall_sample *sample);

/* Bytes held, for reports. */
size_t skv_wall_map_bytes(const skv_wall_map *map);

#endif
