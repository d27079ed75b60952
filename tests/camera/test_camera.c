/* The camera: a world of any shape is shown whole and centred, and pixels lead back to metres. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include <skvalp/camera.h>

static void a_world_is_shown_whole_and_centred(void **state)
{
    (void)state;
    static const struct {
        int width, height;                /* of the view, pixels */
        double world_width, world_height; /* m */
        double scale, origin_x, origin_y;
    } cases[] = {
        {1600, 900, 1.6, 0.9, 1000, 0, 900},   /* fits exactly */
        {1600, 1100, 1.6, 0.9, 1000, 0, 1000}, /* bars above and below */
        {2000, 900, 1.6, 0.9, 1000, 200, 900}, /* bars left and right */
        {100, 100, 50, 200, 0.5, 37.5, 100},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        skv_camera camera = skv_camera_fit(cases[i].width, cases[i].height, cases[i].world_width,
                                           cases[i].world_height);
        assert_int_equal(camera.width, cases[i].width);
        assert_int_equal(camera.height, cases[i].height);
        assert_true(fabs(camera.scale - cases[i].scale) < 1e-9 * cases[i].scale);
        assert_true(fabs(camera.origin_x - cases[i].origin_x) < 1e-9);
        assert_true(fabs(camera.origin_y - cases[i].origin_y) < 1e-9);
    }
}

static void a_view_without_pixels_counts_as_one(void **state)
{
    (void)state;
    skv_camera camera = skv_camera_fit(0, -5, 1.6, 0.9);
    assert_int_equal(camera.width, 1);
    assert_int_equal(camera.height, 1);
    assert_true(camera.scale > 0);
}

static void pixels_lead_back_to_metres(void **state)
{
    (void)state;
    skv_camera camera = skv_camera_fit(2000, 900, 1.6, 0.9);
    double x, y;
    skv_camera_to_world(&camera, 200, 900, &x, &y);
    assert_true(fabs(x) < 1e-12 && fabs(y) < 1e-12);
    skv_camera_to_world(&camera, 1800, 0, &x, &y);
    assert_true(fabs(x - 1.6) < 1e-12 && fabs(y - 0.9) < 1e-12);
}

/* What lies under the pointer stays there, at any zoom that the bounds allow. */
static void zooming_keeps_the_point_under_the_pointer(void **state)
{
    (void)state;
    skv_camera camera = skv_camera_fit(1600, 900, 1.6, 0.9);
    double x, y, px, py;
    skv_camera_to_world(&camera, 400, 300, &x, &y);
    for (int i = 0; i < 12; i++) {
        skv_camera_zoom(&camera, i < 8 ? 1.5 : 0.8, 400, 300);
        skv_camera_to_view(&camera, x, y, &px, &py);
        assert_true(fabs(px - 400) < 1e-6 && fabs(py - 300) < 1e-6);
    }
    assert_true(camera.zoom > 9 && camera.zoom < 11);
    /* Away from the pointer that zoomed in, the sides of the world stay out of the picture. */
    skv_camera_zoom(&camera, 0.15, 1500, 800);
    assert_true(camera.zoom > 1 && camera.origin_x < 1e-9 && camera.origin_y > 900 - 1e-9);
}

static void the_zoom_has_bounds(void **state)
{
    (void)state;
    skv_camera camera = skv_camera_fit(1600, 900, 1.6, 0.9), whole = camera;
    skv_camera_zoom(&camera, 1e9, 0, 900);
    assert_true(camera.zoom == SKV_CAMERA_MAX_ZOOM);
    assert_true(fabs(camera.scale - SKV_CAMERA_MAX_ZOOM * whole.scale) < 1e-9);
    skv_camera_zoom(&camera, 1e-9, 1600, 0);
    assert_true(camera.zoom == 1 && camera.origin_x == whole.origin_x &&
                camera.origin_y == whole.origin_y && camera.scale == whole.scale);
    camera = skv_camera_at(1600, 900, 1.6, 0.9, -7, 100, 4);
    assert_true(fabs(camera.centre_x - 0.2) < 1e-12 && fabs(camera.centre_y - 0.7875) < 1e-12);
}

static void panning_stops_at_the_sides(void **state)
{
    (void)state;
    skv_camera camera = skv_camera_at(800, 450, 1.6, 0.9, 0.8, 0.45, 2);
    double x, y, px, py;
    skv_camera_to_world(&camera, 400, 200, &x, &y);
    skv_camera_pan(&camera, 50, -30);
    skv_camera_to_view(&camera, x, y, &px, &py);
    assert_true(fabs(px - 450) < 1e-9 && fabs(py - 170) < 1e-9);
    skv_camera_pan(&camera, 1e6, 1e6);
    assert_true(fabs(camera.origin_x) < 1e-9 && fabs(camera.origin_y - 900) < 1e-9);
    /* A world that fits is not moved at all. */
    camera = skv_camera_fit(800, 450, 1.6, 0.9);
    skv_camera_pan(&camera, 100, 100);
    assert_true(camera.origin_x == 0 && camera.origin_y == 450);
}

/* Upright, a wide world fills the view and can be panned along, without bars. */
static void a_wide_world_fills_an_upright_view(void **state)
{
    (void)state;
    skv_camera camera = skv_camera_fill(360, 640, 1.6, 0.9);
    assert_true(fabs(camera.scale - 640 / 0.9) < 1e-9);
    assert_true(fabs(camera.centre_x - 0.8) < 1e-12 && fabs(camera.origin_y - 640) < 1e-9);
    skv_camera_pan(&camera, 1e6, 1e6);
    assert_true(fabs(camera.origin_x) < 1e-9 && fabs(camera.origin_y - 640) < 1e-9);
    /* Turned, the same part of the world stays in the middle. */
    skv_camera turned = skv_camera_at(640, 360, 1.6, 0.9, camera.centre_x, camera.centre_y, 2);
    assert_true(fabs(turned.centre_x - 0.4) < 1e-12 && turned.zoom == 2);
}

/* With a margin every side of the world is inside the view, whatever the view's size becomes, and
 * at the end of every way to pan. */
static void margins_stay_free(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1600, 900}, {1600, 860}, {1600, 700},
                                   {300, 900},  {16, 9},     {1, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        int width = sizes[i][0], height = sizes[i][1], least = width < height ? width : height;
        double margin = fmin(6, least / 8), left, right, bottom, top;
        skv_camera camera = skv_camera_apart(6, width, height, 1.6, 0.9, 0.3, 0.2, 1);
        skv_camera_to_view(&camera, 0, 0, &left, &bottom);
        skv_camera_to_view(&camera, 1.6, 0.9, &right, &top);
        assert_true(left >= margin - 1e-9 && right <= width - margin + 1e-9);
        assert_true(top >= margin - 1e-9 && bottom <= height - margin + 1e-9);
        skv_camera_zoom(&camera, 16, 0.5 * width, 0.5 * height);
        skv_camera_pan(&camera, 1e6, 1e6);
        skv_camera_to_view(&camera, 0, 0.9, &left, &top);
        assert_true(fabs(left - margin) < 1e-6 && fabs(top - margin) < 1e-6);
        skv_camera_pan(&camera, -1e6, -1e6);
        skv_camera_to_view(&camera, 1.6, 0, &right, &bottom);
        assert_true(fabs(right - width + margin) < 1e-6 && fabs(bottom - height + margin) < 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_world_is_shown_whole_and_centred),
        cmocka_unit_test(a_view_without_pixels_counts_as_one),
        cmocka_unit_test(zooming_keeps_the_point_under_the_pointer),
        cmocka_unit_test(the_zoom_has_bounds),
        cmocka_unit_test(panning_stops_at_the_sides),
        cmocka_unit_test(a_wide_world_fills_an_upright_view),
        cmocka_unit_test(pixels_lead_back_to_metres),
        cmocka_unit_test(margins_stay_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
