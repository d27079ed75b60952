/* A plot: curves over axes with figures, drawn by the app in the colours of its theme. */
#ifndef SKVALP_PLAY_PLOT_H
#define SKVALP_PLAY_PLOT_H

#include <adwaita.h>

G_BEGIN_DECLS

#define PLAY_TYPE_PLOT (play_plot_get_type())
G_DECLARE_FINAL_TYPE(PlayPlot, play_plot, PLAY, PLOT, GtkWidget)

typedef enum PlayCurveStyle {
    PLAY_CURVE_LINE,
    PLAY_CURVE_DOTS,
    PLAY_CURVE_THEORY /* dashed */
} PlayCurveStyle;

typedef struct PlayCurve {
    const char *label;
    PlayCurveStyle style;
    int count;
    const double *x, *y; /* what is not finite is a gap */
} PlayCurve;

/* Shows curves, which are copied. Labels name the axes, with their units; values along y are
 * divided by `unit`. */
void play_plot_show(PlayPlot *plot, const char *x_label, const char *y_label, double unit,
                    const PlayCurve *curves, int count);

/* What is shown, as CSV: series, and the two axes. To be freed. */
GString *play_plot_csv(PlayPlot *plot);

G_END_DECLS

#endif
