/* What a ray meets first. Invariant: a ray ends at the first wall; fluid behind it is not seen. */
#include "base/assert.h"
#include "base/exact.h"
#include "world/world_internal.h"

#include <math.h>

/* A particle is a disc of its own area: its radius is 1/sqrt(pi) spacings. */
#define DISC 0.56418958

static skv_hit nothing(float x1, float y1)
{
    return (skv_hit){.share = 1, .x = x1, .y = y1, .particle = -1};
}

static skv_hit wall_hit(const skv_terrain *terrain, float x0, float y0, float x1, float y1)
{
    bool starts_inside = skv_terrain_distance(terrain, x0, y0) <= 0;
    float share = starts_inside ? 0 : skv_terrain_sweep(terrain, x0, y0, x1, y1, 0);
    if (share >= 1)
        return nothing(x1, y1);
    skv_hit hit = {.found = true,
                   .share = share,
                   .x = x0 + share * (x1 - x0),
                   .y = y0 + share * (y1 - y0),
                   .particle = -1};
    skv_terrain_normal(terrain, hit.x, hit.y, &hit.nx, &hit.ny);
    return hit;
}

/* The share of the way (dx, dy) at which a point enters the circle of squared radius r2 around
 * (cx, cy), seen from its start; 2 if it does not. */
static double enters(double cx, double cy, double dx, double dy, double r2)
{
    double away = cx * cx + cy * cy - r2, along = cx * dx + cy * dy, way2 = dx * dx + dy * dy;
    if (away <= 0)
        return 0;
    double discriminant = along * along - way2 * away;
    if (!(along > 0) || discriminant < 0)
        return 2;
    return away / (along + sqrt(discriminant));
}

static skv_hit fluid_hit(const skv_world *world, float x0, float y0, float x1, float y1)
{
    const skv_state *s = &world->state;
    int first = -1;
    double dx = (double)x1 - (double)x0, dy = (double)y1 - (double)y0, nearest = 2;
    double radius = DISC * (double)world->fluid.spacing;
    for (int i = 0; i < s->count; i++) {
        double share = enters((double)s->x[i] - (double)x0, (double)s->y[i] - (double)y0, dx, dy,
                              radius * radius);
        if (share < nearest) {
            nearest = share;
            first = i;
        }
    }
    if (nearest > 1)
        return nothing(x1, y1);
    double x = (double)x0 + nearest * dx, y = (double)y0 + nearest * dy;
    double nx = x - (double)s->x[first], ny = y - (double)s->y[first];
    double length = sqrt(nx * nx + ny * ny);
    return (skv_hit){.found = true,
                     .share = (float)nearest,
                     .x = (float)x,
                     .y = (float)y,
                     .nx = length > 0 ? (float)(nx / length) : 0,
                     .ny = length > 0 ? (float)(ny / length) : 1,
                     .particle = first};
}

skv_ray skv_world_ray(const skv_world *world, float x0, float y0, float x1, float y1)
{
    skv_ray ray = {nothing(x1, y1), nothing(x1, y1)};
    SKV_ASSERT_OR(world, ray);
    if (!skv_within((double)x0, -1000, 1000) || !skv_within((double)y0, -1000, 1000) ||
        !skv_within((double)x1, -1000, 1000) || !skv_within((double)y1, -1000, 1000))
        return ray;
    ray.wall = wall_hit(world->terrain, x0, y0, x1, y1);
    ray.fluid = fluid_hit(world, x0, y0, x1, y1);
    if (ray.fluid.share > ray.wall.share)
        ray.fluid = nothing(x1, y1);
    return ray;
}
