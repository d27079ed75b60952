/* The rig of an experiment: its world, built as a scene of solids and water, its lab, and the
 * clock that tells how far it is.
 *
 * The rig keeps the first failure. After it every call returns without effect and readings are
 * NaN, so an experiment is written down as if nothing could go wrong.
 */
#ifndef SKV_EXPERIMENTS_RIG_H
#define SKV_EXPERIMENTS_RIG_H

#include "experiments/parameters.h"
#include "experiments/plan.h"
#include "skvalp/measure.h"
#include "skvalp/world.h"

enum { MAX_OVERRIDES = 4 };

/* A value of the fluid that the experiment itself decides. */
typedef struct override {
    const char *path;
    char value[32];
} override;

typedef struct rig rig;

/* Draws what an experiment has measured up to now into its plot, from `set_up`, the experiment's
 * own notes, and writes down the conditions that go with it. */
typedef void draw_curves(const rig *s, const void *set_up, findings *found);

struct rig {
    const experiment *experiment;
    const skv_lab_options *options; /* may be null */
    settings settings;
    override overrides[MAX_OVERRIDES];
    int override_count;
    double spacing, h; /* of the world, m */
    double total;      /* simulated seconds to come in all, for the progress */
    double done;
    skv_world *world; /* null until it is built */
    skv_lab *lab;
    findings *found;
    draw_curves *draw; /* null: the experiment adds its points itself, or it is too early */
    const void *set_up;
    struct foresight *foresight; /* for the observer; null before it is needed */
    /* Where the last plan goes if only that is asked for: its world stays empty, no frame is
     * stepped, readings are NaN, and it ends with SKV_STOPPED where measuring begins, at the second
     * wait at the latest. Else null. */
    rig_plan *sketch;
    /* Whether not even the world of that plan is made: it ends with SKV_STOPPED where it would be,
     * and only how many particles the passages need is looked at after that. */
    bool outline;
    double enough; /* particles, as the setting counts them, for the narrowest passage so far */
    int particles; /* with which the world began */
    /* Of the experiment's own world, once another stands beside it; 0 before. */
    int own_substeps;
    double own_seconds;
    skv_result result;
    skv_error *error;
};

/* Starts with an experiment's settings and no world. */
void skv_rig_open(rig *s, const experiment *e, const skv_lab_options *options, findings *found,
                  skv_error *error);
/* Writes the plan in `sketch` as a scene to play with. */
skv_result skv_rig_write(const rig *s, skv_write *write, void *user, skv_error *error);
/* Frees everything; returns the first failure, or SKV_OK. */
skv_result skv_rig_close(rig *s);

bool skv_rig_ok(const rig *s);
/* Keeps the result of something that the experiment did by itself, with the rig's error. */
void skv_rig_keep(rig *s, skv_result result);
/* Fails with a message unless a condition holds that concerns several parameters. */
void skv_rig_require(rig *s, bool condition, const char *message);

/* A parameter of the experiment, by its place in the table: its value, and as a length, which the
 * scale multiplies. */
double skv_rig_value(const rig *s, int own);
double skv_rig_length(const rig *s, int own);
double skv_rig_gravity(const rig *s);
/* How many times as long everything takes as at scale 1 under 9.81 m/s^2, for times grow with the
 * root of a length over gravity, and how many times as fast everything moves (W. Froude's law). */
double skv_rig_pace(const rig *s);
double skv_rig_speed(const rig *s);
/* Overrides what the settings say of the fluid: "fluid.viscosity". Before skv_rig_build. */
void skv_rig_set(rig *s, const char *path, double value);

/* Builds the world of a plan and fills it; a world that was there is taken away. */
void skv_rig_build(rig *s, const rig_plan *plan);
/* Puts the walls of a plan around the fluid that is there, as a hand that edits them would: how a
 * gate is opened. */
void skv_rig_rebuild(rig *s, const rig_plan *plan);
/* Builds the world of a plan for what is measured beside the experiment itself, with so many
 * particles as far apart as those of the first. What is reported of the world stays the first's. */
void skv_rig_build_beside(rig *s, const rig_plan *plan, double particles);
/* Fails unless a passage that is `share` times as wide as a parameter's length holds at least six
 * particles side by side. */
void skv_rig_check_passage(rig *s, int own, double share);

/* Of the world that stands: density in kg/m^2, and the area that its particles were given, m^2. */
double skv_rig_density(const rig *s);
double skv_rig_area(const rig *s);

/* Adds an instrument between two points. */
skv_instrument skv_rig_add(rig *s, skv_instrument_kind kind, double x0, double y0, double x1,
                           double y1, double window);
double skv_rig_read(const rig *s, skv_instrument id, int channel);
/* The mean of what several level gauges read. */
double skv_rig_mean_level(const rig *s, const skv_instrument *gauges, int count);
/* As skv_lab_history. */
int skv_rig_history(const rig *s, skv_instrument id, int channel, double *times, double *values,
                    int capacity);

/* Adds the history of a channel to the plot's last curve, every so many-th sample. */
void skv_rig_trace(const rig *s, skv_instrument id, int channel, int every);

/* Names the function that draws the curves: whoever observes the experiment sees them grow. */
void skv_rig_show(rig *s, draw_curves *draw, const void *set_up);
/* Draws them for good, at the end. */
void skv_rig_draw(rig *s);

/* Lets `seconds` pass in frames of 1/60 s: without reading the instruments, and reading them after
 * every frame. */
void skv_rig_wait(rig *s, double seconds);
void skv_rig_watch(rig *s, double seconds);
/* Reads the instruments now. */
void skv_rig_sample(rig *s);

#endif
