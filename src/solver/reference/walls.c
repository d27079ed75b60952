/* Meeting walls: what they add to the sums, what they hold of the slip along them, contact
 * (Algorithm 7 with errata 7), and moves as far as they allow. The boundary itself is sampled in
 * single precision, for both solvers (terrain/boundary.h).
 * Invariant: a particle out of contact is not moved by it. */
#include "solver/reference/reference.h"
#include "solver/wall_image.h"

#include <math.h>

static void book_in_box(const skv_reference *f, int i, double dx, double dy)
{
    skv_reaction *r = f->reaction;
    float nx, ny;
    double d =
        (double)skv_terrain_normal(f->boundary->terrain, (float)f->x[i], (float)f->y[i], &nx, &ny);
    double x = f->x[i] - d * (double)nx, y = f->y[i] - d * (double)ny;
    if (x < r->x0 || x > r->x1 || y < r->y0 || y > r->y1)
        return;
    r->dx += dx;
    r->dy += dy;
    r->moment += (x - (r->x0 + r->x1) / 2) * dy - (y - (r->y0 + r->y1) / 2) * dx;
}

void skv_book_reaction(skv_reference *f, int i, double dx, double dy)
{
    if (dx == 0 && dy == 0)
        return;
    f->given.x += dx;
    f->given.y += dy;
    f->given.moment += f->x[i] * dy - f->y[i] * dx;
    if (f->reaction)
        book_in_box(f, i, dx, dy);
}

static void sample_solid(skv_reference *f, int i)
{
    skv_wall_sample wall;
    float distance = skv_boundary_sample(f->boundary, (float)f->x[i], (float)f->y[i], &wall);
    if (!(distance < f->constants->h))
        wall = (skv_wall_sample){0}; /* what is left there is how the map rounds */
    f->wall_density[i] = (double)wall.r;
    f->wall_near[i] = (double)wall.rn;
    f->f1x[i] = (double)wall.f1x;
    f->f1y[i] = (double)wall.f1y;
    f->f2x[i] = (double)wall.f2x;
    f->f2y[i] = (double)wall.f2y;
    f->image[i] = (double)SKV_FAR;
    f->facing_x[i] = f->facing_y[i] = 0;
}

/* What images leave to the solid is a crowd. */
static void sample_image(skv_reference *f, int i)
{
    const double share = (double)f->constants->residual_share;
    skv_image_sample wall;
    float distance = skv_boundary_sample_image(f->boundary, (float)f->x[i], (float)f->y[i], &wall);
    if (!(distance < f->constants->h && wall.distance < 1))
        wall = (skv_image_sample){.distance = SKV_FAR};
    f->image[i] = (double)wall.distance;
    f->facing_x[i] = (double)wall.nx;
    f->facing_y[i] = (double)wall.ny;
    f->wall_density[i] = (double)wall.r;
    f->wall_near[i] = share * (double)wall.r;
    f->f1x[i] = (double)wall.f1x;
    f->f1y[i] = (double)wall.f1y;
    f->f2x[i] = SKV_NEAR_WEIGHT * share * (double)wall.f1x;
    f->f2y[i] = SKV_NEAR_WEIGHT * share * (double)wall.f1y;
}

void skv_pass_walls(skv_reference *f)
{
    for (int i = 0; i < f->count; i++) {
        if (f->constants->images)
            sample_image(f, i);
        else
            sample_solid(f, i);
    }
}

void skv_pass_slip(skv_reference *f)
{
    const skv_constants *c = f->constants;
    for (int i = 0; i < f->count; i++) {
        double nx = f->facing_x[i], ny = f->facing_y[i], size = sqrt(nx * nx + ny * ny);
        if (!(size > 0))
            continue;
        double tx = -ny / size, ty = nx / size;
        double slip = (f->moved_x[i] + f->dx[i]) * tx + (f->moved_y[i] + f->dy[i]) * ty;
        double held =
            slip * (double)skv_slip_taken(c->slip_friction, c->wall_drag, (float)f->image[i]);
        f->dx[i] -= held * tx;
        f->dy[i] -= held * ty;
        skv_book_reaction(f, i, -held * f->mass[i] * tx, -held * f->mass[i] * ty);
    }
}

/* The way of a particle that may meet a wall, on along it or not; what the wall makes of it is
 * booked. */
static void meet_wall(skv_reference *f, int i, bool on)
{
    float x = (float)f->x[i], y = (float)f->y[i], along_x, along_y, distance;
    double made = (double)skv_boundary_slide(f->boundary, on, &x, &y, (float)f->dx[i],
                                             (float)f->dy[i], &along_x, &along_y, &distance);
    double lost_x = (made - 1) * f->dx[i] + (double)along_x;
    double lost_y = (made - 1) * f->dy[i] + (double)along_y;
    skv_book_reaction(f, i, f->mass[i] * lost_x, f->mass[i] * lost_y);
    f->dx[i] += lost_x;
    f->dy[i] += lost_y;
    f->clearance[i] = (double)distance;
}

/* Carries out a particle's dx, dy. `clearance` is a lower bound of the distance to the nearest
 * wall: only moves that exceed it look at the terrain. */
static void move_one(skv_reference *f, int i, bool on)
{
    double way = sqrt(f->dx[i] * f->dx[i] + f->dy[i] * f->dy[i]);
    /* The distance is bilinear: along a diagonal it can fall by the square root of two. */
    f->clearance[i] -= 1.4143 * way;
    if (!(f->clearance[i] > (double)f->boundary->margin))
        meet_wall(f, i, on);
    f->x[i] += f->dx[i];
    f->y[i] += f->dy[i];
    f->moved_x[i] += f->dx[i];
    f->moved_y[i] += f->dy[i];
}

void skv_pass_move(skv_reference *f)
{
    for (int i = 0; i < f->count; i++)
        move_one(f, i, f->constants->images);
}

/* How far a particle is inside the contact distance, and which way is out; 0: it is not. */
static double find_contact(skv_reference *f, int i, double *nx, double *ny)
{
    if (!(f->clearance[i] < (double)f->boundary->contact_distance))
        return 0;
    float normal_x, normal_y, distance;
    float depth = skv_boundary_contact(f->boundary, (float)f->x[i], (float)f->y[i], &normal_x,
                                       &normal_y, &distance);
    f->clearance[i] = (double)distance;
    *nx = (double)normal_x;
    *ny = (double)normal_y;
    return (double)depth;
}

void skv_pass_contact(skv_reference *f)
{
    const double friction = (double)f->constants->friction;
    const double softness = (double)f->constants->softness;
    for (int i = 0; i < f->count; i++) {
        double nx = 0, ny = 0, depth = find_contact(f, i, &nx, &ny);
        if (!(depth > 0))
            continue;
        double tx = -ny, ty = nx;
        double rub = friction * (f->moved_x[i] * tx + f->moved_y[i] * ty);
        double push = softness * depth;
        f->dx[i] = push * nx - rub * tx;
        f->dy[i] = push * ny - rub * ty;
        skv_book_reaction(f, i, f->mass[i] * f->dx[i], f->mass[i] * f->dy[i]);
        move_one(f, i, false);
    }
}
