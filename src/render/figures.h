/* Figures: numbers and units of the metric kind as strokes, for pictures that leave the house
 * without a toolkit to set text. */
#ifndef SKV_RENDER_FIGURES_H
#define SKV_RENDER_FIGURES_H

#include "render/strokes.h"

/* How many strokes a text takes, and how wide it is at this height of its digits. Characters that
 * are not known count as spaces. */
int skv_figures_count(const char *text);
float skv_figures_width(const char *text, float height);

/* Adds a text from (x, y) on, its lower left corner in view pixels; room is the caller's. */
void skv_figures_add(skv_strokes *strokes, const char *text, float x, float y, float height,
                     const uint8_t color[4]);

#endif
