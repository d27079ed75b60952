/* Painted emitters: across their strip, to where there is more room, downwards where that does not
 * tell. */
#include "skvalp/skvalp.h"
#include "support.h"

#include <stdio.h>

enum { SIZE = 96 };

/* A green strip in an empty picture, its first pixel from the left and from below, and its size. */
typedef struct strip {
    int x, y, width, height;
} strip;

static rgb paint(int x, int y, void *user)
{
    const strip *s = user;
    int column = x - s->x, row = SIZE - 1 - y - s->y;
    bool green = column >= 0 && column < s->width && row >= 0 && row < s->height;
    return (rgb){0, green ? 255 : 0, 0};
}

static skv_emitter emitter_under(strip s, const char *gravity_x, const char *gravity_y)
{
    buffer picture = write_rgb(SIZE, SIZE, paint, &s);
    /* A coarse fluid: its walls are made sooner. */
    const skv_setting settings[] = {
        {"fluid.spacing", "0.05"}, {"gravity.x", gravity_x}, {"gravity.y", gravity_y}};
    skv_scene_options options = skv_default_scene_options();
    options.settings = settings;
    options.setting_count = 3;
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error = {0};
    if (skv_scene_load_memory(picture.data, picture.size, "png", "p.png", &options, &scene,
                              &error) != SKV_OK ||
        skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    int count;
    const skv_emitter *emitters = skv_world_emitters(world, &count);
    assert_int_equal(count, 1);
    skv_emitter emitter = emitters[0];
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    buffer_free(&picture);
    return emitter;
}

static skv_emitter emitter_of(strip s)
{
    return emitter_under(s, "0", "-9.81");
}

/* A dot has no sides: it emits to where things fall. */
static void a_dot_emits_downwards(void **unused)
{
    (void)unused;
    const strip dot = {40, 40, 6, 6};
    skv_emitter e = emitter_under(dot, "3", "-4");
    assert_float_equal(e.vx, 0.6f, 1e-5f);
    assert_float_equal(e.vy, -0.8f, 1e-5f);
    e = emitter_under(dot, "0", "0");
    assert_float_equal(e.vx, 0, 1e-5f);
    assert_float_equal(e.vy, -1, 1e-5f);
}

static void a_strip_emits_to_where_there_is_more_room(void **unused)
{
    (void)unused;
    const struct {
        strip strip;
        float vx, vy;
    } cases[] = {
        {{10, 40, 2, 20}, 1, 0},
        {{84, 40, 2, 20}, -1, 0},
        {{40, 10, 20, 2}, 0, 1},
        {{40, 84, 20, 2}, 0, -1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        skv_emitter e = emitter_of(cases[i].strip);
        assert_float_equal(e.vx, cases[i].vx, 1e-5f);
        assert_float_equal(e.vy, cases[i].vy, 1e-5f);
    }
}

/* Two pixels more room above do not tell, and down is where it flows; four do. */
static void a_little_more_room_does_not_tell(void **unused)
{
    (void)unused;
    assert_float_equal(emitter_of((strip){40, 46, 20, 2}).vy, -1, 1e-5f);
    assert_float_equal(emitter_of((strip){40, 45, 20, 2}).vy, 1, 1e-5f);
}

/* What is too wide is named by its file and by its first pixel from the top left. */
static void a_strip_that_is_too_wide_is_named(void **unused)
{
    (void)unused;
    strip s = {10, 46, 80, 2};
    buffer picture = write_rgb(SIZE, SIZE, paint, &s);
    const skv_setting settings[] = {{"fluid.spacing", "0.001"}};
    skv_scene_options options = skv_default_scene_options();
    options.settings = settings;
    options.setting_count = 1;
    skv_scene *scene;
    skv_error error = {0};
    assert_int_equal(
        skv_scene_load_memory(picture.data, picture.size, "png", "p.png", &options, &scene, &error),
        SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "p.png: the green area at pixel (10, 49) is 1.3333334 m wide; allowed are "
                        "1000 spacings, 1 m, so make it narrower or choose fewer particles");
    buffer_free(&picture);
}

/* An emitter may be as narrow as scenes may say, and lie in a side of the world. */
static void emitters_may_be_narrow_and_in_a_side(void **unused)
{
    (void)unused;
    static const char *const emitters[] = {
        "\"x\": 0.8, \"y\": 0.8, \"vy\": -1, \"width\": 0.0001",
        "\"x\": 1.6, \"y\": 0.8, \"vx\": -1",
        "\"x\": 0.8, \"y\": 0.9, \"vy\": -1",
        "\"x\": 1.62, \"y\": 0.8, \"vy\": -1",
    };
    for (size_t i = 0; i < sizeof emitters / sizeof *emitters; i++) {
        char scene[200];
        snprintf(scene, sizeof scene,
                 "{\"fluid\": {\"spacing\": 0.05}, \"water\": [], \"emitters\": [{%s}]}",
                 emitters[i]);
        skv_world *world = open_text(scene);
        int count;
        skv_world_emitters(world, &count);
        assert_int_equal(count, 1);
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_dot_emits_downwards),
        cmocka_unit_test(a_strip_emits_to_where_there_is_more_room),
        cmocka_unit_test(a_little_more_room_does_not_tell),
        cmocka_unit_test(a_strip_that_is_too_wide_is_named),
        cmocka_unit_test(emitters_may_be_narrow_and_in_a_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
