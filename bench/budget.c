/* Frames of 1/60 s, from a report's rows: what one costs, and how many particles would fill it.
 *
 * Invariant: nothing is guessed: a number in real time lies between two that were measured.
 */
#include "plan.h"

#include <math.h>
#include <string.h>

double bench_frame_ms(const bench_row *row)
{
    return 1e3 * row->fast.minimum * row->substeps;
}

/* Between two sizes a frame's cost is a power of the number of particles. */
static double between(const bench_row *below, const bench_row *above)
{
    double low = bench_frame_ms(below), high = bench_frame_ms(above);
    double power = log(high / low) / log((double)above->particles / below->particles);
    return below->particles * pow(BENCH_FRAME_MS / low, 1 / power);
}

double bench_in_real_time(const bench_report *report, const bench_case *like, int threads)
{
    const bench_row *below = NULL, *above = NULL;
    for (int i = 0; i < report->count; i++) {
        const bench_row *row = &report->row[i];
        if (strcmp(row->what.scene, like->scene) != 0 || row->what.law != like->law ||
            row->what.viscous != like->viscous || row->threads != threads)
            continue;
        bool fits = bench_frame_ms(row) <= BENCH_FRAME_MS;
        if (fits && (!below || row->particles > below->particles))
            below = row;
        if (!fits && (!above || row->particles < above->particles))
            above = row;
    }
    bool framed = below && above && below->particles < above->particles;
    return framed ? between(below, above) : NAN;
}
