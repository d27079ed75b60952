/* Walls: the terrain's distances as a texture, uploaded when the terrain has changed. */
#ifndef SKV_RENDER_WALLS_H
#define SKV_RENDER_WALLS_H

#include "render/gl.h"
#include "skvalp/terrain.h"

typedef struct skv_walls {
    GLuint texture;
    skv_terrain *shown;    /* what the texture shows, shared; null: nothing yet */
    uint64_t version;      /* another number for each terrain that is shown; 0: none yet */
    double free_area;      /* m^2 */
    float lowest, highest; /* m, of the free region */
} skv_walls;

void skv_walls_create(skv_walls *walls);
void skv_walls_destroy(skv_walls *walls);

/* Brings the texture up to date. */
skv_result skv_walls_update(skv_walls *walls, const skv_terrain *terrain, skv_error *error);

#endif
