/* What can be chosen, by name; and the scales: figures that suit the frame, colours that grow in
 * lightness and stay apart for eyes that lack a kind of cones. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "render/picture.h"

static const skv_view scaled[] = {SKV_VIEW_PRESSURE, SKV_VIEW_SPEED, SKV_VIEW_DENSITY,
                                  SKV_VIEW_PARTICLES};
enum { SCALED = sizeof scaled / sizeof *scaled };

static void every_choice_can_be_set_by_name(void **state)
{
    (void)state;
    for (int part = SKV_STYLE_VIEW; part <= SKV_STYLE_DETAIL; part++) {
        int count = 0;
        for (; skv_style_choice_at((skv_style_part)part, count); count++) {
            const skv_style_choice *choice = skv_style_choice_at((skv_style_part)part, count);
            skv_render_style style = skv_default_render_style();
            assert_int_equal(skv_render_style_set(&style, (skv_style_part)part, choice->name, NULL),
                             SKV_OK);
            const int now[] = {(int)style.view, (int)style.overlays, (int)style.palette,
                               (int)style.detail};
            assert_int_equal(now[part], choice->value);
            assert_true(*choice->label && *choice->help);
        }
        assert_true(count >= 3);
        assert_null(skv_style_choice_at((skv_style_part)part, -1));
    }
}

/* A style as a program has it that knows of the view alone: the rest is the default's. */
static void a_style_is_initialised(void **state)
{
    (void)state;
    skv_render_style known;
    memset(&known, 0xa5, sizeof known);
    skv_render_style_init(&known, offsetof(skv_render_style, view) + sizeof known.view);
    assert_int_equal(skv_render_style_set(&known, SKV_STYLE_VIEW, "density", NULL), SKV_OK);
    const skv_frame frame = {.gravity_y = -9.81f, .density = 1000};
    skv_render_style style = skv_default_render_style();
    style.view = SKV_VIEW_DENSITY;
    skv_legend legends[] = {skv_render_legend(&frame, &known), skv_render_legend(&frame, &style)};
    assert_true(legends[0].shown && legends[0].high == legends[1].high);
}

static void overlays_are_a_set(void **state)
{
    (void)state;
    skv_render_style style = skv_default_render_style();
    assert_int_equal(skv_render_style_set(&style, SKV_STYLE_OVERLAY, "grid,arrows", NULL), SKV_OK);
    assert_int_equal(style.overlays, SKV_OVERLAY_GRID | SKV_OVERLAY_ARROWS);
    const char *const wrong[] = {"grid,", "", "grid,,arrows", "grid, arrows", "none,grid"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(skv_render_style_set(&style, SKV_STYLE_OVERLAY, wrong[i], NULL),
                         SKV_ERROR_VALUE);
    assert_int_equal(style.overlays, SKV_OVERLAY_GRID | SKV_OVERLAY_ARROWS);
    assert_int_equal(skv_render_style_set(&style, SKV_STYLE_OVERLAY, "none", NULL), SKV_OK);
    assert_int_equal(style.overlays, 0);
}

static void unknown_names_are_refused_with_a_hint(void **state)
{
    (void)state;
    skv_render_style style = skv_default_render_style();
    skv_error error;
    assert_int_equal(skv_render_style_set(&style, SKV_STYLE_VIEW, "presure", &error),
                     SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "did you mean pressure?"));
    assert_int_equal(skv_render_style_set(&style, SKV_STYLE_PALETTE, "zzz", &error),
                     SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "dark, light, contrast"));
    assert_int_equal(style.view, SKV_VIEW_WATER);
}

/* Figures that divide well, and hold what the frame may show. */
static void scales_suit_the_frame(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 1000, 0);
    skv_frame frame = skv_world_frame(world);
    skv_render_style style = skv_default_render_style();
    assert_false(skv_render_legend(&frame, &style).shown);
    style.view = SKV_VIEW_PRESSURE;
    skv_legend legend = skv_render_legend(&frame, &style);
    assert_true(legend.shown && legend.low == 0);
    assert_string_equal(legend.unit, "Pa m");
    double depth = legend.high * legend.depth; /* the pool is 0.43 m deep */
    assert_true(fabs(depth - 0.8) < 1e-6);
    assert_true(fabs(remainder(legend.high, legend.step)) < 1e-6 * legend.high);
    style.range = 1234;
    assert_true(skv_render_legend(&frame, &style).high == 1234);
    style.view = SKV_VIEW_SPEED;
    style.range = 0;
    legend = skv_render_legend(&frame, &style);
    assert_string_equal(legend.unit, "m/s");
    assert_true(legend.high == 5);
    frame.gravity_x = frame.gravity_y = 0;
    style.view = SKV_VIEW_PRESSURE;
    legend = skv_render_legend(&frame, &style);
    assert_true(legend.high > 0 && legend.depth == 0);
    skv_world_destroy(world);
}

static skv_legend legend_of(skv_view view)
{
    skv_world *world = make_world("pool", 100, 0);
    skv_frame frame = skv_world_frame(world);
    skv_render_style style = skv_default_render_style();
    style.view = view;
    skv_legend legend = skv_render_legend(&frame, &style);
    skv_world_destroy(world);
    return legend;
}

static void scales_grow_in_lightness(void **state)
{
    (void)state;
    for (int v = 0; v < SCALED; v++) {
        skv_legend legend = legend_of(scaled[v]);
        double first = lightness(legend.colors[0]);
        double last = lightness(legend.colors[SKV_LEGEND_COLORS - 1]);
        assert_true(last - first > 40);
        double even = (last - first) / (SKV_LEGEND_COLORS - 1);
        for (int i = 1; i < SKV_LEGEND_COLORS; i++) {
            double step = lightness(legend.colors[i]) - lightness(legend.colors[i - 1]);
            assert_true(step > 0.2 * even && step < 2.5 * even);
        }
    }
}

/* Linear RGB as eyes without a kind of cones see it (Machado and others, 2009). */
static const double without_cones[2][3][3] = {{{0.152286, 1.052583, -0.204868},
                                               {0.114503, 0.786281, 0.099216},
                                               {-0.003882, -0.048116, 1.051998}},
                                              {{0.367322, 0.860646, -0.227968},
                                               {0.280085, 0.672501, 0.047413},
                                               {-0.011820, 0.042940, 0.968881}}};

static double linear(double byte)
{
    double c = byte / 255;
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

static double cube(double t)
{
    return t > 0.008856 ? cbrt(t) : 7.787 * t + 16.0 / 116;
}

/* CIE Lab of a colour seen through a matrix. */
static void seen(const uint8_t *rgb, const double matrix[3][3], double lab[3])
{
    double c[3];
    for (int k = 0; k < 3; k++) {
        c[k] = 0;
        for (int j = 0; j < 3; j++)
            c[k] += matrix[k][j] * linear(rgb[j]);
        c[k] = fmin(fmax(c[k], 0), 1);
    }
    double x = cube((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
    double y = cube(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
    double z = cube((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
    lab[0] = 116 * y - 16;
    lab[1] = 500 * (x - y);
    lab[2] = 200 * (y - z);
}

/* An eighth of a scale apart, colours differ by several times what can just be told apart. */
static void scales_are_safe_for_colour_blindness(void **state)
{
    (void)state;
    for (int v = 0; v < SCALED; v++)
        for (int kind = 0; kind < 2; kind++) {
            skv_legend legend = legend_of(scaled[v]);
            double least = 1e9;
            for (int i = 0; i + 8 < SKV_LEGEND_COLORS; i++) {
                double a[3], b[3];
                seen(legend.colors[i], without_cones[kind], a);
                seen(legend.colors[i + 8], without_cones[kind], b);
                least = fmin(least,
                             sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2)));
            }
            printf("%s, %s: an eighth apart, colours differ by %.1f at least\n", legend.label,
                   kind ? "deuteranopia" : "protanopia", least);
            assert_true(least > 4);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_choice_can_be_set_by_name),
        cmocka_unit_test(a_style_is_initialised),
        cmocka_unit_test(overlays_are_a_set),
        cmocka_unit_test(unknown_names_are_refused_with_a_hint),
        cmocka_unit_test(scales_suit_the_frame),
        cmocka_unit_test(scales_grow_in_lightness),
        cmocka_unit_test(scales_are_safe_for_colour_blindness),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
