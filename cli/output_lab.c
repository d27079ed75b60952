/* Prints the rows of an experiment.
 *
 * Invariant: a single start is printed without a word of starts; of several, every number that
 * scatters has its deviation beside it.
 */
#include "output_lab.h"

#include <math.h>

#include "output_json.h"

static void print_number(double value, int width)
{
    if (isnan(value))
        printf("%*s", width, "-");
    else
        printf("%*.4g", width, value);
}

/* What must be reached, and whether it is. */
static void print_verdict(const skv_lab_row *row)
{
    if (isnan(row->ratio))
        printf("   up to %-9.3g", row->tolerance);
    else
        printf("   +-%5.2g %%    ", 100 * row->tolerance);
    printf("  %-5s ", row->pass ? "pass" : "MISS");
}

static void print_ratio(double ratio)
{
    if (isnan(ratio))
        printf("%9s", "-");
    else
        printf("%9.3f", ratio);
}

static void print_row(const skv_lab_row *row)
{
    printf("  %-36s", row->quantity);
    print_number(row->measured, 11);
    print_number(row->theory, 11);
    print_ratio(row->ratio);
    print_verdict(row);
    printf("%s\n", row->unit);
}

static void print_scatter(const lab_figure *figure)
{
    const skv_lab_row *row = &figure->row;
    printf("  %-36s", row->quantity);
    print_number(row->measured, 11);
    printf(" +-%-8.2g", lab_deviation(figure->measured_squares, figure->starts));
    print_number(row->theory, 11);
    print_ratio(row->ratio);
    if (isnan(row->ratio))
        printf("%11s", "");
    else
        printf(" +-%-8.2g", lab_deviation(figure->ratio_squares, figure->starts));
    print_verdict(row);
    printf("%3d of %-3d %s\n", figure->passed, figure->starts, row->unit);
}

void lab_table(const skv_experiment *info, const skv_report *report, const lab_figure *figures)
{
    int particles, substeps, starts = figures[0].starts;
    double spacing, seconds;
    skv_report_facts(report, &particles, &spacing, &substeps, &seconds);
    printf("%s: ", info->title);
    if (starts > 1)
        printf("%d starts with about ", starts);
    printf("%d particles of %.3g mm, %d substeps a frame, %.3g s\n", particles, 1000 * spacing,
           substeps, seconds);
    if (starts > 1)
        printf("  %-36s%11s%22s%9s%14smust reach             starts     unit\n", info->name, "mean",
               "theory", "ratio", "");
    else
        printf("  %-36s%11s%11s%9s   %s\n", info->name, "measured", "theory", "ratio",
               "must reach         unit");
    for (int i = 0; skv_report_row(report, i); i++) {
        if (starts > 1)
            print_scatter(&figures[i]);
        else
            print_row(&figures[i].row);
    }
}

skv_result lab_json(int number, const lab_figure *figure, skv_error *error)
{
    const skv_lab_row *row = &figure->row;
    int n = figure->starts;
    /* clang-format off */
    json_t *object = json_pack("{so so so so so so so sb}",
        "experiment", output_text(row->experiment),
        "quantity", output_text(row->quantity),
        "unit", output_text(row->unit),
        "measured", output_number(row->measured),
        "theory", output_number(row->theory),
        "ratio", output_number(row->ratio),
        "tolerance", output_number(row->tolerance),
        "pass", row->pass);
    /* clang-format on */
    if (object && n > 1 &&
        (json_object_set_new(object, "starts", json_integer(n)) ||
         json_object_set_new(object, "passed", json_integer(figure->passed)) ||
         json_object_set_new(object, "measured_deviation",
                             output_number(lab_deviation(figure->measured_squares, n))) ||
         json_object_set_new(object, "ratio_deviation",
                             output_number(lab_deviation(figure->ratio_squares, n))))) {
        json_decref(object);
        object = NULL;
    }
    return output_list_add(number, object, error);
}
