/* Prints a report as tables. Invariant: every figure here but those of edits and rivals stands in
 * the CSV, too, or follows from its columns; the thesis' figures are those of its tables 4.1
 * and 4.2.
 */
#include <math.h>
#include <string.h>

#include "company.h"
#include "plan.h"
#include "table.h"

static const char *fluid_name(const bench_case *what)
{
    if (what->law == SKV_LAW_CLAVET)
        return what->viscous ? "clavet" : "clavet, no viscosity";
    return what->viscous ? "calibrated, viscous" : "calibrated";
}

static const char *scene_name(const char *scene)
{
    return strcmp(scene, "pool") == 0 ? "pool, at rest" : "dam break, in motion";
}

/* ---- The main table -------------------------------------------------------------------------- */

static void main_row(table *t, const bench_report *report, const bench_row *one)
{
    const bench_row *all = bench_find(report, &one->what, report->threads);
    table_row(t);
    table_cell(t, "%s", fluid_name(&one->what));
    table_cell(t, "%d", one->particles);
    table_number(t, one->neighbours, 1);
    table_number(t, 1e3 * one->fast.minimum, -3);
    table_number(t, bench_ns(one, one->fast.minimum), 1);
    table_number(t, bench_ns(one, one->fast.median), 1);
    table_number(t, bench_ns(all, all->fast.minimum), 1);
    table_number(t, bench_ns(all, all->fast.median), 1);
    table_number(t, bench_speedup(report, all), 2);
    table_number(t, bench_ns(one, one->reference.minimum), 0);
    table_number(t, bench_ratio(one), 1);
    table_number(t, bench_ratio(all), 1);
    table_number(t, one->bytes, 0);
    table_number(t, 1e-6 * one->kept_bytes * one->particles, 2);
}

static void write_scene(FILE *out, const bench_report *report, bool markdown, const char *scene)
{
    static const char *const heads[] = {"law",       ">particles",    ">neighbours", ">ms/step x1",
                                        ">ns x1",    ">median",       ">ns x all",   ">median",
                                        ">speed-up", ">reference x1", ">ratio x1",   ">ratio x all",
                                        ">bytes",    ">kept MB",      NULL};
    char title[64];
    snprintf(title, sizeof title, "Cost of a substep: %s", scene_name(scene));
    table t;
    table_begin(&t, out, markdown, title, heads);
    for (int fluid = 0; fluid < 4; fluid++)
        for (int i = 0; i < report->count; i++) {
            const bench_row *row = &report->row[i];
            if (row->threads == 1 && bench_is_main_size(report, row->what.particles) &&
                strcmp(row->what.scene, scene) == 0 && (int)row->what.law == fluid / 2 &&
                row->what.viscous == fluid % 2)
                main_row(&t, report, row);
        }
    table_end(&t);
}

/* ---- Pools with company ---------------------------------------------------------------------- */

/* The plain pool comes first, with which the others are compared. */
static void company_row(table *t, const bench_report *report, const char *scene, int particles)
{
    const bench_case what = {scene, SKV_LAW_CALIBRATED, false, particles};
    const bench_case plain = {bench_scenes[0], SKV_LAW_CALIBRATED, false, particles};
    const bench_row *one = bench_find(report, &what, 1), *pool = bench_find(report, &plain, 1);
    const bench_row *all = bench_find(report, &what, report->threads);
    if (!one || !all || !pool)
        return;
    const char *title = bench_company_title(scene);
    table_row(t);
    table_cell(t, "%s", title ? title : "water alone");
    table_cell(t, "%d", one->particles);
    table_cell(t, "%d", one->substeps);
    table_number(t, bench_ns(one, one->fast.minimum), 1);
    table_number(t, bench_ns(one, one->fast.median), 1);
    table_number(t, bench_ns(all, all->fast.minimum), 1);
    table_number(t, bench_ns(all, all->fast.median), 1);
    table_number(t, bench_speedup(report, all), 2);
    table_number(t, bench_ns(one, one->fast.minimum) / bench_ns(pool, pool->fast.minimum), 2);
}

static void write_companies(FILE *out, const bench_report *report, bool markdown)
{
    static const char *const heads[] = {"in the pool", ">particles", ">substeps", ">ns x1",
                                        ">median",     ">ns x all",  ">median",   ">speed-up",
                                        ">over water", NULL};
    int sizes = report->only ? 1 : BENCH_COMPANY_SIZES;
    table t;
    table_begin(&t, out, markdown, "Cost of a substep: a pool with company", heads);
    for (int i = 0; i < sizes; i++) {
        int particles = report->only ? report->only : bench_company_sizes[i];
        company_row(&t, report, bench_scenes[0], particles);
        for (int k = 0; k < BENCH_COMPANIES; k++)
            company_row(&t, report, bench_company_name(k), particles);
    }
    table_end(&t);
    table_note(out, "over water: how many times as long a particle and substep take, on one "
                    "thread.");
}

/* ---- Frames of 1/60 s ------------------------------------------------------------------------ */

/* The numbers of particles with a column of their own: those of which a frame is of any use. */
static int budget_sizes(const bench_report *report, int sizes[BENCH_SIZES])
{
    int count = 0;
    for (int i = 0; !report->only && i < BENCH_SIZES && bench_sizes[i] <= 100000; i++)
        sizes[count++] = bench_sizes[i];
    if (report->only)
        sizes[count++] = report->only;
    return count;
}

static void budget_row(table *t, const bench_report *report, const bench_case *like, int threads)
{
    int sizes[BENCH_SIZES], count = budget_sizes(report, sizes);
    table_row(t);
    table_cell(t, "%s", fluid_name(like));
    table_cell(t, "%s", scene_name(like->scene));
    table_cell(t, "%d", threads);
    for (int i = 0; i < count; i++) {
        const bench_case what = {like->scene, like->law, like->viscous, sizes[i]};
        const bench_row *row = bench_find(report, &what, threads);
        table_number(t, row ? bench_frame_ms(row) : NAN, -3);
    }
    table_number(t, bench_in_real_time(report, like, threads), -2);
}

static void write_budget(FILE *out, const bench_report *report, bool markdown)
{
    const char *heads[TABLE_COLUMNS] = {"law", "scene", ">threads"};
    char name[BENCH_SIZES][16];
    int sizes[BENCH_SIZES], count = budget_sizes(report, sizes);
    for (int i = 0; i < count; i++) {
        snprintf(name[i], sizeof name[i], ">%d", sizes[i]);
        heads[3 + i] = name[i];
    }
    heads[3 + count] = ">in real time";
    table t;
    table_begin(&t, out, markdown, "A frame of 1/60 s, ms, by number of particles", heads);
    for (int law = 0; law < 2; law++)
        for (int scene = 0; scene < 2; scene++) {
            bench_case like = {bench_scenes[scene], (skv_law)law,
                               bench_usual_viscosity((skv_law)law), 0};
            budget_row(&t, report, &like, 1);
            if (report->threads > 1)
                budget_row(&t, report, &like, report->threads);
        }
    table_end(&t);
    table_note(out, "in real time: how many particles take 1/60 s for it, all of it, between two "
                    "numbers that were measured.");
}

/* ---- Phases ---------------------------------------------------------------------------------- */

static void phase_row(table *t, const bench_row *row)
{
    table_row(t);
    table_cell(t, "%s", fluid_name(&row->what));
    table_cell(t, "%d", row->particles);
    table_cell(t, "%d", row->threads);
    double sum = 0;
    for (int i = 0; i < row->phases.count; i++) {
        sum += row->phases.seconds[i];
        table_number(t, bench_ns(row, row->phases.seconds[i]), 1);
    }
    table_number(t, bench_ns(row, fmax(0, row->fast.minimum - sum)), 1);
    table_number(t, bench_ns(row, row->fast.minimum), 1);
}

static void write_phases(FILE *out, const bench_report *report, bool markdown)
{
    const skv_profile *names = &report->row[0].phases;
    const char *heads[TABLE_COLUMNS] = {"law", ">particles", ">threads"};
    char name[TABLE_COLUMNS][TABLE_CELL];
    int count = 3;
    for (int i = 0; i < names->count && count < TABLE_COLUMNS - 3; i++, count++) {
        snprintf(name[count], TABLE_CELL, ">%s", names->name[i]);
        heads[count] = name[count];
    }
    heads[count++] = ">rest";
    heads[count++] = ">sum";
    table t;
    table_begin(&t, out, markdown, "Phases in the pool, ns a particle and substep", heads);
    for (int law = 0; law < 2; law++)
        for (int i = 0; i < report->count; i++) {
            const bench_row *row = &report->row[i];
            if ((int)row->what.law == law && strcmp(row->what.scene, "pool") == 0 &&
                row->what.viscous == bench_usual_viscosity(row->what.law) &&
                (report->only || row->what.particles == 3000 || row->what.particles == 10000 ||
                 row->what.particles == 100000 || row->what.particles == 1000000))
                phase_row(&t, row);
        }
    table_end(&t);
}

/* ---- Edits ----------------------------------------------------------------------------------- */

static void write_edits(FILE *out, const bench_report *report, bool markdown)
{
    static const char *const heads[] = {"edit",      ">particles", ">threads",
                                        ">shortest", ">median",    NULL};
    table t;
    table_begin(&t, out, markdown, "Edits while a world of 1024 x 576 pixels runs, ms a frame",
                heads);
    for (int i = 0; i < BENCH_EDITS; i++) {
        const bench_edit *edit = &report->edit[i];
        table_row(&t);
        table_cell(&t, "%s", edit->name);
        table_cell(&t, "%d", edit->particles);
        table_cell(&t, "%d", edit->threads);
        table_number(&t, 1e3 * edit->time.minimum, -3);
        table_number(&t, 1e3 * edit->time.median, -3);
    }
    table_end(&t);
}

/* ---- The app's frames ------------------------------------------------------------------------ */

static void write_frames(FILE *out, const bench_report *report, bool markdown)
{
    static const char *const heads[] = {"what",    ">particles", ">threads",   ">shortest",
                                        ">median", ">longest",   ">processor", NULL};
    table t;
    table_begin(&t, out, markdown, "A frame of the app, ms", heads);
    for (int i = 0; i < report->frame_count; i++) {
        const bench_frame *frame = &report->frame[i];
        table_row(&t);
        table_cell(&t, "%s", frame->name);
        table_cell(&t, "%d", frame->particles);
        table_cell(&t, "%d", frame->threads);
        const double times[] = {frame->time.minimum, frame->time.median, frame->longest,
                                frame->processor};
        for (size_t k = 0; k < sizeof times / sizeof *times; k++)
            table_number(&t, 1e3 * times[k], -3);
    }
    table_end(&t);
    table_note(out,
               "processor: of all threads, the least; of issue and the face's calls, that of "
               "the face's thread.\nissue: a picture of 640 x 360 pixels, drawn and read back.");
}

/* ---- Another method -------------------------------------------------------------------------- */

static void write_rivals(FILE *out, const bench_report *report, bool markdown)
{
    static const char *const heads[] = {"method",  "scene",  ">particles", ">steps", ">shortest",
                                        ">median", ">level", ">speed",     NULL};
    table t;
    table_begin(&t, out, markdown, "Beside FLIP, one thread, after 5 s: ms a frame", heads);
    for (int i = 0; i < report->rival_count; i++) {
        const bench_rival *rival = &report->rival[i];
        table_row(&t);
        table_cell(&t, "%s", rival->method);
        table_cell(&t, "%s", rival->scene);
        table_cell(&t, "%d", rival->particles);
        table_cell(&t, "%d", rival->steps);
        table_number(&t, 1e3 * rival->time.minimum, -3);
        table_number(&t, 1e3 * rival->time.median, -3);
        table_number(&t, rival->level, 3);
        table_number(&t, rival->speed, 4);
    }
    table_end(&t);
    if (report->rival_count)
        table_note(out,
                   "level: how high the water stands, 1: as much of it as was drawn; speed: rms, "
                   "m/s, 0: at rest.\nFLIP is as simple as it gets, with two steps a frame and "
                   "thirty sweeps each, without bodies, walls or surface tension.");
}

/* ---- The thesis' tables ---------------------------------------------------------------------- */

/* Milliseconds of what the thesis calls a frame. Its law takes one step a frame; the calibrated law
 * takes the substeps of 1/60 s. */
static double frame(const bench_row *row)
{
    if (!row)
        return NAN;
    return 1e3 * row->fast.minimum * (row->what.law == SKV_LAW_CLAVET ? 1 : row->substeps);
}

static double frame_of(const bench_report *report, int scene, skv_law law, bool viscous,
                       int particles, int threads)
{
    const bench_case what = {bench_scenes[scene], law, viscous, particles};
    return frame(bench_find(report, &what, threads));
}

static void write_threading(FILE *out, const bench_report *report, bool markdown)
{
    static const struct {
        double one, four, factor;
    } thesis[2][4] = {{{36, 11, 3.3}, {34, 10, 3.4}, {24, 8.1, 3.0}, {50, 15, 3.3}},
                      {{32, 11, 2.9}, {32, 10, 3.2}, {23, 8.5, 2.7}, {42, 14, 3.0}}};
    static const struct {
        skv_law law;
        bool viscous;
    } set[4] = {{SKV_LAW_CLAVET, true},
                {SKV_LAW_CLAVET, false},
                {SKV_LAW_CALIBRATED, false},
                {SKV_LAW_CALIBRATED, true}};
    static const char *const heads[] = {"test",        ">Tegra 3 x1",    ">Tegra 3 x4",
                                        ">factor",     "our parameters", ">here x1",
                                        ">here x all", ">factor",        NULL};
    table t;
    table_begin(&t, out, markdown,
                "Table 4.1 of the thesis: 3000 particles, ms a frame, and the gain from threads",
                heads);
    for (int scene = 0; scene < 2; scene++)
        for (int i = 0; i < 4; i++) {
            const bench_case what = {bench_scenes[scene], set[i].law, set[i].viscous, 3000};
            double one = frame(bench_find(report, &what, 1));
            double all = report->threads > 1 ? frame(bench_find(report, &what, 2)) : NAN;
            table_row(&t);
            table_cell(&t, "%s test %d", scene ? "dynamic" : "static", i + 1);
            table_number(&t, thesis[scene][i].one, -2);
            table_number(&t, thesis[scene][i].four, -2);
            table_number(&t, thesis[scene][i].factor, 1);
            table_cell(&t, "%s", fluid_name(&what));
            table_number(&t, one, -3);
            table_number(&t, all, -3);
            table_number(&t, one / all, 2);
        }
    table_end(&t);
    table_note(out, "A frame of clavet is one substep, as in the thesis (slow motion); a frame of "
                    "calibrated is 1/60 s in real time.\nThe thesis does not say what its four "
                    "sets of parameters were.");
}

static void write_counts(FILE *out, const bench_report *report, bool markdown)
{
    static const struct {
        int particles;
        double rest, moving;
    } thesis[] = {{2000, 6.9, 6.3}, {2500, 8.7, 8.3}, {3000, 11, 10}, {3500, 13.5, 13},
                  {4000, 16, 15},   {4500, 18.5, 17}, {5000, 21, 21}};
    static const char *const heads[] = {
        ">particles", ">Tegra 3 static",    ">dynamic", ">clavet static",
        ">dynamic",   ">calibrated static", ">dynamic", NULL};
    table t;
    table_begin(&t, out, markdown,
                "Table 4.2 of the thesis: ms a frame on all threads, by number of particles",
                heads);
    for (size_t i = 0; i < sizeof thesis / sizeof *thesis; i++) {
        table_row(&t);
        table_cell(&t, "%d", thesis[i].particles);
        table_number(&t, thesis[i].rest, 1);
        table_number(&t, thesis[i].moving, 1);
        for (int law = SKV_LAW_CLAVET; law >= SKV_LAW_CALIBRATED; law--)
            for (int scene = 0; scene < 2; scene++)
                table_number(&t,
                             frame_of(report, scene, (skv_law)law,
                                      bench_usual_viscosity((skv_law)law), thesis[i].particles, 2),
                             -3);
    }
    table_end(&t);
}

void bench_write_tables(FILE *out, const bench_report *report, bool markdown)
{
    fprintf(out, "%s, %s, %d thread%s, %s, skvalp %s%s", report->cpu, report->instruction_set,
            report->threads, report->threads == 1 ? "" : "s", report->compiler, skv_version(),
            report->quick ? ", quick" : "");
    if (isfinite(report->load))
        fprintf(out, ", load %.1f before", report->load);
    fputc('\n', out);
    for (int scene = 0; scene < 2; scene++)
        write_scene(out, report, markdown, bench_scenes[scene]);
    table_note(out, "ns: nanoseconds a particle and substep, the shortest time and the median; x1: "
                    "one thread.\nreference: the same for the reference solver; ratio: how many "
                    "times as long it takes, with as many threads.\nbytes: a particle, of all "
                    "arrays by particle, the world's and the solver's; kept: what a thread "
                    "keeps of the rows at work, apart from these.");
    write_companies(out, report, markdown);
    write_budget(out, report, markdown);
    write_phases(out, report, markdown);
    write_edits(out, report, markdown);
    write_frames(out, report, markdown);
    write_rivals(out, report, markdown);
    if (!report->only) {
        write_threading(out, report, markdown);
        write_counts(out, report, markdown);
    }
}
