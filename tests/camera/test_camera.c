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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_world_is_shown_whole_and_centred),
        cmocka_unit_test(a_view_without_pixels_counts_as_one),
        cmocka_unit_test(pixels_lead_back_to_metres),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
