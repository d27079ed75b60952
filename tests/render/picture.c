/* Pictures for tests. */
#include "render/picture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

skv_world *make_world(const char *scene, int particles, int frames)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_scene *loaded;
    skv_world *world;
    assert_int_equal(skv_scene_load(scene, &options, &loaded, NULL), SKV_OK);
    assert_int_equal(skv_scene_create_world(loaded, 1, &world, NULL), SKV_OK);
    skv_scene_destroy(loaded);
    for (int i = 0; i < frames; i++)
        assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
    return world;
}

/* One offscreen serves all pictures of a size that follow each other: to make it, with its shaders,
 * takes longer than to draw. */
static skv_offscreen *offscreen_of(int width, int height)
{
    static skv_offscreen *kept;
    static int of_width, of_height;
    skv_error error;
    if (kept && of_width == width && of_height == height)
        return kept;
    skv_offscreen_destroy(kept);
    if (skv_offscreen_create(width, height, &kept, &error) != SKV_OK)
        fail_msg("%s", error.text);
    of_width = width;
    of_height = height;
    return kept;
}

picture shoot_frame(const skv_frame *frame, const skv_render_style *style, int width, int height)
{
    picture made = {width, height, malloc((size_t)width * (size_t)height * 3)};
    skv_error error;
    if (skv_offscreen_render(offscreen_of(width, height), frame, style, made.rgb, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return made;
}

picture shoot(const skv_world *world, const skv_render_style *style, int width, int height)
{
    skv_frame frame = skv_world_frame(world);
    return shoot_frame(&frame, style, width, height);
}

const uint8_t *at(const picture *p, int x, int y)
{
    return p->rgb + ((size_t)y * (size_t)p->width + (size_t)x) * 3;
}

const uint8_t *at_place(const picture *p, double x, double y)
{
    return at(p, (int)(x * p->width / 1.6), (int)((0.9 - y) * p->height / 0.9));
}

skv_render_style style_of(skv_palette palette, skv_view view, skv_detail detail)
{
    skv_render_style style = skv_default_render_style();
    style.palette = palette;
    style.view = view;
    style.detail = detail;
    return style;
}

void to_float(const uint8_t *rgb, float color[3])
{
    for (int k = 0; k < 3; k++)
        color[k] = (float)rgb[k] / 255;
}

bool is_fluid(const uint8_t *c)
{
    return c[2] > 150 && c[2] > c[0] + 60;
}

bool is_dark(const uint8_t *c)
{
    return c[0] < 26 && c[1] < 36 && c[2] < 52;
}

bool is_wall(const uint8_t *c)
{
    return c[0] > 26 && c[0] < 50 && c[1] > c[0] && c[1] < c[0] + 16 && c[2] < c[0] + 30;
}

bool is_white(const uint8_t *c)
{
    return c[0] > 230 && c[1] > 230 && c[2] > 230;
}

double share(const picture *p, bool test(const uint8_t *), int x0, int y0, int x1, int y1)
{
    int count = 0;
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++)
            count += test(at(p, x, y));
    return (double)count / ((double)(x1 - x0) * (y1 - y0));
}

int largest_difference(const picture *a, const picture *b)
{
    int largest = 0;
    for (int i = 0; i < a->width * a->height * 3; i++)
        largest = abs(a->rgb[i] - b->rgb[i]) > largest ? abs(a->rgb[i] - b->rgb[i]) : largest;
    return largest;
}

static double linear(uint8_t byte)
{
    double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const uint8_t *rgb)
{
    return 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
}

double contrast(double a, double b)
{
    return (fmax(a, b) + 0.05) / (fmin(a, b) + 0.05);
}

double lightness(const uint8_t *rgb)
{
    double y = luminance(rgb);
    return y > 0.008856 ? 116 * cbrt(y) - 16 : 903.3 * y;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double median(double *values, int count)
{
    assert_true(count > 0);
    qsort(values, (size_t)count, sizeof *values, compare);
    return values[count / 2];
}
