/* Measuring: what a substep costs, in two scenes, with both pressure laws, from thousands to a
 * million particles, beside the reference solver on the same particles; and in pools that hold more
 * than one fluid.
 *
 * A case is a scene, a law and a number of particles; each case gives one row per number of
 * threads, 1 and all. docs/performance.md says how the times are taken and what they came to.
 */
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#include <stdio.h>

#include "skvalp/scene.h"

/* Above this number of particles the reference solver is left out. */
#define BENCH_REFERENCE_MOST 100000

/* A frame of 1/60 s, ms. */
#define BENCH_FRAME_MS (1000.0 / 60)

typedef struct bench_options {
    bool quick;    /* up to 100 000 particles, fewer rounds */
    int particles; /* measure this number only; 0: all that the tables ask for */
    int threads;   /* what "all threads" means; 0: one per physical core */
} bench_options;

typedef struct bench_case {
    const char *scene; /* "pool": at rest; "dam-break": in motion; or one of company.h */
    skv_law law;
    bool viscous;  /* with pair viscosity */
    int particles; /* as asked for */
} bench_case;

/* Seconds a substep, over the rounds. */
typedef struct bench_time {
    double minimum, median;
} bench_time;

typedef struct bench_row {
    bench_case what;
    int particles; /* as counted */
    int threads;
    int substeps; /* a 1/60 s frame */
    double neighbours;
    bench_time fast;
    bench_time reference; /* NaN where it was left out: of many particles, and of company.h */
    double bytes;         /* a particle, of the particles' arrays */
    double kept_bytes;    /* a particle, of the pairs that are kept */
    double grid_bytes;    /* a particle, of the grid and of each thread's counts */
    skv_profile phases;   /* seconds a substep of the fastest round */
} bench_row;

/* What is done to a world of 1024 x 576 pixels while it runs. */
enum { BENCH_EDITS = 4 };
typedef struct bench_edit {
    const char *name; /* null: not measured */
    int particles;    /* as asked for */
    int threads;
    bench_time time; /* seconds a frame */
} bench_edit;

/* What the app does for a picture. */
enum { BENCH_FRAMES = 8 };
typedef struct bench_frame {
    const char *name;
    int particles;
    int threads;
    bench_time time;           /* s */
    double longest, processor; /* s; processor: time of all its threads, the least */
} bench_frame;

/* Five seconds of a scene by our method and by another one, on one thread. */
enum { BENCH_RIVALS = 8 };
typedef struct bench_rival {
    const char *method, *scene;
    int particles;
    int steps;       /* a frame, at the end */
    bench_time time; /* seconds a frame, of the last second */
    double level;    /* how high the water stands in the end, 1: as high as it was drawn */
    double speed;    /* m/s, rms, in the end */
} bench_rival;

typedef struct bench_report {
    char cpu[96];
    char compiler[64];
    const char *instruction_set;
    double load; /* processes that wanted to run in the minute before; NaN where it is unknown */
    int threads; /* of the rows that are not for one thread */
    bool quick;
    int only; /* the one number of particles that was asked for; 0: all tables */
    int lost; /* particles that escaped or are not finite: the figures are worth nothing */
    int count;
    bench_row *row;
    bench_edit edit[BENCH_EDITS];
    int frame_count;
    bench_frame frame[BENCH_FRAMES];
    int rival_count;
    bench_rival rival[BENCH_RIVALS];
} bench_report;

/* Called before each case and each of its rounds; `done` is the share of the work that is, 0..1. */
typedef void bench_progress(const bench_case *what, double done, void *user);

/* Measures everything; takes under a minute with `quick` and minutes without. `report` needs
 * bench_report_free afterwards, also on failure. */
skv_result bench_measure(const bench_options *options, bench_progress *progress, void *user,
                         bench_report *report, skv_error *error);
void bench_report_free(bench_report *report);

/* Measures what edits cost, for the same report; takes seconds. */
skv_result bench_measure_edits(const bench_options *options, bench_report *report,
                               skv_error *error);

/* Measures what a frame of the app costs, for the same report; takes seconds. */
skv_result bench_measure_frames(const bench_options *options, bench_report *report,
                                skv_error *error);

/* Measures another method beside ours, for the same report; takes seconds. */
skv_result bench_measure_rivals(const bench_options *options, bench_report *report,
                                skv_error *error);

/* The row of a case, or null. `threads`: 1, or anything else for all. */
const bench_row *bench_find(const bench_report *report, const bench_case *what, int threads);

/* Nanoseconds a particle and substep. */
double bench_ns(const bench_row *row, double seconds);
/* Milliseconds that the substeps of 1/60 s take. */
double bench_frame_ms(const bench_row *row);
/* How many particles like these take 1/60 s for it, between two numbers that were measured; NaN
 * where all of them take less, or all more. */
double bench_in_real_time(const bench_report *report, const bench_case *like, int threads);
/* How many times as long the reference takes; NaN where it was left out. */
double bench_ratio(const bench_row *row);
/* How many times as fast as one thread; NaN on one thread. */
double bench_speedup(const bench_report *report, const bench_row *row);

/* What bench_measure has filled: as tables to read, as aligned text or as Markdown; as CSV, one
 * line a row; and the cost against the number of particles as a picture in SVG. */
void bench_write_tables(FILE *out, const bench_report *report, bool markdown);
void bench_write_csv(FILE *out, const bench_report *report);
void bench_write_plot(FILE *out, const bench_report *report);

#endif
