/* printf's formatting without stdio: the same text in every locale and on every platform. */
#ifndef SKV_BASE_FORMAT_H
#define SKV_BASE_FORMAT_H

#include <stdarg.h>
#include <stddef.h>

/* Writes what vsnprintf would in the C locale, cut to `room` bytes with the zero at the end. Knows
 * the conversions d i u x X c s f e g and %, the flags - 0 + and # (of x), width, precision and the
 * lengths hh h l ll z; a directive beyond that and what follows it is copied as it stands. */
void skv_format(char *text, size_t room, const char *format, va_list arguments);

#endif
