/* Values as bytes. Invariant: what was written is read again bit for bit: a value that is not a
 * whole number of units, or too far away, goes as it is. */
#include "session/coder.h"

#include <math.h>
#include <string.h>

#define FARTHEST 1073741824.0 /* units */

/* The first number of a packed value; beyond these, units from the expected one. */
enum { AS_EXPECTED, PLAIN };

void skv_code_count(skv_coder *coder, uint64_t *value)
{
    uint64_t rest = *value, read = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        uint64_t byte = (rest & 0x7f) | (rest > 0x7f ? 0x80 : 0);
        skv_exchange(&coder->port, &byte, 1);
        read |= (byte & 0x7f) << shift;
        rest >>= 7;
        if (!(byte & 0x80))
            break;
    }
    *value = read;
}

static bool same(float a, float b)
{
    uint32_t bits_a, bits_b;
    memcpy(&bits_a, &a, sizeof bits_a);
    memcpy(&bits_b, &b, sizeof bits_b);
    return bits_a == bits_b;
}

static double units_of(float value, double unit)
{
    return floor((double)value / unit + 0.5);
}

static bool is_near(double units)
{
    return fabs(units) <= FARTHEST;
}

/* Distances to both sides, small ones first: 1, 2, 3... for -1, 1, -2... */
static uint64_t number_of(int64_t units)
{
    return units < 0 ? (uint64_t)(-units) * 2 - 1 : (uint64_t)units * 2;
}

static int64_t units_from(uint64_t number)
{
    return number & 1 ? -(int64_t)(number / 2) - 1 : (int64_t)(number / 2);
}

static void pack(skv_coder *coder, float value, float expected, double unit)
{
    double at = units_of(value, unit), from = units_of(expected, unit);
    uint64_t number = PLAIN;
    if (same(value, expected))
        number = AS_EXPECTED;
    else if (is_near(at) && is_near(from) && at != from && same((float)(at * unit), value))
        number = PLAIN + number_of((int64_t)(at - from));
    skv_code_count(coder, &number);
    if (number == PLAIN)
        skv_exchange_float(&coder->port, &value);
}

static float unpack(skv_coder *coder, float expected, double unit)
{
    uint64_t number = 0;
    float value = expected;
    skv_code_count(coder, &number);
    if (number == PLAIN) {
        skv_exchange_float(&coder->port, &value);
    } else if (number != AS_EXPECTED) {
        double at = units_of(expected, unit) + (double)units_from(number - PLAIN);
        value = (float)(at * unit);
    }
    return value;
}

void skv_code_float(skv_coder *coder, float *value, float expected, skv_unit unit)
{
    if (!isfinite(expected))
        expected = 0;
    if (!coder->units)
        skv_exchange_float(&coder->port, value);
    else if (coder->port.to)
        pack(coder, *value, expected, coder->units[unit]);
    else
        *value = unpack(coder, expected, coder->units[unit]);
}

bool skv_code_text(skv_coder *coder, char *text, size_t room)
{
    char read[256];
    if (coder->port.to) {
        skv_put_text(coder->port.to, text);
        return true;
    }
    skv_get_text(coder->port.from, read);
    size_t length = strlen(read);
    if (length < room)
        memcpy(text, read, length + 1);
    return length < room;
}
