/* Compose: pass two of the thesis' rendering. */
#ifndef SKV_RENDER_COMPOSE_H
#define SKV_RENDER_COMPOSE_H

#include "render/look.h"
#include "render/splats.h"
#include "render/walls.h"

/* What the shader shows. */
typedef enum skv_shown {
    SKV_SHOWN_NO_FLUID,
    SKV_SHOWN_WATER,  /* by its depth */
    SKV_SHOWN_TINTED, /* with dyes */
    SKV_SHOWN_PARTED, /* several fluids */
    SKV_SHOWN_PARTED_TINTED,
    SKV_SHOWN_VALUE, /* on a scale */
    SKV_SHOWN_KINDS
} skv_shown;

typedef struct skv_compose {
    GLuint programs[SKV_SHOWN_KINDS][2]; /* plain, full; 0: not needed yet */
    GLuint attributes;
    GLuint scale; /* texture of a view's colours */
} skv_compose;

skv_result skv_compose_create(skv_compose *compose, skv_error *error);
void skv_compose_destroy(skv_compose *compose);

/* What pass two needs to know of a picture. */
typedef struct skv_composition {
    const skv_frame *frame;
    const skv_camera *camera;
    skv_view view;
    const skv_colors *colors;
    const skv_legend *legend;
    const double *slope; /* of the values, as in skv_vertices */
    bool full;
} skv_composition;

/* Draws background, fluid and walls into the framebuffer that is bound, over the whole view. */
skv_result skv_compose_draw(skv_compose *compose, const skv_splats *splats, const skv_walls *walls,
                            const skv_composition *picture, skv_error *error);

#endif
