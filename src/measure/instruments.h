/* The kinds of instruments, each a row of one table; the lab keeps what they read. */
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

/* What an instrument looks at. */
typedef struct look {
    const skv_survey *survey;
    const skv_world *world;
    double watched; /* the reading of the instrument that is watched; NaN: none is */
    skv_error *error;
} look;

/* What distinguishes one kind from another. */
typedef struct instrument_kind {
    const char *name;
    skv_channel channels[SKV_MAX_CHANNELS]; /* ends with the first one without a name */
    double window;                          /* by default, s */
    bool is_line;                           /* its two points must differ */
    bool holds;                             /* a reading is the last sample, whatever the window */
    /* Writes what is seen to `values`, one for each channel, which hold NaN. */
    skv_result (*sample)(instrument *it, const look *seen, double *values);
} instrument_kind;

/* Null for an unknown kind. */
const instrument_kind *skv_instrument_kind_info(skv_instrument_kind kind);
int skv_channel_count(skv_instrument_kind kind);

/* lack.c: why a channel has no reading, the first of them that lacks one. */
const char *skv_instrument_lack(const instrument *it, const skv_survey *survey, int channel);

/* Forgets everything. */
void skv_instrument_reset(instrument *it);

/* The place in the rings of the sample `age` samples before the last. */
int skv_instrument_slot(const instrument *it, int age);

#endif
