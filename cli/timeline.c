/* Cuts the simulated time into steps.
 *
 * Invariant: a run passes exactly through every frame k/60, every moment j*every and the end, each
 * computed from its number, so no rounding adds up. From frame to frame the step is the same float
 * everywhere: a trace whose moments lie on frames leaves the run, bit for bit, as it is.
 */
#include "timeline.h"

#include <math.h>

static const double frames_per_second = 60.0;

static bool same_moment(double a, double b)
{
    return fabs(a - b) < TIMELINE_EPSILON;
}

run_timeline timeline_start(double end, double every, double snapshot)
{
    return (run_timeline){.end = end,
                          .every = every,
                          .at_frame = true,
                          .at_trace = true,
                          .snapshot = snapshot,
                          .at_snapshot = same_moment(snapshot, 0),
                          .at_end = same_moment(end, 0)};
}

float timeline_next(run_timeline *timeline)
{
    double before = timeline->time;
    bool from_frame = timeline->at_frame;
    double frame = (double)(timeline->frame + 1) / frames_per_second;
    double trace = timeline->every > 0 ? (double)(timeline->trace + 1) * timeline->every : INFINITY;

    bool passed = timeline->snapshot < before + TIMELINE_EPSILON;
    double snapshot = passed ? INFINITY : timeline->snapshot;

    double next = fmin(fmin(frame, trace), fmin(snapshot, timeline->end));
    timeline->at_frame = same_moment(frame, next);
    timeline->at_trace = same_moment(trace, next);
    timeline->at_snapshot = same_moment(snapshot, next);
    timeline->at_end = same_moment(timeline->end, next);
    timeline->frame += timeline->at_frame;
    timeline->trace += timeline->at_trace;
    timeline->time = timeline->at_frame ? frame : next;
    return (float)(from_frame && timeline->at_frame ? 1.0 / frames_per_second
                                                    : timeline->time - before);
}
