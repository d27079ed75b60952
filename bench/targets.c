/* Compares what was measured with what must be reached.
 *
 * Invariant: a verdict follows from the shortest times of this run and from nothing else; what was
 * not measured has no verdict.
 */
#include "targets.h"

#include <math.h>
#include <string.h>

#include "plan.h"
#include "table.h"

/* What a target looks at. */
typedef enum figure {
    NS,        /* a particle and substep */
    MS_STEP,   /* a substep */
    MS_FRAME,  /* the substeps of 1/60 s */
    VISCOSITY, /* ns that pair viscosity adds */
    SPEEDUP,   /* least of all threads over one, from 3000 particles up */
    SPREAD,    /* dearest over cheapest particle on one thread, over the sizes */
    BYTES      /* most a particle, from 3000 particles up */
} figure;

typedef struct target {
    const char *text;
    figure figure;
    skv_law law;
    int particles;
    int threads;       /* 1, or 2 for all */
    double must, goal; /* NaN: there is none */
} target;

#define CALIBRATED SKV_LAW_CALIBRATED
#define CLAVET     SKV_LAW_CLAVET
static const target targets[] = {
    {"ns, one thread", NS, CLAVET, 10000, 1, 75, 45},
    {"ms a substep, all threads", MS_STEP, CLAVET, 3000, 2, 0.12, 0.08},
    {"ms a substep, all threads", MS_STEP, CLAVET, 1000000, 2, 40, 28},
    {"ns, one thread", NS, CALIBRATED, 10000, 1, 95, 70},
    {"ns, all threads", NS, CALIBRATED, 10000, 2, 50, 36},
    {"ns that pair viscosity adds, one thread", VISCOSITY, CALIBRATED, 10000, 1, 20, NAN},
    {"ms a frame in real time, all threads", MS_FRAME, CALIBRATED, 10000, 2, 5, NAN},
    {"ms a frame in real time, all threads", MS_FRAME, CALIBRATED, 20000, 2, 12, NAN},
    {"ms a frame in real time, all threads", MS_FRAME, CALIBRATED, 25000, 2, NAN, 12},
    {"all threads over one thread, the least", SPEEDUP, CALIBRATED, 0, 2, 1.85, NAN},
    {"dearest over cheapest ns, one thread", SPREAD, CLAVET, 0, 1, 1.2, NAN},
    {"dearest over cheapest ns, one thread", SPREAD, CALIBRATED, 0, 1, 1.2, NAN},
    {"bytes a particle, the most", BYTES, CALIBRATED, 0, 1, 128, NAN},
};
enum { TARGET_COUNT = (int)(sizeof targets / sizeof targets[0]) };

/* A figure, and the case it comes from where that is a choice of many. */
typedef struct finding {
    double value;
    const bench_row *where;
} finding;

static const bench_row *find_pool(const bench_report *report, const target *t, bool viscous)
{
    const bench_case what = {"pool", t->law, viscous, t->particles};
    return bench_find(report, &what, t->threads);
}

/* Whether a row counts for the figures over all sizes. */
static bool is_main(const bench_report *report, const bench_row *row)
{
    return bench_is_main_size(report, row->what.particles) &&
           row->what.viscous == bench_usual_viscosity(row->what.law);
}

/* The row whose `value` is the largest (sign 1) or smallest (sign -1). */
static finding extreme(const bench_report *report, int sign,
                       double (*value)(const bench_report *, const bench_row *))
{
    finding found = {NAN, NULL};
    for (int i = 0; i < report->count; i++) {
        const bench_row *row = &report->row[i];
        double here = is_main(report, row) ? value(report, row) : NAN;
        if (isfinite(here) && (!found.where || sign * here > sign * found.value))
            found = (finding){here, row};
    }
    return found;
}

static double bytes_of(const bench_report *report, const bench_row *row)
{
    (void)report;
    return row->bytes;
}

/* How much dearer a particle is in this row than in the cheapest one of the same scene and law. */
static double dearness(const bench_report *report, const bench_row *row)
{
    double cheapest = INFINITY;
    if (row->threads != 1)
        return NAN;
    for (int i = 0; i < report->count; i++) {
        const bench_row *other = &report->row[i];
        if (other->threads == 1 && is_main(report, other) && other->what.law == row->what.law &&
            strcmp(other->what.scene, row->what.scene) == 0)
            cheapest = fmin(cheapest, bench_ns(other, other->fast.minimum));
    }
    return bench_ns(row, row->fast.minimum) / cheapest;
}

static double dearness_calibrated(const bench_report *report, const bench_row *row)
{
    return row->what.law == SKV_LAW_CALIBRATED ? dearness(report, row) : NAN;
}

static double dearness_clavet(const bench_report *report, const bench_row *row)
{
    return row->what.law == SKV_LAW_CLAVET ? dearness(report, row) : NAN;
}

static finding look_up(const bench_report *report, const target *t)
{
    const bench_row *row = find_pool(report, t, bench_usual_viscosity(t->law));
    const bench_row *viscous = find_pool(report, t, true);
    switch (t->figure) {
    case NS:
        return (finding){row ? bench_ns(row, row->fast.minimum) : NAN, NULL};
    case MS_STEP:
        return (finding){row ? 1e3 * row->fast.minimum : NAN, NULL};
    case MS_FRAME:
        return (finding){row ? 1e3 * row->fast.minimum * row->substeps : NAN, NULL};
    case VISCOSITY:
        return (finding){row && viscous ? bench_ns(viscous, viscous->fast.minimum) -
                                              bench_ns(row, row->fast.minimum)
                                        : NAN,
                         NULL};
    case SPEEDUP:
        return extreme(report, -1, bench_speedup);
    case SPREAD:
        return extreme(report, 1, t->law == SKV_LAW_CLAVET ? dearness_clavet : dearness_calibrated);
    case BYTES:
        return extreme(report, 1, bytes_of);
    }
    return (finding){NAN, NULL};
}

static const char *verdict(const target *t, double value)
{
    int sign = t->figure == SPEEDUP ? -1 : 1;
    if (!isfinite(value))
        return "not measured";
    if (isfinite(t->goal) && sign * value <= sign * t->goal)
        return isfinite(t->must) ? "yes, and the goal" : "yes";
    if (!isfinite(t->must))
        return "goal missed";
    return sign * value <= sign * t->must ? "yes" : "no";
}

void bench_write_targets(FILE *out, const bench_report *report, bool markdown)
{
    static const char *const heads[] = {"figure",    "where",   ">must reach", ">goal",
                                        ">measured", "reached", NULL};
    table t;
    table_begin(&t, out, markdown, "Figures to reach", heads);
    for (int i = 0; i < TARGET_COUNT; i++) {
        finding found = look_up(report, &targets[i]);
        const bench_case pool = {"pool", targets[i].law, false, targets[i].particles};
        const bench_case *where = found.where ? &found.where->what : &pool;
        table_row(&t);
        table_cell(&t, "%s", targets[i].text);
        if (where->particles)
            table_cell(&t, "%s, %s, %d", where->scene, skv_law_name(where->law), where->particles);
        else
            table_cell(&t, "-");
        table_cell(&t, isfinite(targets[i].must) ? "%g" : "-", targets[i].must);
        table_cell(&t, isfinite(targets[i].goal) ? "%g" : "-", targets[i].goal);
        table_number(&t, found.value, -3);
        table_cell(&t, "%s", verdict(&targets[i], found.value));
    }
    table_end(&t);
    if (report->threads != 2)
        table_note(out, "The figures for all threads are meant for two.");
}
