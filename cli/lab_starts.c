/* Starts: an experiment from slightly different numbers of particles.
 *
 * Invariant: the first start is the run without further starts, and each is the same however many
 * follow; of a single start a figure is its row, to the bit.
 */
#include "lab_starts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Neighbouring starts differ by a hundredth of the particles: enough for every lattice to meet its
 * walls otherwise, little beside what halving the particles changes. */
enum { STEPS = 100 };

/* Starts of what scatters, if nothing else is asked for: a deviation is known to a quarter then. */
enum { STARTS_OF_SCATTER = 8 };

/* Takes a value into a mean of `count` with it, and into the squares of what differs from it. */
static void take(double *mean, double *squares, double value, int count)
{
    double off = value - *mean;
    *mean = count == 1 ? value : *mean + off / count;
    *squares += count == 1 ? 0 : off * (value - *mean);
}

void lab_figure_add(lab_figure *figure, const skv_lab_row *row)
{
    skv_lab_row means = *row;
    double unused = 0, miss = isnan(row->ratio) ? row->measured : row->ratio - 1;
    int n = ++figure->starts;
    means.measured = figure->row.measured;
    means.theory = figure->row.theory;
    means.ratio = figure->row.ratio;
    means.tolerance = figure->row.tolerance;
    take(&means.measured, &figure->measured_squares, row->measured, n);
    take(&means.theory, &unused, row->theory, n);
    take(&means.ratio, &figure->ratio_squares, row->ratio, n);
    take(&means.tolerance, &unused, row->tolerance, n);
    figure->miss_squares += miss * miss;
    /* Misses to either side do not cancel, and scatter counts. A NaN does not pass. */
    means.pass = n == 1 ? row->pass : sqrt(figure->miss_squares / n) <= means.tolerance;
    figure->passed += row->pass;
    figure->row = means;
}

double lab_deviation(double squares, int starts)
{
    return starts > 1 ? sqrt(squares / (starts - 1)) : (double)NAN;
}

/* The number of particles that the settings ask for, or else the registry. */
static int find_wanted(const cli_options *options)
{
    const char *text = "0";
    for (int i = 0; skv_lab_parameter(i); i++)
        if (strcmp(skv_lab_parameter(i)->path, "particles") == 0)
            text = skv_lab_parameter(i)->default_text;
    for (int i = 0; i < options->setting_count; i++)
        if (strcmp(options->settings[i].path, "particles") == 0)
            text = options->settings[i].value;
    double number = 0;
    skv_parse_number(text, &number);
    return (int)number;
}

/* Whether the number of particles follows from another setting. */
static bool is_number_decided(const cli_options *options)
{
    for (int i = 0; i < options->setting_count; i++)
        if (strcmp(options->settings[i].path, "fluid.spacing") == 0)
            return true;
    return false;
}

/* Whether every start that was asked for has settings that are right. */
static skv_result check_starts(lab_starts *starts, int count, skv_error *error)
{
    skv_lab_options lab = skv_default_lab_options();
    skv_result result = SKV_OK;
    for (int i = 0; i < count && result == SKV_OK; i++) {
        lab_starts_choose(starts, i, &lab);
        result = skv_lab_check(&lab, error);
    }
    return result;
}

skv_result lab_starts_open(lab_starts *starts, const cli_options *options, skv_error *error)
{
    const int asked = options->starts, count = options->setting_count;
    const bool decided = is_number_decided(options);
    *starts = (lab_starts){.setting_count = count,
                           .of_any = asked > 0 ? asked : 1,
                           .of_scatter = asked > 0 ? asked
                                         : decided ? 1
                                                   : STARTS_OF_SCATTER};
    if (asked > 1 && decided)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--starts: they differ in their number of particles, which "
                        "fluid.spacing decides here; say particles=N instead of it");
    starts->settings = calloc((size_t)count + 1, sizeof *starts->settings);
    if (!starts->settings)
        return skv_fail(error, SKV_ERROR_MEMORY, "lab: out of memory");
    for (int i = 0; i < count; i++)
        starts->settings[i] = options->settings[i];
    if (starts->of_scatter > 1) {
        starts->wanted = find_wanted(options);
        starts->setting_count++;
    }
    return check_starts(starts, asked, error);
}

int lab_starts_count(const lab_starts *starts, const skv_experiment *experiment)
{
    return experiment->scatters ? starts->of_scatter : starts->of_any;
}

void lab_starts_close(lab_starts *starts)
{
    free(starts->settings);
    starts->settings = NULL;
}

void lab_starts_choose(lab_starts *starts, int start, skv_lab_options *lab)
{
    lab->settings = starts->settings;
    lab->setting_count = starts->setting_count;
    if (starts->wanted == 0)
        return;
    /* As wanted, a step more, a step less, two steps more, ... */
    int step = starts->wanted / STEPS > 1 ? starts->wanted / STEPS : 1;
    int steps = start % 2 ? (start + 1) / 2 : -start / 2;
    snprintf(starts->particles, sizeof starts->particles, "%d", starts->wanted + steps * step);
    starts->settings[starts->setting_count - 1] = (skv_setting){"particles", starts->particles};
}
