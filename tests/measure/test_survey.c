/* Surveys of states that are known exactly: linear fields, a level surface, analytic contours. */
#include "rest.h"
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#define PI 3.14159265358979323846

static skv_survey *survey_of(const skv_world *world)
{
    skv_survey *survey;
    assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
    assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
    return survey;
}

static void linear_fields_are_read_exactly(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    rest_set_pressure(world, 5000, -300, -9810);
    rest_set_velocity(world, 0.8, 0.25, 2, 0.5);
    skv_survey *survey = survey_of(world);
    /* In the bulk, at the floor, in a corner, at the surface. */
    const double points[][2] = {
        {0.8, 0.25}, {0.37, 0.111}, {0.8, 0.005}, {0.01, 0.01}, {0.8, 0.48}};
    for (int i = 0; i < 5; i++) {
        double x = points[i][0], y = points[i][1];
        skv_local local = skv_survey_at(survey, x, y);
        assert_true(local.wet);
        assert_near(local.pressure, 5000 - 300 * x - 9810 * y, 0.1);
        assert_near(local.vx, -2 * (y - 0.25) + 0.5 * (x - 0.8), 1e-5);
        assert_near(local.vy, 2 * (x - 0.8) - 0.5 * (y - 0.25), 1e-5);
    }
    skv_survey_destroy(survey);
    skv_world_destroy(world);
}

static void fill_is_one_inside_and_a_half_at_the_surface(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_survey *survey = survey_of(world);
    double inside = 0, at_floor = 0, at_side = 0, density = 0;
    for (int i = 0; i < 40; i++) {
        double along = 0.3 + 0.0173 * i;
        skv_local local = skv_survey_at(survey, along, 0.25 + 0.003 * i);
        inside += local.fill / 40;
        density += local.density / 40;
        at_floor += skv_survey_at(survey, along, 0.01).fill / 40;
        at_side += skv_survey_at(survey, 0.01, 0.1 + 0.007 * i).fill / 40;
    }
    assert_near(inside, 1, 0.01);
    assert_near(density, 1000, 10);
    /* Without the walls' share they would read 0.6. */
    assert_near(at_floor, 1, 0.06);
    assert_near(at_side, 1, 0.06);
    assert_false(skv_survey_at(survey, 0.8, 0.6).wet);
    assert_int_equal(skv_survey_at(survey, 0.8, 0.6).particles, 0);
    assert_false(skv_survey_at(survey, 0.8, -0.01).wet);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
}

static void the_level_is_volume_over_width(void **unused)
{
    (void)unused;
    const float spacings[] = {0.01f, 0.02f};
    for (int k = 0; k < 2; k++) {
        double s = (double)spacings[k];
        skv_world *world = rest_pool(spacings[k], 0.4f);
        skv_survey *survey = survey_of(world);
        double expected = skv_world_particle_count(world) * s * s / 1.6, sum = 0;
        for (int i = 0; i < 30; i++) {
            double level = 0;
            assert_true(
                skv_survey_surface(survey, 0.2 + 0.041 * i, 0, 0.2 + 0.041 * i, 0.9, &level));
            /* Hexagonal rows are 0.93 s apart. */
            assert_near(level, expected, 0.5 * s);
            sum += level / 30;
        }
        assert_near(sum, expected, 0.25 * s);
        double side = 0;
        assert_true(skv_survey_surface(survey, 0.8, 0.2, 0.8, 0.9, &side));
        assert_near(side, expected - 0.2, 0.5 * s);
        skv_survey_destroy(survey);
        skv_world_destroy(world);
    }
}

static void spray_is_no_surface(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.4f);
    for (int i = 0; i < 3; i++)
        assert_int_equal(skv_world_add_particle(world, 0.8f + 0.015f * (float)i, 0.7f, 0, 0, NULL),
                         SKV_OK);
    skv_survey *survey = survey_of(world);
    double level = 0;
    assert_true(skv_survey_surface(survey, 0.815, 0, 0.815, 0.9, &level));
    assert_near(level, 0.4, 0.02);
    assert_false(skv_survey_surface(survey, 0.815, 0.6, 0.815, 0.9, &level));
    skv_survey_destroy(survey);
    skv_world_destroy(world);
}

static void fields_leave_the_dry_out(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.4f);
    rest_set_pressure(world, 4000, 0, -10000);
    rest_set_velocity(world, 0.8, 0.2, 1, 0);
    skv_survey *survey = survey_of(world);
    skv_grid grid = {0.1, 0.1, 0.1, 15, 8};
    float values[15 * 8];
    for (int quantity = 0; quantity <= SKV_QUANTITY_VELOCITY_Y; quantity++) {
        assert_int_equal(skv_survey_field(survey, (skv_quantity)quantity, &grid, values, NULL),
                         SKV_OK);
        for (int i = 0; i < 15 * 8; i++)
            assert_true(isnan(values[i]) == (i >= 15 * 3 && i / 15 != 3) || i / 15 == 3);
    }
    assert_int_equal(skv_survey_field(survey, SKV_QUANTITY_PRESSURE, &grid, values, NULL), SKV_OK);
    assert_near((double)values[7], 3000, 1);
    assert_int_equal(skv_survey_field(survey, SKV_QUANTITY_SPEED, &grid, values, NULL), SKV_OK);
    assert_near((double)values[15], 0.7, 1e-4);
    assert_int_equal(skv_survey_field(survey, SKV_QUANTITY_VELOCITY_X, &grid, values, NULL), 0);
    assert_near((double)values[0], 0.1, 1e-4);
    skv_error error;
    grid.columns = 1;
    assert_int_equal(skv_survey_field(survey, SKV_QUANTITY_SPEED, &grid, values, &error),
                     SKV_ERROR_VALUE);
    grid.columns = 15;
    assert_int_equal(skv_survey_field(survey, (skv_quantity)99, &grid, values, &error),
                     SKV_ERROR_VALUE);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
}

enum { SIDE = 81 };

static void contours_of_a_hill_are_circles(void **unused)
{
    (void)unused;
    skv_grid grid = {-1, -1, 0.025, SIDE, SIDE};
    static float values[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = grid.x + i % SIDE * grid.step, y = grid.y + i / SIDE * grid.step;
        values[i] = (float)(1 - x * x - y * y);
    }
    static skv_segment pieces[2000];
    const double radius = 0.6137;
    int count = skv_contours(&grid, values, 1 - radius * radius, pieces, 2000);
    assert_in_range(count, 50, 2000);
    double length = 0, area = 0;
    for (int i = 0; i < count; i++) {
        double x0 = (double)pieces[i].x0, y0 = (double)pieces[i].y0;
        double x1 = (double)pieces[i].x1, y1 = (double)pieces[i].y1;
        assert_near(hypot(x0, y0), radius, 3e-4);
        length += hypot(x1 - x0, y1 - y0);
        area += (x0 * y1 - x1 * y0) / 2;
        int followers = 0;
        for (int k = 0; k < count; k++)
            followers +=
                fabsf(pieces[k].x0 - pieces[i].x1) + fabsf(pieces[k].y0 - pieces[i].y1) < 1e-6f;
        assert_int_equal(followers, 1);
    }
    assert_near(length, 2 * PI * radius, 0.01);
    /* Positive: counterclockwise round the summit, which is on the left. */
    assert_near(area, PI * radius * radius, 0.01);
    assert_int_equal(skv_contours(&grid, values, 1 - radius * radius, pieces, 3), count);
    assert_int_equal(skv_contours(&grid, values, 5, pieces, 2000), 0);
    values[SIDE * SIDE / 2] = NAN;
    assert_int_equal(skv_contours(&grid, values, 0.99999, pieces, 2000), 0);
}

static void saddles_part_by_their_middle(void **unused)
{
    (void)unused;
    const skv_grid grid = {0, 0, 1, 2, 2};
    const float low_middle[4] = {1, 0, 0, 1}; /* high at the lower left and the upper right */
    skv_segment pieces[4];
    assert_int_equal(skv_contours(&grid, low_middle, 0.6, pieces, 4), 2);
    for (int i = 0; i < 2; i++) {
        /* Each piece cuts off a high corner. */
        float sum0 = pieces[i].x0 + pieces[i].y0, sum1 = pieces[i].x1 + pieces[i].y1;
        assert_true((sum0 < 1 && sum1 < 1) || (sum0 > 1 && sum1 > 1));
    }
    assert_int_equal(skv_contours(&grid, low_middle, 0.4, pieces, 4), 2);
    for (int i = 0; i < 2; i++) {
        /* Each piece cuts off a low corner. */
        float sum0 = pieces[i].x0 + 1 - pieces[i].y0, sum1 = pieces[i].x1 + 1 - pieces[i].y1;
        assert_true((sum0 < 1 && sum1 < 1) || (sum0 > 1 && sum1 > 1));
    }
}

static void streamlines_of_a_rotation_are_circles(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.8f);
    rest_set_velocity(world, 0.8, 0.4, 3, 0);
    skv_survey *survey = survey_of(world);
    static skv_point points[400];
    int count = skv_streamline(survey, 1.0, 0.4, 0.005, points, 400);
    assert_int_equal(count, 400);
    for (int i = 0; i < count; i++)
        assert_near(hypot((double)points[i].x - 0.8, (double)points[i].y - 0.4), 0.2, 1e-3);
    assert_true(points[1].y > points[0].y);
    assert_int_equal(skv_streamline(survey, 1.0, 0.4, -0.005, points, 2), 2);
    assert_true(points[1].y < points[0].y);
    assert_int_equal(skv_streamline(survey, 1.0, 0.88, 0.005, points, 400), 0);
    rest_set_velocity(world, 0.8, 0.4, 0, 0);
    assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
    assert_int_equal(skv_streamline(survey, 1.0, 0.4, 0.005, points, 400), 1);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
}

static void an_empty_survey_answers(void **unused)
{
    (void)unused;
    skv_survey *survey;
    double level;
    assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
    assert_false(skv_survey_at(survey, 0.5, 0.5).wet);
    assert_false(skv_survey_surface(survey, 0, 0, 0, 1, &level));
    skv_survey_destroy(survey);
    skv_survey_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_fields_are_read_exactly),
        cmocka_unit_test(fill_is_one_inside_and_a_half_at_the_surface),
        cmocka_unit_test(the_level_is_volume_over_width),
        cmocka_unit_test(spray_is_no_surface),
        cmocka_unit_test(fields_leave_the_dry_out),
        cmocka_unit_test(contours_of_a_hill_are_circles),
        cmocka_unit_test(saddles_part_by_their_middle),
        cmocka_unit_test(streamlines_of_a_rotation_are_circles),
        cmocka_unit_test(an_empty_survey_answers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
