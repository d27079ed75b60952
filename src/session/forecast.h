/* A forecast: the pressures that a world's particles will have once it has been stepped. */
#ifndef SKV_SESSION_FORECAST_H
#define SKV_SESSION_FORECAST_H

#include "skvalp/world.h"

typedef struct skv_forecast {
    float *pressure; /* by particle; valid while `known` */
    int count, room;
    bool known;
} skv_forecast;

void skv_forecast_free(skv_forecast *forecast);

/* Steps a copy of a world by a frame. Without memory for that nothing is known. */
void skv_forecast_make(skv_forecast *forecast, const skv_world *world, skv_pool *pool);

#endif
