/* Every figure of the lab against the committed one: none may get worse.
 *
 * The table tests/experiments/committed.csv holds, for every quantity of every experiment at 1500
 * particles, how far it is from theory (|ratio - 1|, or |measured| where the theory is 0) and what
 * it must reach, each in the root mean square over several starts, as the lab judges them. A figure
 * has got worse if it is farther off than committed by more than a tenth of what it must reach:
 * less than that is chance. That takes minutes, so it is left to SKV_LONG_TESTS=1. Otherwise it is
 * one start with as few particles as an experiment has room for, against committed-short.csv,
 * without the two that take two fifths of that time.
 * Set SKV_WRITE_COMMITTED=1 to write the table anew, and look at its difference before committing
 * it.
 */
#include "experiments/experiment.h"

#include "starts.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define HEAD "experiment,quantity,miss,tolerance\n"

typedef struct line {
    char experiment[32], quantity[64];
    double miss, tolerance;
} line;

enum { MAX_LINES = 96 };

static void name_line(line *l, const skv_lab_row *row)
{
    snprintf(l->experiment, sizeof l->experiment, "%s", row->experiment);
    /* A comma would divide the table's columns. */
    snprintf(l->quantity, sizeof l->quantity, "%s", row->quantity);
    for (char *c = l->quantity; *c; c++)
        *c = *c == ',' ? ';' : *c;
}

static const char *table(void)
{
    return long_tests() ? SKV_SOURCE_DIR "/tests/experiments/committed.csv"
                        : SKV_SOURCE_DIR "/tests/experiments/committed-short.csv";
}

static int starts(void)
{
    return long_tests() ? START_COUNT : 1;
}

static int particles_of(const char *name)
{
    bool few = strcmp(name, "vessels") != 0 && strcmp(name, "orifice") != 0;
    return few && !long_tests() ? 700 : 1500;
}

static bool is_left_out(const char *name)
{
    return !long_tests() &&
           (strcmp(name, "conjugate-depths") == 0 || strcmp(name, "torricelli") == 0);
}

/* Takes a start of an experiment into its lines; returns their number. */
static int add_start(line *lines, int which, int start)
{
    char particles[16];
    int wanted = particles_of(skv_experiment_info(which)->name);
    snprintf(particles, sizeof particles, "%d", start_particles(wanted, start));
    const skv_setting asked[] = {{"particles", particles}, {"orifice.slot", "0.16"}};
    skv_lab_options options = skv_default_lab_options();
    options.settings = asked;
    options.setting_count = 2;
    options.threads = 1;
    skv_report *report;
    skv_error error;
    if (skv_experiment_run(which, &options, &report, &error) != SKV_OK)
        fail_msg("%s: %s", skv_experiment_info(which)->name, error.text);
    const skv_lab_row *row;
    int i = 0;
    for (; (row = skv_report_row(report, i)); i++) {
        double miss = row->theory == 0 ? row->measured : row->ratio - 1;
        name_line(&lines[i], row);
        lines[i].miss = sqrt(lines[i].miss * lines[i].miss + miss * miss / starts());
        lines[i].tolerance += row->tolerance / starts();
    }
    skv_report_destroy(report);
    return i;
}

static int measure_all(line *lines)
{
    int count = 0;
    memset(lines, 0, MAX_LINES * sizeof *lines);
    for (int k = 0, added = 0; skv_experiment_info(k); k++, count += added) {
        assert_true(count + MAX_QUANTITIES <= MAX_LINES);
        added = 0;
        if (is_left_out(skv_experiment_info(k)->name))
            continue;
        for (int start = 0; start < starts(); start++)
            added = add_start(&lines[count], k, start);
    }
    return count;
}

static void write_table(const line *lines, int count)
{
    FILE *file = fopen(table(), "w");
    assert_non_null(file);
    fputs(HEAD, file);
    for (int i = 0; i < count; i++)
        fprintf(file, "%s,%s,%.4g,%.4g\n", lines[i].experiment, lines[i].quantity, lines[i].miss,
                lines[i].tolerance);
    assert_int_equal(fclose(file), 0);
}

static int read_table(line *lines)
{
    char text[256];
    int count = 0;
    FILE *file = fopen(table(), "r");
    assert_non_null(file);
    assert_non_null(fgets(text, sizeof text, file));
    assert_string_equal(text, HEAD);
    while (count < MAX_LINES && fgets(text, sizeof text, file)) {
        line *l = &lines[count++];
        assert_int_equal(sscanf(text, "%31[^,],%63[^,],%lf,%lf", l->experiment, l->quantity,
                                &l->miss, &l->tolerance),
                         4);
    }
    fclose(file);
    return count;
}

static void no_figure_gets_worse(void **unused)
{
    (void)unused;
    line now[MAX_LINES], committed[MAX_LINES];
    int count = measure_all(now);
    if (getenv("SKV_WRITE_COMMITTED")) {
        write_table(now, count);
        return;
    }
    int known = read_table(committed), worse = 0;
    assert_int_equal(count, known);
    for (int i = 0; i < count; i++) {
        assert_string_equal(now[i].experiment, committed[i].experiment);
        assert_string_equal(now[i].quantity, committed[i].quantity);
        /* What must be reached is not to be moved silently either; spacings differ a little. */
        assert_true(now[i].tolerance <= 1.02 * committed[i].tolerance);
        double limit = committed[i].miss + 0.1 * committed[i].tolerance;
        if (!(now[i].miss <= limit)) {
            print_error("%s, %s: %.4g off, committed %.4g\n", now[i].experiment, now[i].quantity,
                        now[i].miss, committed[i].miss);
            worse++;
        }
    }
    assert_int_equal(worse, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_figure_gets_worse)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
