/* The figures that the solver must reach. */
#ifndef BENCH_TARGETS_H
#define BENCH_TARGETS_H

#include "bench.h"

/* Writes the table: figure, bound, goal, measured, reached. */
void bench_write_targets(FILE *out, const bench_report *report, bool markdown);

#endif
