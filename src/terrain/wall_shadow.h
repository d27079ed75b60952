/* Beside a thin wall, what stands behind it counts as solid, because no fluid is felt through it:
 * the wall sums of everything that a point cannot see. */
#ifndef SKV_TERRAIN_WALL_SHADOW_H
#define SKV_TERRAIN_WALL_SHADOW_H

#include "skvalp/terrain.h"
#include "terrain/wall_kernel.h"

enum { SKV_SHADOW_RAYS = 64 };

/* Directions all around, the same bits on every machine. */
typedef struct skv_shadow_rays {
    double x[SKV_SHADOW_RAYS], y[SKV_SHADOW_RAYS];
} skv_shadow_rays;

void skv_shadow_rays_make(skv_shadow_rays *rays);

/* How far one sees along each ray from a point in grid coordinates, in pixels, as far as the radius
 * where there is no wall; and, if `values` is not null, the sums there, for a kernel of the
 * pressure, a radius in pixels and n0 h^2 particles in a square radius. */
void skv_shadow_at(const skv_shadow_rays *rays, skv_kernel pressure, const skv_terrain *terrain,
                   float gx, float gy, double radius_pixels, double particles_per_square_radius,
                   double sights[SKV_SHADOW_RAYS], float *values);

/* Those sums beside a flat wall at a distance in radii; the vectors point along x. */
void skv_shadow_of_plane(const skv_shadow_rays *rays, skv_kernel pressure, double distance,
                         double particles_per_square_radius, float values[SKV_WALL_MAPS]);

#endif
