/* Decimal text to a double, without the C library's locale.
 *
 * Invariant: digits 10^e is computed as a whole number (times a power of two if e < 0) with a
 * remainder of which only "is there any" matters, and rounded once, half to even, so the result is
 * that of a correct strtod.
 */
#include "skvalp/base.h"

#include <math.h>

enum {
    LONGEST = 60,        /* characters, so digits too */
    MOST_EXPONENT = 400, /* beyond this power of ten a double overflows, or becomes 0 */
    MOST_LIMBS = 64      /* 60 digits, and 64 bits more than 10^(400 + 60) has */
};

/* A whole number, lowest limb first. */
typedef struct whole {
    uint32_t limb[MOST_LIMBS];
    int count;
    bool inexact; /* something was lost below */
} whole;

static void multiply_add(whole *n, uint32_t factor, uint32_t addend)
{
    uint64_t carry = addend;
    for (int i = 0; i < n->count; i++) {
        carry += (uint64_t)n->limb[i] * factor;
        n->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry)
        n->limb[n->count++] = (uint32_t)carry;
}

static void divide(whole *n, uint32_t divisor)
{
    uint64_t rest = 0;
    for (int i = n->count - 1; i >= 0; i--) {
        rest = rest << 32 | n->limb[i];
        n->limb[i] = (uint32_t)(rest / divisor);
        rest %= divisor;
    }
    while (n->count > 0 && n->limb[n->count - 1] == 0)
        n->count--;
    n->inexact = n->inexact || rest;
}

/* n := 2^32 n */
static void shift(whole *n)
{
    for (int i = n->count++; i > 0; i--)
        n->limb[i] = n->limb[i - 1];
    n->limb[0] = 0;
}

static int bit_length(const whole *n)
{
    int bits = 32 * n->count;
    for (uint32_t top = n->limb[n->count - 1]; !(top >> 31); top <<= 1)
        bits--;
    return bits;
}

static bool bit_at(const whole *n, int place)
{
    return n->limb[place / 32] >> place % 32 & 1;
}

/* n 2^scale, rounded to the nearest double. */
static double round_to_double(const whole *n, int scale)
{
    int drop = bit_length(n) - 53; /* bits below those of a double, or of the smallest double */
    if (drop < -1074 - scale)
        drop = -1074 - scale;
    uint64_t mantissa = 0;
    for (int place = 32 * n->count - 1; place >= drop && place >= 0; place--)
        mantissa = mantissa << 1 | bit_at(n, place);
    if (drop > 0 && drop <= 32 * n->count && bit_at(n, drop - 1)) {
        bool beyond_half = n->inexact;
        for (int place = 0; place < drop - 1; place++)
            beyond_half = beyond_half || bit_at(n, place);
        mantissa += beyond_half || mantissa % 2;
    }
    double value = (double)mantissa;
    int power = drop > 0 ? drop + scale : scale;
    for (; power > 0; power--)
        value *= 2;
    for (; power < 0; power++)
        value *= 0.5;
    return value;
}

/* digits 10^exponent */
static double assemble(whole *digits, int exponent)
{
    if (digits->count == 0)
        return 0;
    for (int i = 0; i < exponent; i++)
        multiply_add(digits, 10, 0);
    /* The quotient keeps more than 64 bits: 10^3 is less than 2^10. */
    int limbs = exponent < 0 ? (-exponent * 10 / 3 + 1) / 32 + 3 : 0;
    for (int i = 0; i < limbs; i++)
        shift(digits);
    for (int i = 0; i < -exponent; i++)
        divide(digits, 10);
    return round_to_double(digits, -32 * limbs);
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Adds the digits at *at to `n` and returns how many there are. */
static int read_digits(const char **at, whole *n)
{
    int count = 0;
    for (; is_digit(**at); ++*at, count++)
        multiply_add(n, 10, (uint32_t)(**at - '0'));
    return count;
}

/* Reads what may follow an e; false if it is no whole number. */
static bool read_exponent(const char **at, int *exponent)
{
    bool negative = **at == '-';
    int size = 0;
    *at += **at == '-' || **at == '+';
    if (!is_digit(**at))
        return false;
    for (; is_digit(**at); ++*at)
        size = size < 10000 ? 10 * size + (**at - '0') : size;
    *exponent += negative ? -size : size;
    return true;
}

bool skv_parse_number(const char *text, double *value)
{
    whole digits = {.count = 0};
    int exponent = 0;
    size_t length = 0;
    while (text[length] != '\0' && length <= LONGEST)
        length++;
    if (length > LONGEST)
        return false;
    const char *at = text;
    at += *at == '-' || *at == '+';
    if (read_digits(&at, &digits) == 0)
        return false;
    if (*at == '.') {
        at++;
        exponent = -read_digits(&at, &digits);
        if (exponent == 0)
            return false;
    }
    if (*at == 'e' || *at == 'E') {
        at++;
        if (!read_exponent(&at, &exponent))
            return false;
    }
    if (*at != '\0' || (exponent > MOST_EXPONENT && digits.count > 0))
        return false;
    double size = exponent < -MOST_EXPONENT - LONGEST || exponent > MOST_EXPONENT
                      ? 0
                      : assemble(&digits, exponent);
    if (!isfinite(size))
        return false;
    *value = text[0] == '-' ? -size : size;
    return true;
}
