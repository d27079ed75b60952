/* The terrain's inside: what its files share.
 *
 * The stored field has a rim of SKV_TERRAIN_RIM pixels around the picture, so that sampling at the
 * picture's edge needs no special case. Grid coordinates count pixel centres of this larger field:
 * the lower left pixel of the rim is at (0, 0), the picture's is at (RIM, RIM).
 */
#ifndef SKV_TERRAIN_TERRAIN_H
#define SKV_TERRAIN_TERRAIN_H

#include "terrain/contour.h"
#include "terrain/squares.h"

#include <stdatomic.h>

/* Two pixels to sample in, one more for the normals' kernel. */
#define SKV_TERRAIN_RIM 3

/* Pixels by which distances are taken to be off, for rounding: 0.0005 at 8192 pixels. */
#define SKV_PIXEL_SLACK 0.01f

struct skv_terrain {
    atomic_int owners;
    int width, height; /* the picture, pixels */
    int columns, rows; /* the picture and its rim, pixels */
    float pixel_size;  /* m */
    float per_metre;   /* pixels a metre */
    unsigned open_sides;
    float lowest, highest; /* the free region, m */
    double free_area;      /* m^2 */
    float *field;          /* columns * rows signed distances, m */
    uint8_t *coverage;     /* columns * rows: the picture it was made from, with its rim */
    uint64_t *row_hash;    /* height: of the picture's rows */
    double *row_free;      /* height: the free pixels of each */
    uint64_t hash;         /* of all that it was made from: equal hashes, equal terrains */
};

/* Allocates a terrain of such a picture, with its arrays; what is in them and everything else is to
 * be filled in. Null: no memory. */
skv_terrain *skv_terrain_allocate(int width, int height);

/* Derives from a terrain's picture and distances what else it holds. With `changed`, where these
 * differ from those of a terrain whose rows it has: what it says of the other rows stays. */
void skv_terrain_derive(skv_terrain *terrain, const skv_squares *changed);

static inline skv_coverage skv_terrain_coverage(const skv_terrain *terrain)
{
    return (skv_coverage){terrain->columns, terrain->rows, terrain->coverage};
}

/* The picture as it was given: row `y` from the bottom, `width` bytes. */
static inline const uint8_t *skv_terrain_row(const skv_terrain *terrain, int y)
{
    return terrain->coverage + (size_t)(y + SKV_TERRAIN_RIM) * (size_t)terrain->columns +
           SKV_TERRAIN_RIM;
}

#endif
