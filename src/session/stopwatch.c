/* The stopwatch. Invariant: its presses stand in the order of their moments. */
#include "skvalp/stopwatch.h"

#include "base/assert.h"

void skv_stopwatch_cut(skv_stopwatch *watch, int64_t end)
{
    SKV_ASSERT(watch);
    while (watch->count > 0 && watch->list[watch->count - 1].moment > end)
        watch->count--;
}

skv_stopwatch_reading skv_stopwatch_read(const skv_stopwatch *watch, int64_t moment)
{
    skv_stopwatch_reading reading = {false, 0, 0, 0};
    SKV_ASSERT_OR(watch, reading);
    int64_t start = 0, lap = 0;
    for (int i = 0; i < watch->count && watch->list[i].moment <= moment; i++) {
        const skv_press *press = &watch->list[i];
        if (press->lap) {
            reading.laps++;
            reading.lap = press->moment - lap;
            lap = press->moment;
        } else if (reading.running) {
            reading.running = false;
            reading.frames = press->moment - start;
        } else {
            reading = (skv_stopwatch_reading){.running = true};
            start = lap = press->moment;
        }
    }
    if (reading.running)
        reading.frames = moment - start;
    return reading;
}

/* Keeps the start that it runs from, if it runs. */
static void make_room(skv_stopwatch *watch, int64_t moment)
{
    skv_stopwatch_reading reading = skv_stopwatch_read(watch, moment);
    watch->list[0] = (skv_press){.moment = moment - reading.frames};
    watch->count = reading.running ? 1 : 0;
}

void skv_stopwatch_press(skv_stopwatch *watch, int64_t moment, bool lap)
{
    SKV_ASSERT(watch);
    skv_stopwatch_cut(watch, moment);
    if (lap && !skv_stopwatch_read(watch, moment).running)
        return;
    if (watch->count == SKV_MOST_PRESSES)
        make_room(watch, moment);
    watch->list[watch->count++] = (skv_press){moment, lap};
}
