/* The fluids of a world as data: what they may be, and as bytes. */
#ifndef SKV_WORLD_LIQUIDS_H
#define SKV_WORLD_LIQUIDS_H

#include "base/bytes.h"
#include "skvalp/world.h"

/* The cookie of skv_liquid. */
extern const uint32_t skv_liquid_cookie;

/* The name of every world's first fluid. */
#define SKV_FIRST_FLUID "water"

/* The color of a fluid that has none of its own. */
enum { SKV_NO_COLOR = -1 };

/* Whether the fluids of a definition may be one world's; a message names the first that may not. */
skv_result skv_check_liquids(const skv_world_def *def, skv_error *error);

/* Which of a fluid's values is wrong. */
typedef enum skv_liquid_member {
    SKV_LIQUID_SANE,
    SKV_LIQUID_WRONG_NAME,
    SKV_LIQUID_WRONG_DENSITY,
    SKV_LIQUID_WRONG_VISCOSITY,
    SKV_LIQUID_WRONG_COLOR,
    SKV_LIQUID_WRONG_MODULUS,
    SKV_LIQUID_WRONG_YIELD,
    SKV_LIQUID_WRONG_PLASTICITY,
    SKV_LIQUID_WRONG_INTERFACE
} skv_liquid_member;

/* The first wrong value of a fluid beside those before it in a definition's list, and in `text`
 * what is wrong with it, such as "is empty; ...". */
skv_liquid_member skv_liquid_complain(const skv_world_def *def, int index, char *text, size_t size);

/* Fails for a number that none of so many fluids has. */
skv_result skv_check_fluid(int fluid, int fluids, skv_error *error);

/* Writes or reads a dye and a fluid's number as one byte: the dye, and 16 times the number. */
void skv_exchange_contents(skv_port *port, int *dye, int *fluid);

/* What is said of a fluid beside what all have. */
typedef struct skv_liquid_extras {
    bool springs, interfaces;
} skv_liquid_extras;

/* Writes or reads the further fluids of a definition, with these extras or without; false if they
 * are none. */
bool skv_exchange_liquids(skv_port *port, skv_world_def *def, skv_liquid_extras extras);

/* Whether a fluid of a world pushes others apart. */
bool skv_world_has_interfaces(const skv_world *world);

/* The fluids of its particles, if one does; else null. */
const uint8_t *skv_world_pushed(const skv_world *world);

#endif
