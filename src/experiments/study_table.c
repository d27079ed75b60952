/* A study's tables: of one run, written and read, and of all that were read.
 *
 * Invariant: a run's table is a function of the run and its rows alone, and is read only if it is
 * that text to the last byte; so the table of a study is the same however its runs were shared out.
 */
#include "experiments/study.h"

#include "base/assert.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

/* The longest line: every parameter's path, or their values, and the columns of a row. */
enum { LONGEST_LINE = 8192 };

typedef struct line {
    char text[LONGEST_LINE];
    size_t length;
} line;

static void __attribute__((format(printf, 2, 3))) put(line *l, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    l->length += skv_format_list(l->text + l->length, LONGEST_LINE - l->length, format, arguments);
    va_end(arguments);
    if (l->length >= LONGEST_LINE)
        l->length = LONGEST_LINE - 1;
}

static bool add(const char *text, size_t length, void *user)
{
    put(user, "%.*s", (int)length, text);
    return true;
}

/* A text that may hold a comma. */
static void put_cell(line *l, const char *text)
{
    skv_write_cell(text, add, l);
}

#define COLUMNS                                                                                    \
    "quantity,unit,measured,theory,ratio,tolerance,pass,starts,passed,"                            \
    "measured_deviation,ratio_deviation"

static void put_head(line *l, const skv_study *study)
{
    skv_setting setting;
    l->length = 0;
    put(l, "skvalp,experiment,");
    for (int i = 0; skv_study_run_setting(study, 0, i, &setting); i++)
        put(l, "%s,", setting.path);
    put(l, COLUMNS "\n");
}

/* What a row begins with: all that is known before it is measured. */
static void put_known(line *l, const skv_study *study, int run, const quantity *q)
{
    skv_setting setting;
    l->length = 0;
    put(l, "%s,%s,", skv_version(), study->experiment->info.name);
    for (int i = 0; skv_study_run_setting(study, run, i, &setting); i++)
        put(l, "%s,", setting.value);
    put_cell(l, q->name);
    put(l, ",%s", q->unit);
}

static void put_number(line *l, double value)
{
    char text[VALUE_SIZE];
    skv_exact_number(value, text);
    put(l, ",%s", text);
}

static void put_row(line *l, const skv_study *study, int run, int i, const skv_study_row *row)
{
    put_known(l, study, run, &study->experiment->quantities[i]);
    put_number(l, row->row.measured);
    put_number(l, row->row.theory);
    put_number(l, row->row.ratio);
    put_number(l, row->row.tolerance);
    put(l, ",%s,%d,%d", row->row.pass ? "true" : "false", row->starts, row->passed);
    put_number(l, row->measured_deviation);
    put_number(l, row->ratio_deviation);
    put(l, "\n");
}

/* ---- Writing --------------------------------------------------------------------------------- */

static bool write_rows(line *l, const skv_study *study, int run, const skv_study_row *rows,
                       skv_write *write, void *user)
{
    for (int i = 0; i < study->experiment->count; i++) {
        put_row(l, study, run, i, &rows[i]);
        if (!write(l->text, l->length, user))
            return false;
    }
    return true;
}

/* Writes the runs from `first` on: those that have rows, or with `rows` one run of these. */
static skv_result write_table(const skv_study *study, int first, int count,
                              const skv_study_row *rows, skv_write *write, void *user,
                              skv_error *error)
{
    line *l = skv_calloc(1, sizeof *l);
    if (!l)
        return skv_fail(error, SKV_ERROR_MEMORY, "study: out of memory");
    put_head(l, study);
    bool written = write(l->text, l->length, user);
    for (int run = first; run < first + count && written; run++) {
        const skv_study_row *own = rows ? rows : study->rows[run];
        written = !own || write_rows(l, study, run, own, write, user);
    }
    skv_free(l);
    return written ? SKV_OK
                   : skv_fail(error, SKV_ERROR_FILE, "study: its table could not be written");
}

skv_result skv_study_write(const skv_study *study, int run, const skv_study_row *rows,
                           skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(study && rows && write && run >= 0 && run < study->runs, SKV_ERROR_VALUE);
    return write_table(study, run, 1, rows, write, user, error);
}

skv_result skv_study_table(const skv_study *study, skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(study && write, SKV_ERROR_VALUE);
    return write_table(study, 0, study->runs, NULL, write, user, error);
}

/* ---- Reading --------------------------------------------------------------------------------- */

typedef struct reader {
    const char *at, *end;
    int line; /* counted from 1 */
    const char *wrong;
} reader;

/* Goes on behind a text that must stand here, or says what is wrong: `other`, if another does. */
static void skip(reader *r, const line *text, const char *other)
{
    size_t left = (size_t)(r->end - r->at), length = text->length < left ? text->length : left;
    if (memcmp(r->at, text->text, length) != 0)
        r->wrong = other;
    else if (length < text->length)
        r->wrong = "it is cut";
    else
        r->at += length;
}

/* The field behind the next comma, without it; empty if there is none. */
static void next_field(reader *r, char field[VALUE_SIZE])
{
    size_t length = 0;
    bool comma = r->at < r->end && *r->at == ',';
    const char *from = comma ? r->at + 1 : r->at;
    while (from + length < r->end && from[length] != ',' && from[length] != '\n')
        length++;
    field[0] = '\0';
    bool cut = from + length == r->end;
    if (!comma || cut || length >= VALUE_SIZE) {
        if (!r->wrong)
            r->wrong = cut ? "it is cut" : "a number is missing or too long";
        return;
    }
    memcpy(field, from, length);
    field[length] = '\0';
    r->at = from + length;
}

static double next_number(reader *r)
{
    char field[VALUE_SIZE];
    double value = (double)NAN;
    next_field(r, field);
    if (field[0] && !skv_parse_number(field, &value) && !r->wrong)
        r->wrong = "a number is none";
    return value;
}

static int next_count(reader *r)
{
    double value = next_number(r);
    if (value >= 0 && value <= 99 && value == floor(value))
        return (int)value;
    if (!r->wrong)
        r->wrong = "its number of starts is none";
    return 0;
}

static bool next_truth(reader *r)
{
    char field[VALUE_SIZE];
    next_field(r, field);
    bool is_true = strcmp(field, "true") == 0;
    if (!is_true && strcmp(field, "false") != 0 && !r->wrong)
        r->wrong = "it says neither true nor false";
    return is_true;
}

static void read_row(reader *r, line *l, const skv_study *study, int run, int i, skv_study_row *row)
{
    const quantity *q = &study->experiment->quantities[i];
    r->line++;
    put_known(l, study, run, q);
    const char *begin = r->at;
    skip(r, l, "it is another run's, another version's, or changed");
    if (r->wrong)
        return;
    row->row = (skv_lab_row){
        .experiment = study->experiment->info.name, .quantity = q->name, .unit = q->unit};
    row->row.measured = next_number(r);
    row->row.theory = next_number(r);
    row->row.ratio = next_number(r);
    row->row.tolerance = next_number(r);
    row->row.pass = next_truth(r);
    row->starts = next_count(r);
    row->passed = next_count(r);
    row->measured_deviation = next_number(r);
    row->ratio_deviation = next_number(r);
    if (!r->wrong && study->starts > 0 && row->starts != study->starts)
        r->wrong = "it is of another number of starts";
    /* Only what is written exactly so comes from here. */
    put_row(l, study, run, i, row);
    r->at = begin;
    if (!r->wrong)
        skip(r, l, "it is changed");
}

static skv_result read_rows(const skv_study *study, int run, reader *r, skv_study_row *rows,
                            skv_error *error)
{
    line *l = skv_calloc(1, sizeof *l);
    if (!l)
        return skv_fail(error, SKV_ERROR_MEMORY, "study: out of memory");
    put_head(l, study);
    skip(r, l, "it is not the head of this run's table");
    for (int i = 0; i < study->experiment->count && !r->wrong; i++)
        read_row(r, l, study, run, i, &rows[i]);
    skv_free(l);
    if (!r->wrong && r->at != r->end) {
        r->line++;
        r->wrong = "there is more than a run's table";
    }
    return r->wrong ? skv_fail(error, SKV_ERROR_FORMAT, "line %d: %s", r->line, r->wrong) : SKV_OK;
}

skv_result skv_study_read(skv_study *study, int run, const char *text, size_t size,
                          skv_error *error)
{
    SKV_ASSERT_OR(study && (text || size == 0) && run >= 0 && run < study->runs, SKV_ERROR_VALUE);
    skv_study_row *rows = skv_calloc((size_t)study->experiment->count, sizeof *rows);
    if (!rows)
        return skv_fail(error, SKV_ERROR_MEMORY, "study: out of memory");
    const char *begin = text ? text : "";
    reader r = {.at = begin, .end = begin + size, .line = 1};
    skv_result result = read_rows(study, run, &r, rows, error);
    if (result == SKV_OK) {
        skv_free(study->rows[run]);
        study->rows[run] = rows;
    } else {
        skv_free(rows);
    }
    return result;
}
