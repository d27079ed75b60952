/* Coincident particles of the rows solver are found and put apart, and what is known of their
 * distance from walls stays true. */
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

static void one_of_many_is_found(void **unused)
{
    (void)unused;
    enum { COUNT = 48, A_CELL = 2, CELLS = 64, FIRST = 4 * ROW_MARGIN, ROOM = COUNT + 16 };
    /* Of those in cells of two, somebody comes to lie where the other does, wherever the cell is.
     */
    for (int twin = 0; twin < COUNT; twin += A_CELL) {
        float x[ROOM], y[ROOM], clearance[ROOM];
        int number[ROOM], cell_start[CELLS + 1], row_start = 0, row_end = COUNT;
        for (int i = 0; i < ROOM; i++) {
            x[i] =
                i < COUNT ? 0.25f * (float)(i / A_CELL) + 0.1f + 0.05f * (float)(i % A_CELL) : 1e9f;
            y[i] = 0.5f;
            clearance[i] = 2;
            number[i] = i;
        }
        for (int c = 0; c <= CELLS; c++) {
            int begin = c < FIRST ? 0 : A_CELL * (c - FIRST);
            cell_start[c] = begin < COUNT ? begin : COUNT;
        }
        x[twin + 1] = x[twin];
        skv_rows rows = {.row_count = 1,
                         .stride = CELLS,
                         .cells_used = CELLS,
                         .cell_start = cell_start,
                         .row_start = &row_start,
                         .row_end = &row_end,
                         .set = {{.x = x, .y = y, .clearance = clearance, .number = number}}};
        skv_rows_separate_coincident(&rows, 0);
        for (int i = 0; i < ROOM; i++) /* nobody else has moved */
            assert_true((clearance[i] < 2) == (i == twin + 1));
        assert_true(x[twin] != x[twin + 1] || y[twin] != y[twin + 1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(who_is_put_aside_is_nearer_to_a_wall),
                                       cmocka_unit_test(one_of_many_is_found)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
