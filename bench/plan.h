/* Which cases are measured. */
#ifndef BENCH_PLAN_H
#define BENCH_PLAN_H

#include "bench.h"

enum { BENCH_MAX_CASES = 80, BENCH_SIZES = 6, BENCH_COMPANY_SIZES = 2 };

/* The numbers of particles of the main table. */
extern const int bench_sizes[BENCH_SIZES];

/* Those of the table of pools with company. */
extern const int bench_company_sizes[BENCH_COMPANY_SIZES];

/* The scenes: at rest, and in motion. */
extern const char *const bench_scenes[2];

/* The pair of law and viscosity that the main table has: clavet's law is the thesis', which has
 * viscosity; the calibrated one is meant without. */
bool bench_usual_viscosity(skv_law law);

/* Whether the main table has this number of particles; the other sizes are there for other tables.
 */
bool bench_is_main_size(const bench_report *report, int particles);

/* Writes the cases, each once, smallest first within a table; returns their number. */
int bench_plan(const bench_options *options, bench_case cases[BENCH_MAX_CASES]);

#endif
