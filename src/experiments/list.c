/* The list of experiments. Invariant: it calls nothing, so that what an experiment stands on, its
 * settings for one, may ask for the list. */
#include "experiments/experiment.h"

#define ADDRESS(name) &skv_exp_##name,
static const experiment *const experiments[] = {SKV_EXPERIMENTS(ADDRESS)};
enum { EXPERIMENTS = (int)(sizeof experiments / sizeof *experiments) };

const experiment *skv_experiment_at(int i)
{
    return i >= 0 && i < EXPERIMENTS ? experiments[i] : NULL;
}

const skv_experiment *skv_experiment_info(int i)
{
    const experiment *e = skv_experiment_at(i);
    return e ? &e->info : NULL;
}
