/* A lab behind numbers that the face gave out before the lab had seen its instruments. Invariant:
 * every probe of the list is an instrument of the lab. */
#include "session/probes.h"

#include <string.h>

#include "base/memory.h"
#include "measure/survey.h"

void skv_probes_destroy(skv_probes *probes)
{
    skv_lab_destroy(probes->lab);
    *probes = (skv_probes){0};
}

/* Every frame is read; after a jump in time histories begin anew. */
#define LONGEST_FRAME (1.5 / 60)

skv_result skv_probes_sample(skv_probes *probes, const skv_world *world, const float *pressure,
                             skv_error *error)
{
    double time = skv_world_time(world);
    if (probes->count == 0)
        return SKV_OK;
    if (time > probes->time + LONGEST_FRAME)
        skv_lab_restart(probes->lab);
    probes->time = time;
    return skv_lab_sample_with(probes->lab, world, pressure, error);
}

static int find(const skv_probes *probes, uint32_t id)
{
    for (int i = 0; i < probes->count; i++)
        if (probes->list[i].id == id)
            return i;
    return -1;
}

static skv_result add(skv_probes *probes, const skv_message *message, skv_error *error)
{
    skv_result result = probes->lab ? SKV_OK : skv_lab_create(&probes->lab, error);
    skv_instrument instrument = 0;
    if (result == SKV_OK && probes->count == SKV_MOST_PROBES)
        result = skv_fail(error, SKV_ERROR_LIMIT, "there are %d instruments already; remove one",
                          SKV_MOST_PROBES);
    if (result == SKV_OK)
        result = skv_lab_add(probes->lab, &message->probe.def, &instrument, error);
    if (result != SKV_OK)
        return result;
    int i = probes->count++;
    probes->list[i].id = message->probe.id;
    probes->list[i].instrument = instrument;
    probes->list[i].watched = false;
    return SKV_OK;
}

static void remove_probe(skv_probes *probes, int i)
{
    skv_lab_remove(probes->lab, probes->list[i].instrument);
    probes->count--;
    memmove(&probes->list[i], &probes->list[i + 1],
            (size_t)(probes->count - i) * sizeof *probes->list);
}

skv_result skv_probes_handle(skv_probes *probes, const skv_message *message, skv_error *error)
{
    if (message->kind == SKV_MESSAGE_PROBE_ADD)
        return add(probes, message, error);
    const skv_instrument_def *to = &message->probe.def;
    int i = find(probes, message->probe.id);
    if (i < 0)
        return SKV_OK;
    if (message->kind == SKV_MESSAGE_PROBE_MOVE)
        return skv_lab_move(probes->lab, probes->list[i].instrument, to->x0, to->y0, to->x1, to->y1,
                            error);
    if (message->kind == SKV_MESSAGE_PROBE_WATCH)
        probes->list[i].watched = message->probe.watched;
    else
        remove_probe(probes, i);
    return SKV_OK;
}

static int channels(skv_instrument_kind kind)
{
    int count = 0;
    while (count < SKV_MAX_CHANNELS && skv_instrument_channel(kind, count))
        count++;
    return count;
}

/* Numbers that the histories of the watched probes have: times, and values of each channel. */
static size_t count_samples(const skv_probes *probes)
{
    size_t sum = 0;
    for (int i = 0; i < probes->count; i++) {
        skv_instrument instrument = probes->list[i].instrument;
        int samples = skv_lab_history(probes->lab, instrument, 0, NULL, NULL, 0);
        int arrays = 1 + channels(skv_lab_def(probes->lab, instrument)->kind);
        sum += probes->list[i].watched ? (size_t)samples * (size_t)arrays : 0;
    }
    return sum;
}

/* Copies a history to `room`; returns the end of it. */
static double *paint_history(const skv_lab *lab, skv_instrument instrument, skv_probe *probe,
                             double *room)
{
    int samples = skv_lab_history(lab, instrument, 0, NULL, NULL, 0);
    double *times = room;
    room += samples;
    for (int c = 0; c < channels(probe->def.kind); c++) {
        skv_lab_history(lab, instrument, c, times, room, samples);
        probe->history[c] = room;
        room += samples;
    }
    probe->times = times;
    probe->samples = samples;
    return room;
}

void skv_probes_paint(const skv_probes *probes, skv_canvas *canvas)
{
    bool room = skv_canvas_reserve_samples(canvas, count_samples(probes));
    double *samples = canvas->samples;
    canvas->picture.probe_count = probes->count;
    for (int i = 0; i < probes->count; i++) {
        skv_probe *probe = &canvas->picture.probes[i];
        skv_instrument instrument = probes->list[i].instrument;
        probe->id = probes->list[i].id;
        probe->def = *skv_lab_def(probes->lab, instrument);
        for (int c = 0; c < channels(probe->def.kind); c++)
            probe->value[c] = skv_lab_reading(probes->lab, instrument, c);
        const char *lack = skv_lab_lack(probes->lab, instrument);
        probe->lack = lack ? lack : "";
        if (room && probes->list[i].watched)
            samples = paint_history(probes->lab, instrument, probe, samples);
    }
}

void skv_probes_note(const skv_probes *probes, skv_showing *showing)
{
    showing->probe_count = 0;
    for (int i = 0; i < probes->count; i++) {
        const skv_instrument_def *def = skv_lab_def(probes->lab, probes->list[i].instrument);
        if (def->kind != SKV_INSTRUMENT_STOPWATCH)
            showing->probes[showing->probe_count++] = (skv_shown_probe){
                def->kind, def->x0, def->y0, def->x1, def->y1, probes->list[i].watched};
    }
}
