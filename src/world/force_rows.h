/* The numbers of a force field, one row each: the one place that knows what a number is called, its
 * unit, range and meaning. A new one is a member of skv_force, a row here, and its use; scenes,
 * their documentation, checks and snapshots follow from the rows.
 *
 * Whoever includes this defines what becomes of a row, FORCE_NUMBER(id, member, unit, least, most,
 * help), in the order of snapshots. All are 0 by default, and do nothing then.
 */
/* clang-format off */
FORCE_NUMBER(AX, ax, "m/s^2", -1000, 1000, "acceleration to the right, like gravity")
FORCE_NUMBER(AY, ay, "m/s^2", -1000, 1000, "acceleration upwards")
FORCE_NUMBER(TOWARD_X, toward_x, "m", -1000, 1000, "the point of attraction")
FORCE_NUMBER(TOWARD_Y, toward_y, "m", -1000, 1000, "the point of attraction")
FORCE_NUMBER(ATTRACTION, attraction, "m/s^2", -1000, 1000,
             "acceleration towards the point; negative: away from it")
FORCE_NUMBER(WIND_X, wind_x, "m/s", -100, 100, "speed to the right that the fluid is to take")
FORCE_NUMBER(WIND_Y, wind_y, "m/s", -100, 100, "speed upwards that it is to take")
FORCE_NUMBER(DRAG, drag, "1/s", 0, 1000, "how fast it takes the wind's speed")
FORCE_NUMBER(SPIN, spin, "rad/s", -100, 100,
             "how fast the wind turns about the area's middle, counter-clockwise")
/* clang-format on */
#undef FORCE_NUMBER
