/* From green and red areas of a painted world to emitters and drains. */
#ifndef SKV_SCENE_TAPS_H
#define SKV_SCENE_TAPS_H

#include "scene/scene_data.h"

/* An area of one paint. */
typedef struct skv_tap_area {
    int64_t count;       /* pixels */
    double x, y;         /* sums of their centres, pixels */
    double xx, yy, xy;   /* ... and of the products */
    int lowest, highest; /* rows */
    int place;           /* of its first pixel in the paint */
} skv_tap_area;

/* Green areas, from the bottom up. */
typedef struct skv_taps {
    skv_tap_area green[SKV_MAX_EMITTERS];
    int count;
} skv_taps;

/* Finds the areas of a scaled scene's paint, and adds the red ones to its drains; no terrain is
 * needed yet. Fails with SKV_ERROR_MEMORY, or SKV_ERROR_LIMIT for more areas than a world takes. */
skv_result skv_scene_find_taps(skv_scene *scene, const char *label, skv_taps *taps,
                               skv_error *error);

/* Adds the green ones to its emitters; SKV_ERROR_VALUE for one that is too wide. */
skv_result skv_scene_add_emitters(skv_scene *scene, const skv_taps *taps, const char *label,
                                  skv_error *error);

#endif
