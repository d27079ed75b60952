/* How people write a unit. */
#ifndef SKV_BASE_UNIT_H
#define SKV_BASE_UNIT_H

#include <stddef.h>

/* "m²/s" of "m^2/s", cut to `room` bytes. What programs read, tables and messages keep the latter.
 */
void skv_spell_unit(const char *si, char *text, size_t room);

#endif
