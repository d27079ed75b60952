/* The picture by its colours: fluid, walls and air where they should be, at every size and number
 * of particles. What is on the screen is tests/app's; what is beautiful is for eyes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl3.h>
#include <cmocka.h>

#include <skvalp/render.h>
#include <skvalp/scene.h>

#include "render/picture.h"
#include "render/renderer.h"

static skv_result render(skv_offscreen *offscreen, const skv_world *world,
                         const skv_render_style *style, uint8_t *rgb, skv_error *error)
{
    skv_frame frame = skv_world_frame(world);
    return skv_offscreen_render(offscreen, &frame, style, rgb, error);
}

/* Rows from the top to the first fluid of a column, or -1. */
static int surface(const picture *p, int x)
{
    for (int y = 0; y < p->height; y++)
        if (is_fluid(at(p, x, y)))
            return y;
    return -1;
}

/* A pool at rest is closed, level, and as high as it is in the world. */
static void check_pool(int particles, int frames, int width, int height, double slack)
{
    skv_world *world = make_world("pool", particles, frames);
    skv_render_style style = skv_default_render_style();
    picture p = shoot(world, &style, width, height);
    skv_particles all = skv_world_particles(world);
    float highest = 0;
    for (int i = 0; i < all.count; i++)
        highest = fmaxf(highest, all.y[i]);

    double scale = width / 1.6, spacing = skv_world_spacing(world) * scale;
    int expected = (int)(height - scale * highest - 0.5 * spacing);
    int reach = (int)ceil(slack * spacing) + 2, top = height, bottom = 0;
    int left = width / 10, right = width - left; /* without what walls do to the surface */
    for (int x = left; x < right; x++) {
        int y = surface(&p, x);
        assert_true(y >= 0);
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    assert_in_range(top, expected - reach, expected + reach);
    assert_true(bottom - top <= reach);
    assert_true(share(&p, is_fluid, 0, bottom + reach, width, height) == 1);
    assert_true(share(&p, is_dark, 0, 0, width, top - reach) > 0.9999); /* corners are wall */

    /* Calm colours: neighbours in a row differ little, and the bottom is a deeper blue. */
    for (int y = bottom + 10; y < height; y++)
        for (int x = 3; x < width - 2; x++)
            assert_true(abs(at(&p, x, y)[0] - at(&p, x - 1, y)[0]) < 24);
    assert_true(at(&p, width / 2, height - 4)[0] < at(&p, width / 2, bottom + 6)[0] - 15);
    free(p.rgb);
    skv_world_destroy(world);
}

static void test_pool_of_3000(void **state)
{
    (void)state;
    check_pool(3000, 120, 960, 540, 0.5);
}

static void test_pool_of_10000(void **state)
{
    (void)state;
    check_pool(10000, 45, 480, 270, 0.7);
}

static void test_pool_of_100(void **state)
{
    (void)state;
    check_pool(100, 240, 640, 360, 0.5);
}

static void test_particles_smaller_than_pixels(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 10000, 2);
    skv_render_style style = skv_default_render_style();
    picture p = shoot(world, &style, 96, 54);
    assert_true(share(&p, is_fluid, 0, 30, 96, 54) == 1);
    assert_true(share(&p, is_dark, 0, 0, 96, 24) == 1);
    free(p.rgb);
    skv_world_destroy(world);
}

static void test_walls_are_drawn_to_the_pixel(void **state)
{
    (void)state;
    skv_world *world = make_world("u-tube", 1000, 0);
    const skv_terrain *terrain = skv_world_terrain(world);
    skv_render_style style = skv_default_render_style();
    int width = 800, height = (int)(800 * skv_terrain_height(terrain) / skv_terrain_width(terrain));
    picture p = shoot(world, &style, width, height);
    int checked = 0, different = 0;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            float scale = skv_terrain_width(terrain) / (float)width;
            float distance = skv_terrain_distance(terrain, ((float)x + 0.5f) * scale,
                                                  ((float)(height - y) - 0.5f) * scale);
            if (distance < -4 * scale || distance > 1.5f * scale) {
                different += is_wall(at(&p, x, y)) != (distance < 0);
                checked++;
            }
        }
    assert_true(checked > width * height * 9 / 10);
    assert_true(different < 40); /* where the surface fades into air, it looks like wall */
    free(p.rgb);
    skv_world_destroy(world);
}

static void test_around_the_world_is_solid(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 300, 0);
    skv_render_style style = skv_default_render_style();
    picture p = shoot(world, &style, 320, 320); /* 16:9 leaves 70 rows above and below */
    assert_true(share(&p, is_fluid, 0, 0, 320, 66) == 0);
    assert_true(share(&p, is_dark, 0, 0, 320, 66) == 0);
    assert_true(share(&p, is_dark, 0, 73, 320, 100) == 1);
    assert_true(share(&p, is_fluid, 0, 254, 320, 320) == 0);
    free(p.rgb);
    skv_world_destroy(world);
}

static void test_light_style(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 1000, 0);
    skv_render_style style = skv_default_render_style();
    style.palette = SKV_PALETTE_LIGHT;
    picture p = shoot(world, &style, 320, 180);
    const uint8_t *air = at(&p, 160, 20);
    assert_true(air[0] > 180 && air[1] > 180 && air[2] > 180);
    assert_true(is_fluid(at(&p, 160, 170)));
    free(p.rgb);
    skv_world_destroy(world);
}

static void test_tracers_are_a_tenth_and_in_no_rows(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 3000, 30);
    skv_render_style style = skv_default_render_style();
    picture without = shoot(world, &style, 960, 540);
    style.overlays = SKV_OVERLAY_TRACERS;
    picture with = shoot(world, &style, 960, 540);
    assert_true(share(&without, is_white, 0, 0, 960, 540) == 0);
    /* A tenth of the particles, discs of 0.36 spacings: 4 % of the fluid's area. */
    double left = share(&with, is_white, 0, 290, 480, 540);
    double right = share(&with, is_white, 480, 290, 960, 540);
    assert_true(left > 0.015 && left < 0.06);
    assert_true(right > 0.015 && right < 0.06);
    /* A tracer's tenth successor is a tracer no more often than others are. */
    skv_particles all = skv_world_particles(world);
    int tracers = 0, regular = 0;
    for (int i = 0; i + 10 < all.count; i++) {
        bool first = is_white(at(&with, (int)(600 * all.x[i]), 539 - (int)(600 * all.y[i])));
        int j = i + 10;
        bool second = is_white(at(&with, (int)(600 * all.x[j]), 539 - (int)(600 * all.y[j])));
        tracers += first;
        regular += first && second;
    }
    assert_in_range(tracers, 240, 360);
    assert_true(regular < tracers / 4);
    free(without.rgb);
    free(with.rgb);
    skv_world_destroy(world);
}

static void test_pressure_range(void **state)
{
    (void)state;
    skv_world *world = make_world("pool", 1000, 60);
    skv_render_style style = skv_default_render_style();
    style.view = SKV_VIEW_PRESSURE;
    style.range = 1000; /* a tenth of a metre of water: white below */
    picture p = shoot(world, &style, 320, 180);
    assert_true(share(&p, is_white, 0, 160, 320, 180) > 0.9);
    style.range = 1e9;
    picture q = shoot(world, &style, 320, 180);
    assert_true(at(&q, 160, 170)[0] < 60); /* plain blue */
    style.range = NAN;
    skv_offscreen *offscreen;
    skv_error error;
    assert_int_equal(skv_offscreen_create(320, 180, &offscreen, NULL), SKV_OK);
    assert_int_equal(render(offscreen, world, &style, p.rgb, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "range"));
    skv_offscreen_destroy(offscreen);
    free(p.rgb);
    free(q.rgb);
    skv_world_destroy(world);
}

static void test_same_world_same_picture(void **state)
{
    (void)state;
    skv_world *world = make_world("dam-break", 1000, 25);
    skv_world *twin = make_world("dam-break", 1000, 25);
    skv_render_style style = skv_default_render_style();
    picture a = shoot(world, &style, 320, 180), b = shoot(twin, &style, 320, 180);
    assert_true(largest_difference(&a, &b) <= 2);
    free(a.rgb);
    free(b.rgb);
    skv_world_destroy(world);
    skv_world_destroy(twin);
}

/* One offscreen for several worlds, one after the other and back: nothing of one shows up in the
 * other, neither walls nor pressures. */
static void test_worlds_do_not_mix(void **state)
{
    (void)state;
    skv_world *pool = make_world("pool", 800, 20), *tube = make_world("u-tube", 800, 20);
    skv_render_style style = skv_default_render_style();
    picture alone = shoot(pool, &style, 320, 180);
    picture after = {320, 180, malloc(320 * 180 * 3)};
    skv_offscreen *offscreen;
    assert_int_equal(skv_offscreen_create(320, 180, &offscreen, NULL), SKV_OK);
    const skv_world *worlds[] = {tube, pool, tube, pool};
    for (int i = 0; i < 4; i++)
        assert_int_equal(render(offscreen, worlds[i], &style, after.rgb, NULL), SKV_OK);
    assert_true(largest_difference(&alone, &after) <= 2);
    skv_offscreen_destroy(offscreen);
    free(alone.rgb);
    free(after.rgb);
    skv_world_destroy(pool);
    skv_world_destroy(tube);
}

static void test_sizes(void **state)
{
    (void)state;
    skv_world *world = make_world("dam-break", 200, 5);
    skv_render_style style = skv_default_render_style();
    style.overlays = SKV_OVERLAY_TRACERS;
    const int sizes[][2] = {{1, 1}, {2, 3}, {17, 5}, {3, 400}, {401, 7}, {333, 217}, {2049, 33}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        picture p = shoot(world, &style, sizes[i][0], sizes[i][1]);
        free(p.rgb);
    }
    skv_world_destroy(world);
}

static void test_absurd_sizes_are_refused(void **state)
{
    (void)state;
    const int sizes[][2] = {{0, 10}, {10, 0}, {-1, 10}, {1 << 20, 1}, {1, 1 << 20}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        skv_offscreen *offscreen;
        skv_error error = {0};
        assert_int_equal(skv_offscreen_create(sizes[i][0], sizes[i][1], &offscreen, &error),
                         SKV_ERROR_VALUE);
        assert_null(offscreen);
        assert_non_null(strstr(error.text, "pixels"));
    }
    skv_offscreen_destroy(NULL);
    skv_renderer_destroy(NULL);
}

/* Reads the framebuffer that is bound, top row first. */
static void read_pixels(picture *p)
{
    uint8_t *rgba = malloc((size_t)p->width * (size_t)p->height * 4);
    glReadPixels(0, 0, p->width, p->height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++)
            memcpy(p->rgb + (y * p->width + x) * 3, rgba + ((p->height - 1 - y) * p->width + x) * 4,
                   3);
    free(rgba);
}

/* A renderer of one's own with a hand, as the app has it, in a context lent by an offscreen. */
static void test_own_renderer(bool half_float)
{
    skv_world *world = make_world("pool", 500, 10);
    skv_offscreen *context;
    skv_renderer *renderer;
    skv_error error;
    assert_int_equal(skv_offscreen_create(320, 180, &context, NULL), SKV_OK);
    if (half_float)
        assert_int_equal(skv_renderer_create(&renderer, &error), SKV_OK);
    else
        assert_int_equal(skv_renderer_create_with(false, &renderer, &error), SKV_OK);
    picture p = {320, 180, malloc(320 * 180 * 3)};
    skv_render_style style = skv_default_render_style();
    assert_int_equal(render(context, world, &style, p.rgb, NULL), SKV_OK);

    skv_camera camera = {.scale = 200, .origin_x = 0, .origin_y = 180, .width = 320, .height = 180};
    skv_mark hand = {
        .shape = SKV_MARK_CIRCLE, .role = SKV_MARK_HAND, .x0 = 0.8f, .y0 = 0.6f, .radius = 0.2f};
    picture drawn = {320, 180, malloc(320 * 180 * 3)};
    skv_frame frame = skv_world_frame(world);
    assert_int_equal(skv_renderer_draw(renderer, &frame, &camera, &style, &hand, 1, &error),
                     SKV_OK);
    read_pixels(&drawn);

    assert_true(share(&drawn, is_fluid, 0, 103, 320, 180) == 1);
    assert_true(share(&drawn, is_dark, 0, 0, 110, 80) == 1);
    assert_false(is_dark(at(&drawn, 160, 21)));               /* the ring's top: y = 0.8 m */
    assert_true(is_dark(at(&drawn, 160, 17)));                /* beyond it */
    assert_true(at(&drawn, 160, 50)[0] > at(&p, 160, 50)[0]); /* a faint disc inside */
    skv_renderer_destroy(renderer);
    skv_offscreen_destroy(context);
    free(p.rgb);
    free(drawn.rgb);
    skv_world_destroy(world);
}

static void test_own_renderer_with_half_floats(void **state)
{
    (void)state;
    test_own_renderer(true);
}

static void test_own_renderer_with_bytes(void **state)
{
    (void)state;
    test_own_renderer(false);
}

static void test_no_context_is_said(void **state)
{
    (void)state;
    skv_renderer *renderer;
    skv_error error;
    assert_int_equal(skv_renderer_create(&renderer, &error), SKV_ERROR_DEVICE);
    assert_null(renderer);
    assert_non_null(strstr(error.text, "context"));
}

/* Drawing a paused world again changes nothing, and drawing does not disturb the context. */
static void test_drawing_again_changes_nothing(void **state)
{
    (void)state;
    skv_world *world = make_world("dam-break", 500, 20);
    skv_render_style style = skv_default_render_style();
    skv_offscreen *offscreen;
    picture a = {320, 180, malloc(320 * 180 * 3)}, b = {320, 180, malloc(320 * 180 * 3)};
    assert_int_equal(skv_offscreen_create(320, 180, &offscreen, NULL), SKV_OK);
    assert_int_equal(render(offscreen, world, &style, a.rgb, NULL), SKV_OK);
    for (int i = 0; i < 3; i++)
        assert_int_equal(render(offscreen, world, &style, b.rgb, NULL), SKV_OK);
    assert_int_equal(largest_difference(&a, &b), 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    skv_offscreen_destroy(offscreen);
    free(a.rgb);
    free(b.rgb);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_context_is_said), /* first: later ones make contexts */
        cmocka_unit_test(test_pool_of_3000),
        cmocka_unit_test(test_pool_of_10000),
        cmocka_unit_test(test_pool_of_100),
        cmocka_unit_test(test_particles_smaller_than_pixels),
        cmocka_unit_test(test_walls_are_drawn_to_the_pixel),
        cmocka_unit_test(test_around_the_world_is_solid),
        cmocka_unit_test(test_light_style),
        cmocka_unit_test(test_tracers_are_a_tenth_and_in_no_rows),
        cmocka_unit_test(test_pressure_range),
        cmocka_unit_test(test_same_world_same_picture),
        cmocka_unit_test(test_worlds_do_not_mix),
        cmocka_unit_test(test_sizes),
        cmocka_unit_test(test_absurd_sizes_are_refused),
        cmocka_unit_test(test_own_renderer_with_half_floats),
        cmocka_unit_test(test_own_renderer_with_bytes),
        cmocka_unit_test(test_drawing_again_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
