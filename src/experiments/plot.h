/* Curves, and their picture: an SVG of points, lines, axes and a legend. */
#ifndef SKV_EXPERIMENTS_PLOT_H
#define SKV_EXPERIMENTS_PLOT_H

#include "skvalp/experiments.h"

enum { MAX_CURVES = 8 };

typedef enum curve_style { CURVE_DOTS, CURVE_RINGS, CURVE_LINE, CURVE_THEORY } curve_style;

typedef struct curve {
    char label[48];
    curve_style style;
    int count, capacity;
    double *x, *y;
} curve;

/* Owned by its report. */
typedef struct skv_plot {
    const char *title, *x_label, *y_label; /* with units: "t (s)"; static texts */
    curve curves[MAX_CURVES];
    int count;
    bool failed; /* memory ran out: a curve is not complete */
} skv_plot;

/* Starts a curve; the points that follow belong to it. */
void skv_plot_begin(skv_plot *p, const char *label, curve_style style);
void skv_plot_point(skv_plot *p, double x, double y);
/* A curve of theory: a swing from `start` at time 0, until `time`. */
void skv_plot_swing(skv_plot *p, const char *label, double start, double period, double time);
void skv_plot_free(skv_plot *p);

skv_result skv_plot_write_svg(const skv_plot *p, skv_write *write, void *user, skv_error *error);
skv_result skv_plot_write_csv(const skv_plot *p, skv_write *write, void *user, skv_error *error);

#endif
