/* Measures instead of looking: a probe at the bottom of a pool and a gauge for its level, against
 * what hydrostatics says. Prints a table, one line a quarter of a second. */
#include <skvalp/skvalp.h>

#include <math.h>
#include <stdio.h>

static const double X = 0.8; /* where both instruments stand, m */

/* A calm pool, half a metre deep. */
static skv_result make_pool(skv_world **world, skv_error *error)
{
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.02f;
    skv_fill_def pool = skv_default_fill_def();
    pool.y1 = 0.5f;
    skv_result result = skv_world_create(&def, world, error);
    return result == SKV_OK ? skv_world_fill(*world, &pool, NULL, error) : result;
}

static skv_result add_instruments(skv_lab *lab, skv_instrument *probe, skv_instrument *gauge,
                                  skv_error *error)
{
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = X;
    def.y0 = 0.1;
    def.window = 0.25; /* a mean over a quarter of a second */
    skv_result result = skv_lab_add(lab, &def, probe, error);
    if (result != SKV_OK)
        return result;
    def = skv_default_instrument_def(SKV_INSTRUMENT_LEVEL); /* from the bottom upwards */
    def.x0 = def.x1 = X;
    def.y0 = 0.1;
    def.y1 = 0.85;
    def.window = 0.25;
    return skv_lab_add(lab, &def, gauge, error);
}

/* Steps and reads; returns the last pressure over what the water above the probe weighs. */
static skv_result measure(skv_world *world, skv_lab *lab, double *ratio, skv_error *error)
{
    skv_instrument probe, gauge;
    skv_result result = add_instruments(lab, &probe, &gauge, error);
    for (int frame = 1; frame <= 120 && result == SKV_OK; frame++) {
        result = skv_world_step(world, 1.0f / 60, error);
        if (result == SKV_OK)
            result = skv_lab_sample(lab, world, error);
        if (result != SKV_OK || frame % 15)
            continue;
        double pressure = skv_lab_reading(lab, probe, 0);
        double above = skv_lab_reading(lab, gauge, 0);
        *ratio = pressure / (skv_world_fluid(world)->density * 9.81 * above);
        printf("%.2f s: %5.0f Pa m under %.3f m of water, %.3f of theory\n", skv_world_time(world),
               pressure, above, *ratio);
    }
    return result;
}

int main(void)
{
    skv_error error = {0};
    skv_world *world = NULL;
    skv_lab *lab = NULL;
    double ratio = NAN;
    skv_result result = make_pool(&world, &error);
    if (result == SKV_OK)
        result = skv_lab_create(&lab, &error);
    if (result == SKV_OK)
        result = measure(world, lab, &ratio, &error);
    if (result != SKV_OK)
        fprintf(stderr, "instruments: %s\n", error.text);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
    return result == SKV_OK && fabs(ratio - 1) < 0.1 ? 0 : 1;
}
