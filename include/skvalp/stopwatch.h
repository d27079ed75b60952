/** @file
 * Stopwatch: takes the world's time, in frames since the start, and goes back and forth with it.
 *
 * It is the list of moments at which it was pressed, so what it shows depends on the moment alone:
 * before a press that press has not been made yet. Plain data of the face's; all zero is one that
 * was never pressed.
 */
#ifndef SKVALP_STOPWATCH_H
#define SKVALP_STOPWATCH_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SKV_MOST_PRESSES 64

typedef struct skv_press {
    int64_t moment; /**< skv_picture.moment */
    bool lap;       /**< false: starts from 0, or stops */
} skv_press;
typedef struct skv_stopwatch {
    int count;
    skv_press list[SKV_MOST_PRESSES]; /**< the earlier first */
} skv_stopwatch;

/** What it shows, in frames of 1/60 s. */
typedef struct skv_stopwatch_reading {
    bool running;
    int64_t frames; /**< since it was started, until it was stopped */
    int laps;       /**< whole ones */
    int64_t lap;    /**< how long the last whole one was; 0: none */
} skv_stopwatch_reading;

/** A press now; those that had been made later, before the world went back, are forgotten. A lap
 * while it does not run does nothing. If there are too many, all before are
 * forgotten but the start that it runs from. */
SKV_API void skv_stopwatch_press(skv_stopwatch *watch, int64_t moment, bool lap);

/** Forgets presses after the log's end (skv_picture.end), which was cut off there. */
SKV_API void skv_stopwatch_cut(skv_stopwatch *watch, int64_t end);

SKV_API skv_stopwatch_reading skv_stopwatch_read(const skv_stopwatch *watch, int64_t moment);

#ifdef __cplusplus
}
#endif
#endif
