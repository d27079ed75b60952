/* Films between bodies and walls.
 *
 * A gap that is too narrow for particles holds water, too, and that bears the pressure of the water
 * at its ends; without it what lies on the floor would be pressed down by all above it, and wood
 * would never rise. So the pieces of a body's rim that are so near to the terrain take the pressure
 * at the film's two open ends, mixed by the way along the rim, with what depth adds. The wall bears
 * it: the solver lets it take what particles in the gap would push (terrain/solids.h), so that
 * nothing counts twice.
 *
 * Invariant: ends in air have no pressure, and a film without an end has none.
 */
#include "base/exact.h"
#include "terrain/sample.h"
#include "world/bodies.h"

#include <math.h>

/* Around an end pressures are averaged so far, spacings. */
#define AROUND 2.0

/* With less than a tenth of a particle there an end lies in air. */
#define LEAST 0.1

/* The pieces of one body's rim, in the world's axes, in the order of its points. */
typedef struct rim {
    int count;
    double x[SKV_MOST_RIM], y[SKV_MOST_RIM]; /* their middles */
    double along_x[SKV_MOST_RIM], along_y[SKV_MOST_RIM];
    bool open[SKV_MOST_RIM];   /* no wall is near: the water's pressure is known there */
    double film[SKV_MOST_RIM]; /* share of the pressure that the film bears there */
} rim;

static int next_of(const rim *all, int k, int step)
{
    return (k + step + all->count) % all->count;
}

/* How narrow it is at piece k, which bears a film where its outer side faces the wall. */
static void look(const skv_world *world, rim *all, int k)
{
    float nx, ny, spacing = world->fluid.spacing;
    float gap = skv_normal_at(world->terrain, (float)all->x[k], (float)all->y[k], &nx, &ny);
    double x = all->along_x[k], y = all->along_y[k], length = sqrt(x * x + y * y);
    all->open[k] = !(gap < skv_film_reach(spacing));
    all->film[k] = 0;
    if (!all->open[k] && length > 0)
        all->film[k] = (double)(skv_film_share(gap, spacing) *
                                skv_facing(nx, ny, (float)(y / length), (float)(-x / length)));
}

/* Whether part of it is so near to a wall, and part of it is not. */
static bool place_rim(const skv_world *world, const skv_rigid *r, rim *all)
{
    const skv_body_shape *shape = r->shape;
    float reach = skv_film_reach(world->fluid.spacing);
    float middle = skv_distance_at(world->terrain, (float)r->x, (float)r->y);
    if (middle > (float)shape->outline.reach + reach)
        return false;
    int open = 0;
    all->count = shape->rims;
    for (int k = 0; k < all->count; k++) {
        double x0, y0, x1, y1;
        skv_rigid_rim(r, k, &x0, &y0);
        skv_rigid_rim(r, next_of(all, k, 1), &x1, &y1);
        all->x[k] = (x0 + x1) / 2;
        all->y[k] = (y0 + y1) / 2;
        all->along_x[k] = x1 - x0;
        all->along_y[k] = y1 - y0;
        look(world, all, k);
        open += all->open[k];
    }
    return open > 0 && open < all->count;
}

/* What depth adds to the pressure on the way (x, y). */
static double by_depth(const skv_world *world, double x, double y)
{
    return (double)world->fluid.density *
           ((double)world->gravity_x * x + (double)world->gravity_y * y);
}

/* The water's pressure at a place. */
static double pressure_at(const skv_world *world, double x, double y)
{
    const skv_state *s = &world->state;
    double reach = AROUND * (double)world->fluid.spacing, sum = 0, weights = 0;
    for (int i = 0; i < s->count; i++) {
        double dx = x - (double)s->x[i], dy = y - (double)s->y[i], square = dx * dx + dy * dy;
        if (!(square < reach * reach))
            continue;
        double weight = 1 - sqrt(square) / reach;
        sum += weight * ((double)s->pressure[i] + by_depth(world, dx, dy));
        weights += weight;
    }
    return weights > LEAST ? skv_max(sum / weights, 0) : 0;
}

/* From piece k on to the first that is open; writes how many pieces away it is. */
static int find_end(const rim *all, int k, int step, double *way)
{
    for (*way = 0; !all->open[k]; ++*way)
        k = next_of(all, k, step);
    return k;
}

/* The pressure that an end has hands on to piece k. */
static double handed_on(const skv_world *world, const rim *all, int end, double pressure, int k)
{
    if (!(pressure > 0))
        return 0;
    return pressure + by_depth(world, all->x[k] - all->x[end], all->y[k] - all->y[end]);
}

static void press(const skv_world *world, skv_rigid *r, const rim *all, double dt)
{
    int ends[2] = {-1, -1};
    double pressures[2] = {0};
    for (int k = 0; k < all->count; k++) {
        if (!(all->film[k] > 0))
            continue;
        double ways[2], sum = 0;
        for (int side = 0; side < 2; side++) {
            int end = find_end(all, k, side ? 1 : -1, &ways[side]);
            if (end != ends[side])
                pressures[side] = pressure_at(world, all->x[end], all->y[end]);
            ends[side] = end;
        }
        for (int side = 0; side < 2; side++)
            sum += ways[1 - side] * handed_on(world, all, ends[side], pressures[side], k);
        double pressure = skv_max(sum / (ways[0] + ways[1]), 0) * all->film[k];
        double push = pressure * dt;
        skv_rigid_press(r, -push * all->along_y[k], push * all->along_x[k], all->x[k], all->y[k]);
    }
}

void skv_bodies_press_films(const skv_world *world, double dt)
{
    rim all;
    for (int k = 0; k < world->bodies->count; k++)
        if (place_rim(world, &world->bodies->body[k], &all))
            press(world, &world->bodies->body[k], &all, dt);
}
