/* The stage of an experiment: its world, built from convex solids and boxes of water, its lab, and
 * the clock that tells how far it is. */
#ifndef SKV_EXPERIMENTS_STAGE_H
#define SKV_EXPERIMENTS_STAGE_H

#include "experiments/parameters.h"
#include "skvalp/measure.h"

enum { MAX_CORNERS = 6, MAX_SOLIDS = 8 };

/* A convex solid: its corners counterclockwise, in metres. */
typedef struct solid {
    int corners;
    double x[MAX_CORNERS], y[MAX_CORNERS];
} solid;

solid skv_solid_box(double x0, double y0, double x1, double y1);

/* What a stage is to look like. */
typedef struct stage_plan {
    double width, height; /* of the closed world, m */
    solid solids[MAX_SOLIDS];
    int solid_count;
    unsigned open_sides;
    double depth; /* deepest water to expect, m */
    double gravity_x, gravity_y;
} stage_plan;

typedef struct stage {
    const settings *settings;
    const skv_lab_options *options;
    skv_fluid_def fluid; /* experiments may change what the settings say, before skv_stage_build */
    double spacing, h;   /* m */
    double total;        /* simulated seconds to come in all, for the progress */
    double done;
    skv_world *world;
    skv_lab *lab;
} stage;

/* Chooses the spacing with which `area` square metres hold `share` times the wanted particles. */
void skv_stage_choose_spacing(stage *s, double area, double share);

/* Builds the world of a plan; a world that was there is taken away. */
skv_result skv_stage_build(stage *s, const stage_plan *plan, skv_error *error);

/* The same, but the particles of the world that was there are put into the new one, with their
 * velocities: how a gate is opened. */
skv_result skv_stage_rebuild(stage *s, const stage_plan *plan, skv_error *error);

void skv_stage_close(stage *s);

/* Fills a box; `inside` may be null. */
skv_result skv_stage_fill(stage *s, double x0, double y0, double x1, double y1, skv_inside *inside,
                          void *user, skv_error *error);

/* Adds an instrument between two points. */
skv_result skv_stage_add(stage *s, skv_instrument_kind kind, double x0, double y0, double x1,
                         double y1, double window, skv_instrument *id, skv_error *error);

/* The mean of what several level gauges read. */
double skv_stage_mean_level(const stage *s, const skv_instrument *gauges, int count);

/* Lets one frame of 1/60 s pass, and reads the instruments. */
skv_result skv_stage_frame(stage *s, skv_error *error);
/* The same for `seconds`, without reading them. */
skv_result skv_stage_wait(stage *s, double seconds, skv_error *error);

/* Fails unless a passage of this width holds at least six particles side by side. */
skv_result skv_stage_check_passage(const stage *s, const char *what, double width,
                                   skv_error *error);

#endif
