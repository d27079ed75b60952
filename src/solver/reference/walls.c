/* Meeting walls: moves as far as they allow, what the solid adds to the sums, and contact with them
 * (Algorithm 7 with errata 7): friction along the wall, then a push out of the contact distance.
 * Invariant: a particle out of contact gets no displacement by it. */
#include "solver/reference/passes.h"
#include "solver/wall_image.h"

#include <math.h>

static void book_in_box(const skv_substep *sub, int i, double dx, double dy)
{
    skv_reaction *r = sub->reaction;
    const skv_pass_data *s = &sub->data;
    float nx, ny;
    double d = (double)skv_terrain_normal(sub->boundary->terrain, s->x[i], s->y[i], &nx, &ny);
    double x = (double)s->x[i] - d * (double)nx, y = (double)s->y[i] - d * (double)ny;
    if (x < r->x0 || x > r->x1 || y < r->y0 || y > r->y1)
        return;
    r->dx += dx;
    r->dy += dy;
    r->moment += (x - (r->x0 + r->x1) / 2) * dy - (y - (r->y0 + r->y1) / 2) * dx;
}

void skv_book_reaction(const skv_substep *sub, int i, double dx, double dy)
{
    if (dx == 0 && dy == 0)
        return;
    const skv_pass_data *s = &sub->data;
    double per_h = (double)sub->constants->inv_h;
    double x = per_h * (double)s->x[i], y = per_h * (double)s->y[i];
    skv_impulse_sum given = {0};
    skv_impulse_add(&given, per_h * dx, per_h * dy, per_h * (x * dy - y * dx));
    atomic_fetch_add_explicit(&sub->given->x, given.x, memory_order_relaxed);
    atomic_fetch_add_explicit(&sub->given->y, given.y, memory_order_relaxed);
    atomic_fetch_add_explicit(&sub->given->moment, given.moment, memory_order_relaxed);
    if (sub->reaction)
        book_in_box(sub, i, dx, dy);
}

/* Moves particle i by its dx, dy as far as the walls allow; returns the share it could move, and
 * writes what it has moved along a wall instead. `clearance` is a lower bound of the distance to
 * the nearest wall: only moves that exceed it look at the terrain, which in a pool are one in ten.
 */
static float move_particle(const skv_substep *sub, int i, float *along_x, float *along_y)
{
    const skv_pass_data *s = &sub->data;
    float dx = s->dx[i], dy = s->dy[i];
    *along_x = *along_y = 0;
    /* The distance is bilinear: along a diagonal it can fall by the square root of two. */
    s->clearance[i] -= 1.4143f * sqrtf(dx * dx + dy * dy);
    if (s->clearance[i] > sub->boundary->margin) {
        s->x[i] += dx;
        s->y[i] += dy;
        return 1;
    }
    float x = s->x[i], y = s->y[i];
    float made = skv_boundary_slide(sub->boundary, sub->constants->images, &x, &y, dx, dy, along_x,
                                    along_y, &s->clearance[i]);
    skv_book_reaction(sub, i, (double)((made - 1) * dx + *along_x),
                      (double)((made - 1) * dy + *along_y));
    s->x[i] = x;
    s->y[i] = y;
    return made;
}

void skv_pass_advance(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    for (int i = begin; i < end; i++) {
        float along_x, along_y, lost = move_particle(sub, i, &along_x, &along_y) - 1;
        s->wx[i] = lost * s->dx[i] + along_x;
        s->wy[i] = lost * s->dy[i] + along_y;
    }
}

static void sample_solid(const skv_substep *sub, int i)
{
    const skv_pass_data *s = &sub->data;
    skv_wall_sample wall;
    skv_boundary_sample(sub->boundary, s->x[i], s->y[i], &wall);
    s->wall_density[i] = wall.r;
    s->wall_near[i] = wall.rn;
    s->f1x[i] = wall.f1x;
    s->f1y[i] = wall.f1y;
    s->f2x[i] = wall.f2x;
    s->f2y[i] = wall.f2y;
    s->image[i] = SKV_FAR;
    s->facing_x[i] = s->facing_y[i] = 0;
}

/* What images leave to the solid is a crowd. */
static void sample_image(const skv_substep *sub, int i)
{
    const skv_pass_data *s = &sub->data;
    const float share = sub->constants->residual_share;
    skv_image_sample wall;
    float distance = skv_boundary_sample_image(sub->boundary, s->x[i], s->y[i], &wall);
    bool near = distance < sub->constants->h && wall.distance < 1;
    s->image[i] = near ? wall.distance : SKV_FAR;
    s->facing_x[i] = near ? wall.nx : 0;
    s->facing_y[i] = near ? wall.ny : 0;
    s->wall_density[i] = near ? wall.r : 0;
    s->wall_near[i] = share * s->wall_density[i];
    s->f1x[i] = near ? wall.f1x : 0;
    s->f1y[i] = near ? wall.f1y : 0;
    s->f2x[i] = SKV_NEAR_WEIGHT * share * s->f1x[i];
    s->f2y[i] = SKV_NEAR_WEIGHT * share * s->f1y[i];
}

void skv_pass_walls(const skv_substep *sub, int begin, int end)
{
    for (int i = begin; i < end; i++) {
        if (sub->constants->images)
            sample_image(sub, i);
        else
            sample_solid(sub, i);
    }
}

void skv_pass_correct(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    for (int i = begin; i < end; i++) {
        float along_x, along_y, made = move_particle(sub, i, &along_x, &along_y);
        s->wx[i] += made * s->dx[i] + along_x;
        s->wy[i] += made * s->dy[i] + along_y;
    }
}

void skv_pass_slip(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    for (int i = begin; i < end; i++) {
        float nx = s->facing_x[i], ny = s->facing_y[i], size = sqrtf(nx * nx + ny * ny);
        if (!(size > 0))
            continue;
        float tx = -ny / size, ty = nx / size;
        /* The particle's displacement in this substep so far, along the wall. */
        float moved_x = s->wx[i] + s->dx[i] + c->dt * s->vx[i];
        float moved_y = s->wy[i] + s->dy[i] + c->dt * s->vy[i];
        float taken = skv_slip_taken(c->slip_friction, c->wall_drag, s->image[i]);
        float held = taken * (moved_x * tx + moved_y * ty);
        s->dx[i] -= held * tx;
        s->dy[i] -= held * ty;
        skv_book_reaction(sub, i, (double)(-held * tx), (double)(-held * ty));
    }
}

void skv_pass_find_contacts(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    float reach = sub->boundary->contact_distance;
    for (int i = begin; i < end; i++) {
        s->depth[i] = 0;
        if (s->clearance[i] < reach)
            s->depth[i] = skv_boundary_contact(sub->boundary, s->x[i], s->y[i], &s->normal_x[i],
                                               &s->normal_y[i], &s->clearance[i]);
    }
}

void skv_pass_contact(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    for (int i = begin; i < end; i++) {
        s->dx[i] = 0;
        s->dy[i] = 0;
        if (!(s->depth[i] > 0))
            continue;
        float tx = -s->normal_y[i], ty = s->normal_x[i];
        /* The particle's displacement in this substep so far, along the wall. */
        float slide = (s->wx[i] + c->dt * s->vx[i]) * tx + (s->wy[i] + c->dt * s->vy[i]) * ty;
        float rub = c->friction * slide, push = c->softness * s->depth[i];
        s->dx[i] = push * s->normal_x[i] - rub * tx;
        s->dy[i] = push * s->normal_y[i] - rub * ty;
        skv_book_reaction(sub, i, (double)s->dx[i], (double)s->dy[i]);
    }
}
