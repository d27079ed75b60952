/* Bodies as they look: filled, with an outline, in every palette, where the body is and nowhere
 * else.
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
    assert_int_equal(skv_world_add_body(world, &def, NULL, NULL, NULL), SKV_OK);
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        const skv_colors *colors = skv_look_colors((skv_palette)palette);
        skv_render_style style = style_of((skv_palette)palette, SKV_VIEW_WATER, SKV_DETAIL_FULL);
        picture p = shoot(world, &style, WIDTH, HEIGHT);
        assert_true(is_color(at_place(&p, 0.42, 0.7), colors->body));
        assert_true(is_color(at_place(&p, 0.58, 0.7), colors->body));
        assert_true(is_color(at_place(&p, 0.5, 0.62), colors->body));
        assert_false(is_color(at_place(&p, 0.5, 0.72), colors->body));
        assert_false(is_color(at_place(&p, 0.38, 0.7), colors->body));
        assert_true(is_color(at_place(&p, 1.2, 0.3), colors->body));
        assert_true(is_color(at_place(&p, 1.27, 0.36), colors->body));
        assert_false(is_color(at_place(&p, 1.28, 0.38), colors->body));
        bool edged = false;
        for (double x = 1.08; x < 1.12; x += 0.001)
            edged |= is_color(at_place(&p, x, 0.3), colors->body_edge);
        assert_true(edged);
        free(p.rgb);
    }
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bodies_are_seen_where_they_are)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
