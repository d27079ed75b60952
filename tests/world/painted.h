/* Random painted worlds for the tests: mazes, funnels, slanted walls and blobs, as pictures in
 * memory, and the closed chambers they consist of. */
#ifndef SKV_TESTS_PAINTED_H
#define SKV_TESTS_PAINTED_H

#include <stdbool.h>
#include <stdint.h>

/* A small generator (splitmix64), so that a seed names a world for ever. */
typedef struct dice {
    uint64_t state;
} dice;

dice dice_from_seed(uint64_t seed);
uint64_t dice_bits(dice *d);
/* Uniform in [low, high). */
float dice_float(dice *d, float low, float high);
/* Uniform in low..high. */
int dice_int(dice *d, int low, int high);

#define PAINTED_MAX_PIXELS 256

typedef enum painted_kind {
    PAINTED_MAZE,
    PAINTED_FUNNELS,
    PAINTED_DIAGONALS,
    PAINTED_BLOBS,
    PAINTED_MIXED,
    PAINTED_KINDS
} painted_kind;

typedef struct painted {
    painted_kind kind;
    bool grey; /* smooth edges; otherwise black and white */
    int width, height;
    uint8_t coverage[PAINTED_MAX_PIXELS * PAINTED_MAX_PIXELS]; /* row 0 at the bottom */
    /* The chamber of each pixel that is free, from 1; 0 for solid. Pixels that touch only at a
     * corner are taken as connected, so two chambers are surely closed against each other. */
    uint16_t chamber[PAINTED_MAX_PIXELS * PAINTED_MAX_PIXELS];
    int chambers;
} painted;

const char *painted_kind_name(painted_kind kind);

/* Paints a world, all of it from the dice. */
void paint(painted *p, dice *d);

/* The chamber of a point given in pixels from the lower left corner: that of the nearest free
 * pixel, or 0 if none is within two pixels. */
int painted_chamber(const painted *p, float px, float py);

#endif
