/* printf's formatting without stdio and locale: the core is freestanding, and a host may have set a
 * locale that writes numbers with a comma. Invariant: a double is turned into its exact decimal
 * digits and rounded once, half to even, so the text is that of a correct vsnprintf. */
#include "skvalp/base.h"

#include <string.h>

/* Where text goes; what is beyond its room is counted but not kept. */
typedef struct sink {
    char *text;
    size_t room, used;
} sink;

/* A directive: %-010.3ld */
typedef struct directive {
    bool left, zeros, plus, alternate;
    int width, precision; /* precision -1: none given */
    int length;           /* 'H' for hh, 'h', 'l', 'L' for ll, 'z'; 0: none */
    char conversion;
} directive;

static void put(sink *s, const char *text, size_t length)
{
    if (s->used < s->room) {
        size_t left = s->room - s->used;
        memcpy(s->text + s->used, text, length < left ? length : left);
    }
    s->used += length;
}

static void repeat(sink *s, char c, int count)
{
    for (; count > 0; count--)
        put(s, &c, 1);
}

/* Pads a converted piece to its width; zeros come between the sign or 0x and the digits. */
static void put_padded(sink *s, const directive *d, const char *prefix, const char *body,
                       size_t length, bool zeros)
{
    size_t prefix_length = strlen(prefix);
    int pad = d->width - (int)(prefix_length + length);
    if (!d->left && !zeros)
        repeat(s, ' ', pad);
    put(s, prefix, prefix_length);
    if (!d->left && zeros)
        repeat(s, '0', pad);
    put(s, body, length);
    if (d->left)
        repeat(s, ' ', pad);
}

static void put_integer(sink *s, const directive *d, uint64_t value, bool negative)
{
    unsigned base = d->conversion == 'x' || d->conversion == 'X' ? 16 : 10;
    const char *symbols = d->conversion == 'X' ? "0123456789ABCDEF" : "0123456789abcdef";
    char digits[64];
    size_t at = sizeof digits;
    int least = d->precision < 0 ? 1 : d->precision < 60 ? d->precision : 60;
    const char *prefix = negative ? "-" : d->plus && d->conversion == 'd' ? "+" : "";
    if (d->alternate && base == 16 && value)
        prefix = d->conversion == 'X' ? "0X" : "0x";
    for (; value || (int)(sizeof digits - at) < least; value /= base)
        digits[--at] = symbols[value % base];
    put_padded(s, d, prefix, digits + at, sizeof digits - at, d->zeros && d->precision < 0);
}

#define LIMB 1000000000u

/* An exact decimal number 0.d1 d2 d3 ... * 10^point, without leading or trailing zeros. A double
 * has at most 767 digits, which are 86 limbs in base 10^9. */
enum { MOST_LIMBS = 86 };
typedef struct decimal {
    int count, point;
    uint8_t digit[800];
} decimal;

static void drop_trailing_zeros(decimal *n)
{
    while (n->count && n->digit[n->count - 1] == 0)
        n->count--;
}

/* Multiplies a whole number in base 10^9, lowest limb first; returns its new length. */
static int multiply(uint32_t *limb, int count, uint32_t factor)
{
    uint64_t carry = 0;
    for (int i = 0; i < count; i++) {
        carry += (uint64_t)limb[i] * factor;
        limb[i] = (uint32_t)(carry % LIMB);
        carry /= LIMB;
    }
    if (carry)
        limb[count++] = (uint32_t)carry;
    return count;
}

static void write_limbs(const uint32_t *limb, int count, decimal *n)
{
    bool leading = true;
    for (int i = count - 1; i >= 0; i--) {
        for (uint32_t place = LIMB / 10; place; place /= 10) {
            uint8_t digit = (uint8_t)(limb[i] / place % 10);
            leading = leading && digit == 0;
            if (!leading)
                n->digit[n->count++] = digit;
        }
    }
}

/* The digits of a finite, positive number m 2^e: those of m 2^e or of m 5^-e. */
static void make_decimal(double value, decimal *n)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    uint64_t mantissa = bits & ((1ull << 52) - 1);
    int exponent = (int)(bits >> 52 & 0x7ff);
    mantissa |= exponent ? 1ull << 52 : 0;
    exponent = (exponent ? exponent : 1) - 1075;
    for (; mantissa && mantissa % 2 == 0; mantissa /= 2)
        exponent++;
    uint32_t limb[MOST_LIMBS];
    int count = 0, behind = exponent < 0 ? -exponent : 0;
    for (; mantissa; mantissa /= LIMB)
        limb[count++] = (uint32_t)(mantissa % LIMB);
    for (int left = exponent; left > 0; left -= 29)
        count = multiply(limb, count, 1u << (left < 29 ? left : 29));
    for (int left = behind; left > 0; left -= 12) {
        uint32_t factor = 1;
        for (int i = 0; i < left && i < 12; i++)
            factor *= 5;
        count = multiply(limb, count, factor);
    }
    n->count = 0;
    write_limbs(limb, count, n);
    n->point = n->count - behind;
    drop_trailing_zeros(n);
}

/* Keeps `digits` digits, rounding half to even. */
static void round_to(decimal *n, int digits)
{
    if (digits >= n->count)
        return;
    if (digits < 0) {
        n->count = 0;
        return;
    }
    bool half = n->digit[digits] == 5 && digits + 1 == n->count;
    bool odd = digits > 0 && n->digit[digits - 1] % 2;
    bool up = half ? odd : n->digit[digits] >= 5;
    n->count = digits;
    if (up) {
        int i = digits - 1;
        while (i >= 0 && n->digit[i] == 9)
            i--;
        n->count = i + 1;
        if (i >= 0) {
            n->digit[i]++;
        } else {
            n->digit[0] = 1;
            n->count = 1;
            n->point++;
        }
    }
    drop_trailing_zeros(n);
}

static char digit_at(const decimal *n, int place)
{
    return (char)('0' + (place >= 0 && place < n->count ? n->digit[place] : 0));
}

/* Room for any double with any precision up to MOST_DECIMALS. */
enum { MOST_DECIMALS = 60, NUMBER_ROOM = 400 };

static size_t write_fixed(const decimal *n, int decimals, char *out)
{
    size_t used = 0;
    for (int place = n->point > 0 ? 0 : n->point - 1; place < n->point; place++)
        out[used++] = digit_at(n, place);
    if (decimals > 0)
        out[used++] = '.';
    for (int place = n->point; place < n->point + decimals; place++)
        out[used++] = digit_at(n, place);
    return used;
}

static size_t write_exponential(const decimal *n, int decimals, char *out)
{
    size_t used = 0;
    int exponent = n->count ? n->point - 1 : 0;
    out[used++] = digit_at(n, 0);
    if (decimals > 0)
        out[used++] = '.';
    for (int i = 1; i <= decimals; i++)
        out[used++] = digit_at(n, i);
    out[used++] = 'e';
    out[used++] = exponent < 0 ? '-' : '+';
    unsigned size = (unsigned)(exponent < 0 ? -exponent : exponent);
    if (size >= 100)
        out[used++] = (char)('0' + size / 100);
    out[used++] = (char)('0' + size / 10 % 10);
    out[used++] = (char)('0' + size % 10);
    return used;
}

static void put_double(sink *s, const directive *d, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    bool negative = bits >> 63;
    const char *prefix = negative ? "-" : d->plus ? "+" : "";
    bits &= ~(1ull << 63);
    if (bits >= 0x7ffull << 52) {
        put_padded(s, d, prefix, bits > 0x7ffull << 52 ? "nan" : "inf", 3, false);
        return;
    }
    decimal n;
    make_decimal(negative ? -value : value, &n);
    int decimals = d->precision < 0               ? 6
                   : d->precision < MOST_DECIMALS ? d->precision
                                                  : MOST_DECIMALS;
    char out[NUMBER_ROOM];
    size_t length;
    if (d->conversion == 'f') {
        round_to(&n, n.point + decimals);
        if (n.count == 0)
            n.point = 0;
        length = write_fixed(&n, decimals, out);
    } else if (d->conversion == 'e') {
        round_to(&n, decimals + 1);
        length = write_exponential(&n, decimals, out);
    } else {
        /* g: so many digits in all, whichever form is shorter, without trailing zeros. */
        int digits = decimals ? decimals : 1;
        round_to(&n, digits);
        int exponent = n.count ? n.point - 1 : 0;
        if (exponent < -4 || exponent >= digits) {
            length = write_exponential(&n, n.count > 1 ? n.count - 1 : 0, out);
        } else {
            n.point = n.count ? n.point : 1;
            int behind = n.count - n.point;
            length = write_fixed(&n, behind > 0 ? behind : 0, out);
        }
    }
    put_padded(s, d, prefix, out, length, d->zeros);
}

/* A number in the format, or the next argument for a star. */
static int read_number(const char **at, va_list *arguments)
{
    int number = 0;
    if (**at == '*') {
        ++*at;
        return va_arg(*arguments, int);
    }
    for (; **at >= '0' && **at <= '9'; ++*at)
        number = number < 100000 ? 10 * number + (**at - '0') : number;
    return number;
}

/* Reads what follows a %; leaves `*at` behind the conversion. */
static directive read_directive(const char **at, va_list *arguments)
{
    directive d = {.precision = -1};
    for (;; ++*at) {
        if (**at == '-')
            d.left = true;
        else if (**at == '0')
            d.zeros = true;
        else if (**at == '+')
            d.plus = true;
        else if (**at == '#')
            d.alternate = true;
        else
            break;
    }
    d.width = read_number(at, arguments);
    if (d.width < 0) {
        d.left = true;
        d.width = -d.width;
    }
    if (**at == '.') {
        ++*at;
        d.precision = read_number(at, arguments);
    }
    if (**at == 'h' || **at == 'l' || **at == 'z')
        d.length = (unsigned char)*(*at)++;
    if ((d.length == 'h' || d.length == 'l') && **at == d.length) {
        d.length += 'H' - 'h';
        ++*at;
    }
    d.conversion = **at;
    *at += **at != 0;
    return d;
}

static int64_t signed_argument(int length, va_list *arguments)
{
    if (length == 'L')
        return va_arg(*arguments, long long);
    if (length == 'l')
        return va_arg(*arguments, long);
    if (length == 'z')
        return va_arg(*arguments, ptrdiff_t);
    int value = va_arg(*arguments, int);
    return length == 'h' ? (short)value : length == 'H' ? (signed char)value : value;
}

static uint64_t unsigned_argument(int length, va_list *arguments)
{
    if (length == 'L')
        return va_arg(*arguments, unsigned long long);
    if (length == 'l')
        return va_arg(*arguments, unsigned long);
    if (length == 'z')
        return va_arg(*arguments, size_t);
    unsigned value = va_arg(*arguments, unsigned);
    return length == 'h' ? (unsigned short)value : length == 'H' ? (unsigned char)value : value;
}

/* Converts one directive; false if it is none of those known here. */
static bool convert(sink *s, directive *d, va_list *arguments)
{
    switch (d->conversion) {
    case '%':
        put(s, "%", 1);
        return true;
    case 'c': {
        char c = (char)va_arg(*arguments, int);
        put_padded(s, d, "", &c, 1, false);
        return true;
    }
    case 's': {
        const char *text = va_arg(*arguments, const char *);
        size_t length = 0;
        while ((d->precision < 0 || length < (size_t)d->precision) && text[length])
            length++;
        put_padded(s, d, "", text, length, false);
        return true;
    }
    case 'd':
    case 'i': {
        int64_t value = signed_argument(d->length, arguments);
        d->conversion = 'd';
        put_integer(s, d, value < 0 ? 0 - (uint64_t)value : (uint64_t)value, value < 0);
        return true;
    }
    case 'u':
    case 'x':
    case 'X':
        put_integer(s, d, unsigned_argument(d->length, arguments), false);
        return true;
    case 'f':
    case 'e':
    case 'g':
        put_double(s, d, va_arg(*arguments, double));
        return true;
    default:
        return false;
    }
}

size_t skv_format_list(char *text, size_t room, const char *format, va_list arguments)
{
    sink s = {text, room > 0 ? room - 1 : 0, 0};
    /* A va_list may be an array, which as a parameter is none any more. */
    va_list list;
    va_copy(list, arguments);
    const char *at = format;
    while (*at) {
        size_t plain = 0;
        while (at[plain] && at[plain] != '%')
            plain++;
        put(&s, at, plain);
        at += plain;
        if (!*at)
            break;
        const char *begin = at++;
        directive d = read_directive(&at, &list);
        if (!convert(&s, &d, &list)) {
            put(&s, begin, strlen(begin));
            break;
        }
    }
    va_end(list);
    if (room)
        text[s.used < s.room ? s.used : s.room] = 0;
    return s.used;
}

size_t skv_format(char *text, size_t room, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    size_t length = skv_format_list(text, room, format, arguments);
    va_end(arguments);
    return length;
}
