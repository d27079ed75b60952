/* The list of experiments. Invariant: it calls base alone, so that what an experiment stands on,
 * its settings for one, may ask for the list. */
#include "experiments/experiment.h"

#include "base/assert.h"

#include <string.h>

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

skv_result skv_experiment_find(const char *name, int *found, skv_error *error)
{
    SKV_ASSERT_OR(name && found, SKV_ERROR_VALUE);
    const char *names[EXPERIMENTS];
    for (int i = 0; i < EXPERIMENTS; i++) {
        names[i] = experiments[i]->info.name;
        if (strcmp(names[i], name) == 0) {
            *found = i;
            return SKV_OK;
        }
    }
    const char *nearest = skv_nearest_name(name, names, EXPERIMENTS);
    if (nearest)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "lab: there is no experiment '%s'; did you mean %s?", name, nearest);
    return skv_fail(error, SKV_ERROR_VALUE,
                    "lab: there is no experiment '%s'; see 'skvalp lab --help'", name);
}
