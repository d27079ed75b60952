/* Packed logs. Invariant: unpacking gives the same records, bit for bit; and from any bytes at all
 * it gives whole records in order, or nothing. */
#include "session/packed_log.h"

#include <math.h>

#include "base/memory.h"

#define EARTH_GRAVITY 9.81
/* A log beyond this is no game of a person: half an hour of four hands in motion. Three times as
 * much is held while it grows. */
#define LARGEST_LOG ((size_t)16 << 20)

/* A record begins with a byte: kind, and frames since the one before if these are few. */
enum { KIND_BITS = 5, KIND_MASK = (1 << KIND_BITS) - 1, MANY_FRAMES = 7 };
_Static_assert(SKV_COMMAND_KINDS <= KIND_MASK + 1, "5 bits");

skv_steps skv_steps_of(const skv_world *world)
{
    const skv_terrain *terrain = skv_world_terrain(world);
    double size = fmax((double)skv_terrain_width(terrain), (double)skv_terrain_height(terrain));
    float x, y;
    int exponent;
    skv_world_gravity(world, &x, &y);
    frexp(size / 4096, &exponent);
    skv_steps steps = {.length = ldexp(0.5, exponent)};
    steps.speed = 64 * steps.length;
    steps.strength = sqrt((double)x * x + (double)y * y);
    /* In a weightless scene keys and tilt still do what they say. */
    if (steps.strength == 0)
        steps.strength = EARTH_GRAVITY;
    steps.gravity = steps.strength / 1024;
    return steps;
}

double skv_in_steps(double value, double unit)
{
    return unit > 0 ? floor(value / unit + 0.5) * unit : value;
}

/* ---- Writing --------------------------------------------------------------------------------- */

static void put_begin(skv_writer *w, skv_command_kind kind, uint64_t frames)
{
    skv_coder coder = {.port.to = w};
    uint64_t few = frames < MANY_FRAMES ? frames : MANY_FRAMES, rest = frames - few;
    skv_put(w, (uint64_t)kind | few << KIND_BITS, 1);
    if (few == MANY_FRAMES)
        skv_code_count(&coder, &rest);
}

static void put_log(skv_writer *w, const skv_log *log, skv_packer *packer)
{
    int64_t before = 0;
    for (int i = 0; i < SKV_UNITS; i++)
        skv_put_double(w, packer->units[i]);
    for (size_t at = 0; at < log->size;) {
        skv_command command;
        int64_t frame = skv_log_frame(log, at);
        at = skv_log_read(log, at, &command);
        put_begin(w, command.kind, (uint64_t)(frame - before));
        skv_command_pack(&command, packer, w);
        before = frame;
    }
}

static skv_packer *make_packer(const double units[SKV_UNITS])
{
    skv_packer *packer = skv_calloc(1, sizeof *packer);
    for (int i = 0; packer && i < SKV_UNITS; i++)
        packer->units[i] = units[i];
    return packer;
}

uint8_t *skv_log_pack(const skv_log *log, const skv_steps *steps, size_t *size)
{
    const double units[SKV_UNITS] = {
        [SKV_UNIT_LENGTH] = steps->length,
        [SKV_UNIT_SPEED] = steps->speed,
        [SKV_UNIT_GRAVITY] = steps->gravity,
    };
    uint8_t *bytes = NULL;
    /* Twice: first the bytes are only counted. */
    for (int pass = 0; pass < 2; pass++) {
        skv_packer *packer = make_packer(units);
        skv_writer writer = {bytes, 0};
        if (packer)
            put_log(&writer, log, packer);
        skv_free(packer);
        *size = writer.used;
        if (pass == 0 && packer)
            bytes = skv_calloc(writer.used, 1);
        if (!packer || !bytes) {
            skv_free(bytes);
            return NULL;
        }
    }
    return bytes;
}

/* ---- Reading --------------------------------------------------------------------------------- */

static skv_result refuse(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_FORMAT, "its log is damaged; take another copy");
}

static bool get_begin(skv_reader *r, skv_command_kind *kind, uint64_t *frames)
{
    skv_coder coder = {.port.from = r};
    unsigned begin = (unsigned)skv_get(r, 1);
    *kind = (skv_command_kind)(begin & KIND_MASK);
    *frames = begin >> KIND_BITS;
    uint64_t rest = 0;
    if (*frames == MANY_FRAMES)
        skv_code_count(&coder, &rest);
    *frames += rest;
    return !r->failed && (unsigned)*kind < SKV_COMMAND_KINDS && rest <= UINT32_MAX;
}

static skv_result get_log(skv_reader *r, skv_log *log, int64_t frames, bool checks,
                          skv_packer *packer, skv_error *error)
{
    int64_t frame = 0;
    skv_result result = SKV_OK;
    while (r->at < r->size && result == SKV_OK) {
        skv_command command;
        skv_command_kind kind;
        uint64_t passed;
        if (!get_begin(r, &kind, &passed) || (int64_t)passed > frames - frame ||
            !skv_command_unpack(kind, &command, packer, r))
            return refuse(error);
        frame += (int64_t)passed;
        if (log->size > LARGEST_LOG)
            return skv_fail(error, SKV_ERROR_LIMIT,
                            "its log has more than the %zu bytes that are read", LARGEST_LOG);
        if (checks || kind != SKV_COMMAND_CHECK)
            result = skv_log_append(log, frame, &command, error);
    }
    return result;
}

skv_result skv_log_unpack(skv_log *log, const uint8_t *bytes, size_t size, int64_t frames,
                          bool checks, skv_error *error)
{
    skv_reader reader = {.bytes = bytes, .size = size};
    double units[SKV_UNITS];
    for (int i = 0; i < SKV_UNITS; i++) {
        units[i] = skv_get_double(&reader);
        if (reader.failed || !(units[i] > 0 && isfinite(units[i])))
            return refuse(error);
    }
    skv_packer *packer = make_packer(units);
    if (!packer)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a log");
    skv_result result = get_log(&reader, log, frames, checks, packer, error);
    skv_free(packer);
    return result;
}
