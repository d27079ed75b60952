/* The numbers of a fluid beside the first, one row each: the one place that knows what a number is
 * called, its unit, range, default and meaning, and which snapshots have it. A new one is a member
 * of skv_liquid, a row here, its flag in world/liquids.h, and its use; scenes, their documentation,
 * checks, messages and snapshots follow from the rows.
 *
 * Whoever includes this defines what becomes of a row, in the order of snapshots:
 *   LIQUID_NUMBER(id, member, unit, least, most, standard, extra, help)
 * and, where it matters, of
 *   LIQUID_OF_MATERIAL(id, member, unit, least, most, help)   its default is the material's, and
 *                                                             every snapshot has it
 *   LIQUID_OF_FIRST(id, member, unit, least, most, extra, help)   its default, SKV_AS_FIRST, stands
 *                                                                 for that of the first fluid
 * `standard` is the default, and `extra` the flag of snapshots that have it. Those two kinds are
 * members of skv_fluid_def, too. All macros are undefined at the end.
 */
#ifndef LIQUID_OF_MATERIAL
#define LIQUID_OF_MATERIAL(id, member, unit, least, most, help)                                    \
    LIQUID_NUMBER(id, member, unit, least, most, 0, 0, help)
#endif
#ifndef LIQUID_OF_FIRST
#define LIQUID_OF_FIRST(id, member, unit, least, most, extra, help)                                \
    LIQUID_NUMBER(id, member, unit, least, most, SKV_AS_FIRST, extra, help)
#endif

/* clang-format off */
LIQUID_OF_MATERIAL(DENSITY, density, "kg/m^2", 0.01, 400000,
                   "mass of a square metre of the sheet; else the material's")
LIQUID_OF_MATERIAL(VISCOSITY, viscosity, "m^2/s", 0, 0.05,
                   "kinematic viscosity; else the material's")
/* Springs: the stiffest block of 0.2 m sags by 1 %, and takes twice the substeps of water. What has
 * yielded by all of its length holds nothing. What flows in less than a hundredth of a second is a
 * liquid to the eye. */
LIQUID_NUMBER(SHEAR_MODULUS, shear_modulus, "Pa", 0, 20000, 0, SKV_WITH_SPRINGS,
              "springs hold its shape, as in jelly; 0: a liquid")
LIQUID_NUMBER(YIELD, yield, "", 0, 1, 0.1, SKV_WITH_SPRINGS,
              "strain from which on its springs give way for good, if it is plastic")
LIQUID_NUMBER(PLASTICITY, plasticity, "1/s", 0, 100, 0, SKV_WITH_SPRINGS,
              "how fast they do; 0: it stays elastic")
/* Layers are calm with 400, and drops gain nothing from more than 100. */
LIQUID_NUMBER(INTERFACE_PUSH, interface_push, "m/s^2", 0, 400, 0, SKV_WITH_INTERFACES,
              "pushes it and other fluids apart: 20 for short lines, 100 for drops")
LIQUID_OF_FIRST(COHESION, cohesion, "m/s^2", 0, 500, SKV_WITH_COHESIONS,
                "surface tension of its own; else fluid.cohesion")
/* clang-format on */
#undef LIQUID_NUMBER
#undef LIQUID_OF_MATERIAL
#undef LIQUID_OF_FIRST
