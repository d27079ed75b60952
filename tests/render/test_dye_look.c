/* Dye as it looks: colours that every eye tells apart and that stand out against walls, in views of
 * water alone, and mixed where fluids meet. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "render/eyes.h"
#include "render/look.h"
#include "render/picture.h"

static void every_eye_tells_colours_apart(void **state)
{
    (void)state;
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        const skv_colors *colors = skv_look_colors((skv_palette)palette);
        float all[SKV_DYES + 1][3];
        memcpy(all + 1, colors->dyes, sizeof colors->dyes);
        for (int k = 0; k < 3; k++)
            all[0][k] = sqrtf(colors->shallow[k] * colors->deep[k]);
        for (int eye = 0; eye < EYES; eye++)
            for (int i = 0; i <= SKV_DYES; i++)
                for (int j = 0; j < i; j++)
                    if (colors_apart(eye, all[i], all[j]) < 0.07)
                        fail_msg("palette %d, eye %d: %s and %s are %g apart", palette, eye,
                                 skv_dye_name(i), skv_dye_name(j),
                                 colors_apart(eye, all[i], all[j]));
    }
}

/* Amber that is dark enough to stand out against light walls turns to mud if it stays yellow: it is
 * warm in every palette, and pure. */
static void amber_is_no_mud(void **state)
{
    (void)state;
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        double lab[3];
        color_seen_by(0, skv_look_colors((skv_palette)palette)->dyes[1], lab);
        double purity = sqrt(lab[1] * lab[1] + lab[2] * lab[2]);
        double hue = atan2(lab[2], lab[1]) * 57.29577951308232;
        if (purity < 0.12 || hue < 55 || hue > 85)
            fail_msg("palette %d: amber has the purity %.3f and the hue %.0f", palette, purity,
                     hue);
    }
}

/* ---- Pictures -------------------------------------------------------------------------------- */

enum { WIDTH = 640, HEIGHT = 360 };

/* Walls all around 0.4 m of water, the left half of one colour and the right half of another. */
static skv_world *make_basin(int left, int right)
{
    char text[400];
    const char *form =
        "{\"particles\": 2000, \"solid\": [{\"shape\": \"box\", \"x1\": 0.2}, {\"shape\": "
        "\"box\", \"x0\": 1.4}], \"water\": [{\"shape\": \"box\", \"x1\": 0.8, \"y1\": "
        "0.5, \"dye\": \"%s\"}, {\"shape\": \"box\", \"x0\": 0.8, \"y1\": 0.5, \"dye\": "
        "\"%s\"}]}";
    skv_format(text, sizeof text, form, skv_dye_name(left), skv_dye_name(right));
    skv_scene *scene;
    skv_world *world;
    assert_int_equal(skv_scene_load_memory(text, strlen(text), "json", "basin", NULL, &scene, NULL),
                     SKV_OK);
    assert_int_equal(skv_scene_create_world(scene, 1, &world, NULL), SKV_OK);
    skv_scene_destroy(scene);
    return world;
}

/* From just below the surface to the floor: the colour that was asked for, and a contrast of 3:1
 * with walls and air. In the view of water with and without light, and in that of fluid. */
static void colours_show_and_stand_out(void **state)
{
    (void)state;
    const struct {
        skv_view view;
        skv_detail detail;
    } ways[] = {{SKV_VIEW_WATER, SKV_DETAIL_FULL},
                {SKV_VIEW_WATER, SKV_DETAIL_PLAIN},
                {SKV_VIEW_FLUID, SKV_DETAIL_FULL}};
    for (int dye = 1; dye <= SKV_DYES; dye++) {
        skv_world *world = make_basin(dye, dye);
        for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
            const skv_colors *colors = skv_look_colors((skv_palette)palette);
            for (int w = 0; w < (dye == 1 ? 3 : 1); w++) {
                skv_render_style style =
                    style_of((skv_palette)palette, ways[w].view, ways[w].detail);
                picture p = shoot(world, &style, WIDTH, HEIGHT);
                double wall = luminance(at_place(&p, 0.1, 0.3)),
                       air = luminance(at_place(&p, 0.8, 0.8));
                for (double y = 0.02; y < 0.46; y += 0.04) {
                    const uint8_t *drawn = at_place(&p, 0.7, y);
                    float color[3];
                    to_float(drawn, color);
                    for (int other = 1; other <= SKV_DYES; other++)
                        assert_true(colors_apart(0, color, colors->dyes[dye - 1]) <=
                                    colors_apart(0, color, colors->dyes[other - 1]));
                    if (contrast(luminance(drawn), wall) < 3 || contrast(luminance(drawn), air) < 3)
                        fail_msg("%s, palette %d: contrast %.2f with walls, %.2f with air",
                                 skv_dye_name(dye), palette, contrast(luminance(drawn), wall),
                                 contrast(luminance(drawn), air));
                }
                free(p.rgb);
            }
        }
        skv_world_destroy(world);
    }
}

/* Where two meet, colours go over into each other without a step, and multiply: amber and blue make
 * green. Away from there each is by itself. */
static void colours_mix_at_borders(void **state)
{
    (void)state;
    skv_world *world = make_basin(2, 0);
    skv_render_style style = style_of(SKV_PALETTE_DARK, SKV_VIEW_WATER, SKV_DETAIL_FULL);
    picture p = shoot(world, &style, WIDTH, HEIGHT);
    double s = (double)skv_world_spacing(world);
    const uint8_t *amber = at_place(&p, 0.8 - 6 * s, 0.2), *clear = at_place(&p, 0.8 + 6 * s, 0.2);
    const uint8_t *mixed = at_place(&p, 0.8, 0.2);
    assert_true(amber[0] > 2 * amber[2] && clear[2] > 2 * clear[0]);
    assert_true(mixed[1] > mixed[0] && mixed[1] > mixed[2]);
    int last = -1, steps = 0;
    for (double x = 0.8 - 6 * s; x < 0.8 + 6 * s; x += 1.6 / WIDTH) {
        int blue = at_place(&p, x, 0.2)[2];
        assert_true(last < 0 || blue > last - 12);
        steps += last >= 0 && blue > last + 2;
        last = blue;
    }
    assert_true(steps > 8);
    free(p.rgb);
    skv_world_destroy(world);
}

/* A colour changes nothing where values are shown, nor where there is none. */
static void values_know_no_dye(void **state)
{
    (void)state;
    skv_world *dyed = make_basin(1, 3), *clear = make_basin(0, 0);
    const skv_view views[] = {SKV_VIEW_PRESSURE, SKV_VIEW_SPEED, SKV_VIEW_DENSITY,
                              SKV_VIEW_PARTICLES, SKV_VIEW_WATER};
    for (int v = 0; v < 5; v++) {
        skv_render_style style = style_of(SKV_PALETTE_DARK, views[v], SKV_DETAIL_FULL);
        picture a = shoot(dyed, &style, WIDTH, HEIGHT), b = shoot(clear, &style, WIDTH, HEIGHT);
        assert_true((largest_difference(&a, &b) > 0) == (views[v] == SKV_VIEW_WATER));
        free(a.rgb);
        free(b.rgb);
    }
    skv_world_destroy(dyed);
    skv_world_destroy(clear);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_eye_tells_colours_apart),
        cmocka_unit_test(amber_is_no_mud),
        cmocka_unit_test(colours_show_and_stand_out),
        cmocka_unit_test(colours_mix_at_borders),
        cmocka_unit_test(values_know_no_dye),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
