/* The line on a terminal that says how far the work is. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdbool.h>

typedef struct progress_line {
    const char *label;
    double total; /* simulated seconds */
    bool wanted;  /* stderr is a terminal and nobody asked for quiet */
    bool shown;
    double started, updated; /* clock_seconds */
} progress_line;

/* Seconds of a clock that only goes forward. */
double clock_seconds(void);

/* `label` and everything else must outlive the progress. */
progress_line progress_start(const char *label, double total, bool quiet);
/* Shows where the run is, at most ten times a second. */
void progress_update(progress_line *progress, double simulated);
/* Shows a text of one's own, as often. */
void progress_show(progress_line *progress, const char *text);
/* Takes the line away. */
void progress_end(progress_line *progress);

#endif
