/* The thesis' distance field (Algorithm 10) with its normals (section 3.4) and the errata applied,
 * as the comparison for the sub-pixel field. Distances in pixels, > 0 in air. */
#ifndef SKV_TESTS_TERRAIN_MANHATTAN_H
#define SKV_TESTS_TERRAIN_MANHATTAN_H

#include <stdbool.h>
#include <stdint.h>

/* The fields have a frame of one solid pixel around the picture: pixel (x, y) of the picture is
 * element (y + 1) * width + x + 1. */
typedef struct manhattan {
    int width, height; /* with the frame */
    float *raw;        /* as printed: 0 at edge pixels of the solid, whole steps from there */
    float *corrected;  /* (raw + 1/2) max(|nx|, |ny|): about Euclidean */
    float *nx, *ny;    /* 9x9 kernel, out of the solid; 0, 0 where undefined */
} manhattan;

/* Solid is everything from 128 on. */
manhattan manhattan_create(int width, int height, const uint8_t *coverage);
void manhattan_destroy(manhattan *field);

#endif
