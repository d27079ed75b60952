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

/* Books what a wall of a solid's number gives particle i. To a solid with the arm of where the
 * particle was before the substep: its velocity is the way from there, so that is what its moment
 * of momentum changes by. */
static void book(skv_reference *f, int i, int solid, double dx, double dy)
{
    if (dx == 0 && dy == 0)
        return;
    f->given.x += dx;
    f->given.y += dy;
    f->given.moment += f->x[i] * dy - f->y[i] * dx;
    if (solid == 0 && f->reaction)
        book_in_box(f, i, dx, dy);
    if (solid == 0 || !f->solid_given)
        return;
    const skv_pose *at = &f->boundary->solids->solid[solid - 1].now;
    double x = f->x[i] - f->moved_x[i] - (double)at->x;
    double y = f->y[i] - f->moved_y[i] - (double)at->y;
    skv_impulse *given = &f->solid_given[solid - 1];
    given->x += dx;
    given->y += dy;
    given->moment += x * dy - y * dx;
}

/* Of particle i where it lies. */
static void meet_walls(const skv_reference *f, int i, skv_walls_met *met)
{
    skv_solids_meet(f->boundary, f->constants->images, (float)f->x[i], (float)f->y[i], met);
}

void skv_book_push(skv_reference *f, int i, double out, double lambda, double near_lambda,
                   double dx, double dy)
{
    if (dx == 0 && dy == 0)
        return;
    if (!f->boundary->solids) {
        book(f, i, 0, dx, dy);
        return;
    }
    skv_walls_met met;
    meet_walls(f, i, &met);
    float share[SKV_MOST_PARTS][2];
    double rest = lambda;
    if (f->constants->images)
        rest += SKV_NEAR_WEIGHT * (double)f->constants->residual_share * near_lambda;
    skv_solids_share(f->boundary, &met, (float)f->x[i], (float)f->y[i], (float)out, (float)rest,
                     (float)near_lambda, (float)dx, (float)dy, share);
    for (int k = 1; k < met.count; k++) {
        double part_x = (double)share[k][0], part_y = (double)share[k][1];
        book(f, i, met.part[k].solid, part_x, part_y);
        dx -= part_x;
        dy -= part_y;
    }
    /* The first has what is left, so that the sum is exact. */
    book(f, i, met.count ? met.part[0].solid : 0, dx, dy);
}

void skv_book_turn(skv_reference *f, int i)
{
    const skv_constants *c = f->constants;
    if (!f->solid_given || !(f->wall_density[i] != 0 || f->image[i] < 1))
        return;
    skv_walls_met met;
    meet_walls(f, i, &met);
    double flat = (double)c->image_gradient * (double)skv_flat_slope((float)f->image[i]);
    for (int k = 0; k < met.count; k++) {
        const skv_part_of_walls *part = &met.part[k];
        if (part->solid == 0)
            continue;
        double wall_x = (double)part->f1x + flat * (double)part->nx;
        double wall_y = (double)part->f1y + flat * (double)part->ny;
        f->solid_given[part->solid - 1].moment -=
            (double)c->tension_scale * (double)c->h *
            (wall_x * f->gradient_y[i] - wall_y * f->gradient_x[i]);
    }
}

/* What the walls at i are, those of solids joined with the terrain's; beyond h nothing: what is
 * left there is how the map rounds. */
static void sample_solid(skv_reference *f, int i)
{
    skv_walls_met met;
    meet_walls(f, i, &met);
    const skv_wall_sample wall = skv_sums_of(&met.sum);
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
    skv_walls_met met;
    meet_walls(f, i, &met);
    skv_image_sample wall = skv_image_of_part(&met.sum);
    if (!(wall.distance < 1))
        wall.distance = SKV_FAR;
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

/* How far the wall beside i moves in the substep. */
static void find_way(const skv_reference *f, int i, double *x, double *y)
{
    skv_walls_met met;
    meet_walls(f, i, &met);
    float way_x, way_y;
    skv_solids_way(f->boundary, &met, (float)f->x[i], (float)f->y[i], &way_x, &way_y);
    *x = (double)way_x;
    *y = (double)way_y;
}

void skv_pass_slip(skv_reference *f)
{
    const skv_constants *c = f->constants;
    for (int i = 0; i < f->count; i++) {
        double nx = f->facing_x[i], ny = f->facing_y[i], size = sqrt(nx * nx + ny * ny);
        if (!(size > 0))
            continue;
        double tx = -ny / size, ty = nx / size, way_x, way_y;
        find_way(f, i, &way_x, &way_y);
        double slip = (f->moved_x[i] + f->dx[i] - way_x) * tx;
        slip += (f->moved_y[i] + f->dy[i] - way_y) * ty;
        double drag = f->drag[i] / f->mass[i], stick = (double)c->wall_stick;
        float friction = !f->various ? c->slip_friction : drag > 0 ? 0 : c->bare_slip;
        float pairs = f->various ? (float)(stick * drag) : c->wall_drag;
        double held = slip * (double)skv_slip_taken(friction, pairs, (float)f->image[i]);
        f->dx[i] -= held * tx;
        f->dy[i] -= held * ty;
        skv_book_push(f, i, 0, 0, 0, -held * f->mass[i] * tx, -held * f->mass[i] * ty);
    }
}

/* Books what stops particle i at a wall at (x, y), a film's share of it to the terrain. */
static void book_stop(skv_reference *f, int i, int solid, float x, float y, double dx, double dy)
{
    double film = (double)skv_solids_film(f->boundary, solid, x, y) * f->mass[i];
    book(f, i, solid, (f->mass[i] - film) * dx, (f->mass[i] - film) * dy);
    if (film > 0)
        book(f, i, 0, film * dx, film * dy);
}

/* The way of a particle that may meet a wall, on along it or not; what the wall makes of it is
 * booked. */
static void meet_wall(skv_reference *f, int i, bool on)
{
    float x = (float)f->x[i], y = (float)f->y[i], along_x, along_y, distance;
    skv_cuts cuts = {0};
    double made = (double)skv_solids_slide(f->boundary, f->advances, on, &x, &y, (float)f->dx[i],
                                           (float)f->dy[i], &along_x, &along_y, &distance, &cuts);
    double lost_x = (made - 1) * f->dx[i] + (double)along_x;
    double lost_y = (made - 1) * f->dy[i] + (double)along_y;
    f->dx[i] += lost_x;
    f->dy[i] += lost_y;
    f->clearance[i] = (double)distance;
    for (int k = 0; k + 1 < cuts.count; k++) {
        double cut_x = (double)cuts.cut[k].dx, cut_y = (double)cuts.cut[k].dy;
        book_stop(f, i, cuts.cut[k].solid, x, y, cut_x, cut_y);
        lost_x -= cut_x;
        lost_y -= cut_y;
    }
    int last = cuts.count ? cuts.cut[cuts.count - 1].solid : 0;
    book_stop(f, i, last, x, y, lost_x, lost_y);
}

/* A solid that moves may come as near as the circle around it does. */
static void expect_solids(skv_reference *f, int i)
{
    const skv_solids *all = f->boundary->solids;
    for (int k = 0; all && f->advances && k < all->count; k++) {
        const skv_solid *s = &all->solid[k];
        double rx = f->x[i] - (double)s->now.x, ry = f->y[i] - (double)s->now.y;
        double near = sqrt(rx * rx + ry * ry) - (double)(s->reach + skv_solid_way(s));
        f->clearance[i] = skv_min(f->clearance[i], near);
    }
}

/* Carries out a particle's dx, dy. `clearance` is a lower bound of the distance to the nearest
 * wall: only moves that exceed it look at the terrain. */
static void move_one(skv_reference *f, int i, bool on)
{
    expect_solids(f, i);
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

/* What a particle is in contact with. */
typedef struct contact {
    double depth; /* inside the contact distance; 0: it is not */
    double nx, ny;
    double way_x, way_y; /* of the wall in this substep */
    int solid;
} contact;

static contact find_contact(skv_reference *f, int i)
{
    contact found = {0};
    if (!(f->clearance[i] < (double)f->boundary->contact_distance))
        return found;
    float nx, ny, distance, x = (float)f->x[i], y = (float)f->y[i];
    found.depth = (double)skv_solids_contact(f->boundary, x, y, &nx, &ny, &distance, &found.solid);
    f->clearance[i] = (double)distance;
    if (!(found.depth > 0))
        return found;
    found.nx = (double)nx;
    found.ny = (double)ny;
    if (found.solid)
        find_way(f, i, &found.way_x, &found.way_y);
    return found;
}

void skv_pass_contact(skv_reference *f)
{
    const double friction = (double)f->constants->friction;
    const double softness = (double)f->constants->softness;
    for (int i = 0; i < f->count; i++) {
        contact c = find_contact(f, i);
        if (!(c.depth > 0))
            continue;
        double tx = -c.ny, ty = c.nx;
        double rub = friction * ((f->moved_x[i] - c.way_x) * tx + (f->moved_y[i] - c.way_y) * ty);
        double push = softness * c.depth;
        f->dx[i] = push * c.nx - rub * tx;
        f->dy[i] = push * c.ny - rub * ty;
        book_stop(f, i, c.solid, (float)f->x[i], (float)f->y[i], f->dx[i], f->dy[i]);
        move_one(f, i, false);
    }
}
