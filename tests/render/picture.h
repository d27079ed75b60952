/* Pictures for tests: made of built-in scenes, and what can be counted and measured on them. */
#ifndef TESTS_RENDER_PICTURE_H
#define TESTS_RENDER_PICTURE_H

#include <skvalp/render.h>
#include <skvalp/scene.h>

typedef struct picture {
    int width, height;
    uint8_t *rgb; /* top row first; free it */
} picture;

/* A built-in scene after so many frames. */
skv_world *make_world(const char *scene, int particles, int frames);

/* A picture of it in an offscreen. */
picture shoot(const skv_world *world, const skv_render_style *style, int width, int height);
picture shoot_frame(const skv_frame *frame, const skv_render_style *style, int width, int height);

const uint8_t *at(const picture *p, int x, int y);
/* At a place in metres of a world of 1.6 x 0.9 m that fills the picture. */
const uint8_t *at_place(const picture *p, double x, double y);

/* The default style with these. */
skv_render_style style_of(skv_palette palette, skv_view view, skv_detail detail);

/* A pixel's colour, 0..1. */
void to_float(const uint8_t *rgb, float color[3]);

/* In the dark palette: water, air, wall; and what is white. */
bool is_fluid(const uint8_t *c);
bool is_dark(const uint8_t *c);
bool is_wall(const uint8_t *c);
bool is_white(const uint8_t *c);

/* The share of pixels in a rectangle that pass a test. */
double share(const picture *p, bool test(const uint8_t *), int x0, int y0, int x1, int y1);

int largest_difference(const picture *a, const picture *b);

/* Luminance as seen, 0..1, and the contrast of two of them, 1..21 (WCAG 2). */
double luminance(const uint8_t *rgb);
double contrast(double a, double b);
/* CIE L*, 0..100. */
double lightness(const uint8_t *rgb);

/* The median of values, which are sorted. */
double median(double *values, int count);

#endif
