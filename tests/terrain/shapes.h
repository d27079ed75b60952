/* Analytic shapes and their pictures, for the terrain tests. */
#ifndef SKV_TESTS_TERRAIN_SHAPES_H
#define SKV_TESTS_TERRAIN_SHAPES_H

#include "skvalp/terrain.h"
#include "terrain/wall_map.h"

/* A shape by its signed distance in pixels, > 0 in air. */
typedef struct shape {
    const char *name;
    double (*distance)(const struct shape *shape, double x, double y);
    double x, y;   /* centre of a circle, a point of a wall */
    double radius; /* of a circle */
    double nx, ny; /* a wall's normal, out of the solid */
} shape;

shape disc_shape(const char *name, double x, double y, double radius);
shape bowl_shape(const char *name, double x, double y, double radius);
/* A half plane through (x, y) whose surface rises by `degrees`, air above it. */
shape wall_shape(const char *name, double x, double y, double degrees);

double shape_distance(const shape *shape, double x, double y);
/* The unit normal out of the solid, by differences of the distance. */
void shape_normal(const shape *shape, double x, double y, double *nx, double *ny);

/* Paints a shape: area coverage from 16 x 16 points a pixel, or with `grey` false the pixel
 * centres' side. */
void paint_shape(const shape *shape, int width, int height, bool grey, uint8_t *coverage);

/* Makes a terrain of the picture, which must succeed. */
skv_terrain *make_terrain(int width, int height, const uint8_t *coverage, float pixel_size,
                          unsigned open_sides);

/* Its map with images, thin walls known; for a smoothing radius of three spacings. */
skv_wall_map *make_image_map(const skv_terrain *terrain, float radius);

/* A small random generator: the same numbers everywhere. */
typedef struct dice {
    uint64_t state;
} dice;
double roll(dice *d); /* 0..1 */

#endif
