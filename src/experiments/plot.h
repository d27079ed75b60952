/* Curves, and their picture: an SVG of points, lines, axes and a legend. */
#ifndef SKV_EXPERIMENTS_PLOT_H
#define SKV_EXPERIMENTS_PLOT_H

#include "skvalp/experiments.h"

enum { MAX_CURVES = 8 };
/* Of the picture, pixels. */
enum { PLOT_WIDTH = 640, PLOT_HEIGHT = 400 };

typedef struct curve {
    char label[48];
    skv_curve_style style;
    int count, capacity;
    double *x, *y;
} curve;

/* Owned by its report. Curves past `count` keep their memory for the next that begins. */
typedef struct skv_plot {
    const char *title, *x_label, *y_label; /* with units: "t (s)"; static texts */
    curve curves[MAX_CURVES];
    int count;
    bool failed; /* memory ran out: a curve is not complete */
} skv_plot;

/* Marks a label for translators where it is not written in the call that begins its curve
 * (scripts/update-po.sh reads both). */
#define PLOT_LABEL(text) text

/* Starts a curve; the points that follow belong to it. */
void skv_plot_begin(skv_plot *p, const char *label, skv_curve_style style);
void skv_plot_point(skv_plot *p, double x, double y);
/* A curve of theory: a swing from `start` at time 0, until `time`. */
void skv_plot_swing(skv_plot *p, const char *label, double start, double period, double time);
/* Takes curves away until `count` are left. */
void skv_plot_cut(skv_plot *p, int count);
/* The i-th curve, i below `count`. */
skv_curve skv_plot_curve(const skv_plot *p, int i);
void skv_plot_free(skv_plot *p);

skv_result skv_plot_write_svg(const skv_plot *p, skv_write *write, void *user, skv_error *error);
skv_result skv_plot_write_csv(const skv_plot *p, skv_write *write, void *user, skv_error *error);

#endif
