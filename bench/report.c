/* Reads figures out of a report, and writes it as CSV. Invariant: a figure that was not measured is
 * NaN here and an empty field there. */
#include "bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const bench_row *bench_find(const bench_report *report, const bench_case *what, int threads)
{
    for (int i = 0; i < report->count; i++) {
        const bench_row *row = &report->row[i];
        if (strcmp(row->what.scene, what->scene) == 0 && row->what.law == what->law &&
            row->what.viscous == what->viscous && row->what.particles == what->particles &&
            row->threads == (threads == 1 ? 1 : report->threads))
            return row;
    }
    return NULL;
}

double bench_ns(const bench_row *row, double seconds)
{
    return 1e9 * seconds / row->particles;
}

double bench_ratio(const bench_row *row)
{
    return row->reference.minimum / row->fast.minimum;
}

double bench_speedup(const bench_report *report, const bench_row *row)
{
    const bench_row *one = bench_find(report, &row->what, 1);
    return one && row->threads > 1 ? one->fast.minimum / row->fast.minimum : NAN;
}

static void number(FILE *out, double value)
{
    if (isfinite(value))
        fprintf(out, ",%.6g", value);
    else
        fputc(',', out);
}

static bool take(const char *text, size_t length, void *out)
{
    return fwrite(text, 1, length, out) == length;
}

void bench_write_csv(FILE *out, const bench_report *report)
{
    fputs("cpu,compiler,instruction_set,scene,law,viscosity,particles,threads,substeps,neighbours,"
          "ms_per_step,ms_per_step_median,ns_per_particle_substep,ns_per_particle_substep_median,"
          "reference_ns_per_particle_substep,reference_ns_per_particle_substep_median,ratio,"
          "bytes_per_particle,kept_bytes_per_particle,grid_bytes_per_particle",
          out);
    const skv_profile *names = &report->row[0].phases;
    for (int i = 0; i < names->count; i++)
        fprintf(out, ",%s_ns", names->name[i]);
    fputc('\n', out);
    for (int i = 0; i < report->count; i++) {
        const bench_row *row = &report->row[i];
        skv_write_cell(report->cpu, take, out);
        fputc(',', out);
        skv_write_cell(report->compiler, take, out);
        fputc(',', out);
        fprintf(out, "%s,%s,%s,%s,%d,%d,%d", report->instruction_set, row->what.scene,
                skv_law_name(row->what.law), row->what.viscous ? "on" : "off", row->particles,
                row->threads, row->substeps);
        const double numbers[] = {row->neighbours,
                                  1e3 * row->fast.minimum,
                                  1e3 * row->fast.median,
                                  bench_ns(row, row->fast.minimum),
                                  bench_ns(row, row->fast.median),
                                  bench_ns(row, row->reference.minimum),
                                  bench_ns(row, row->reference.median),
                                  bench_ratio(row),
                                  row->bytes,
                                  row->kept_bytes,
                                  row->grid_bytes};
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
            number(out, numbers[k]);
        for (int k = 0; k < row->phases.count; k++)
            number(out, bench_ns(row, row->phases.seconds[k]));
        fputc('\n', out);
    }
}
