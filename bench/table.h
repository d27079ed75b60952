/* A table of text cells, printed aligned or as Markdown. */
#ifndef BENCH_TABLE_H
#define BENCH_TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "skvalp/base.h"

enum { TABLE_ROWS = 64, TABLE_COLUMNS = 14, TABLE_CELL = 80 };

typedef struct table {
    FILE *out;
    bool markdown;
    int columns, rows, filled; /* filled: cells of the last row */
    bool right[TABLE_COLUMNS];
    char cell[TABLE_ROWS][TABLE_COLUMNS][TABLE_CELL]; /* row 0: the heads */
} table;

/* Prints the title and begins a table. A head that starts with '>' makes a column of numbers, set
 * to the right. The list ends with null. */
void table_begin(table *t, FILE *out, bool markdown, const char *title, const char *const *heads);
void table_row(table *t);
void table_cell(table *t, const char *format, ...) SKV_PRINTF(2, 3);
/* A number with its digits after the point, or significant ones if `digits` is negative; "-" if
 * there is none. */
void table_number(table *t, double value, int digits);
/* Prints the rows; none, no table. */
void table_end(const table *t);

/* A paragraph. */
void table_note(FILE *out, const char *text);

#endif
