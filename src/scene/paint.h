/* The colours of a painted world: what each pixel of a picture means. */
#ifndef SKV_SCENE_PAINT_H
#define SKV_SCENE_PAINT_H

#include "scene/image.h"
#include "skvalp/base.h"

/* What a pixel is, beside being solid to some degree. */
typedef enum skv_paint {
    SKV_PAINT_NONE, /* black to white */
    SKV_PAINT_FLUID,
    SKV_PAINT_EMITTER,
    SKV_PAINT_DRAIN,
    SKV_PAINT_OIL,  /* fluid, but another one */
    SKV_PAINT_BODY, /* of wood */
    SKV_PAINTS
} skv_paint;

/* A picture read as a world: row 0 at the BOTTOM, width * height bytes each. */
typedef struct skv_painting {
    int width, height;
    uint8_t *coverage;         /* 0 = air, 255 = solid */
    uint8_t *paint;            /* skv_paint */
    int64_t count[SKV_PAINTS]; /* pixels of each skv_paint */
} skv_painting;

/* Reads a picture's colours. Fails with SKV_ERROR_VALUE and the pixel, counted from the top left,
 * for a colour that means nothing. */
skv_result skv_paint_read(const skv_image *image, const char *label, skv_painting *painting,
                          skv_error *error);
void skv_painting_free(skv_painting *painting);

#endif
