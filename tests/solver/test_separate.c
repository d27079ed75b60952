/* Coincident particles of the rows solver are put apart, and what is known of their distance from
 * walls stays true. */
#include "solver/rows/rows_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void who_is_put_aside_is_nearer_to_a_wall(void **unused)
{
    (void)unused;
    enum { COUNT = 12, CELLS = 64, CELL = 4 * (ROW_MARGIN + 1) };
    float x[COUNT], y[COUNT], clearance[COUNT];
    int number[COUNT], cell_start[CELLS + 1], row_start = 0, row_end = COUNT;
    for (int i = 0; i < COUNT; i++) {
        x[i] = 1.125f; /* in the middle of its cell */
        y[i] = 0.5f;
        clearance[i] = 2;
        number[i] = i;
    }
    for (int c = 0; c <= CELLS; c++)
        cell_start[c] = c <= CELL ? 0 : COUNT;
    skv_rows rows = {.row_count = 1,
                     .stride = CELLS,
                     .cells_used = CELLS,
                     .cell_start = cell_start,
                     .row_start = &row_start,
                     .row_end = &row_end,
                     .set = {{.x = x, .y = y, .clearance = clearance, .number = number}}};
    skv_rows_separate_coincident(&rows, 0);
    for (int i = 0; i < COUNT; i++) {
        float way = hypotf(x[i] - 1.125f, y[i] - 0.5f);
        assert_true(way < 0.02f);
        assert_true(clearance[i] <= 2 - way + 1e-6f);
        for (int j = 0; j < i; j++)
            assert_true(x[i] != x[j] || y[i] != y[j]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(who_is_put_aside_is_nearer_to_a_wall)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
