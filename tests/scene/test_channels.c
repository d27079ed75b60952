/* Vessels that a narrow channel joins: a note says how many particles the channel needs. */
#include "scene/support.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/* Loads two vessels beside a wall; `walls` are the solids, `more` further fields. */
static skv_scene *open(const char *walls, const char *more, int particles)
{
    char text[700], count[32];
    snprintf(count, sizeof count, "%d", particles);
    snprintf(text, sizeof text,
             "{\"solid\":[%s],\"water\":[{\"shape\":\"box\",\"x1\":0.75,\"y1\":0.5},"
             "{\"shape\":\"box\",\"x0\":0.85,\"y1\":0.3}]%s}",
             walls, more);
    const char *const settings[] = {"particles", count, NULL};
    skv_scene *scene;
    skv_error error;
    if (load_text(text, settings, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return scene;
}

static bool is_noted(const char *walls, const char *more, int particles)
{
    skv_scene *scene = open(walls, more, particles);
    const char *note = skv_scene_notice(scene, 0);
    bool noted = note && strncmp(note, "a channel is ", 13) == 0;
    skv_scene_destroy(scene);
    return noted;
}

#define WALL_ABOVE(gap) "{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y0\":" gap "}"

/* The note tells the width, and the number of particles that it asks for makes it go. */
static void a_narrow_channel_is_noted(void **unused)
{
    (void)unused;
    static const struct {
        const char *walls;
        double width;
    } cases[] = {
        {WALL_ABOVE("0.01"), 0.01},
        {WALL_ABOVE("0.015"), 0.015},
        {WALL_ABOVE("0.02"), 0.02},
        {WALL_ABOVE("0.03"), 0.03},
        /* Away from the floor, and aslant. */
        {"{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y1\":0.1},"
         "{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y0\":0.125}",
         0.025},
        {"{\"shape\":\"box\",\"x0\":0.7,\"x1\":0.9},{\"shape\":\"line\",\"carve\":true,"
         "\"thickness\":0.03,\"points\":[[0.6,0.2],[1,0.1]]}",
         0.03},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        skv_scene *scene = open(cases[i].walls, "", 3000);
        double spacing = (double)skv_scene_world_def(scene).fluid.spacing, width;
        const char *note = skv_scene_notice(scene, 0);
        int enough;
        assert_non_null(note);
        assert_int_equal(sscanf(note,
                                "a channel is %lf m wide, so levels beside it may stay apart; %d "
                                "particles make it 4 spacings wide",
                                &width, &enough),
                         2);
        assert_true(fabs(width - cases[i].width) < 0.0013); /* half a pixel */
        skv_scene_destroy(scene);
        double finer = spacing * sqrt(3000.0 / enough);
        assert_true(4 * finer < width && 4.2 * finer > width);
        if (enough < 30000)
            assert_false(is_noted(cases[i].walls, "", enough));
    }
}

/* Nor is what joins no vessels, water does not come to or has no level. */
static void nothing_else_is_noted(void **unused)
{
    (void)unused;
    assert_false(is_noted(WALL_ABOVE("0.05"), "", 3000));
    assert_true(is_noted(WALL_ABOVE("0.05"), "", 500));
    /* A slot above all water, unless an emitter may raise it; a closed wall; a crack in the floor.
     */
    const char *slot = "{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y1\":0.7},"
                       "{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y0\":0.72}";
    assert_false(is_noted(slot, "", 3000));
    assert_true(is_noted(slot, ",\"emitters\":[{\"x\":0.3,\"y\":0.8,\"vy\":-1}]", 3000));
    assert_false(is_noted(WALL_ABOVE("0"), "", 3000));
    assert_false(is_noted("{\"shape\":\"box\",\"y1\":0.1},{\"shape\":\"box\",\"carve\":true,"
                          "\"x0\":0.4,\"x1\":0.42,\"y1\":0.1}",
                          "", 3000));
    /* Two channels: the water takes the wide one. */
    assert_false(is_noted("{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y0\":0.02,\"y1\":0.1},"
                          "{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y0\":0.2}",
                          "", 3000));
    assert_false(is_noted(WALL_ABOVE("0.02"), ",\"gravity\":{\"y\":0}", 3000));
    assert_false(is_noted(WALL_ABOVE("0.02"), ",\"fluid\":{\"law\":\"clavet\"}", 3000));
}

/* Pixels so fine that the terrain's distances end within a spacing or two of a wall. */
static void fine_pixels_change_nothing(void **unused)
{
    (void)unused;
    static const struct {
        double gap;
        bool noted;
    } cases[] = {{0.29, false}, {0.11, false}, {0.06, true}, {0.03, true}, {0, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "{\"world\":{\"width\":0.4,\"height\":0.3,\"pixel\":0.0005},\"particles\":100,"
                 "\"solid\":[{\"shape\":\"box\",\"x0\":0.19,\"x1\":0.21,\"y0\":%g}],"
                 "\"water\":[{\"shape\":\"box\",\"y1\":0.15}]}",
                 cases[i].gap);
        skv_scene *scene;
        assert_int_equal(load_text(text, NULL, &scene, NULL), SKV_OK);
        if ((skv_scene_notice(scene, 0) != NULL) != cases[i].noted)
            fail_msg("a gap of %g m", cases[i].gap);
        skv_scene_destroy(scene);
    }
}

static void the_built_in_scenes_have_wide_channels(void **unused)
{
    (void)unused;
    const skv_scene_info *info;
    for (int i = 0; (info = skv_builtin_scene(i)); i++) {
        skv_scene_options options = skv_default_scene_options();
        options.particles = 3000;
        skv_scene *scene;
        assert_int_equal(skv_scene_load(info->name, &options, &scene, NULL), SKV_OK);
        const char *notice;
        for (int k = 0; (notice = skv_scene_notice(scene, k)); k++)
            assert_null(strstr(notice, "channel"));
        skv_scene_destroy(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_narrow_channel_is_noted),
        cmocka_unit_test(nothing_else_is_noted),
        cmocka_unit_test(fine_pixels_change_nothing),
        cmocka_unit_test(the_built_in_scenes_have_wide_channels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
