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
    const skv_solids *solids = boundary->solids;
    struct {
        float x, y, near, most;
    } circle[SKV_MOST_SOLIDS];
    for (int k = 0; k < solids->count; k++) {
        const skv_solid *solid = &solids->solid[k];
        circle[k].near = (solid->reach + skv_solid_way(solid)) * boundary->per_unit;
        circle[k].most = (circle[k].near + FREE) * (circle[k].near + FREE);
        middle_of(boundary, solid, &circle[k].x, &circle[k].y);
    }
    const float *along = boundary->swapped ? p->y : p->x; /* the world's x */
    for (int i = rows->row_start[row]; i < rows->row_end[row]; i++) {
        float clear = p->clearance[i] < FREE ? p->clearance[i] : FREE;
        uint64_t left = solids->beside[skv_strip_of(solids, along[i] * boundary->unit)];
        for (; left; left &= left - 1) {
            const int k = __builtin_ctzll(left);
            float dx = p->x[i] - circle[k].x, dy = p->y[i] - circle[k].y;
            float square = dx * dx + dy * dy;
            float away = square < circle[k].most ? sqrtf(square) - circle[k].near : FREE;
            clear = away < clear ? away : clear;
        }
        p->clearance[i] = clear;
    }
}

/* A part of what walls are, as a sample and back. */
static skv_near_wall sample_of(const skv_part_of_walls *part, bool images, int particle)
{
    skv_near_wall wall = {.particle = particle, .solid = part->solid};
    if (images)
        wall.at.image = skv_image_of_part(part);
    else
        wall.at.wall = skv_sums_of(part);
    return wall;
}

static skv_part_of_walls part_of(const skv_near_wall *wall, bool images)
{
    const skv_image_sample *image = &wall->at.image;
    const skv_wall_sample *sums = &wall->at.wall;
    return images ? (skv_part_of_walls){.solid = wall->solid,
                                        .distance = image->distance,
                                        .nx = image->nx,
                                        .ny = image->ny,
                                        .f1x = image->f1x,
                                        .f1y = image->f1y}
                  : (skv_part_of_walls){.solid = wall->solid,
                                        .distance = 1,
                                        .f1x = sums->f1x,
                                        .f1y = sums->f1y,
                                        .f2x = sums->f2x,
                                        .f2y = sums->f2y};
}

float skv_rows_sample_solids(const skv_boundary *boundary, bool images, float x, float y,
                             skv_near_wall *to)
{
    skv_walls_met met;
    skv_solids_meet(boundary, images, x, y, &met);
    to[0] = sample_of(&met.sum, images, to->particle);
    if (met.count < 2)
        return met.distance;
    to->solid = -met.count;
    for (int k = 0; k < met.count; k++)
        to[1 + k] = sample_of(&met.part[k], images, to->particle);
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

/* Samples what particle i is beside. */
static void sample_particle(const skv_rows *rows, int i, const skv_constants *c,
                            const skv_boundary *boundary, skv_near_wall all[ROW_MOST_WALLS])
{
    float x, y;
    place_of(rows, i, c, &x, &y);
    all->particle = i;
    skv_rows_sample_solids(boundary, c->images, x, y, all);
}

/* The parts of what a particle has been sampled beside. */
static void recall(const skv_near_wall *wall, bool images, skv_walls_met *met)
{
    const skv_near_wall *part = wall->solid < 0 ? wall + 1 : wall;
    met->count = wall->solid < 0 ? -wall->solid : 1;
    for (int k = 0; k < met->count; k++)
        met->part[k] = part_of(&part[k], images);
}

void skv_rows_way_of_walls(const skv_rows *rows, const skv_near_wall *wall, const skv_constants *c,
                           const skv_boundary *boundary, float *dx, float *dy)
{
    float x, y;
    skv_walls_met met;
    place_of(rows, wall->particle, c, &x, &y);
    recall(wall, c->images, &met);
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
    recall(wall, images, &met);
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
                      skv_row_given *walls)
{
    const int i = wall->particle;
    skv_walls_met met;
    recall(wall, c->images, &met);
    float flat = c->images ? c->image_gradient * skv_flat_slope(wall->at.image.distance) : 0;
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
    for (int n = 0; n < samples->used; n += skv_near_walls(&samples->sample[n]))
        if (samples->sample[n].solid != 0 && turns(rows, samples->sample[n].particle))
            book_turn(rows, &samples->sample[n], c, walls);
    /* Those that found no place are met anew. */
    const skv_row_particles *p = &rows->set[rows->current];
    for (int i = rows->row_start[row]; samples->used < 0 && i < rows->row_end[row]; i++) {
        if (p->clearance[i] >= 1 || !turns(rows, i))
            continue;
        skv_near_wall all[ROW_MOST_WALLS];
        sample_particle(rows, i, c, boundary, all);
        book_turn(rows, all, c, walls);
    }
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
        skv_near_wall all[ROW_MOST_WALLS];
        sample_particle(rows, i, c, boundary, all);
        skv_rows_way_of_walls(rows, all, c, boundary, &way_x, &way_y);
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
