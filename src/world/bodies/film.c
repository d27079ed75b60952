/* Films between bodies and walls.
 *
 * A gap that is too narrow for particles holds water, too, and that bears the pressure of the water
 * at its ends; without it what lies on the floor would be pressed down by all above it, and wood
 * would never rise. So the pieces of a body's rim that are so near to the terrain take the pressure
 * at the film's two open ends, mixed by the way along the rim, with what depth adds in the fluids
 * there. The wall bears it: the solver lets it take what particles in the gap would push
 * (terrain/solids.h), so that nothing counts twice.
 *
 * Invariant: ends in air have no pressure, and a film without an end has none.
 */
#include "base/exact.h"
#include "terrain/sample.h"
#include "world/bodies/bodies.h"

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

/* Whether it is awake and part of it may be so near to a wall. */
static bool may_have_film(const skv_world *world, const skv_rigid *r)
{
    float reach = skv_film_reach(world->fluid.spacing);
    float middle = skv_distance_at(world->terrain, (float)r->x, (float)r->y);
    return !r->asleep && !(middle > (float)r->shape->outline.reach + reach);
}

/* Whether part of it is, and part of it is not. */
static bool place_rim(const skv_world *world, const skv_rigid *r, rim *all)
{
    if (!may_have_film(world, r))
        return false;
    int open = 0;
    all->count = r->shape->rims;
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

/* What there is at an open end. */
typedef struct end {
    int piece; /* that it is; -1: none */
    double pressure, density;
} end;

/* What depth adds to the pressure on the way (x, y) through fluid of a density. */
static double by_depth(const skv_world *world, double density, double x, double y)
{
    return density * ((double)world->gravity_x * x + (double)world->gravity_y * y);
}

static double density_of(const skv_world *world, int particle)
{
    return (double)world->liquids[skv_fluid_of(&world->state, particle)].density;
}

/* Looks at the fluids around a piece. */
static end look_around(const skv_world *world, const rim *all, int piece)
{
    const skv_state *s = &world->state;
    const double x = all->x[piece], y = all->y[piece], first = (double)world->fluid.density;
    double reach = AROUND * (double)world->fluid.spacing, sum = 0, weights = 0, denser = 0;
    for (int i = 0; i < s->count; i++) {
        double dx = x - (double)s->x[i], dy = y - (double)s->y[i], square = dx * dx + dy * dy;
        if (!(square < reach * reach))
            continue;
        double weight = 1 - sqrt(square) / reach, own = density_of(world, i);
        sum += weight * ((double)s->pressure[i] + by_depth(world, own, dx, dy));
        denser += weight * (own - first);
        weights += weight;
    }
    if (!(weights > LEAST))
        return (end){piece, 0, 0};
    return (end){piece, skv_max(sum / weights, 0), first + denser / weights};
}

/* From piece k on to the first that is open; writes how many pieces away it is. */
static int find_end(const rim *all, int k, int step, double *way)
{
    for (*way = 0; !all->open[k]; ++*way)
        k = next_of(all, k, step);
    return k;
}

/* The pressure that an end has hands on to piece k. */
static double handed_on(const skv_world *world, const rim *all, const end *from, int k)
{
    if (!(from->pressure > 0))
        return 0;
    return from->pressure + by_depth(world, from->density, all->x[k] - all->x[from->piece],
                                     all->y[k] - all->y[from->piece]);
}

static void press(const skv_world *world, skv_rigid *r, const rim *all, double dt)
{
    end ends[2] = {{.piece = -1}, {.piece = -1}};
    for (int k = 0; k < all->count; k++) {
        if (!(all->film[k] > 0))
            continue;
        double ways[2], sum = 0;
        for (int side = 0; side < 2; side++) {
            int piece = find_end(all, k, side ? 1 : -1, &ways[side]);
            if (piece != ends[side].piece)
                ends[side] = look_around(world, all, piece);
        }
        for (int side = 0; side < 2; side++)
            sum += ways[1 - side] * handed_on(world, all, &ends[side], k);
        double pressure = skv_max(sum / (ways[0] + ways[1]), 0) * all->film[k];
        double push = pressure * dt;
        skv_rigid_press(r, -push * all->along_y[k], push * all->along_x[k], all->x[k], all->y[k]);
    }
}

bool skv_bodies_may_have_films(const skv_world *world)
{
    bool may = false;
    for (int k = 0; k < skv_world_has_bodies(world); k++)
        may = may || may_have_film(world, &world->bodies->body[k]);
    return may;
}

void skv_bodies_press_films(const skv_world *world, double dt)
{
    rim all;
    for (int k = 0; k < world->bodies->count; k++)
        if (place_rim(world, &world->bodies->body[k], &all))
            press(world, &world->bodies->body[k], &all, dt);
}
