/* The boundary of the fluid: the walls as a solver meets them. SI units, the world's axes.
 *
 * Plain data and functions of it, all of them const: any number of threads may ask at once. */
#ifndef SKV_TERRAIN_BOUNDARY_H
#define SKV_TERRAIN_BOUNDARY_H

#include "terrain/wall_map.h"

typedef struct skv_boundary {
    const skv_terrain *terrain;
    const skv_wall_map *walls;
    float clearance; /* how close a move may come to a wall, m */
} skv_boundary;

/* Moves (x, y) by (dx, dy) as far as the walls allow; writes the distance to the nearest wall there
 * and returns the share of the way that was made, 0..1. */
float skv_boundary_move(const skv_boundary *boundary, float *x, float *y, float dx, float dy,
                        float *distance);

/* How far to push a particle at (x, y) out of the contact distance, in m; 0 if it is not in
 * contact. In a gap narrower than twice that distance the push ends in the middle: both walls
 * pushing in turn would shake the fluid. Writes the distance, and the normal if there is contact.
 */
float skv_boundary_contact(const skv_boundary *boundary, float contact_distance, float x, float y,
                           float *nx, float *ny, float *distance);

/* The wall sums at a point; returns the distance to the nearest wall. */
float skv_boundary_sample(const skv_boundary *boundary, float x, float y, skv_wall_sample *wall);

/* True if there are thin walls at all, and if one may be within h of a point: there alone pairs
 * must be asked whether they see each other. */
bool skv_boundary_has_thin(const skv_boundary *boundary);
bool skv_boundary_near_thin(const skv_boundary *boundary, float x, float y);

/* True if a thin wall stands between two places within h of each other, so that the particles there
 * feel nothing of each other; the same for both orders. The bounds are lower bounds of the places'
 * distances from walls, in m; 0: not known. */
bool skv_boundary_occluded(const skv_boundary *boundary, float ax, float ay, float a_clearance,
                           float bx, float by, float b_clearance);

#endif
