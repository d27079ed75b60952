/** @file
 * Numbers: how people read and type them, in their language. U+2212 is the minus, U+00A0 stands
 * between groups of three digits and before a unit, decimals come after the language's own mark,
 * and there is never an exponent: "19,3 cm", "−9,81", "1 200".
 */
#ifndef SKVALP_NUMBERS_H
#define SKVALP_NUMBERS_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The signs of a language. */
typedef struct skv_numerals {
    const char *language; /**< "sv" */
    const char *decimal;  /**< "," */
    const char *group;    /**< U+00A0, also before units */
    const char *minus;    /**< U+2212 */
} skv_numerals;

/** The languages that are known, English first; null past the last. Static. */
SKV_API const skv_numerals *skv_numerals_at(int i);

/** Those of a language or locale, "sv" or "sv_SE.UTF-8"; English for those that are not known and
 * for null. */
SKV_API const skv_numerals *skv_numerals_of(const char *language);

/** A number's text. */
typedef struct skv_digits {
    char text[48];
} skv_digits;

/** With so many decimals, 0..9, halves rounded away from 0, and no minus before zeros; an en dash
 * for what is not finite, and from 1e15 on. `numerals` null: English. */
SKV_API skv_digits skv_number(double value, int decimals, const skv_numerals *numerals);

/** With so many significant digits, 1..9, of which zeros after the decimal mark are left out; whole
 * digits are never rounded away, and there are at most 9 decimals. */
SKV_API skv_digits skv_number_short(double value, int digits, const skv_numerals *numerals);

/** A unit in which people read what is in an SI unit. */
typedef struct skv_unit {
    char name[24]; /**< in English: "cm of water"; "" if it is a mere number */
    double size;   /**< how much of the SI unit one of it is */
    int decimals;  /**< that a reading has; -1: four significant digits */
} skv_unit;

/** The unit for readings in `si`, of a skv_channel: if `plain`, the one that people know, "cm of
 * water" for "Pa m"; else, and where they know no other, `si` itself, "m/s²" for "m/s^2". */
SKV_API skv_unit skv_unit_of(const char *si, bool plain);

/** The number of a reading in it, "24.5" of 2403 Pa m; its name, translated, follows a
 * skv_numerals.group. */
SKV_API skv_digits skv_number_in(double value, skv_unit unit, const skv_numerals *numerals);

/** What somebody typed as skv_parse_number takes it: "-9.81" of "−9,81", "1200" of "1 200". Either
 * mark is read; but with a point as mark a comma before three last digits may part thousands, which
 * is left as it is. Whatever is no number is copied as it stands. Cut to `size`. */
SKV_API void skv_number_read(const char *typed, const skv_numerals *numerals, char *plain,
                             size_t size);

/** The reverse for a field: a number as the library writes it ("1e-06"), with all its digits as
 * people read them; other texts are copied. */
SKV_API skv_digits skv_number_shown(const char *plain, const skv_numerals *numerals);

#ifdef __cplusplus
}
#endif
#endif
