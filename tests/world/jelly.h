/* Worlds of jelly, clay and goo. */
#ifndef SKV_TEST_JELLY_H
#define SKV_TEST_JELLY_H

#include "support/fixture.h"

#define JELLY_SPACING 0.0155f /* m */
#define JELLY_SIDE    0.2f    /* of a block, m */

/* Shear modulus, yield and plasticity, as of docs/springs.md. */
extern const float jelly_numbers[3], clay_numbers[3], goo_numbers[3];

/* A tank's definition with one fluid of these numbers beside water. */
skv_world_def jelly_def(const float *numbers, skv_solver_kind solver, float spacing);

/* A block of the first fluid beside water in the middle of the tank, its floor at y. */
skv_world *jelly_block(const skv_world_def *def, float y);

/* Jelly, clay and goo above water, with a drain in a corner. */
skv_world *jelly_medley(skv_solver_kind solver, int threads, skv_instruction_set set);

#endif
