/* A sweep: the values that a parameter takes one after the other. */
#ifndef SKV_EXPERIMENTS_SWEEP_H
#define SKV_EXPERIMENTS_SWEEP_H

#include "skvalp/experiments.h"

/* Room for any value: 17 digits with sign, point and exponent, or a choice's name. */
enum { VALUE_SIZE = 32 };

typedef struct sweep {
    const skv_field *field;
    int count;
    char (*values)[VALUE_SIZE]; /* as skv_value_write has them; owned */
} sweep;

/* A number in the fewest digits that read back to the same bits; empty if it is not finite. */
void skv_exact_number(double value, char text[VALUE_SIZE]);

/* Checks a value of a field and writes it as it stands in names and tables. */
skv_result skv_value_write(const skv_field *field, const char *value, char text[VALUE_SIZE],
                           skv_error *error);

/* Reads "1,2,5" or "FROM:TO:NUMBER", at most `most` values. `s` needs skv_sweep_free afterwards,
 * also on failure. */
skv_result skv_sweep_read(sweep *s, const skv_field *field, const char *text, int most,
                          skv_error *error);
void skv_sweep_free(sweep *s);

#endif
