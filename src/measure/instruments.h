/* What the instruments read from one survey; the lab keeps their histories. */
#ifndef SKV_MEASURE_INSTRUMENTS_H
#define SKV_MEASURE_INSTRUMENTS_H

#include "measure/survey.h"
#include "measure/wall_force.h"

/* An instrument as the lab keeps it. */
typedef struct instrument {
    skv_instrument id;
    skv_instrument_def def;
    int channels;
    /* Ring buffers: the time of a sample, and its values, channel by channel. */
    double *times, *values;
    int next, count;
    skv_force_meter meter;
    double held_since; /* stopwatch: since when the condition holds; negative: it does not */
    double stopped_at; /* stopwatch: NaN while it runs */
} instrument;

int skv_channel_count(skv_instrument_kind kind);

/* Reads everything but a stopwatch, which looks at another instrument, into `values`. */
skv_result skv_instrument_read(instrument *instrument, const skv_survey *survey,
                               const skv_world *world, double *values, skv_error *error);

#endif
