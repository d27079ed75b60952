/* Lab run: an experiment on a thread of its own, with pictures and curves as it goes. */
#ifndef SKVALP_PLAY_LAB_RUN_H
#define SKVALP_PLAY_LAB_RUN_H

#include <gtk/gtk.h>
#include <skvalp/render.h>

#include "plot.h"
#include "view.h"

/* A moment of the run, on the main loop; valid during the call. */
typedef struct PlayLabNews {
    double share;        /* how far it is */
    GdkTexture *picture; /* null: none was made */
    const PlayCurve *curves;
    int curve_count;
    bool ended;
    const char *error;   /* it failed; null otherwise */
    const char *results; /* at the end: a line for each quantity */
} PlayLabNews;

typedef void PlayLabShow(const PlayLabNews *news, gpointer user);

/* Runs experiment number `experiment` with as many particles as are chosen (skv_lab_options) and
 * shows it, until it ends or `stop` is cancelled: `show` is not called any more then. */
void play_lab_run(int experiment, int particles, const skv_render_style *style, GCancellable *stop,
                  PlayLabShow *show, gpointer user);

/* Opens the set-up of an experiment, by its name, to play with, with as many as are chosen. */
void play_lab_open(const char *experiment, PlayView *view);

#endif
