/* Collects cells, then prints them with columns as wide as they need. Invariant: the cells are
 * ASCII, so a byte is a column; Markdown differs from plain text in its rules only. */
#include "table.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

void table_begin(table *t, FILE *out, bool markdown, const char *title, const char *const *heads)
{
    t->out = out;
    t->markdown = markdown;
    t->rows = 0;
    table_row(t);
    for (t->columns = 0; heads[t->columns] && t->columns < TABLE_COLUMNS; t->columns++) {
        const char *head = heads[t->columns];
        t->right[t->columns] = *head == '>';
        table_cell(t, "%s", head + (*head == '>'));
    }
    fprintf(out, markdown ? "\n### %s\n\n" : "\n%s\n\n", title);
}

void table_row(table *t)
{
    if (t->rows < TABLE_ROWS)
        t->rows++;
    memset(t->cell[t->rows - 1], 0, sizeof t->cell[0]);
    t->filled = 0;
}

void table_cell(table *t, const char *format, ...)
{
    if (t->filled == TABLE_COLUMNS)
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(t->cell[t->rows - 1][t->filled++], TABLE_CELL, format, arguments);
    va_end(arguments);
}

void table_number(table *t, double value, int digits)
{
    if (!isfinite(value)) {
        table_cell(t, "-");
    } else if (digits >= 0) {
        table_cell(t, "%.*f", digits, value);
    } else {
        int before = value > 0 ? (int)floor(log10(value)) + 1 : 1;
        int after = -digits - before;
        table_cell(t, "%.*f", after < 0 ? 0 : after > 6 ? 6 : after, value);
    }
}

static void print_row(const table *t, int row, const int *width)
{
    for (int c = 0; c < t->columns; c++) {
        const char *separator = t->markdown ? (c ? " | " : "| ") : (c ? "  " : "");
        bool open_end =
            !t->markdown && !t->right[c] && c == t->columns - 1; /* no blanks at line ends */
        fprintf(t->out, t->right[c] ? "%s%*s" : "%s%-*s", separator, open_end ? 0 : width[c],
                t->cell[row][c]);
    }
    fputs(t->markdown ? " |\n" : "\n", t->out);
}

static void print_rule(const table *t, const int *width)
{
    for (int c = 0; c < t->columns; c++) {
        fputs(t->markdown ? "|-" : c ? "  " : "", t->out);
        for (int k = 0; k < width[c]; k++)
            fputc('-', t->out);
        if (t->markdown)
            fputc(t->right[c] ? ':' : '-', t->out);
    }
    fputs(t->markdown ? "|\n" : "\n", t->out);
}

void table_end(const table *t)
{
    int width[TABLE_COLUMNS] = {0};
    for (int row = 0; row < t->rows; row++) {
        for (int c = 0; c < t->columns; c++) {
            int length = (int)strlen(t->cell[row][c]);
            width[c] = length > width[c] ? length : width[c];
        }
    }
    print_row(t, 0, width);
    print_rule(t, width);
    for (int row = 1; row < t->rows; row++)
        print_row(t, row, width);
}

void table_note(FILE *out, const char *text)
{
    fprintf(out, "\n%s\n", text);
}
