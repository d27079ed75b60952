/* Pools with company: what else there may be in the fluid, beside the plain pool. */
#ifndef BENCH_COMPANY_H
#define BENCH_COMPANY_H

enum { BENCH_COMPANIES = 4 };

/* The name of each, as a case's scene has it. */
const char *bench_company_name(int i);

/* By such a name: how a table calls it, and the scene as JSON; null if it is another scene's. */
const char *bench_company_title(const char *name);
const char *bench_company_scene(const char *name);

#endif
