/* A drawn surface: the height of fluid as a drawing has it, along gravity, over a region's columns.
 */
#ifndef SKV_CALM_DRAWN_H
#define SKV_CALM_DRAWN_H

#include <stdbool.h>

/* A surface is less steep than a face, as that of a dam. */
#define SKV_DRAWN_STEEPEST 1.0f

/* A place of it. `across` goes to the right of upwards. */
typedef struct skv_drawn_place {
    float across, height; /* m, as gravity has it */
    bool known;           /* else it is bridged */
} skv_drawn_place;

typedef struct skv_drawn_surface {
    float width; /* of a column, m */
    int first, count;
    skv_drawn_place *places; /* one in each column, from left to right */
} skv_drawn_surface;

/* Notes a place in its column, where it counts if it is the highest. */
void skv_drawn_note(const skv_drawn_surface *surface, int column, float across, float height);

/* Whether the known heights differ by more than this, m. */
bool skv_drawn_is_uneven(const skv_drawn_surface *surface, float difference);

/* Whether of two columns side by side one is known at least, and no height differs from the next
 * that is known by a steeper slope than the steepest. */
bool skv_drawn_is_gentle(const skv_drawn_surface *surface);

/* Gives the other columns, those below a roof, heights between the known ones, one at least. */
void skv_drawn_bridge(const skv_drawn_surface *surface);

/* The surface above a place: a line between the places of two columns, or beyond the last. */
void skv_drawn_look(const skv_drawn_surface *surface, float across, float *height, float *slope);

#endif
