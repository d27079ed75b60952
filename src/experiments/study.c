/* A study's plan: which runs it has, what they are called, and with what they run.
 *
 * Invariant: the runs are numbered as in nested loops over the sweeps, the last one innermost. No
 * path stands twice among settings and sweeps together.
 */
#include "experiments/study.h"

#include "base/assert.h"
#include "base/fields.h"
#include "base/memory.h"

#include <string.h>

/* ---- Checking a plan ------------------------------------------------------------------------- */

/* The parameter with a path, if it concerns the experiment; otherwise null, and why. */
static const skv_field *find_parameter(const experiment *e, const skv_setting *setting,
                                       skv_error *error)
{
    const char *path = setting->path;
    const skv_field *found = NULL;
    if (!path || !setting->value) {
        skv_fail(error, SKV_ERROR_VALUE, "setting: a path and a value are needed");
        return NULL;
    }
    for (int i = 0; skv_lab_parameter(i); i++)
        if (strcmp(skv_lab_parameter(i)->path, path) == 0)
            found = skv_lab_parameter(i);
    if (!found) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "%.60s: the lab has no such parameter; see 'skvalp lab --help'", path);
        return NULL;
    }
    size_t first = strcspn(path, ".");
    bool own = first == strlen(e->info.name) && strncmp(path, e->info.name, first) == 0;
    if (path[first] == '.' && !own && strncmp(path, "fluid.", 6) != 0) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "%s: it is a parameter of %.*s and changes nothing in %s; omit it", path,
                 (int)first, path, e->info.name);
        return NULL;
    }
    return found;
}

/* Of a path given before the old value goes. */
static void forget_fixed(skv_study *s, const skv_field *field)
{
    int kept = 0;
    for (int i = 0; i < s->fixed_count; i++)
        if (s->fixed[i].field != field)
            s->fixed[kept++] = s->fixed[i];
    s->fixed_count = kept;
}

static skv_result take_settings(skv_study *s, const skv_study_plan *plan, skv_error *error)
{
    s->fixed = skv_calloc((size_t)plan->setting_count + 1, sizeof *s->fixed);
    if (!s->fixed)
        return skv_fail(error, SKV_ERROR_MEMORY, "study: out of memory");
    for (int i = 0; i < plan->setting_count; i++) {
        const skv_setting *setting = &plan->settings[i];
        fixed_value next = {.field = find_parameter(s->experiment, setting, error)};
        if (!next.field)
            return SKV_ERROR_VALUE;
        skv_result result = skv_value_write(next.field, setting->value, next.value, error);
        if (result != SKV_OK)
            return result;
        forget_fixed(s, next.field);
        s->fixed[s->fixed_count++] = next;
    }
    return SKV_OK;
}

static skv_result check_new(const skv_study *s, const skv_field *field, skv_error *error)
{
    for (int i = 0; i < s->fixed_count; i++)
        if (s->fixed[i].field == field)
            return skv_fail(error, SKV_ERROR_VALUE,
                            "%s: it is both set and swept; take one of the two", field->path);
    for (int i = 0; i < s->sweep_count; i++)
        if (s->sweeps[i].field == field)
            return skv_fail(error, SKV_ERROR_VALUE, "%s: it is swept twice; join the two",
                            field->path);
    return SKV_OK;
}

static skv_result take_sweeps(skv_study *s, const skv_study_plan *plan, skv_error *error)
{
    if (plan->sweep_count > SKV_MAX_SWEEPS)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "study: %d parameters are swept, and %d are allowed; set some of them",
                        plan->sweep_count, SKV_MAX_SWEEPS);
    s->runs = 1;
    for (int i = 0; i < plan->sweep_count; i++) {
        const skv_setting *setting = &plan->sweeps[i];
        const skv_field *field = find_parameter(s->experiment, setting, error);
        if (!field)
            return SKV_ERROR_VALUE;
        skv_result result = check_new(s, field, error);
        if (result != SKV_OK)
            return result;
        sweep *next = &s->sweeps[s->sweep_count++];
        result = skv_sweep_read(next, field, setting->value, SKV_MAX_RUNS, error);
        if (result != SKV_OK)
            return result;
        if (next->count > SKV_MAX_RUNS / s->runs)
            return skv_fail(error, SKV_ERROR_LIMIT,
                            "%s: more than %d runs, which is all that a study may have; take "
                            "fewer values",
                            field->path, SKV_MAX_RUNS);
        s->runs *= next->count;
    }
    return SKV_OK;
}

skv_result skv_study_create(const skv_study_plan *plan, skv_study **out, skv_error *error)
{
    SKV_ASSERT_OR(plan && out, SKV_ERROR_VALUE);
    *out = NULL;
    const experiment *e = skv_experiment_at(plan->experiment);
    if (!e)
        return skv_fail(error, SKV_ERROR_VALUE, "study: there is no experiment %d",
                        plan->experiment);
    skv_study *s = skv_calloc(1, sizeof *s);
    if (!s)
        return skv_fail(error, SKV_ERROR_MEMORY, "study: out of memory");
    s->experiment = e;
    s->number = plan->experiment;
    s->starts = plan->starts;
    skv_result result = take_settings(s, plan, error);
    if (result == SKV_OK)
        result = take_sweeps(s, plan, error);
    if (result == SKV_OK) {
        s->rows = skv_calloc((size_t)s->runs, sizeof(*s->rows));
        if (!s->rows)
            result = skv_fail(error, SKV_ERROR_MEMORY, "study: out of memory");
    }
    if (result == SKV_OK)
        *out = s;
    else
        skv_study_destroy(s);
    return result;
}

void skv_study_destroy(skv_study *study)
{
    if (!study)
        return;
    for (int i = 0; study->rows && i < study->runs; i++)
        skv_free(study->rows[i]);
    for (int i = 0; i < study->sweep_count; i++)
        skv_sweep_free(&study->sweeps[i]);
    skv_free(study->rows);
    skv_free(study->fixed);
    skv_free(study);
}

/* ---- Its runs -------------------------------------------------------------------------------- */

int skv_study_stride(const skv_study *study, int swept)
{
    int stride = 1;
    for (int i = swept + 1; i < study->sweep_count; i++)
        stride *= study->sweeps[i].count;
    return stride;
}

int skv_study_place(const skv_study *study, int run, int swept)
{
    return run / skv_study_stride(study, swept) % study->sweeps[swept].count;
}

int skv_study_experiment(const skv_study *study)
{
    SKV_ASSERT_OR(study, -1);
    return study->number;
}

int skv_study_runs(const skv_study *study)
{
    SKV_ASSERT_OR(study, 0);
    return study->runs;
}

bool skv_study_run_setting(const skv_study *study, int run, int i, skv_setting *setting)
{
    SKV_ASSERT_OR(study && setting && run >= 0 && run < study->runs, false);
    int swept = i - study->fixed_count;
    if (i < 0 || swept >= study->sweep_count)
        return false;
    if (swept < 0) {
        *setting = (skv_setting){study->fixed[i].field->path, study->fixed[i].value};
    } else {
        const sweep *s = &study->sweeps[swept];
        *setting = (skv_setting){s->field->path, s->values[skv_study_place(study, run, swept)]};
    }
    return true;
}

void skv_study_run_name(const skv_study *study, int run, char name[SKV_RUN_NAME])
{
    SKV_ASSERT(study && run >= 0 && run < study->runs);
    skv_setting setting;
    size_t length = skv_format(name, SKV_RUN_NAME, "%s", study->experiment->info.name);
    for (int i = study->fixed_count; skv_study_run_setting(study, run, i, &setting); i++)
        length +=
            skv_format(name + length, SKV_RUN_NAME - length, ",%s=%s", setting.path, setting.value);
    if (study->starts > 0)
        skv_format(name + length, SKV_RUN_NAME - length, ",starts=%d", study->starts);
}

bool skv_study_is_alike(const skv_study *a, const skv_study *b)
{
    SKV_ASSERT_OR(a && b, false);
    bool alike = a->experiment == b->experiment && a->starts == b->starts &&
                 a->fixed_count == b->fixed_count && a->sweep_count == b->sweep_count;
    for (int i = 0; alike && i < a->fixed_count; i++)
        alike = a->fixed[i].field == b->fixed[i].field &&
                strcmp(a->fixed[i].value, b->fixed[i].value) == 0;
    for (int i = 0; alike && i < a->sweep_count; i++)
        alike = a->sweeps[i].field == b->sweeps[i].field;
    return alike;
}
