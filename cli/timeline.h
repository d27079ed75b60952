/* The moments of a run: 1/60 s frames, moments of the trace, that of the snapshot, and the end. */
#ifndef CLI_TIMELINE_H
#define CLI_TIMELINE_H

#include <stdbool.h>
#include <stdint.h>

/* Moments closer together than this are one. */
#define TIMELINE_EPSILON 1e-5

typedef struct run_timeline {
    double end;      /* s */
    double every;    /* s between the moments of the trace; 0: none */
    double snapshot; /* s; negative: none */
    /* The present moment. */
    double time;
    bool at_frame, at_trace, at_snapshot, at_end;
    int64_t frame, trace; /* the last ones reached */
} run_timeline;

/* Starts at t = 0, which is a frame and a moment of the trace. */
run_timeline timeline_start(double end, double every, double snapshot);

/* Goes to the next moment and returns the step that leads there, s; not to be called at the end. */
float timeline_next(run_timeline *timeline);

#endif
