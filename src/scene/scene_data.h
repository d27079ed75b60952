/* A loaded scene. Immutable: worlds are built from it as often as wanted. */
#ifndef SKV_SCENE_DATA_H
#define SKV_SCENE_DATA_H

#include "scene/draft.h"
#include "scene/paint.h"
#include "scene/water.h"

#define SKV_MAX_NOTICES 8
#define SKV_MAX_FILES   2 /* a scene and its picture */

typedef struct skv_scene_body {
    char name[SKV_BODY_NAME_SIZE];
    skv_body_def def;
    float angle; /* about its pin, or else its own middle */
} skv_scene_body;

struct skv_scene {
    char *name, *title, *description; /* never null */
    double seconds;
    int width, height; /* pixels */
    double pixel_size; /* m */
    unsigned open_sides;
    skv_terrain *terrain;
    uint8_t *coverage;          /* width * height, row 0 at the bottom; until the terrain is made */
    uint8_t *paint;             /* likewise, skv_paint; null if no picture was painted */
    int64_t marked[SKV_PAINTS]; /* pixels of each skv_paint */
    int oil;                    /* number of the fluid of yellow pixels, if there are any */
    skv_shape *solids;
    int solid_count;
    skv_water water;
    skv_force forces[SKV_MAX_FORCES];
    int force_count;
    skv_emitter emitters[SKV_MAX_EMITTERS];
    int emitter_count;
    skv_drain drains[SKV_MAX_DRAINS];
    int drain_count;
    skv_scene_body *bodies;
    int body_count;
    float air;                  /* pressure, Pa m; 0: none */
    double *points;             /* of all shapes */
    skv_world_def def;          /* of its worlds, but for terrain, threads and capacity */
    int particles;              /* at the start */
    int amount;                 /* skv_scene_amount */
    bool settle;                /* its worlds */
    char *files[SKV_MAX_FILES]; /* it was read from */
    char *notices[SKV_MAX_NOTICES];
    uint8_t *recipe; /* recipe.h; null: none */
    size_t recipe_size;
};

/* Whether a picture has pixels of fluid. */
static inline bool skv_scene_is_painted(const skv_scene *scene)
{
    return scene->marked[SKV_PAINT_FLUID] + scene->marked[SKV_PAINT_OIL] > 0;
}

/* Makes the scene that a draft's values describe, over a picture (null: none), whose pixels it
 * frees when they have served. On failure `*scene` is null. */
skv_result skv_scene_build(const skv_draft *draft, skv_image *picture, const char *picture_label,
                           skv_scene **scene, skv_error *error);

/* Makes what acts on the fluid in a scene of a given size, from a draft's values; and sets it in a
 * world. */
skv_result skv_scene_build_acting(const skv_draft *draft, skv_scene *scene, skv_error *error);
skv_result skv_scene_set_acting(const skv_scene *scene, skv_world *world, skv_error *error);

/* Says something without failing; cut to fit. */
void skv_scene_note(skv_scene *scene, const char *format, ...) SKV_PRINTF(2, 3);

#endif
