/* The boundary of the fluid: the walls as a solver meets them.
 *
 * Plain data and functions of it, sampled in place: nothing calls back, so it can be copied to
 * where a solver runs. Places and lengths are in units and axes of the asker's choice; the world's
 * own boundary is in m and in the world's axes. All of it is const: any number of threads may ask.
 *
 * Invariant: an answer in other units and axes is that in the world's own, but for the rounding of
 * the conversion; and a move ends where the terrain's sweep lets it, so nothing passes a wall,
 * however fast it is.
 */
#ifndef SKV_TERRAIN_BOUNDARY_H
#define SKV_TERRAIN_BOUNDARY_H

#include "base/exact.h"
#include "terrain/sample.h"
#include "terrain/wall_map.h"

typedef struct skv_boundary {
    const skv_terrain *terrain;
    const skv_wall_map *walls;
    float margin;           /* how close a move may come to a wall, m */
    float contact_distance; /* closer to a wall than this is contact, m */
    /* What stands in the fluid beside the terrain, terrain/solids.h, which alone knows of them: the
     * functions here are of the terrain. Null: nothing. */
    const struct skv_solids *solids;

    float unit, per_unit; /* the asker's unit of length, in m, and its reciprocal */
    bool swapped;         /* the asker's x is the world's y */
} skv_boundary;

/* The same walls, in other units and axes. */
static inline skv_boundary skv_boundary_seen(const skv_boundary *boundary, float unit,
                                             float per_unit, bool swapped)
{
    skv_boundary seen = *boundary;
    seen.unit = unit;
    seen.per_unit = per_unit;
    seen.swapped = swapped;
    return seen;
}

static inline void skv_boundary_swap(const skv_boundary *b, float *x, float *y)
{
    if (b->swapped) {
        float kept = *x;
        *x = *y;
        *y = kept;
    }
}

/* From the asker's units and axes to the world's. */
static inline void skv_boundary_to_world(const skv_boundary *b, float *x, float *y)
{
    *x *= b->unit;
    *y *= b->unit;
    skv_boundary_swap(b, x, y);
}

/* Moves (x, y) by (dx, dy) as far as the walls allow; writes the distance to the nearest wall there
 * and returns the share of the way that was made, 0..1. */
static inline float skv_boundary_move(const skv_boundary *b, float *x, float *y, float dx, float dy,
                                      float *distance)
{
    float wx = *x, wy = *y, wdx = dx, wdy = dy;
    skv_boundary_to_world(b, &wx, &wy);
    skv_boundary_to_world(b, &wdx, &wdy);
    float share = skv_terrain_sweep(b->terrain, wx, wy, wx + wdx, wy + wdy, b->margin);
    wx += share < 1 ? share * wdx : wdx;
    wy += share < 1 ? share * wdy : wdy;
    *distance = skv_distance_at(b->terrain, wx, wy) * b->per_unit;
    /* Not wx, wy turned back: a free move must give the same bits as one that did not ask. */
    *x += share < 1 ? share * dx : dx;
    *y += share < 1 ? share * dy : dy;
    return share;
}

/* How near a way along a wall may come, in margins. It begins at the margin itself, and with 1
 * rounding would decide how far it goes on a wall that bends a little. With 0.5 jets that leave an
 * orifice are slower by a hundredth. */
#define SKV_MARGIN_ALONG 0.9f

/* How much of a way along a wall a corner leaves, 1: all, 0: nothing, at a point in the world's
 * axes with the wall's normal there. In a corner the wall bends towards the way, which would end at
 * once or not at all by how its start was rounded: the two walls stop it together. What bends as a
 * circle of ten pixels is no corner yet, what does as one of three is one. */
static inline float skv_boundary_straight(const skv_boundary *b, float x, float y, float nx,
                                          float ny)
{
    float pixel = b->terrain->pixel_size, tx = -pixel * ny, ty = pixel * nx;
    float aside =
        skv_distance_at(b->terrain, x + tx, y + ty) + skv_distance_at(b->terrain, x - tx, y - ty);
    float bend = (2 * skv_distance_at(b->terrain, x, y) - aside) * b->terrain->per_metre;
    return skv_clamp(1.5f - 5 * bend, 0, 1);
}

/* The same; but with `on` what is left of the way after it has met a wall goes on along it, which
 * it writes to (along_x, along_y): fluid that comes to a wall at a slant loses what it had into the
 * wall, and no more. */
static inline float skv_boundary_slide(const skv_boundary *b, bool on, float *x, float *y, float dx,
                                       float dy, float *along_x, float *along_y, float *distance)
{
    float made = skv_boundary_move(b, x, y, dx, dy, distance);
    *along_x = *along_y = 0;
    if (!on || !(made < 1))
        return made;
    float wx = *x, wy = *y, nx, ny;
    skv_boundary_to_world(b, &wx, &wy);
    skv_normal_at(b->terrain, wx, wy, &nx, &ny);
    float left = (1 - made) * skv_boundary_straight(b, wx, wy, nx, ny);
    skv_boundary_swap(b, &nx, &ny);
    float left_x = left * dx, left_y = left * dy, in = left_x * nx + left_y * ny;
    if (!(in < 0))
        return made;
    left_x -= in * nx;
    left_y -= in * ny;
    skv_boundary nearer = *b;
    nearer.margin = SKV_MARGIN_ALONG * b->margin;
    float share = skv_boundary_move(&nearer, x, y, left_x, left_y, distance);
    *along_x = share * left_x;
    *along_y = share * left_y;
    return made;
}

/* How far to push a particle at (x, y) out of the contact distance; 0 if it is not in contact. In a
 * gap narrower than twice that distance the push ends in the middle: both walls pushing in turn
 * would shake the fluid. Writes the distance, and the normal if there is contact. */
static inline float skv_boundary_contact(const skv_boundary *b, float x, float y, float *nx,
                                         float *ny, float *distance)
{
    skv_boundary_to_world(b, &x, &y);
    float clear = skv_normal_at(b->terrain, x, y, nx, ny), depth = b->contact_distance - clear;
    *distance = clear * b->per_unit;
    if (!(depth > 0))
        return 0;
    float beyond = skv_distance_at(b->terrain, x + depth * *nx, y + depth * *ny);
    float gain = skv_maxf(-depth, skv_minf(depth, beyond - clear));
    skv_boundary_swap(b, nx, ny);
    return 0.5f * (depth + gain) * b->per_unit;
}

/* True if there are thin walls at all, and if one may be within h of a point: there alone pairs
 * must be asked whether they see each other. */
static inline bool skv_boundary_has_thin(const skv_boundary *b)
{
    return b->walls->thin != NULL;
}

static inline bool skv_boundary_near_thin(const skv_boundary *b, float x, float y)
{
    skv_boundary_to_world(b, &x, &y);
    return skv_wall_map_near_thin(b->walls, x, y);
}

/* The distance to the nearest wall, in m, from a point that it turns to the world's; beside a thin
 * wall, which it tells, with the normal. */
static inline float skv_boundary_face(const skv_boundary *b, float *x, float *y, bool *thin,
                                      float *nx, float *ny)
{
    skv_boundary_to_world(b, x, y);
    *thin = skv_wall_map_near_thin(b->walls, *x, *y);
    return *thin ? skv_normal_at(b->terrain, *x, *y, nx, ny) : skv_distance_at(b->terrain, *x, *y);
}

/* The wall sums at a point; returns the distance to the nearest wall. */
static inline float skv_boundary_sample(const skv_boundary *b, float x, float y,
                                        skv_wall_sample *wall)
{
    bool thin;
    float nx = 0, ny = 0, distance = skv_boundary_face(b, &x, &y, &thin, &nx, &ny);
    if (thin)
        skv_wall_map_sample_beside(b->walls, x, y, distance, nx, ny, wall);
    else
        skv_wall_map_sample(b->walls, x, y, wall);
    skv_boundary_swap(b, &wall->f1x, &wall->f1y);
    skv_boundary_swap(b, &wall->f2x, &wall->f2y);
    return distance * b->per_unit;
}

/* What images need at a point, for walls that have them; returns the distance to the nearest wall.
 */
static inline float skv_boundary_sample_image(const skv_boundary *b, float x, float y,
                                              skv_image_sample *image)
{
    bool thin;
    float nx = 0, ny = 0, distance = skv_boundary_face(b, &x, &y, &thin, &nx, &ny);
    if (thin)
        skv_wall_map_sample_image_beside(b->walls, x, y, distance, nx, ny, image);
    else
        skv_wall_map_sample_image(b->walls, x, y, image);
    skv_boundary_swap(b, &image->nx, &image->ny);
    skv_boundary_swap(b, &image->f1x, &image->f1y);
    return distance * b->per_unit;
}

/* True if a thin wall stands between two places within h of each other, so that the particles there
 * feel nothing of each other; the same for both orders. The bounds are lower bounds of the places'
 * distances from walls; 0: not known. */
static inline bool skv_boundary_occluded(const skv_boundary *b, float ax, float ay,
                                         float a_clearance, float bx, float by, float b_clearance)
{
    const skv_terrain *t = b->terrain;
    skv_boundary_to_world(b, &ax, &ay);
    skv_boundary_to_world(b, &bx, &by);
    return skv_wall_map_near_thin(b->walls, ax, ay) && skv_wall_map_near_thin(b->walls, bx, by) &&
           skv_grid_occluded(t, skv_to_grid(t, ax), skv_to_grid(t, ay), a_clearance * b->unit,
                             skv_to_grid(t, bx), skv_to_grid(t, by), b_clearance * b->unit);
}

#endif
