/* A study: its settings, its sweeps, and the rows of those of its runs that were read. */
#ifndef SKV_EXPERIMENTS_STUDY_H
#define SKV_EXPERIMENTS_STUDY_H

#include "experiments/experiment.h"
#include "experiments/sweep.h"
#include "skvalp/study.h"

typedef struct fixed_value {
    const skv_field *field;
    char value[VALUE_SIZE];
} fixed_value;

struct skv_study {
    const experiment *experiment;
    int number;         /* of the experiment */
    fixed_value *fixed; /* one for each path, in the order of their last mention */
    int fixed_count;
    sweep sweeps[SKV_MAX_SWEEPS]; /* the last is the fastest */
    int sweep_count;
    int starts, runs;
    skv_study_row **rows; /* of each run; null: not read */
};

/* The number of a run's value in its sweep, and how many runs it stays the same. */
int skv_study_place(const skv_study *study, int run, int swept);
int skv_study_stride(const skv_study *study, int swept);

#endif
