/* The fluids of a world as data: what they may be, and as bytes. */
#ifndef SKV_WORLD_LIQUIDS_H
#define SKV_WORLD_LIQUIDS_H

#include "base/bytes.h"
#include "skvalp/world.h"
#include "solver/solver.h"

/* The cookie of skv_liquid. */
extern const uint32_t skv_liquid_cookie;

/* The name of every world's first fluid. */
#define SKV_FIRST_FLUID "water"

/* The color of a fluid that has none of its own. */
enum { SKV_NO_COLOR = -1 };

/* The cohesion of a fluid that has the first one's. */
enum { SKV_AS_FIRST = -1 };

/* Whether the fluids of a definition may be one world's; a message names the first that may not. */
skv_result skv_check_liquids(const skv_world_def *def, skv_error *error);

/* The first member of a fluid beside those before it in a definition's list that is wrong, such as
 * "name", and in `text` what is wrong with it, such as "is empty; ..."; null: nothing is. */
const char *skv_liquid_complain(const skv_world_def *def, int index, char *text, size_t size);

/* Fails for a number that none of so many fluids has. */
skv_result skv_check_fluid(int fluid, int fluids, skv_error *error);

/* Writes or reads a dye and a fluid's number as one byte: the dye, and 16 times the number. */
void skv_exchange_contents(skv_port *port, int *dye, int *fluid);

/* What a snapshot says of fluids beside what all have, if one has it: flags of the snapshot. */
enum {
    SKV_WITH_SPRINGS = 512,
    SKV_WITH_INTERFACES = 2048, /* it pushes others apart */
    SKV_WITH_COHESIONS = 8192,  /* of its own */
    SKV_LIQUID_EXTRAS = SKV_WITH_SPRINGS | SKV_WITH_INTERFACES | SKV_WITH_COHESIONS
};

/* Writes or reads the further fluids of a definition, with these extras; false if they are none. */
bool skv_exchange_liquids(skv_port *port, skv_world_def *def, unsigned extras);

/* Those of a world's fluids. */
unsigned skv_world_liquid_extras(const skv_world *world);

/* The greatest cohesion of a world's fluids, m/s^2: what its constants are made for. */
float skv_world_most_cohesion(const skv_world *world);

/* Notes what share of that each has. */
void skv_world_share_cohesion(skv_world *world);

/* Tells a solver of which fluids particles are, and what these do that it has to know by fluid: if
 * one pushes others, or they differ in cohesion. */
void skv_world_tell_fluids(const skv_world *world, skv_solver_particles *particles);

#endif
