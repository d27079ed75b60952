/* Bodies as they look: filled, with an outline, in every palette, where the body is and nowhere
 * else; and fluid beside them is as dark as its depth below the surface makes it.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "render/body_look.h"
#include "render/eyes.h"
#include "render/look.h"
#include "render/picture.h"
#include "skvalp/bodies.h"

enum { WIDTH = 640, HEIGHT = 360 };

/* Whether a pixel has a colour, 0..1, but for rounding. */
static bool is_color(const uint8_t *pixel, const float *color)
{
    float seen[3];
    to_float(pixel, seen);
    for (int k = 0; k < 3; k++)
        if (fabsf(seen[k] - color[k]) > 0.02f)
            return false;
    return true;
}

static void bodies_are_seen_where_they_are(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 800, 1);
    skv_body_def def = skv_default_body_def();
    const float corners[] = {0, 0, 0.2f, 0, 0.2f, 0.2f, 0.1f, 0.05f, 0, 0.2f}; /* with a notch */
    def.shape = skv_polygon(corners, 5);
    def.x = 0.4f;
    def.y = 0.6f;
    assert_int_equal(skv_world_add_body(world, &def, NULL, NULL, NULL), SKV_OK);
    def.shape = skv_circle(0, 0, 0.1f);
    def.x = 1.2f;
    def.y = 0.3f;
    def.pinned = true;
    def.pin_x = 1.16f;
    def.pin_y = 0.33f;
    assert_int_equal(skv_world_add_body(world, &def, NULL, NULL, NULL), SKV_OK);
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        const skv_body_look *look = skv_look_body((skv_palette)palette, def.density);
        skv_render_style style = style_of((skv_palette)palette, SKV_VIEW_WATER, SKV_DETAIL_FULL);
        picture p = shoot(world, &style, WIDTH, HEIGHT);
        assert_true(is_color(at_place(&p, 0.42, 0.7), look->inside));
        assert_true(is_color(at_place(&p, 0.58, 0.7), look->inside));
        assert_true(is_color(at_place(&p, 0.5, 0.62), look->inside));
        assert_false(is_color(at_place(&p, 0.5, 0.72), look->inside));
        assert_false(is_color(at_place(&p, 0.38, 0.7), look->inside));
        assert_true(is_color(at_place(&p, 1.2, 0.3), look->inside));
        assert_true(is_color(at_place(&p, 1.27, 0.36), look->inside));
        assert_true(is_color(at_place(&p, 1.16, 0.33), look->edge)); /* its pin */
        assert_false(is_color(at_place(&p, 1.28, 0.38), look->inside));
        bool edged = false;
        for (int mm = 1080; mm < 1120; mm++)
            edged |= is_color(at_place(&p, mm / 1000.0, 0.3), look->edge);
        assert_true(edged);
        free(p.rgb);
    }
    skv_world_destroy(world);
}

/* Cork, wood, ice, brick and steel, and what is about as heavy. In every palette every eye tells
 * them apart, and all but their edges from water; the edges part them from it. */
static void materials_have_their_colours(void **state)
{
    (void)state;
    const float densities[] = {240, 500, 917, 1900, 7850}, alike[] = {100, 700, 917, 2400, 11340};
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        const skv_colors *colors = skv_look_colors((skv_palette)palette);
        const skv_body_look *looks[5];
        for (int i = 0; i < 5; i++) {
            looks[i] = skv_look_body((skv_palette)palette, densities[i]);
            assert_ptr_equal(looks[i], skv_look_body((skv_palette)palette, alike[i]));
            for (int eye = 0; eye < EYES; eye++) {
                for (int j = 0; j < i; j++)
                    if (colors_apart(eye, looks[i]->inside, looks[j]->inside) < 0.08)
                        fail_msg("palette %d, eye %d: %d and %d are %g apart", palette, eye, i, j,
                                 colors_apart(eye, looks[i]->inside, looks[j]->inside));
                if (colors_apart(eye, looks[i]->inside, colors->shallow) < 0.1 ||
                    colors_apart(eye, looks[i]->inside, colors->deep) < 0.1 ||
                    colors_apart(eye, looks[i]->edge, looks[i]->inside) < 0.2)
                    fail_msg("palette %d, eye %d: %d is like water, or its edge is like it",
                             palette, eye, i);
            }
        }
    }
}

/* The greatest difference of what lies about a box on the floor from how it looks without the box.
 */
static float lighter_by(const picture *alone, const picture *with)
{
    const double places[][2] = {{0.68, 0.02}, {0.68, 0.08}, {0.8, 0.12}, {0.92, 0.05}};
    float most = 0;
    for (int i = 0; i < 4; i++) {
        float before[3], after[3];
        to_float(at_place(alone, places[i][0], places[i][1]), before);
        to_float(at_place(with, places[i][0], places[i][1]), after);
        for (int k = 0; k < 3; k++)
            most = fmaxf(most, fabsf(after[k] - before[k]));
    }
    return most;
}

static void bodies_are_no_air_to_the_fluid_beside_them(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 2000, 1);
    skv_render_style style = style_of(SKV_PALETTE_DARK, SKV_VIEW_WATER, SKV_DETAIL_FULL);
    picture alone = shoot(world, &style, WIDTH, HEIGHT);
    skv_body_def def = skv_default_body_def();
    def.shape = skv_box(0.7f, 0, 0.9f, 0.1f);
    def.fixed = true;
    assert_int_equal(skv_world_add_body(world, &def, NULL, NULL, NULL), SKV_OK);
    picture with = shoot(world, &style, WIDTH, HEIGHT);
    print_message("beside a body water is lighter by %.3f\n", (double)lighter_by(&alone, &with));
    assert_true(lighter_by(&alone, &with) < 0.04f);
    free(alone.rgb);
    free(with.rgb);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_are_seen_where_they_are),
        cmocka_unit_test(materials_have_their_colours),
        cmocka_unit_test(bodies_are_no_air_to_the_fluid_beside_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
