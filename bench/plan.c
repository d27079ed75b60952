/* Lists what is measured: the main table and the thesis' tables. Invariant: no case is listed
 * twice, however many tables want it. */
#include "plan.h"

#include "company.h"

#include <string.h>

const int bench_sizes[BENCH_SIZES] = {3000, 10000, 30000, 100000, 300000, 1000000};
const char *const bench_scenes[2] = {"pool", "dam-break"};
const int bench_company_sizes[BENCH_COMPANY_SIZES] = {3000, 10000};

enum { QUICK_MOST = 100000 };

static const skv_law laws[2] = {SKV_LAW_CALIBRATED, SKV_LAW_CLAVET};

bool bench_usual_viscosity(skv_law law)
{
    return law == SKV_LAW_CLAVET;
}

bool bench_is_main_size(const bench_report *report, int particles)
{
    bool found = report->only == particles;
    for (int i = 0; i < BENCH_SIZES; i++)
        found = found || bench_sizes[i] == particles;
    return found;
}

typedef struct plan {
    bench_case *cases;
    int count;
} plan;

static void add(plan *p, const char *scene, skv_law law, bool viscous, int particles)
{
    for (int i = 0; i < p->count; i++) {
        const bench_case *c = &p->cases[i];
        if (strcmp(c->scene, scene) == 0 && c->law == law && c->viscous == viscous &&
            c->particles == particles)
            return;
    }
    if (p->count < BENCH_MAX_CASES)
        p->cases[p->count++] = (bench_case){scene, law, viscous, particles};
}

/* Both scenes with both laws. */
static void add_all(plan *p, int particles)
{
    for (int scene = 0; scene < 2; scene++)
        for (int law = 0; law < 2; law++)
            add(p, bench_scenes[scene], laws[law], bench_usual_viscosity(laws[law]), particles);
}

/* The pool with each company. */
static void add_companies(plan *p, int particles)
{
    for (int i = 0; i < BENCH_COMPANIES; i++)
        add(p, bench_company_name(i), SKV_LAW_CALIBRATED, false, particles);
}

int bench_plan(const bench_options *options, bench_case cases[BENCH_MAX_CASES])
{
    plan p = {.cases = cases};
    if (options->particles) {
        add_all(&p, options->particles);
        add_companies(&p, options->particles);
        return p.count;
    }
    /* Table 4.2 of the thesis. */
    for (int particles = 2000; particles <= 5000; particles += 500)
        add_all(&p, particles);
    /* Table 4.1: four sets of parameters. */
    for (int scene = 0; scene < 2; scene++)
        for (int law = 0; law < 2; law++)
            add(&p, bench_scenes[scene], laws[law], !bench_usual_viscosity(laws[law]), 3000);
    for (int i = 0; i < BENCH_SIZES; i++)
        if (!options->quick || bench_sizes[i] <= QUICK_MOST)
            add_all(&p, bench_sizes[i]);
    for (int i = 0; i < BENCH_COMPANY_SIZES; i++)
        add_companies(&p, bench_company_sizes[i]);
    return p.count;
}
