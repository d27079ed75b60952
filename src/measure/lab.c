/* A lab: instruments, read after every frame, and what they remember.
 *
 * Invariant: all memory for histories is taken when an instrument is added; a sample only writes
 * into the rings. Instruments are read in the order in which they were added, so a stopwatch sees
 * the present reading of what it watches.
 */
#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "measure/instruments.h"

#include <math.h>
#include <string.h>

enum { DEF_COOKIE = 0x494e, MAX_CAPACITY = 1000000 };

struct skv_lab {
    skv_survey *survey;
    instrument **instruments;
    int count, capacity;
    skv_instrument next_id;
    double time; /* of the last sample; negative: none yet */
};

skv_instrument_def skv_default_instrument_def(skv_instrument_kind kind)
{
    const instrument_kind *info = skv_instrument_kind_info(kind);
    return (skv_instrument_def){
        .kind = kind,
        .window = info ? info->window : 0,
        .capacity = 1200,
        .cookie = SKV_COOKIE(DEF_COOKIE, skv_instrument_def),
    };
}

void skv_instrument_def_init(skv_instrument_def *def, size_t size, skv_instrument_kind kind)
{
    const skv_instrument_def standard = skv_default_instrument_def(kind);
    skv_def_init(def, size, &standard, sizeof standard);
}

skv_result skv_lab_create(skv_lab **out, skv_error *error)
{
    SKV_ASSERT_OR(out, SKV_ERROR_VALUE);
    *out = NULL;
    skv_lab *lab = skv_calloc(1, sizeof *lab);
    if (!lab)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a lab");
    skv_result result = skv_survey_create(&lab->survey, error);
    if (result != SKV_OK) {
        skv_free(lab);
        return result;
    }
    lab->next_id = 1;
    lab->time = -1;
    *out = lab;
    return SKV_OK;
}

static void free_instrument(instrument *it)
{
    skv_free(it->times);
    skv_free(it->values);
    skv_force_free(&it->meter);
    skv_free(it);
}

void skv_lab_destroy(skv_lab *lab)
{
    if (!lab)
        return;
    for (int i = 0; i < lab->count; i++)
        free_instrument(lab->instruments[i]);
    skv_free(lab->instruments);
    skv_survey_destroy(lab->survey);
    skv_free(lab);
}

static int find(const skv_lab *lab, skv_instrument id)
{
    int i = lab->count - 1;
    while (i >= 0 && lab->instruments[i]->id != id)
        i--;
    return i;
}

static bool points_are_sane(skv_instrument_kind kind, double x0, double y0, double x1, double y1)
{
    bool line = skv_instrument_kind_info(kind)->is_line;
    const double most = 1e6;
    bool sane = fabs(x0) <= most && fabs(y0) <= most && fabs(x1) <= most && fabs(y1) <= most;
    return sane && (!line || x0 != x1 || y0 != y1);
}

static skv_result check_name(const char *name, skv_error *error)
{
    size_t length = 0;
    while (length < sizeof((skv_instrument_def *)0)->name && name[length]) {
        char c = name[length++];
        if (c < ' ' || c > '~' || c == ',' || c == '"')
            return skv_fail(error, SKV_ERROR_VALUE,
                            "instrument: a name holds printable ASCII without commas and quotes");
    }
    if (length == sizeof((skv_instrument_def *)0)->name)
        return skv_fail(error, SKV_ERROR_VALUE, "instrument: the name is too long");
    return SKV_OK;
}

static skv_result check_def(const skv_lab *lab, const skv_instrument_def *def, skv_error *error)
{
    if (!skv_instrument_kind_info(def->kind))
        return skv_fail(error, SKV_ERROR_VALUE, "instrument: there is no kind %d", (int)def->kind);
    if (!points_are_sane(def->kind, def->x0, def->y0, def->x1, def->y1))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%s: its points are not finite, or the same where a line is needed",
                        skv_instrument_kind_name(def->kind));
    if (def->capacity < 1 || def->capacity > MAX_CAPACITY)
        return skv_fail(error, SKV_ERROR_VALUE, "%s: capacity %d; allowed is 1..%d",
                        skv_instrument_kind_name(def->kind), def->capacity, MAX_CAPACITY);
    if (!(def->window >= 0 && def->window <= 1e6) || !(def->hold >= 0 && def->hold <= 1e6))
        return skv_fail(error, SKV_ERROR_VALUE, "%s: window and hold are 0..1e6 s",
                        skv_instrument_kind_name(def->kind));
    if (def->kind == SKV_INSTRUMENT_STOPWATCH) {
        int watched = find(lab, def->watched);
        if (watched < 0 || !isfinite(def->threshold) ||
            !skv_instrument_channel(lab->instruments[watched]->def.kind, def->channel))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "stopwatch: it watches no channel of an instrument added before it");
    }
    return check_name(def->name, error);
}

static skv_result make_room(skv_lab *lab, skv_error *error)
{
    if (lab->count < lab->capacity)
        return SKV_OK;
    int capacity = lab->capacity ? 2 * lab->capacity : 8;
    instrument **list = skv_calloc((size_t)capacity, sizeof(*list));
    if (!list)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for instruments");
    if (lab->count)
        memcpy(list, lab->instruments, (size_t)lab->count * sizeof(*list));
    skv_free(lab->instruments);
    lab->instruments = list;
    lab->capacity = capacity;
    return SKV_OK;
}

skv_result skv_lab_add(skv_lab *lab, const skv_instrument_def *def, skv_instrument *id,
                       skv_error *error)
{
    SKV_ASSERT_OR(lab && def && id, SKV_ERROR_VALUE);
    *id = 0;
    skv_instrument_def own = skv_default_instrument_def(SKV_INSTRUMENT_LEVEL);
    const skv_instrument_def *given = def;
    SKV_ASSERT_INITIALISED(def, skv_def_open(given, &own, sizeof own), SKV_ERROR_VALUE);
    own = skv_default_instrument_def(def->kind); /* of which a default depends */
    def = skv_def_open(given, &own, sizeof own);
    skv_result result = check_def(lab, def, error);
    if (result == SKV_OK)
        result = make_room(lab, error);
    if (result != SKV_OK)
        return result;
    instrument *it = skv_calloc(1, sizeof *it);
    int channels = skv_channel_count(def->kind);
    if (it) {
        it->times = skv_calloc((size_t)def->capacity, sizeof *it->times);
        it->values = skv_calloc((size_t)def->capacity * (size_t)channels, sizeof *it->values);
    }
    if (!it || !it->times || !it->values) {
        if (it)
            free_instrument(it);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a history of %d samples",
                        def->capacity);
    }
    it->def = *def;
    it->channels = channels;
    it->id = *id = lab->next_id++;
    skv_instrument_reset(it);
    lab->instruments[lab->count++] = it;
    return SKV_OK;
}

skv_result skv_lab_move(skv_lab *lab, skv_instrument id, double x0, double y0, double x1, double y1,
                        skv_error *error)
{
    SKV_ASSERT_OR(lab, SKV_ERROR_VALUE);
    int i = find(lab, id);
    if (i < 0)
        return skv_fail(error, SKV_ERROR_VALUE, "lab: there is no instrument %u", id);
    instrument *it = lab->instruments[i];
    if (!points_are_sane(it->def.kind, x0, y0, x1, y1))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%s: its points are not finite, or the same where a line is needed",
                        skv_instrument_kind_name(it->def.kind));
    it->def.x0 = x0;
    it->def.y0 = y0;
    it->def.x1 = x1;
    it->def.y1 = y1;
    skv_instrument_reset(it);
    return SKV_OK;
}

void skv_lab_remove(skv_lab *lab, skv_instrument id)
{
    SKV_ASSERT(lab);
    int i = find(lab, id);
    if (i < 0)
        return;
    free_instrument(lab->instruments[i]);
    lab->count--;
    memmove(lab->instruments + i, lab->instruments + i + 1,
            (size_t)(lab->count - i) * sizeof(*lab->instruments));
}

skv_instrument skv_lab_instrument(const skv_lab *lab, int i)
{
    SKV_ASSERT_OR(lab, 0);
    return i >= 0 && i < lab->count ? lab->instruments[i]->id : 0;
}

const skv_instrument_def *skv_lab_def(const skv_lab *lab, skv_instrument id)
{
    SKV_ASSERT_OR(lab, NULL);
    int i = find(lab, id);
    return i >= 0 ? &lab->instruments[i]->def : NULL;
}

const skv_survey *skv_lab_survey(const skv_lab *lab)
{
    SKV_ASSERT_OR(lab, NULL);
    return lab->survey;
}

static void remember(instrument *it, double time, const double *values)
{
    it->times[it->next] = time;
    for (int c = 0; c < it->channels; c++)
        it->values[c * it->def.capacity + it->next] = values[c];
    it->next = (it->next + 1) % it->def.capacity;
    if (it->count < it->def.capacity)
        it->count++;
}

/* Takes back the last sample if it is of this moment. */
static void forget(instrument *it, double time)
{
    if (it->count == 0 || it->times[skv_instrument_slot(it, 0)] != time)
        return;
    it->next = skv_instrument_slot(it, 0);
    it->count--;
}

static double reading(const instrument *it, int channel)
{
    if (channel < 0 || channel >= it->channels || it->count == 0)
        return (double)NAN;
    double window = skv_instrument_kind_info(it->def.kind)->holds ? 0 : it->def.window;
    /* Half a millisecond: sums of float frames must not decide which samples count. */
    double oldest = it->times[skv_instrument_slot(it, 0)] - window + 5e-4;
    double sum = 0;
    int used = 0;
    for (int age = 0; age < it->count; age++) {
        int at = skv_instrument_slot(it, age);
        if (age > 0 && it->times[at] < oldest)
            break;
        double value = it->values[channel * it->def.capacity + at];
        if (isnan(value))
            continue;
        sum += value;
        used++;
    }
    return used ? sum / used : (double)NAN;
}

static void reset_all(const skv_lab *lab)
{
    for (int i = 0; i < lab->count; i++)
        skv_instrument_reset(lab->instruments[i]);
}

void skv_lab_restart(skv_lab *lab)
{
    SKV_ASSERT(lab);
    reset_all(lab);
    skv_survey_forget(lab->survey);
    lab->time = -1;
}

skv_result skv_lab_sample(skv_lab *lab, const skv_world *world, skv_error *error)
{
    return skv_lab_sample_with(lab, world, NULL, error);
}

skv_result skv_lab_sample_with(skv_lab *lab, const skv_world *world, const float *pressure,
                               skv_error *error)
{
    SKV_ASSERT_OR(lab && world, SKV_ERROR_VALUE);
    skv_result result = skv_survey_take_with(lab->survey, world, pressure, error);
    if (result != SKV_OK)
        return result;
    double time = skv_world_time(world);
    if (time < lab->time)
        reset_all(lab);
    lab->time = time;
    for (int i = 0; i < lab->count && result == SKV_OK; i++) {
        instrument *it = lab->instruments[i];
        forget(it, time);
        double values[SKV_MAX_CHANNELS];
        for (int c = 0; c < SKV_MAX_CHANNELS; c++)
            values[c] = (double)NAN;
        /* Those that stand before this one have their new samples already. */
        const look seen = {lab->survey, world,
                           skv_lab_reading(lab, it->def.watched, it->def.channel), error};
        result = skv_instrument_kind_info(it->def.kind)->sample(it, &seen, values);
        if (result == SKV_OK)
            remember(it, time, values);
    }
    return result;
}

double skv_lab_reading(const skv_lab *lab, skv_instrument id, int channel)
{
    SKV_ASSERT_OR(lab, (double)NAN);
    int i = find(lab, id);
    return i >= 0 ? reading(lab->instruments[i], channel) : (double)NAN;
}

const char *skv_lab_lack(const skv_lab *lab, skv_instrument id)
{
    SKV_ASSERT_OR(lab, NULL);
    int i = find(lab, id), channel = 0;
    const instrument *it = i >= 0 ? lab->instruments[i] : NULL;
    while (it && channel < it->channels && !isnan(reading(it, channel)))
        channel++;
    return it && channel < it->channels ? skv_instrument_lack(it, lab->survey, channel) : NULL;
}

int skv_lab_history(const skv_lab *lab, skv_instrument id, int channel, double *times,
                    double *values, int capacity)
{
    SKV_ASSERT_OR(lab, 0);
    int i = find(lab, id);
    if (i < 0 || channel < 0 || channel >= lab->instruments[i]->channels)
        return 0;
    const instrument *it = lab->instruments[i];
    int wanted = it->count < capacity ? it->count : capacity;
    for (int k = 0; k < wanted; k++) {
        int at = skv_instrument_slot(it, wanted - 1 - k);
        if (times)
            times[k] = it->times[at];
        if (values)
            values[k] = it->values[channel * it->def.capacity + at];
    }
    return it->count;
}

/* CSV goes out in pieces of a line's length at most. */
typedef struct csv {
    skv_write *write;
    void *user;
    bool failed;
} csv;

static void put(csv *out, const char *text)
{
    if (!out->failed)
        out->failed = !out->write(text, strlen(text), out->user);
}

static void put_number(csv *out, double value, const char *format)
{
    char text[40] = "";
    if (isfinite(value))
        skv_format(text, sizeof text, format, value);
    put(out, text);
}

static void write_head(csv *out, instrument *const *list, int count)
{
    put(out, "t [s]");
    for (int i = 0; i < count; i++) {
        for (int c = 0; c < list[i]->channels; c++) {
            const skv_channel *channel = skv_instrument_channel(list[i]->def.kind, c);
            const char *name = list[i]->def.name;
            put(out, ",");
            put(out, *name ? name : skv_instrument_kind_name(list[i]->def.kind));
            put(out, " ");
            put(out, channel->name);
            if (*channel->unit) {
                put(out, " [");
                put(out, channel->unit);
                put(out, "]");
            }
        }
    }
    put(out, "\n");
}

skv_result skv_lab_write_csv(const skv_lab *lab, skv_instrument id, skv_write *write, void *user,
                             skv_error *error)
{
    SKV_ASSERT_OR(lab && write, SKV_ERROR_VALUE);
    int one = id ? find(lab, id) : -1;
    if (id && one < 0)
        return skv_fail(error, SKV_ERROR_VALUE, "lab: there is no instrument %u", id);
    instrument *const *list = id ? lab->instruments + one : lab->instruments;
    int count = id ? 1 : lab->count;
    int rows = count ? list[0]->count : 0;
    for (int i = 1; i < count; i++)
        rows = list[i]->count < rows ? list[i]->count : rows;
    csv out = {write, user, false};
    write_head(&out, list, count);
    for (int age = rows - 1; age >= 0; age--) {
        put_number(&out, list[0]->times[skv_instrument_slot(list[0], age)], "%.6f");
        for (int i = 0; i < count; i++) {
            for (int c = 0; c < list[i]->channels; c++) {
                put(&out, ",");
                put_number(
                    &out,
                    list[i]->values[c * list[i]->def.capacity + skv_instrument_slot(list[i], age)],
                    "%.9g");
            }
        }
        put(&out, "\n");
    }
    if (out.failed)
        return skv_fail(error, SKV_ERROR_FILE, "lab: the table could not be written");
    return SKV_OK;
}
