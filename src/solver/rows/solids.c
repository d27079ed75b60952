/* Solids beside the terrain, as the rows meet them: how near they come, how their walls move, and
 * what each of them gives. One particle at a time and compiled once: few particles are near any.
 * Invariant: where there are none, nothing of it is called. */
#include "solver/rows/solids.h"

#include <math.h>

static void middle_of(const skv_boundary *boundary, const skv_solid *solid, float *x, float *y)
{
    *x = solid->now.x * boundary->per_unit;
    *y = solid->now.y * boundary->per_unit;
    skv_boundary_swap(boundary, x, y);
}

/* Bounds are lowered to so many radii at most: below one the walls are sampled, and with two a
 * substep's moves do not lead there from where no solid is. */
#define FREE 2.0f

void skv_rows_expect_solids(const skv_rows *rows, int row, const skv_boundary *boundary)
{
    const skv_row_particles *p = &rows->set[rows->current];
    const int begin = rows->row_start[row], end = rows->row_end[row];
    float low = INFINITY, high = -INFINITY;
    for (int i = begin; i < end; i++) {
        p->clearance[i] = p->clearance[i] < FREE ? p->clearance[i] : FREE;
        low = p->y[i] < low ? p->y[i] : low;
        high = p->y[i] > high ? p->y[i] : high;
    }
    for (int k = 0; k < boundary->solids->count; k++) {
        const skv_solid *solid = &boundary->solids->solid[k];
        float x, y, near = (solid->reach + skv_solid_way(solid)) * boundary->per_unit;
        const float most = (near + FREE) * (near + FREE);
        middle_of(boundary, solid, &x, &y);
        if (low - y > near + FREE || y - high > near + FREE)
            continue; /* of the whole row */
        for (int i = begin; i < end; i++) {
            float dx = p->x[i] - x, dy = p->y[i] - y, square = dx * dx + dy * dy;
            if (square >= most)
                continue;
            float away = sqrtf(square) - near;
            p->clearance[i] = away < p->clearance[i] ? away : p->clearance[i];
        }
    }
}

float skv_rows_sample_solids(const skv_boundary *boundary, bool images, float x, float y,
                             skv_near_wall *to)
{
    skv_walls_met met;
    skv_solids_meet(boundary, images, x, y, &met);
    to->solid = met.sum.solid;
    if (images)
        to->at.image = skv_image_of_part(&met.sum);
    else
        to->at.wall = skv_sums_of(&met.sum);
    return met.distance;
}

/* Where a particle is while its pairs lag behind. */
static void place_of(const skv_rows *rows, int i, const skv_constants *c, float *x, float *y)
{
    const skv_row_particles *p = &rows->set[rows->current];
    float lag = lag_of_one(p, i, c->pair_lag, c->lag_rise);
    *x = p->x[i] + lag * p->u[i];
    *y = p->y[i] + lag * p->v[i];
}

/* What particle i has been sampled beside; met anew only if that are several. */
static void meet_again(const skv_near_wall *wall, const skv_constants *c,
                       const skv_boundary *boundary, float x, float y, skv_walls_met *met)
{
    if (wall->solid < 0) {
        skv_solids_meet(boundary, c->images, x, y, met);
        return;
    }
    const skv_image_sample *image = &wall->at.image;
    const skv_wall_sample *sums = &wall->at.wall;
    met->count = 1;
    met->part[0] = (skv_part_of_walls){.solid = wall->solid, .distance = 1};
    if (c->images) {
        met->part[0].distance = image->distance;
        met->part[0].nx = image->nx;
        met->part[0].ny = image->ny;
        met->part[0].f1x = image->f1x;
        met->part[0].f1y = image->f1y;
    } else {
        met->part[0].f1x = sums->f1x;
        met->part[0].f1y = sums->f1y;
    }
    met->sum = met->part[0];
}

void skv_rows_way_of_walls(const skv_rows *rows, const skv_near_wall *wall, const skv_constants *c,
                           const skv_boundary *boundary, float *dx, float *dy)
{
    float x, y;
    skv_walls_met met;
    place_of(rows, wall->particle, c, &x, &y);
    meet_again(wall, c, boundary, x, y, &met);
    skv_solids_way(boundary, &met, x, y, dx, dy);
}

/* Books what a wall gives particle i at (x, y). To a solid about its middle, and with the arm of
 * where the particle was before the substep: its velocity is the way from there, so that is what
 * its moment of momentum changes by. */
static void book(const skv_rows *rows, const skv_boundary *boundary, int solid, int i, float x,
                 float y, float dx, float dy, skv_row_given *walls)
{
    const skv_row_particles *p = &rows->set[rows->current];
    float at_x, at_y;
    if (solid) {
        middle_of(boundary, &boundary->solids->solid[solid - 1], &at_x, &at_y);
        skv_impulse_give(&walls->solid[solid - 1], x - p->u[i] - at_x, y - p->v[i] - at_y, dx, dy);
    } else if (rows->reaction) {
        skv_rows_book_reaction(rows, boundary, x, y, dx, dy, walls);
    }
}

void skv_rows_book_push(const skv_rows *rows, const skv_near_wall *wall, bool images,
                        const skv_boundary *boundary, float x, float y, float dx, float dy,
                        skv_push_made made, skv_row_given *walls)
{
    if (wall->solid >= 0) {
        book(rows, boundary, wall->solid, wall->particle, x, y, dx, dy, walls);
        return;
    }
    skv_walls_met met;
    float share[SKV_MOST_PARTS][2];
    skv_solids_meet(boundary, images, x, y, &met);
    skv_solids_share(boundary, &met, x, y, made.by_slope, made.by_rest, made.by_near, dx, dy,
                     share);
    for (int k = 0; k < met.count; k++)
        book(rows, boundary, met.part[k].solid, wall->particle, x, y, share[k][0], share[k][1],
             walls);
}

void skv_rows_book_cuts(const skv_rows *rows, const skv_boundary *boundary, int i, float x, float y,
                        const skv_cuts *cuts, skv_row_given *walls)
{
    float mass = skv_row_mass(rows, i);
    for (int k = 0; k < cuts->count; k++) {
        int solid = cuts->cut[k].solid;
        float dx = mass * cuts->cut[k].dx, dy = mass * cuts->cut[k].dy;
        float film = skv_solids_film(boundary, solid, x, y);
        skv_impulse_give(&walls->all, x, y, dx, dy);
        book(rows, boundary, solid, i, x, y, (1 - film) * dx, (1 - film) * dy, walls);
        if (film > 0)
            book(rows, boundary, 0, i, x, y, film * dx, film * dy, walls);
    }
}

static void book_turn(const skv_rows *rows, const skv_near_wall *wall, const skv_constants *c,
                      const skv_boundary *boundary, skv_row_given *walls)
{
    float x, y;
    int i = wall->particle;
    skv_walls_met met;
    place_of(rows, i, c, &x, &y);
    meet_again(wall, c, boundary, x, y, &met);
    float flat = c->images ? c->image_gradient * skv_flat_slope(met.sum.distance) : 0;
    for (int k = 0; k < met.count; k++) {
        const skv_part_of_walls *part = &met.part[k];
        if (part->solid == 0)
            continue;
        float wall_x = part->f1x + flat * part->nx, wall_y = part->f1y + flat * part->ny;
        float turn =
            c->tension_scale * (wall_x * rows->gradient_y[i] - wall_y * rows->gradient_x[i]);
        skv_impulse_add(&walls->solid[part->solid - 1], 0, 0, -(double)turn);
    }
}

/* Whether a particle may turn what it is near. */
static bool turns(const skv_rows *rows, int i)
{
    const skv_row_particles *p = &rows->set[rows->current];
    return rows->graded[i / ROW_LANES] && !(p->number[i] & ROW_HELD);
}

void skv_rows_book_turns(const skv_rows *rows, int row, const skv_constants *c,
                         const skv_boundary *boundary, const skv_row_samples *samples,
                         skv_row_given *walls)
{
    for (int n = 0; n < samples->used; n++)
        if (samples->sample[n].solid != 0 && turns(rows, samples->sample[n].particle))
            book_turn(rows, &samples->sample[n], c, boundary, walls);
    /* Those that found no place are met anew. */
    const skv_row_particles *p = &rows->set[rows->current];
    for (int i = rows->row_start[row]; samples->used < 0 && i < rows->row_end[row]; i++)
        if (p->clearance[i] < 1 && turns(rows, i))
            book_turn(rows, &(skv_near_wall){.particle = i, .solid = -1}, c, boundary, walls);
}

void skv_rows_touch_solids(const skv_rows *rows, int i, const skv_constants *c,
                           const skv_boundary *boundary, skv_row_given *walls)
{
    const skv_row_particles *p = &rows->set[rows->current];
    float nx, ny, way_x = 0, way_y = 0, along_x, along_y;
    int solid;
    float depth =
        skv_solids_contact(boundary, p->x[i], p->y[i], &nx, &ny, &p->clearance[i], &solid);
    if (!(depth > 0))
        return;
    if (solid) {
        const skv_near_wall all = {.particle = i, .solid = -1};
        skv_rows_way_of_walls(rows, &all, c, boundary, &way_x, &way_y);
    }
    float slide = (p->v[i] - way_y) * nx - (p->u[i] - way_x) * ny;
    float rub = c->friction * slide, push = c->softness * depth;
    float dx = push * nx + rub * ny, dy = push * ny - rub * nx;
    skv_cuts cuts = {.count = 1, .cut = {{solid, dx, dy}}};
    skv_rows_book_cuts(rows, boundary, i, p->x[i], p->y[i], &cuts, walls);
    float made = skv_solids_slide(boundary, false, false, &p->x[i], &p->y[i], dx, dy, &along_x,
                                  &along_y, &p->clearance[i], &cuts);
    p->u[i] += made * dx + along_x;
    p->v[i] += made * dy + along_y;
    skv_rows_book_cuts(rows, boundary, i, p->x[i], p->y[i], &cuts, walls);
}

void skv_rows_tell_solids(const skv_rows *rows, const skv_boundary *boundary, skv_impulse *given)
{
    double h = (double)boundary->unit;
    for (int k = 0; k < boundary->solids->count; k++) {
        skv_impulse_sum sum = {0};
        for (int t = 0; t < rows->threads; t++)
            skv_impulse_join(&sum, &rows->thread[t].walls.solid[k]);
        skv_impulse all = skv_impulse_value(&sum);
        given[k] = (skv_impulse){all.x * h, all.y * h, all.moment * h * h};
        if (boundary->swapped)
            given[k] = (skv_impulse){given[k].y, given[k].x, -given[k].moment};
    }
}
