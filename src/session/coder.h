/* Values of commands as bytes: plainly, as a player's log holds them, or packed, as replays and
 * links do. One way for writing and reading. */
#ifndef SKV_SESSION_CODER_H
#define SKV_SESSION_CODER_H

#include "base/bytes.h"

/* What packed values are counted in. */
typedef enum skv_unit { SKV_UNIT_LENGTH, SKV_UNIT_SPEED, SKV_UNIT_GRAVITY, SKV_UNITS } skv_unit;

typedef struct skv_coder {
    skv_port port;
    const double *units; /* of SKV_UNITS; null: plainly */
} skv_coder;

/* A whole number, 7 bits a byte, the lowest first. */
void skv_code_count(skv_coder *coder, uint64_t *value);

/* A value in its own 4 bytes or, packed, as the units from what is expected: a byte if that is
 * near, and without loss whatever it is. */
void skv_code_float(skv_coder *coder, float *value, float expected, skv_unit unit);

/* A text that fits; false if what is read does not. */
bool skv_code_text(skv_coder *coder, char *text, size_t room);

#endif
