/* Solids: what stands or moves in the fluid beside the terrain, each with walls of its own.
 *
 * A solid's walls are those of a small terrain, its shape, in a frame of its own; a pose says where
 * that frame lies. The terrain is number 0, the solids beside it have the numbers from 1 on. The
 * share of a particle's kernel that lies in solids adds over them, for they do not overlap; so a
 * particle near several meets one image distance, of the sum of their shares, and what each does to
 * it goes by how much of that distance's slope is its own (terrain/image_distance.h).
 *
 * Places and lengths are in the units and axes of the boundary that is asked, poses in m and in the
 * world's. Invariant: what a particle is given is the sum of what the solids give it.
 */
#ifndef SKV_TERRAIN_SOLIDS_H
#define SKV_TERRAIN_SOLIDS_H

#include "terrain/boundary.h"
#include "terrain/image_distance.h"

enum {
    SKV_MOST_SOLIDS = 64, /* beside the terrain: a bit each */
    SKV_STRIPS = 128,     /* that they are looked for in */
    SKV_MOST_PARTS = 6    /* that one particle meets at once; more are passed over */
};

/* Where a frame lies: its middle, and the cosine and sine of the angle by which it is turned. */
typedef struct skv_pose {
    float x, y, cos, sin;
} skv_pose;

typedef struct skv_solid {
    const skv_boundary *shape; /* its walls, in m and in its own frame, with all sides open */
    float middle_x, middle_y;  /* of its frame, m: the point that the pose places ... */
    float reach;               /* ... within so far of which all of it lies, m */
    skv_pose before, now;      /* where a substep's advance finds it, and where it stays then */
    float dx, dy, turn;        /* its middle's way meanwhile, m, and how far it turns, rad */
} skv_solid;

/* All beside the terrain: number k is solid[k - 1]. */
typedef struct skv_solids {
    int count;
    skv_solid solid[SKV_MOST_SOLIDS];
    float spacing; /* of the fluid, m */
    skv_image_law law;
    /* Strips along the world's x from `low` on, m: which solids may be, or on their way in the
     * substep have been, within two radii of each. */
    float low, strips_a_metre;
    uint64_t beside[SKV_STRIPS];
} skv_solids;

/* The strip of a place; the first and the last go on without end. */
static inline int skv_strip_of(const skv_solids *solids, float x)
{
    return (int)skv_clamp((x - solids->low) * solids->strips_a_metre, 0, SKV_STRIPS - 1);
}

/* Finds the strips for solids that lie where they are `now` and have come their ways, and a
 * smoothing radius. */
void skv_solids_arrange(skv_solids *solids, float h);

/* What one solid is to a particle: with walls by images its share of D's slope (nx, ny) and the
 * rest of R and F1; else R, Rn, F1 and F2. */
typedef struct skv_part_of_walls {
    int solid;
    float distance; /* D of this one alone */
    float nx, ny, r, rn, f1x, f1y, f2x, f2y;
} skv_part_of_walls;

/* A gap so narrow between a body and a wall is a film, which bears the pressure at its ends
 * (world/bodies/film.c): from 2.4 spacings downwards, and wholly from 1.8 on. Between two walls by
 * images no particle comes into less; where the film bore less, a light body came off the floor by
 * so much and stayed there (docs/notebook/2026-11-27-bodies.md). */
static inline float skv_film_reach(float spacing)
{
    return 2.4f * spacing;
}

/* How much of the pressure in a gap the film bears: what is left do particles. */
static inline float skv_film_share(float gap, float spacing)
{
    return skv_clamp((skv_film_reach(spacing) - gap) / (0.6f * spacing), 0, 1);
}

/* How much two walls with these normals face each other. */
static inline float skv_facing(float nx, float ny, float mx, float my)
{
    return skv_clamp(-(nx * mx + ny * my), 0, 1);
}

/* What all of them are together: `sum` as if of one solid, its number or -1 if there are several.
 */
typedef struct skv_walls_met {
    float distance; /* to the nearest */
    int count;      /* parts; those within h alone */
    skv_part_of_walls sum, part[SKV_MOST_PARTS];
} skv_walls_met;

/* Meets the walls at a point, those of the terrain first; `images`: as images need them. This and
 * what follows serve a boundary without solids, too, and find there what it does alone. */
void skv_solids_meet(const skv_boundary *boundary, bool images, float x, float y,
                     skv_walls_met *met);

/* A part, or the sum, as a solver takes it from the terrain alone. */
static inline skv_wall_sample skv_sums_of(const skv_part_of_walls *p)
{
    return (skv_wall_sample){p->r, p->rn, p->f1x, p->f1y, p->f2x, p->f2y};
}

static inline skv_image_sample skv_image_of_part(const skv_part_of_walls *p)
{
    return (skv_image_sample){p->distance, p->nx, p->ny, p->r, p->f1x, p->f1y};
}

/* How far the walls' material moves in the substep where a point is. */
void skv_solids_way(const skv_boundary *boundary, const skv_walls_met *met, float x, float y,
                    float *dx, float *dy);

/* Shares out what the walls give a particle at (x, y), where it has met them: (dx, dy), of which by
 * its size each part has a known push of `by_slope` times its share of D's slope, `by_rest` times
 * its F1 and `by_near` times its F2; what is over goes by the sizes of the shares. */
void skv_solids_share(const skv_boundary *boundary, const skv_walls_met *met, float x, float y,
                      float by_slope, float by_rest, float by_near, float dx, float dy,
                      float share[SKV_MOST_PARTS][2]);

/* How much of what stops a particle at (x, y) beside solid number `solid` the terrain bears,
 * because it lies in a film between the two. */
float skv_solids_film(const skv_boundary *boundary, int solid, float x, float y);

/* What walls take from a move, one after the other. */
typedef struct skv_cuts {
    int count;
    struct {
        int solid;
        float dx, dy;
    } cut[SKV_MOST_PARTS];
} skv_cuts;

/* As skv_boundary_slide, but also stopped by solids: in their own frames, in which what is at rest
 * before a body that comes is what moves. `advances`: the solids move meanwhile from where they
 * were before to where they are now. Where one stops the particle none of the way counts as made,
 * and (along_x, along_y) is all of it. */
float skv_solids_slide(const skv_boundary *boundary, bool advances, bool on, float *x, float *y,
                       float dx, float dy, float *along_x, float *along_y, float *distance,
                       skv_cuts *cuts);

/* As skv_boundary_contact: with the wall in which the particle is deepest, and its number. */
float skv_solids_contact(const skv_boundary *boundary, float x, float y, float *nx, float *ny,
                         float *distance, int *solid);

/* Lower bound of the distance between a point and all solids while a substep lasts, in m. */
static inline float skv_solid_way(const skv_solid *s)
{
    float turn = s->turn < 0 ? -s->turn : s->turn;
    return sqrtf(s->dx * s->dx + s->dy * s->dy) + turn * s->reach;
}

/* From the world's axes to a solid's frame, and back. */
static inline void skv_solid_enter(const skv_solid *s, const skv_pose *pose, float *x, float *y)
{
    float rx = *x - pose->x, ry = *y - pose->y;
    *x = s->middle_x + (pose->cos * rx + pose->sin * ry);
    *y = s->middle_y + (pose->cos * ry - pose->sin * rx);
}

static inline void skv_solid_turn(const skv_pose *pose, float *x, float *y)
{
    float lx = *x, ly = *y;
    *x = pose->cos * lx - pose->sin * ly;
    *y = pose->sin * lx + pose->cos * ly;
}

static inline void skv_solid_leave(const skv_solid *s, const skv_pose *pose, float *x, float *y)
{
    *x -= s->middle_x;
    *y -= s->middle_y;
    skv_solid_turn(pose, x, y);
    *x += pose->x;
    *y += pose->y;
}

#endif
