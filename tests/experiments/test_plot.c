/* Plots: any curves make a picture that can be drawn, and a table that a spreadsheet reads. */
#include "experiments/plot.h"
#include "support/kept.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* A spreadsheet gets three cells a line. */
static void labels_keep_their_commas(void **unused)
{
    (void)unused;
    skv_plot plot = {.title = "", .x_label = "x, m", .y_label = "y"};
    kept t = {0};
    skv_plot_begin(&plot, "theory, \"ideal\"", SKV_CURVE_THEORY);
    skv_plot_point(&plot, 1, 2);
    assert_int_equal(skv_plot_write_csv(&plot, kept_add, &t, NULL), SKV_OK);
    assert_string_equal(t.bytes, "series,\"x, m\",y\n\"theory, \"\"ideal\"\"\",1,2\n");
    skv_plot_free(&plot);
    kept_clear(&t);
}

static void odd_curves_are_drawn(void **unused)
{
    (void)unused;
    skv_plot picture = {.title = "A & B < C", .x_label = "x", .y_label = "y"};
    kept t = {0};
    assert_int_equal(skv_plot_write_svg(&picture, kept_add, &t, NULL), SKV_OK);
    assert_non_null(strstr(t.bytes, "A &amp; B &lt; C"));
    skv_plot_point(&picture, 1, 1); /* belongs to no curve */
    skv_plot_begin(&picture, "one point", SKV_CURVE_DOTS);
    skv_plot_point(&picture, 1, -3);
    skv_plot_point(&picture, (double)NAN, 2);
    skv_plot_point(&picture, 2, (double)INFINITY);
    assert_int_equal(picture.curves[0].count, 1);
    kept_clear(&t);
    assert_int_equal(skv_plot_write_svg(&picture, kept_add, &t, NULL), SKV_OK);
    assert_null(strstr(t.bytes, "nan"));
    for (int i = 0; i < MAX_CURVES; i++)
        skv_plot_begin(&picture, "more", SKV_CURVE_LINE);
    assert_true(picture.failed);
    skv_plot_free(&picture);
    kept_clear(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(labels_keep_their_commas),
        cmocka_unit_test(odd_curves_are_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
