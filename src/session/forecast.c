/* Forecasts. A particle's pressure is that of the last substep: before the first one it is 0, and
 * after gravity, walls or the liquid were changed it is that of what was there before. While
 * nothing is stepped a copy of the world says what they lead to. Invariant: the world stays as it
 * is. */
#include "session/forecast.h"

#include "base/memory.h"
#include "skvalp/particles.h"
#include "skvalp/snapshot.h"

#include <string.h>

#define FRAME (1.0f / 60)

void skv_forecast_free(skv_forecast *forecast)
{
    skv_free(forecast->pressure);
    *forecast = (skv_forecast){0};
}

static bool reserve(skv_forecast *forecast, int count)
{
    if (count <= forecast->room)
        return true;
    skv_forecast_free(forecast);
    forecast->pressure = skv_calloc((size_t)count, sizeof *forecast->pressure);
    forecast->room = forecast->pressure ? count : 0;
    return forecast->pressure;
}

/* Both lists of ids ascend; who is gone by then keeps the pressure that it has. */
static void take(float *pressure, const skv_particles *now, const skv_particles *then)
{
    for (int i = 0, k = 0; i < now->count; i++) {
        while (k < then->count && then->id[k] < now->id[i])
            k++;
        bool there = k < then->count && then->id[k] == now->id[i];
        pressure[i] = there ? then->pressure[k] : now->pressure[i];
    }
}

void skv_forecast_make(skv_forecast *forecast, const skv_world *world, skv_pool *pool)
{
    skv_world_def host = skv_default_world_def();
    host.pool = pool;
    skv_world *copy = NULL;
    skv_particles now = skv_world_particles(world);
    forecast->known = reserve(forecast, now.count) &&
                      skv_world_copy(world, &host, &copy, NULL) == SKV_OK &&
                      skv_world_step(copy, FRAME, NULL) == SKV_OK;
    if (forecast->known) {
        skv_particles then = skv_world_particles(copy);
        take(forecast->pressure, &now, &then);
        forecast->count = now.count;
    }
    skv_world_destroy(copy);
}
