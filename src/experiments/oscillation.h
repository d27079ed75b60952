/* Reading period and decay off a swinging quantity. */
#ifndef SKV_EXPERIMENTS_OSCILLATION_H
#define SKV_EXPERIMENTS_OSCILLATION_H

typedef struct oscillation {
    double period; /* s, from the first zero crossings; NaN if there are fewer than three */
    double
        amplitude1; /* share of the first extreme that the one a period later has; NaN likewise */
    double first_crossing; /* s */
} oscillation;

/* Crossings of `rest`, linear between samples. The period is that of the first `half_periods` half
 * swings, from crossing to crossing. The extreme before the first crossing counts as the first. */
oscillation skv_oscillation_read(const double *times, const double *values, int count, double rest,
                                 int half_periods);

#endif
