/* Strokes: what is drawn over the fluid, lines with round ends, dots and rings in any number. They
 * are gathered in the order in which they shall cover each other and drawn in one call. */
#ifndef SKV_RENDER_STROKES_H
#define SKV_RENDER_STROKES_H

#include "render/gl.h"

/* In view pixels, y up. A dot is a line from a point to the same point. */
typedef struct skv_stroke {
    float x0, y0, x1, y1;
    float radius;     /* of a dot or a ring; half the width of a line */
    float ring;       /* width of a ring's line; 0: filled */
    float dash;       /* length of a dash and of the gap after it; 0: unbroken */
    uint8_t color[4]; /* RGBA */
} skv_stroke;

typedef struct skv_strokes {
    GLuint program, attributes, buffer;
    int count, capacity;
    skv_stroke *list;
} skv_strokes;

skv_result skv_strokes_create(skv_strokes *strokes, skv_error *error);
void skv_strokes_destroy(skv_strokes *strokes);

/* Makes room for `count` more; SKV_ERROR_MEMORY. */
skv_result skv_strokes_reserve(skv_strokes *strokes, int count, skv_error *error);

/* Adds one, for which there has to be room. */
void skv_strokes_add(skv_strokes *strokes, skv_stroke stroke);

/* Draws them into the framebuffer that is bound, of this size, and forgets them. */
void skv_strokes_draw(skv_strokes *strokes, int width, int height);

#endif
