/* From real time to whole frames. Invariant: what is due is less than a frame between two calls;
 * what does not fit into the budget is dropped, and shows in the factor. */
#include "session/pace.h"

#include <math.h>

#define FRAME_RATE     60.0
#define MOST_FRAMES    12  /* more were a jump, after a stall or where pictures take 0.2 s */
#define MEASURE_PERIOD 0.5 /* s */
#define BUDGET         (1.0 / 30)

skv_pace skv_pace_start(void)
{
    return (skv_pace){.speed = 1, .factor = 1};
}

/* Frames that real time asks for. Displays near 60 Hz count as exactly 60, so that each refresh
 * shows one new frame instead of now and then none or two. */
static double frames_of(double seconds)
{
    double frames = seconds * FRAME_RATE;
    double whole = floor(frames + 0.5);
    return whole >= 1 && fabs(frames - whole) < 0.02 * whole ? whole : frames;
}

/* Frames that fit into the budget; one always, or nothing would go on. */
static double fitting(const skv_pace *pace, double budget)
{
    double fit = pace->step_cost > 0 ? floor(budget / pace->step_cost) : MOST_FRAMES;
    return fmin(fmax(fit, 1), MOST_FRAMES);
}

double skv_pace_budget(bool beside, double interval, double drawing)
{
    return beside ? fmax(BUDGET, interval) : fmax(BUDGET - drawing, drawing / 2);
}

static void measure(skv_pace *pace, double seconds, double wished, double stepped)
{
    pace->real += seconds;
    pace->wished += wished;
    pace->simulated += stepped;
    if (pace->real < MEASURE_PERIOD)
        return;
    pace->factor = pace->wished > 0 ? fmin(pace->simulated / pace->wished, 1) : 1;
    /* A frame that just missed the period is no lack. */
    if (pace->wished - pace->simulated < 1.5)
        pace->factor = 1;
    pace->real = pace->wished = pace->simulated = 0;
}

int skv_pace_pass(skv_pace *pace, double seconds, double budget)
{
    double wished = frames_of(seconds) * pace->speed;
    /* The tiny share added makes ten times a tenth of a frame one frame; time comes in whole ns. */
    pace->due += wished;
    double whole = floor(pace->due + 1e-4), most = fitting(pace, budget);
    if (whole > most) {
        whole = most;
        pace->due = whole;
    }
    pace->due = fmax(pace->due - whole, 0);
    measure(pace, seconds, wished, whole);
    return (int)whole;
}

void skv_pace_wait(skv_pace *pace, double seconds)
{
    double wished = frames_of(seconds) * pace->speed;
    pace->due = fmin(pace->due + wished, MOST_FRAMES);
    measure(pace, seconds, wished, 0);
}

/* A tenth of each new value: about the mean of the last ten. */
static void average(double *mean, double value)
{
    *mean += *mean > 0 ? 0.1 * (value - *mean) : value;
}

void skv_pace_stepped(skv_pace *pace, double seconds)
{
    average(&pace->step_cost, seconds);
}

void skv_pace_drawn(skv_pace *pace, double seconds)
{
    average(&pace->drawing, seconds);
}

void skv_pace_rest(skv_pace *pace)
{
    pace->due = pace->real = pace->wished = pace->simulated = 0;
    pace->factor = 1;
}
