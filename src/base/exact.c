/* exp, log, pow, powers of ten, sin, cos and atan2 from +, -, *, / and sqrt alone. Invariant: no
 * call into libm, so the same bits come out of every C library. Speed does not matter: none of them
 * runs in a step.
 */
#include "base/exact.h"

#include <math.h>
#include <stdbool.h>

static const double LN2 = 0.69314718055994530942;

double skv_exp(double x)
{
    /* e^x = (e^(x / 2^k))^(2^k) would lose digits; split off powers of two instead. */
    int power = (int)(x / LN2 + (x < 0 ? -0.5 : 0.5));
    double rest = x - power * LN2;
    double term = 1, sum = 1;
    for (int i = 1; i <= 20; i++) {
        term *= rest / i;
        sum += term;
    }
    for (; power > 0; power--)
        sum *= 2;
    for (; power < 0; power++)
        sum *= 0.5;
    return sum;
}

double skv_log(double x)
{
    int power = 0;
    for (; x > 1.5; power++)
        x *= 0.5;
    for (; x < 0.75; power--)
        x *= 2;
    /* ln x = 2 artanh(t), t = (x-1)/(x+1), |t| <= 0.2: 16 terms reach double precision. */
    double t = (x - 1) / (x + 1), square = t * t, sum = 0;
    for (int i = 31; i >= 1; i -= 2)
        sum = sum * square + 1.0 / i;
    return 2 * t * sum + power * LN2;
}

double skv_pow(double b, double e)
{
    if (e == 0)
        return 1;
    return b > 0 ? skv_exp(e * skv_log(b)) : 0;
}

double skv_decade(double x)
{
    double up = 1, down = 1;
    while (up < 1e300 && up * 10 <= x)
        up *= 10;
    while (down < 1e300 && x * down < 1)
        down *= 10;
    return up / down;
}

/* sin or cos of an angle that is `quarters` quarters of a circle and a rest of at most half of one:
 * nine terms reach double precision. */
static double wave(long quarters, double rest)
{
    bool cosine = quarters & 1;
    double square = rest * rest, sum = 1;
    for (int i = cosine ? 17 : 16; i > 0; i -= 2)
        sum = 1 - square / (i * (i + 1.0)) * sum;
    double value = cosine ? sum : rest * sum;
    return quarters & 2 ? -value : value;
}

/* The angle plus so many quarters of a circle. A quarter is taken in two parts, the first short
 * enough to be multiplied exactly. */
static double wave_of(double x, int ahead)
{
    static const double quarter = 1.57079632673412561417, more = 6.07710050650619224932e-11;
    double quarters = floor(x / (quarter + more) + 0.5);
    return wave((long)quarters + ahead, (x - quarters * quarter) - quarters * more);
}

double skv_sin(double x)
{
    return wave_of(x, 0);
}

double skv_cos(double x)
{
    return wave_of(x, 1);
}

double skv_atan2(double y, double x)
{
    double across = fabs(x), up = fabs(y), larger = skv_max(across, up);
    if (!(larger > 0))
        return 0;
    /* Halve the angle three times, tan(a/2) = t / (1 + sqrt(1 + t^2)); then nine terms suffice. */
    double t = skv_min(across, up) / larger;
    for (int i = 0; i < 3; i++)
        t = t / (1 + sqrt(1 + t * t));
    double square = t * t, sum = 0;
    for (int k = 17; k >= 1; k -= 2)
        sum = 1.0 / k - square * sum;
    double angle = 8 * t * sum;
    if (up > across)
        angle = SKV_PI / 2 - angle;
    if (x < 0)
        angle = SKV_PI - angle;
    return y < 0 ? -angle : angle;
}
