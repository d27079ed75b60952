/* Sums over what a point cannot see: along each ray the kernels are integrated from where it meets
 * a wall to the radius, in closed form. Invariant: libm's functions are not used, so the sums are
 * the same on every machine.
 */
#include "terrain/wall_shadow.h"

#include "terrain/sample.h"

#include <math.h>
#include <string.h>

/* Where a ray is taken to have met the wall, and how far it goes on at least, in pixels. */
#define TOUCH 0.02
#define STEP  0.05

enum { LANES = 8 }; /* rays that are followed at a time: each step waits for the one before */

void skv_shadow_rays_make(skv_shadow_rays *rays)
{
    /* From a right angle, halved, to half the angle between two rays and to the angle itself. */
    double cosine = 0, sine = 1, half_cosine = 0, half_sine = 1;
    for (int parts = 4; parts < 2 * SKV_SHADOW_RAYS; parts *= 2) {
        cosine = half_cosine;
        sine = half_sine;
        half_sine = sqrt((1 - cosine) / 2);
        half_cosine = sqrt((1 + cosine) / 2);
    }
    /* The first ray lies half an angle off the axis: no ray runs along an upright wall. */
    double x = half_cosine, y = half_sine;
    for (int i = 0; i < SKV_SHADOW_RAYS; i++) {
        rays->x[i] = x;
        rays->y[i] = y;
        double next = x * cosine - y * sine;
        y = x * sine + y * cosine;
        x = next;
    }
}

/* Adds a ray that sees as far as `sight` radii. */
static void add_ray(skv_kernel pressure, double x, double y, double sight,
                    double sums[SKV_WALL_MAPS])
{
    if (!(1 - sight > 0))
        return;
    skv_kernel_ray beyond = skv_kernel_beyond(pressure, sight);
    sums[SKV_WALL_R] += beyond.density;
    sums[SKV_WALL_RN] += beyond.near_density;
    /* The push points from the wall to the particle. */
    sums[SKV_WALL_F1X] -= x * beyond.push;
    sums[SKV_WALL_F1Y] -= y * beyond.push;
    sums[SKV_WALL_F2X] -= x * beyond.near_push;
    sums[SKV_WALL_F2Y] -= y * beyond.near_push;
}

static void finish(const double sums[SKV_WALL_MAPS], double particles_per_square_radius,
                   float values[SKV_WALL_MAPS])
{
    const double turn = 2 * SKV_PI;
    for (int k = 0; k < SKV_WALL_MAPS; k++)
        values[k] = (float)(particles_per_square_radius * turn / SKV_SHADOW_RAYS * sums[k]);
}

/* How far a point is from walls, in pixels. */
static double distance_at(const skv_terrain *terrain, double gx, double gy)
{
    return (double)skv_grid_distance(terrain, (float)gx, (float)gy) * (double)terrain->per_metre;
}

/* How far one sees from a point, which is `d` from walls, along LANES rays, in pixels; `longest`
 * where there is no wall. */
static void find_sights(const skv_terrain *terrain, double gx, double gy, double d, const double *x,
                        const double *y, double longest, double sights[LANES])
{
    double clear[LANES];
    bool ended[LANES] = {false};
    for (int lane = 0; lane < LANES; lane++) {
        sights[lane] = 0;
        clear[lane] = d;
    }
    for (int left = LANES; left > 0;) {
        for (int lane = 0; lane < LANES; lane++) {
            if (ended[lane])
                continue;
            double *t = &sights[lane];
            if (clear[lane] <= TOUCH) {
                *t = *t + clear[lane] > 0 ? *t + clear[lane] : 0;
                ended[lane] = true;
                left--;
                continue;
            }
            *t += 0.9 * clear[lane] + STEP;
            if (*t >= longest) {
                *t = longest;
                ended[lane] = true;
                left--;
                continue;
            }
            clear[lane] = distance_at(terrain, gx + *t * x[lane], gy + *t * y[lane]);
        }
    }
}

void skv_shadow_at(const skv_shadow_rays *rays, skv_kernel pressure, const skv_terrain *terrain,
                   float gx, float gy, double radius_pixels, double particles_per_square_radius,
                   double sights[SKV_SHADOW_RAYS], float *values)
{
    double sums[SKV_WALL_MAPS] = {0}, x = (double)gx, y = (double)gy;
    double d = distance_at(terrain, x, y);
    for (int i = 0; i < SKV_SHADOW_RAYS; i += LANES)
        find_sights(terrain, x, y, d, rays->x + i, rays->y + i, radius_pixels, sights + i);
    for (int i = 0; values && i < SKV_SHADOW_RAYS; i++)
        add_ray(pressure, rays->x[i], rays->y[i], sights[i] / radius_pixels, sums);
    if (values)
        finish(sums, particles_per_square_radius, values);
}

void skv_shadow_of_plane(const skv_shadow_rays *rays, skv_kernel pressure, double distance,
                         double particles_per_square_radius, float values[SKV_WALL_MAPS])
{
    double sums[SKV_WALL_MAPS] = {0};
    for (int i = 0; i < SKV_SHADOW_RAYS; i++) {
        if (-rays->x[i] > distance)
            add_ray(pressure, rays->x[i], rays->y[i], distance / -rays->x[i], sums);
    }
    finish(sums, particles_per_square_radius, values);
}
