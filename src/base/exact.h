/* Elementary functions that give the same bits on every machine: built from +, -, *, / and sqrt in
 * double precision only, because libm's exp, log and sin differ between libraries. */
#ifndef SKV_BASE_EXACT_H
#define SKV_BASE_EXACT_H

#include "base/ieee.h"

#include <stdbool.h>
#include <stdint.h>

#define SKV_PI 3.141592653589793

/* The smaller and the larger of two; b if a is NaN. Not fmin and fmax: of 0 and -0 these may return
 * either, and processors differ. */
static inline float skv_minf(float a, float b)
{
    return a < b ? a : b;
}

static inline float skv_maxf(float a, float b)
{
    return a > b ? a : b;
}

static inline double skv_min(double a, double b)
{
    return a < b ? a : b;
}

static inline double skv_max(double a, double b)
{
    return a > b ? a : b;
}

/* True if lo <= value <= hi; false for a NaN. */
static inline bool skv_within(double value, double lo, double hi)
{
    return value >= lo && value <= hi;
}

/* From -1/2 up to 1/2, as if by chance, by a number alone. */
static inline float skv_scatter(uint32_t number)
{
    number *= 0x9e3779b1u;
    number ^= number >> 16;
    number *= 0x85ebca6bu;
    number ^= number >> 13;
    return (float)(number & 0xffff) / 65536.0f - 0.5f;
}

/* e^x for |x| <= 700, relative error below 1e-14. */
double skv_exp(double x);

/* Natural logarithm for normal x > 0, absolute error below 1e-14 near 1, relative elsewhere. */
double skv_log(double x);

/* Sine and cosine for |x| <= 100000, absolute error below 1e-14. */
double skv_sin(double x);
double skv_cos(double x);

/* The angle of (x, y) against the x axis, -pi..pi, absolute error below 1e-14; 0 for (0, 0). */
double skv_atan2(double y, double x);

/* b^e for b >= 0; 0^e is 0 for e > 0 and 1 for e = 0. */
double skv_pow(double b, double e);

/* The largest power of ten, from 1e-300 to 1e300, that is not above x > 0 by more than rounding. */
double skv_decade(double x);

#endif
