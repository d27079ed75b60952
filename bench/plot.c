/* Draws the cost of a particle and substep against the number of particles, both logarithmic, as an
 * SVG picture that follows the reader's light or dark theme.
 *
 * Invariant: a point's place depends on its own figures only; axes, lines and labels are made from
 * the same two functions, so a label always stands at the end of its line.
 */
#include <math.h>
#include <string.h>

#include "plan.h"

enum { WIDTH = 1080, HEIGHT = 520, TOP = 84, BOTTOM = 52, LEFT = 62, PANEL = 326, STEP = 535 };

/* One panel: a scene. */
typedef struct panel {
    FILE *out;
    const bench_report *report;
    const char *scene;
    int left;               /* of its plot area, px */
    double least, most;     /* ns, of the axis */
    double fewest, biggest; /* particles, of the axis */
} panel;

/* A line: which figure of which rows. */
typedef struct line {
    skv_law law;
    int threads; /* 1, 2: all */
    bool reference;
} line;

static const line lines[] = {
    {SKV_LAW_CLAVET, 1, true},  {SKV_LAW_CALIBRATED, 1, true},  {SKV_LAW_CALIBRATED, 1, false},
    {SKV_LAW_CLAVET, 1, false}, {SKV_LAW_CALIBRATED, 2, false}, {SKV_LAW_CLAVET, 2, false},
};
enum { LINES = (int)(sizeof lines / sizeof lines[0]) };

static double place_x(const panel *p, double particles)
{
    return p->left + PANEL * log(particles / p->fewest) / log(p->biggest / p->fewest);
}

static double place_y(const panel *p, double ns)
{
    return TOP + (HEIGHT - TOP - BOTTOM) * log(p->most / ns) / log(p->most / p->least);
}

static double value_of(const line *l, const bench_row *row)
{
    return bench_ns(row, l->reference ? row->reference.minimum : row->fast.minimum);
}

static bool belongs(const panel *p, const line *l, const bench_row *row)
{
    int threads = l->threads == 1 ? 1 : p->report->threads;
    if (l->threads != 1 && threads == 1)
        return false;
    return strcmp(row->what.scene, p->scene) == 0 && row->what.law == l->law &&
           row->what.viscous == bench_usual_viscosity(l->law) && row->threads == threads &&
           bench_is_main_size(p->report, row->what.particles) && isfinite(value_of(l, row));
}

/* The row of a line with the fewest particles above `above`, or null. */
static const bench_row *next_point(const panel *p, const line *l, int above)
{
    const bench_row *next = NULL;
    for (int i = 0; i < p->report->count; i++) {
        const bench_row *row = &p->report->row[i];
        if (belongs(p, l, row) && row->particles > above &&
            (!next || row->particles < next->particles))
            next = row;
    }
    return next;
}

/* Plain colours, then those for a dark page: not every viewer knows CSS variables. */
static void write_style(FILE *out)
{
    fputs("<style>\n"
          "text { font: 13px system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif; fill: #1f2328; }\n"
          ".title { font-size: 17px; font-weight: 600; }\n"
          ".scene { font-size: 14px; font-weight: 600; }\n"
          ".ground { fill: #ffffff; }\n"
          ".quiet { fill: #59636e; }\n"
          ".grid { stroke: #e2e5e9; stroke-width: 1; }\n"
          "polyline { fill: none; stroke-width: 2; stroke-linejoin: round; }\n"
          ".all { stroke-dasharray: 7 4; }\n"
          ".reference { stroke-width: 1.5; stroke-dasharray: 2 4; }\n"
          "circle { fill: #ffffff; stroke-width: 2; }\n"
          "polyline.calibrated, circle.calibrated { stroke: #1a67b3; }\n"
          "polyline.clavet, circle.clavet { stroke: #bc4c00; }\n"
          "text.calibrated, circle.full.calibrated { fill: #1a67b3; }\n"
          "text.clavet, circle.full.clavet { fill: #bc4c00; }\n"
          ".thesis { fill: #1f2328; }\n"
          "@media (prefers-color-scheme: dark) {\n"
          "  text, .thesis { fill: #e6edf3; }\n"
          "  .ground, circle { fill: #0d1117; }\n"
          "  .quiet { fill: #9198a1; }\n"
          "  .grid { stroke: #2b313a; }\n"
          "  polyline.calibrated, circle.calibrated { stroke: #58a6ff; }\n"
          "  polyline.clavet, circle.clavet { stroke: #f0883e; }\n"
          "  text.calibrated, circle.full.calibrated { fill: #58a6ff; }\n"
          "  text.clavet, circle.full.clavet { fill: #f0883e; }\n"
          "}\n"
          "</style>\n",
          out);
}

static void write_count(FILE *out, int particles)
{
    if (particles >= 1000000)
        fprintf(out, "%g M", particles / 1e6);
    else
        fprintf(out, "%g k", particles / 1e3);
}

static void write_axes(const panel *p)
{
    double right = p->left + PANEL;
    for (int tick = 0; tick < 18; tick++) {
        static const double steps[] = {1, 2, 5};
        int decade = tick / 3;
        double ns = steps[tick % 3] * pow(10, decade), y = place_y(p, ns);
        if (ns < p->least * 0.999 || ns > p->most * 1.001)
            continue;
        fprintf(p->out,
                "<line class=\"grid\" x1=\"%d\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>"
                "<text class=\"quiet\" x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%g</text>\n",
                p->left, right, y, y, p->left - 8, y + 4, ns);
    }
    for (int i = 0; i < BENCH_SIZES; i++) {
        double x = place_x(p, bench_sizes[i]);
        if (x < p->left || x > right)
            continue;
        fprintf(p->out,
                "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\"/>"
                "<text class=\"quiet\" x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">",
                x, x, TOP, HEIGHT - BOTTOM, x, HEIGHT - BOTTOM + 19);
        write_count(p->out, bench_sizes[i]);
        fputs("</text>\n", p->out);
    }
    fprintf(p->out,
            "<text class=\"scene\" x=\"%d\" y=\"%d\">%s</text>\n"
            "<text class=\"quiet\" x=\"%d\" y=\"%d\" text-anchor=\"middle\">particles</text>\n",
            p->left, TOP - 14,
            strcmp(p->scene, "pool") == 0 ? "pool, at rest" : "dam break, in motion",
            p->left + PANEL / 2, HEIGHT - BOTTOM + 40);
}

static void write_line(const panel *p, const line *l)
{
    const char *law = skv_law_name(l->law);
    const char *kind = l->reference ? " reference" : l->threads == 1 ? "" : " all";
    const bench_row *row = next_point(p, l, 0);
    fprintf(p->out, "<polyline class=\"%s%s\" points=\"", law, kind);
    for (; row; row = next_point(p, l, row->particles))
        fprintf(p->out, "%.1f,%.1f ", place_x(p, row->particles), place_y(p, value_of(l, row)));
    fputs("\"/>\n", p->out);
    for (row = next_point(p, l, 0); row; row = next_point(p, l, row->particles))
        fprintf(p->out, "<circle class=\"%s%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%s\"/>\n", law,
                l->threads == 1 && !l->reference ? " full" : "", place_x(p, row->particles),
                place_y(p, value_of(l, row)), l->reference ? "2.5" : "3.5");
}

static void write_label(const panel *p, const line *l, double x, double y)
{
    fprintf(p->out, "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">%s", skv_law_name(l->law), x + 10,
            y + 4, skv_law_name(l->law));
    if (l->reference)
        fputs(", reference</text>\n", p->out);
    else
        fprintf(p->out, ", %d thread%s</text>\n", l->threads == 1 ? 1 : p->report->threads,
                l->threads == 1 ? "" : "s");
}

/* The labels stand at the ends of their lines, moved apart where these are close together. */
static void write_labels(const panel *p)
{
    const double apart = 16;
    double y[LINES], x[LINES];
    int order[LINES], count = 0;
    for (int i = 0; i < LINES; i++) {
        const bench_row *last = NULL, *row = next_point(p, &lines[i], 0);
        for (; row; row = next_point(p, &lines[i], row->particles))
            last = row;
        if (!last)
            continue;
        x[i] = place_x(p, last->particles);
        y[i] = place_y(p, value_of(&lines[i], last));
        int at = count++;
        for (; at > 0 && y[order[at - 1]] > y[i]; at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
    for (int k = 1; k < count; k++) {
        double gap = y[order[k]] - y[order[k - 1]];
        if (gap < apart) {
            y[order[k - 1]] -= (apart - gap) / 2;
            y[order[k]] += (apart - gap) / 2;
        }
    }
    for (int k = 1; k < count; k++)
        y[order[k]] = fmax(y[order[k]], y[order[k - 1]] + apart);
    for (int k = 0; k < count; k++)
        write_label(p, &lines[order[k]], x[order[k]], y[order[k]]);
}

/* What the thesis needed for 3000 particles on four cores of a Tegra 3 (its table 4.2). */
static double thesis_ns(const char *scene)
{
    return strcmp(scene, "pool") == 0 ? 11e6 / 3000 : 10e6 / 3000;
}

static void write_thesis(const panel *p)
{
    double x = place_x(p, 3000), y = place_y(p, thesis_ns(p->scene));
    fprintf(p->out,
            "<path class=\"thesis\" d=\"M%.1f %.1fl6 6l-6 6l-6 -6z\"/>"
            "<text class=\"quiet\" x=\"%.1f\" y=\"%.1f\">the thesis, 2013: four cores of a "
            "Tegra 3</text>\n",
            x, y - 6, x + 12, y + 4);
}

/* The axes' ranges, the same in both panels. */
static void set_ranges(panel *p)
{
    double fewest = 3000, biggest = 10000;
    p->least = 50;
    p->most = 5000;
    for (int i = 0; i < p->report->count; i++) {
        const bench_row *row = &p->report->row[i];
        double ns = bench_ns(row, row->fast.minimum);
        double reference = bench_ns(row, row->reference.minimum);
        if (bench_is_main_size(p->report, row->what.particles)) {
            fewest = fmin(fewest, row->particles);
            biggest = fmax(biggest, row->particles);
        }
        while (ns < p->least)
            p->least = p->least < 3 ? p->least / 2 : p->least / 2.5;
        while (isfinite(reference) && reference > p->most)
            p->most *= 2;
    }
    p->fewest = fewest / 1.15;
    p->biggest = biggest * 1.1;
}

void bench_write_plot(FILE *out, const bench_report *report)
{
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" role=\"img\" "
            "aria-label=\"Cost of a particle against the number of particles\">\n",
            WIDTH, HEIGHT);
    write_style(out);
    fprintf(out,
            "<rect class=\"ground\" width=\"%d\" height=\"%d\" rx=\"8\"/>\n"
            "<text class=\"title\" x=\"%d\" y=\"28\">Nanoseconds a particle and substep</text>\n"
            "<text class=\"quiet\" x=\"%d\" y=\"48\">%s, %s, %s</text>\n",
            WIDTH, HEIGHT, LEFT - 44, LEFT - 44, report->cpu, report->instruction_set,
            report->compiler);
    for (int i = 0; i < 2; i++) {
        panel p = {.out = out, .report = report, .scene = bench_scenes[i], .left = LEFT + STEP * i};
        set_ranges(&p);
        write_axes(&p);
        for (int k = 0; k < LINES; k++)
            if (next_point(&p, &lines[k], 0))
                write_line(&p, &lines[k]);
        write_labels(&p);
        write_thesis(&p);
    }
    fputs("</svg>\n", out);
}
