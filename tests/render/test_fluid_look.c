/* Fluids as they look: each in its colour, which every eye tells from the others and from water and
 * which stands out against walls; or in the colour that a scene gives it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "render/eyes.h"
#include "render/look.h"
#include "render/picture.h"
#include "skvalp/acting.h"

enum { WIDTH = 640, HEIGHT = 360 };

static void every_eye_tells_fluids_apart(void **state)
{
    (void)state;
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        const skv_colors *colors = skv_look_colors((skv_palette)palette);
        float all[SKV_MAX_FLUIDS][3];
        memcpy(all + 1, colors->fluids, sizeof colors->fluids);
        for (int k = 0; k < 3; k++)
            all[0][k] = sqrtf(colors->shallow[k] * colors->deep[k]);
        for (int eye = 0; eye < EYES; eye++)
            for (int i = 0; i < SKV_MAX_FLUIDS; i++)
                for (int j = 0; j < i; j++)
                    if (colors_apart(eye, all[i], all[j]) < 0.06)
                        fail_msg("palette %d, eye %d: %d and %d are %g apart", palette, eye, i, j,
                                 colors_apart(eye, all[i], all[j]));
    }
}

static skv_liquid made_of(const char *name)
{
    skv_liquid liquid = skv_default_liquid();
    const skv_material *material;
    for (int i = 0; (material = skv_material_info(i)); i++)
        if (strcmp(material->name, name) == 0) {
            liquid.density = material->density;
            liquid.viscosity = material->viscosity;
        }
    return liquid;
}

/* Wherever they stand in the list: oil is yellow, honey orange, mercury grey. No two are alike, and
 * a scene's own colour goes first. */
static void materials_have_their_colours(void **state)
{
    (void)state;
    skv_liquid fluids[SKV_MAX_FLUIDS] = {made_of("water"), made_of("mercury"), made_of("honey"),
                                         made_of("water"), made_of("oil"),     made_of("oil"),
                                         made_of("water"), made_of("mercury")};
    skv_frame frame = {.fluids = fluids, .fluid_count = SKV_MAX_FLUIDS};
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        int colors[SKV_MAX_FLUIDS];
        double lab[3][3];
        for (int i = 0; i < SKV_MAX_FLUIDS; i++) {
            colors[i] = skv_render_fluid_color(&frame, (skv_palette)palette, i);
            for (int j = 0; j < i; j++)
                assert_int_not_equal(colors[i], colors[j]);
        }
        for (int i = 0; i < 3; i++) {
            int code = colors[(int[]){1, 2, 4}[i]];
            float color[3] = {(float)(code >> 16) / 255, (float)(code >> 8 & 255) / 255,
                              (float)(code & 255) / 255};
            color_seen_by(0, color, lab[i]);
        }
        double hues[3], purities[3];
        for (int i = 0; i < 3; i++) {
            hues[i] = atan2(lab[i][2], lab[i][1]) * 57.29577951308232;
            purities[i] = hypot(lab[i][1], lab[i][2]);
        }
        if (purities[0] > 0.03 || hues[1] < 45 || hues[1] > 75 || hues[2] < hues[1] + 5)
            fail_msg("palette %d: mercury's purity %.3f, honey's hue %.0f, oil's %.0f", palette,
                     purities[0], hues[1], hues[2]);
        fluids[1].color = 0x123456;
        assert_int_equal(skv_render_fluid_color(&frame, (skv_palette)palette, 1), 0x123456);
        fluids[1].color = -1;
    }
}

/* So it is with the first fluid, and what is like it has another colour; in water's place water
 * stays.
 */
static void the_first_fluid_has_its_materials_colour(void **state)
{
    (void)state;
    static const char *const names[] = {"oil", "honey", "mercury"};
    for (int i = 0; i < 3; i++) {
        skv_liquid fluids[3] = {made_of(names[i]), made_of("water"), made_of(names[i])};
        skv_liquid beside[2] = {made_of("water"), made_of(names[i])};
        skv_frame frame = {.fluids = fluids, .fluid_count = 3};
        skv_frame of_water = {.fluids = beside, .fluid_count = 2}, nothing = {.fluid_count = 0};
        for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
            int color = skv_render_fluid_color(&frame, (skv_palette)palette, 0);
            int water = skv_render_fluid_color(&of_water, (skv_palette)palette, 0);
            assert_int_equal(color, skv_render_fluid_color(&of_water, (skv_palette)palette, 1));
            assert_int_equal(water, skv_render_fluid_color(&nothing, (skv_palette)palette, 0));
            for (int other = 1; other < 3; other++)
                assert_int_not_equal(color,
                                     skv_render_fluid_color(&frame, (skv_palette)palette, other));
        }
    }
}

/* It is drawn as well: halfway down in its colour, darker below and lighter above. */
static void a_first_fluid_shows_its_colour(void **state)
{
    (void)state;
    static const char text[] = "{\"particles\": 1500, \"fluid\": {\"material\": \"honey\"}, "
                               "\"water\": [{\"shape\": \"box\", \"y1\": 0.6}]}";
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error;
    if (skv_scene_load_memory(text, strlen(text), "json", "honey", NULL, &scene, &error) ||
        skv_scene_create_world(scene, 1, &world, &error))
        fail_msg("%s", error.text);
    skv_scene_destroy(scene);
    skv_frame frame = skv_world_frame(world);
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        const skv_colors *colors = skv_look_colors((skv_palette)palette);
        skv_detail detail = palette == SKV_PALETTE_LIGHT ? SKV_DETAIL_PLAIN : SKV_DETAIL_FULL;
        skv_render_style style = style_of((skv_palette)palette, SKV_VIEW_WATER, detail);
        picture p = shoot(world, &style, WIDTH, HEIGHT);
        float honey[3], drawn[3];
        skv_look_fluid(colors, &frame, 0, honey);
        for (double y = 0.04; y < 0.56; y += 0.04) {
            to_float(at_place(&p, 0.7, y), drawn);
            for (int k = 0; k < 3; k++)
                assert_true(fabsf(drawn[k] - honey[k]) <=
                            0.16f * colors->relief * honey[k] + 0.02f);
        }
        double low = luminance(at_place(&p, 0.7, 0.04)), high = luminance(at_place(&p, 0.7, 0.54));
        assert_true(colors->relief > 0 ? high > 1.1 * low : high == low);
        free(p.rgb);
    }
    skv_world_destroy(world);
}

/* Walls around 0.4 m of one of seven fluids, and a drop of water dyed rose. */
static skv_world *make_basin(int fluid, const char *color)
{
    char text[1000] = "{\"particles\": 1500, \"settle\": false, \"solid\": [{\"shape\": \"box\", "
                      "\"x1\": 0.2}, {\"shape\": \"box\", \"x0\": 1.4}], \"fluids\": [",
         one[300];
    for (int i = 1; i < SKV_MAX_FLUIDS; i++) {
        snprintf(one, sizeof one, "%s{\"name\": \"%d\"%s}", i > 1 ? ", " : "", i,
                 i == fluid ? color : "");
        strcat(text, one);
    }
    snprintf(one, sizeof one,
             "], \"water\": [{\"shape\": \"box\", \"y1\": 0.5, \"fluid\": \"%d\"}, {\"shape\": "
             "\"circle\", \"x\": 1.2, \"y\": 0.2, \"radius\": 0.1, \"fluid\": \"%d\", \"dye\": "
             "\"rose\"}]}",
             fluid, fluid);
    strcat(text, one);
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error;
    if (skv_scene_load_memory(text, strlen(text), "json", "basin", NULL, &scene, &error) ||
        skv_scene_create_world(scene, 1, &world, &error))
        fail_msg("%s", error.text);
    skv_scene_destroy(scene);
    return world;
}

/* From the surface to the floor, in every palette. */
static void fluids_show_and_stand_out(void **state)
{
    (void)state;
    for (int fluid = 1; fluid < SKV_MAX_FLUIDS; fluid++) {
        skv_world *world = make_basin(fluid, "");
        for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
            const skv_colors *colors = skv_look_colors((skv_palette)palette);
            skv_detail detail = fluid % 2 ? SKV_DETAIL_FULL : SKV_DETAIL_PLAIN;
            skv_render_style style = style_of((skv_palette)palette, SKV_VIEW_WATER, detail);
            picture p = shoot(world, &style, WIDTH, HEIGHT);
            double wall = luminance(at_place(&p, 0.1, 0.3)),
                   air = luminance(at_place(&p, 0.8, 0.8));
            for (double y = 0.02; y < 0.46; y += 0.04) {
                const uint8_t *drawn = at_place(&p, 0.7, y);
                float color[3];
                to_float(drawn, color);
                for (int other = 1; other < SKV_MAX_FLUIDS; other++)
                    assert_true(colors_apart(0, color, colors->fluids[fluid - 1]) <=
                                colors_apart(0, color, colors->fluids[other - 1]));
                if (contrast(luminance(drawn), wall) < 3 || contrast(luminance(drawn), air) < 3)
                    fail_msg("%d, palette %d: contrast %.2f with walls, %.2f with air", fluid,
                             palette, contrast(luminance(drawn), wall),
                             contrast(luminance(drawn), air));
            }
            /* A dye hides its fluid's colour. */
            float dyed[3];
            to_float(at_place(&p, 1.2, 0.2), dyed);
            assert_true(colors_apart(0, dyed, colors->dyes[0]) <
                        colors_apart(0, dyed, colors->fluids[fluid - 1]));
            free(p.rgb);
        }
        skv_world_destroy(world);
    }
}

/* Between oil and water, as they lie and where they are stirred: but for a line of two pixels all
 * is of the one's colour or the other's. */
static void fluids_part_in_a_clean_line(void **state)
{
    (void)state;
    skv_world *world = make_world("oil", 1000, 1);
    for (int frame = 0; frame < 30; frame++) {
        skv_hand hand = (skv_hand){.x = 0.4f + 0.02f * (float)frame,
                                   .y = 0.3f,
                                   .vx = 1.2f,
                                   .radius = 0.1f,
                                   .attraction = 100,
                                   .follow = 40};
        assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
        assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
    }
    skv_frame frame = skv_world_frame(world);
    for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
        skv_detail detail = palette == SKV_PALETTE_LIGHT ? SKV_DETAIL_PLAIN : SKV_DETAIL_FULL;
        skv_render_style style = style_of((skv_palette)palette, SKV_VIEW_FLUID, detail);
        picture p = shoot_frame(&frame, &style, WIDTH, HEIGHT);
        float colors[2][3], drawn[3];
        for (int fluid = 0; fluid < 2; fluid++)
            skv_look_fluid(skv_look_colors((skv_palette)palette), &frame, fluid, colors[fluid]);
        int neither = 0, longest = 0, seen[2] = {0};
        for (int x = 4; x < WIDTH - 4; x++)
            for (int y = HEIGHT - 5, run = 0; y > HEIGHT - 130; y--) {
                to_float(at(&p, x, y), drawn);
                double first = colors_apart(0, drawn, colors[0]);
                double second = colors_apart(0, drawn, colors[1]);
                run = first > 0.13 && second > 0.13 ? run + 1 : 0;
                seen[second < first] += run == 0;
                neither += run > 0;
                longest = run > longest ? run : longest;
            }
        if (longest > 14 || neither > 1000 || seen[0] < 40000 || seen[1] < 5000)
            fail_msg("palette %d: %d pixels of neither, %d of them in a row; %d, %d", palette,
                     neither, longest, seen[0], seen[1]);
        free(p.rgb);
    }
    skv_world_destroy(world);
}

static void a_scene_names_a_colour(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        float color[3];
    } given[] = {{", \"color\": \"#804020\"", {128, 64, 32}},
                 {", \"color\": \"#ffffff\"", {255, 255, 255}},
                 {", \"color\": \"#20e060\"", {32, 224, 96}}};
    for (int i = 0; i < 3; i++) {
        skv_world *world = make_basin(3, given[i].text);
        for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++) {
            skv_render_style style =
                style_of((skv_palette)palette, SKV_VIEW_WATER, SKV_DETAIL_PLAIN);
            picture p = shoot(world, &style, WIDTH, HEIGHT);
            const uint8_t *drawn = at_place(&p, 0.7, 0.25);
            /* Halfway down; light goes with the depth. */
            for (int k = 0; k < 3; k++)
                if (fabsf((float)drawn[k] - given[i].color[k]) > 0.12f * given[i].color[k] + 2)
                    fail_msg("%s: %d %d %d", given[i].text, drawn[0], drawn[1], drawn[2]);
            free(p.rgb);
        }
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_eye_tells_fluids_apart),
        cmocka_unit_test(materials_have_their_colours),
        cmocka_unit_test(the_first_fluid_has_its_materials_colour),
        cmocka_unit_test(a_first_fluid_shows_its_colour),
        cmocka_unit_test(fluids_show_and_stand_out),
        cmocka_unit_test(fluids_part_in_a_clean_line),
        cmocka_unit_test(a_scene_names_a_colour),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
