/* Several starts of one experiment: a run is exact, but a slightly other number of particles is
 * another run. What differs between the starts, and what a row comes to over all of them. */
#ifndef CLI_LAB_STARTS_H
#define CLI_LAB_STARTS_H

#include "options.h"
#include "skvalp/experiments.h"

/* A row over all starts so far. */
typedef struct lab_figure {
    skv_lab_row row; /* numbers are means; it passes if the misses' root mean square does */
    int starts, passed;
    /* Sums of squares: of what differs from the mean, and of the misses. */
    double measured_squares, ratio_squares, miss_squares;
} lab_figure;

/* Adds the row of one more start. */
void lab_figure_add(lab_figure *figure, const skv_lab_row *row);
/* The standard deviation that a sum of squares amounts to; NaN for a single start. */
double lab_deviation(double squares, int starts);

/* Lets a start with one number of particles have its settings. */
typedef struct lab_starts {
    skv_setting *settings; /* those of the command line and, with several starts, one more; owned */
    int setting_count;
    int wanted;     /* particles; 0: there is one start, from the settings as they were given */
    int of_any;     /* starts of any experiment, */
    int of_scatter; /* and of one that scatters */
    char particles[16];
} lab_starts;

/* Fails if several starts are asked for and the settings, known to be right, leave nothing for them
 * to differ in, or one of them would have too many particles or too few. Needs lab_starts_close,
 * also on failure. */
skv_result lab_starts_open(lab_starts *starts, const cli_options *options, skv_error *error);
void lab_starts_close(lab_starts *starts);
/* From how many starts an experiment is run. */
int lab_starts_count(const lab_starts *starts, const skv_experiment *experiment);
/* Puts the settings of a start, counted from 0, into `lab`. */
void lab_starts_choose(lab_starts *starts, int start, skv_lab_options *lab);

#endif
