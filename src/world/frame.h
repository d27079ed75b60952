/* One frame through one of the two solvers; shared by src/world's step files. */
#ifndef SKV_WORLD_FRAME_H
#define SKV_WORLD_FRAME_H

#include "world/world_internal.h"

/* Takes one substep with the reference solver: the passes as a readable list. */
void skv_reference_substep(skv_world *world);

/* Takes `count` substeps, `time` seconds in all, with the production solver; what sleeps stays. */
void skv_rows_substeps(skv_world *world, int count, float time);

/* The walls as both solvers meet them, SI units. */

/* Moves (x, y) by (dx, dy) as far as the walls allow; writes the distance to the nearest wall there
 * and returns the share of the way that was made, 0..1. */
float skv_move_at_walls(const skv_world *world, float *x, float *y, float dx, float dy,
                        float *distance);

/* How far to push a particle at (x, y) out of the contact distance, in m; 0 if it is not in
 * contact. In a gap narrower than twice that distance the push ends in the middle: both walls
 * pushing in turn would shake the fluid. Writes the distance, and the normal if there is contact.
 */
float skv_contact_depth(const skv_world *world, float x, float y, float *nx, float *ny,
                        float *distance);

/* The wall sums at a point; returns the distance to the nearest wall. */
float skv_walls_at(const skv_world *world, float x, float y, skv_wall_sample *wall);

/* True if a thin wall stands between two particles, so that they feel nothing of each other; the
 * same for (a, b) and (b, a). Meant for pairs within h. `context` is the world. */
bool skv_wall_between(const void *context, float ax, float ay, float bx, float by);

/* Lets lists leave out the pairs that thin walls part. */
void skv_cut_pairs_at_walls(const skv_world *world, skv_neighbours *neighbours);

#endif
