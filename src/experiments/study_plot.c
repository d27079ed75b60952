/* A study's picture: panels, one below the other, with what was measured against what was swept.
 *
 * Invariant: the points of a panel stand in the order of what is swept, whatever order it was
 * given in, so the line of theory never turns back.
 */
#include "experiments/study.h"

#include "base/assert.h"
#include "base/memory.h"
#include "base/unit.h"

#include <string.h>

/* A picture of more is no picture any more, and a browser needs long for it. */
enum { MOST_PANELS = 48 };

typedef struct panels {
    const skv_study *study;
    int along;     /* the sweep that runs along the panels' axis */
    double *place; /* its values */
    int *order;    /* their numbers, smallest value first */
} panels;

static bool is_number(const skv_field *field)
{
    return field->type == SKV_FIELD_NUMBER || field->type == SKV_FIELD_INTEGER;
}

/* Ranges are in order, forward or back; lists are short. */
static void sort(panels *p, int count)
{
    bool falls = p->place[0] > p->place[count - 1];
    for (int i = 0; i < count; i++) {
        int next = falls ? count - 1 - i : i, at = i;
        for (; at > 0 && p->place[p->order[at - 1]] > p->place[next]; at--)
            p->order[at] = p->order[at - 1];
        p->order[at] = next;
    }
}

static skv_result open_panels(panels *p, const skv_study *study, skv_error *error)
{
    *p = (panels){.study = study};
    while (p->along < study->sweep_count && !is_number(study->sweeps[p->along].field))
        p->along++;
    if (p->along == study->sweep_count)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "plot: no number is swept that it could be drawn along; read the table");
    const sweep *s = &study->sweeps[p->along];
    int all = study->runs / s->count * study->experiment->count;
    if (all > MOST_PANELS)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "plot: it would have %d panels, and %d are allowed; take fewer values of "
                        "what is swept besides %s",
                        all, MOST_PANELS, s->field->path);
    p->place = skv_calloc((size_t)s->count, sizeof *p->place);
    p->order = skv_calloc((size_t)s->count, sizeof *p->order);
    if (!p->place || !p->order)
        return skv_fail(error, SKV_ERROR_MEMORY, "plot: out of memory");
    for (int i = 0; i < s->count; i++)
        skv_parse_number(s->values[i], &p->place[i]);
    sort(p, s->count);
    return SKV_OK;
}

/* The run at a place along the axis, in a combination of the other sweeps. */
static int run_at(const panels *p, int combination, int place)
{
    int stride = skv_study_stride(p->study, p->along);
    int before = combination / stride, behind = combination % stride;
    return (before * p->study->sweeps[p->along].count + place) * stride + behind;
}

static void say_title(const panels *p, int run, char *title, size_t room)
{
    const skv_study *s = p->study;
    size_t length = skv_format(title, room, "%s", s->experiment->info.title);
    const char *joint = ": ";
    for (int i = 0; i < s->sweep_count; i++) {
        if (i == p->along || length >= room)
            continue;
        length +=
            skv_format(title + length, room - length, "%s%s=%s", joint, s->sweeps[i].field->path,
                       s->sweeps[i].values[skv_study_place(s, run, i)]);
        joint = ", ";
    }
}

static void say_label(const char *name, const char *unit, char *text, size_t room)
{
    char spelt[24];
    skv_spell_unit(unit, spelt, sizeof spelt);
    skv_format(text, room, *unit ? "%s (%s)" : "%s", name, spelt);
}

static void draw_points(const panels *p, int combination, int row, bool theory, skv_plot *plot)
{
    for (int i = 0; i < p->study->sweeps[p->along].count; i++) {
        const skv_study_row *rows = p->study->rows[run_at(p, combination, p->order[i])];
        /* Where the theory is 0, the bound is what counts, and there is nothing to draw. */
        if (rows && (!theory || rows[row].row.theory != 0))
            skv_plot_point(plot, p->place[p->order[i]],
                           theory ? rows[row].row.theory : rows[row].row.measured);
    }
}

static skv_result write_panel(const panels *p, int combination, int row, skv_write *write,
                              void *user, skv_error *error)
{
    const quantity *q = &p->study->experiment->quantities[row];
    const skv_field *along = p->study->sweeps[p->along].field;
    char title[192], x_label[96], y_label[96];
    say_title(p, run_at(p, combination, 0), title, sizeof title);
    say_label(along->path, along->unit, x_label, sizeof x_label);
    say_label(q->name, q->unit, y_label, sizeof y_label);
    skv_plot plot = {.title = title, .x_label = x_label, .y_label = y_label};
    skv_plot_begin(&plot, "measured", SKV_CURVE_DOTS);
    draw_points(p, combination, row, false, &plot);
    skv_plot_begin(&plot, "theory", SKV_CURVE_THEORY);
    draw_points(p, combination, row, true, &plot);
    if (plot.curves[1].count == 0)
        skv_plot_cut(&plot, 1);
    skv_result result = plot.failed ? skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a plot")
                                    : skv_plot_write_svg(&plot, write, user, error);
    skv_plot_free(&plot);
    return result;
}

static bool say(skv_write *write, void *user, const char *text)
{
    return write(text, strlen(text), user);
}

static skv_result write_panels(const panels *p, skv_write *write, void *user, skv_error *error)
{
    const int combinations = p->study->runs / p->study->sweeps[p->along].count;
    const int all = combinations * p->study->experiment->count;
    char text[192];
    skv_format(text, sizeof text,
               "<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' viewBox='0 0 %d "
               "%d'>\n",
               PLOT_WIDTH, all * PLOT_HEIGHT, PLOT_WIDTH, all * PLOT_HEIGHT);
    bool written = say(write, user, text);
    skv_result result = SKV_OK;
    for (int i = 0; i < all && written && result == SKV_OK; i++) {
        skv_format(text, sizeof text, "<g transform='translate(0 %d)'>\n", i * PLOT_HEIGHT);
        written = say(write, user, text);
        result = write_panel(p, i % combinations, i / combinations, write, user, error);
        written = written && say(write, user, "</g>\n");
    }
    written = written && say(write, user, "</svg>\n");
    if (result == SKV_OK && !written)
        result = skv_fail(error, SKV_ERROR_FILE, "plot: it could not be written");
    return result;
}

skv_result skv_study_plot(const skv_study *study, skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(study && write, SKV_ERROR_VALUE);
    panels p;
    skv_result result = open_panels(&p, study, error);
    if (p.place && p.order)
        result = write_panels(&p, write, user, error);
    skv_free(p.place);
    skv_free(p.order);
    return result;
}
