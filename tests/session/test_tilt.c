/* Tilt, from a folder that looks like a device's sensor. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include <skvalp/tilt.h>

static char root[64];

static void put(const char *name, const char *text)
{
    char path[128];
    snprintf(path, sizeof path, "%s/iio:device3/%s", root, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "%s\n", text);
    fclose(file);
}

static void put_reading(double x, double y)
{
    char text[32];
    snprintf(text, sizeof text, "%d", (int)lround(x * 1000));
    put("in_accel_x_raw", text);
    snprintf(text, sizeof text, "%d", (int)lround(y * 1000));
    put("in_accel_y_raw", text);
}

static int setup(void **state)
{
    (void)state;
    char path[128];
    strcpy(root, "/tmp/skvalp-tilt-XXXXXX");
    if (!mkdtemp(root))
        return -1;
    snprintf(path, sizeof path, "%s/iio:device3", root);
    if (mkdir(path, 0700) != 0)
        return -1;
    put_reading(0, 1); /* held upright */
    put("in_accel_scale", "0.00981");
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    static const char *const names[] = {"in_accel_x_raw", "in_accel_y_raw", "in_accel_scale",
                                        "in_mount_matrix", "in_accel_x_offset"};
    char path[128];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        snprintf(path, sizeof path, "%s/iio:device3/%s", root, names[i]);
        unlink(path);
    }
    snprintf(path, sizeof path, "%s/iio:device3", root);
    rmdir(path);
    return rmdir(root);
}

static skv_tilt *open_tilt(void)
{
    skv_tilt *tilt;
    skv_error error = {0};
    if (skv_tilt_open(root, &tilt, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return tilt;
}

static void expect(skv_tilt *tilt, skv_orientation up, double wanted_x, double wanted_y)
{
    skv_tilt_reading r;
    assert_true(skv_tilt_read(tilt, 0, up, &r));
    if (hypot(r.gravity_x - wanted_x, r.gravity_y - wanted_y) > 1e-6)
        fail_msg("(%g, %g), wanted (%g, %g)", r.gravity_x, r.gravity_y, wanted_x, wanted_y);
    assert_true(r.push_x == 0 && r.push_y == 0);
}

static void test_axes_follow_the_screen(void **state)
{
    (void)state;
    const double upright[4][2] = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}}; /* what holds it up */
    for (int up = 0; up < 4; up++) {
        skv_tilt *tilt = open_tilt();
        /* Whichever edge is up on the screen: held upright, water falls to the other one. */
        put_reading(upright[up][0], upright[up][1]);
        expect(tilt, (skv_orientation)up, 0, -1);
        skv_tilt_close(tilt);
    }
    /* Tilted to the right, the right edge is low: water flows there. */
    skv_tilt *tilt = open_tilt();
    put_reading(-0.6, 0.8);
    expect(tilt, SKV_ORIENTATION_TOP, 0.6, -0.8);
    skv_tilt_close(tilt);
    skv_tilt_close(NULL);
}

static void test_shaking_and_smoothing(void **state)
{
    (void)state;
    skv_tilt_reading r;
    skv_tilt *tilt = open_tilt();
    expect(tilt, SKV_ORIENTATION_TOP, 0, -1);
    put_reading(0.05, 1.05); /* noise, and a hand that holds it */
    assert_true(skv_tilt_read(tilt, 0.02, SKV_ORIENTATION_TOP, &r));
    assert_true(r.push_x == 0 && r.push_y == 0);
    /* Jerked to the left: half of it is gravity in 50 ms, half of it splashes to the right;
     * together they are the acceleration. */
    put_reading(-1, 1);
    assert_true(skv_tilt_read(tilt, 0.05, SKV_ORIENTATION_TOP, &r));
    assert_true(r.gravity_x > 0.4 && r.gravity_x < 0.6);
    assert_true(fabs(r.gravity_x + r.push_x / (9.81 * 0.05) - 1) < 1e-9);
    assert_true(fabs(r.push_y) < 0.03);
    /* For long: at most 2 g, and no shaking any more. */
    put_reading(9, 0);
    for (int i = 0; i < 50; i++)
        assert_true(skv_tilt_read(tilt, 0.05, SKV_ORIENTATION_TOP, &r));
    assert_true(fabs(r.gravity_x + 2) < 1e-6 && fabs(r.gravity_y) < 1e-6);
    assert_true(r.push_x == 0 && r.push_y == 0);
    /* As wild as can be, and after a pause: no more than a session takes. */
    put_reading(-100, 100);
    assert_true(skv_tilt_read(tilt, 5, SKV_ORIENTATION_TOP, &r));
    assert_true(fabs(r.push_x) <= 10 && fabs(r.push_y) <= 10);
    /* A file that is gone or odd is no reading. */
    put("in_accel_x_raw", "many");
    assert_false(skv_tilt_read(tilt, 0.05, SKV_ORIENTATION_TOP, &r));
    skv_tilt_close(tilt);
}

static void test_how_it_is_built_in(void **state)
{
    (void)state;
    put("in_mount_matrix", "0, 1, 0; -1, 0, 0; 0, 0, 1");
    put("in_accel_x_offset", "500");
    put_reading(-1.5, 0); /* -1 with the offset, which the device's y axis reads as 1 */
    skv_tilt *tilt = open_tilt();
    expect(tilt, SKV_ORIENTATION_TOP, 0, -1);
    skv_tilt_close(tilt);
    put("in_mount_matrix", "1, 2, three"); /* is none */
    put("in_accel_x_offset", "0");
    put_reading(0, 1);
    tilt = open_tilt();
    expect(tilt, SKV_ORIENTATION_TOP, 0, -1);
    skv_tilt_close(tilt);
}

/* A front end that has its readings from elsewhere. */
static void test_what_is_told(void **state)
{
    (void)state;
    const double upright[4][2] = {{0, 9.81}, {-9.81, 0}, {0, -9.81}, {9.81, 0}};
    for (int up = 0; up < 4; up++) {
        skv_tilt_filter filter = {0};
        skv_tilt_reading r =
            skv_tilt_feel(&filter, upright[up][0], upright[up][1], 0, (skv_orientation)up);
        assert_true(fabs(r.gravity_x) < 1e-9 && fabs(r.gravity_y + 1) < 1e-9);
    }
    skv_tilt_filter filter = {0};
    skv_tilt_feel(&filter, 0, 9.81, 0, SKV_ORIENTATION_TOP);
    skv_tilt_reading shaken = skv_tilt_feel(&filter, -9.81, 9.81, 0.05, SKV_ORIENTATION_TOP);
    assert_true(shaken.push_x > 0.2 && shaken.push_y == 0);
    /* What is no number changes nothing, and neither do clocks that stand still or go back. */
    const double odd[3][3] = {{NAN, 0, 0.02}, {0, INFINITY, 0.02}, {0, 9.81, NAN}};
    for (int i = 0; i < 3; i++) {
        skv_tilt_reading r =
            skv_tilt_feel(&filter, odd[i][0], odd[i][1], odd[i][2], SKV_ORIENTATION_TOP);
        assert_true(r.gravity_x == shaken.gravity_x && r.gravity_y == shaken.gravity_y);
        assert_true(r.push_x == 0 && r.push_y == 0);
    }
    skv_tilt_reading back = skv_tilt_feel(&filter, 50, 9.81, -1, SKV_ORIENTATION_TOP);
    assert_true(back.push_x == 0 && back.push_y == 0);
}

static void test_no_sensor(void **state)
{
    (void)state;
    skv_tilt *tilt;
    skv_error error = {0};
    assert_int_equal(skv_tilt_open("/nowhere", &tilt, &error), SKV_ERROR_DEVICE);
    assert_null(tilt);
    assert_non_null(strstr(error.text, "no acceleration sensor"));
    skv_tilt_open(NULL, &tilt, NULL); /* this machine's own, if it has one */
    skv_tilt_close(tilt);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_axes_follow_the_screen, setup, teardown),
        cmocka_unit_test_setup_teardown(test_shaking_and_smoothing, setup, teardown),
        cmocka_unit_test_setup_teardown(test_how_it_is_built_in, setup, teardown),
        cmocka_unit_test(test_what_is_told),
        cmocka_unit_test(test_no_sensor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
