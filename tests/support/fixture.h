/* Worlds that several tests use. */
#ifndef SKV_TEST_FIXTURE_H
#define SKV_TEST_FIXTURE_H

#include "skvalp/skvalp.h"

/* Adds so many liquids to a definition, like the default fluid: "the 2.", "the 3." and so on. */
void fixture_add_liquids(skv_world_def *def, int count);

/* Makes a world's particles such of all its fluids in turn. */
void fixture_mix_fluids(skv_world *world);

/* A definition with these values; gravity as by default, no sleep. */
skv_world_def fixture_def(skv_law law, skv_solver_kind solver, float viscosity, float spacing,
                          int threads);

/* A host with so many threads, for loading and copying; valid until the next call. */
const skv_world_def *fixture_host(int threads);

/* Fills a box and returns how many particles were added; fails the test on any error. */
int fixture_fill(skv_world *world, float x0, float y0, float x1, float y1);
/* The same with another fluid than the first. */
int fixture_fill_with(skv_world *world, float x0, float y0, float x1, float y1, int fluid);

/* A closed tank of 1.6 x 0.9 m without particles; fails the test on any error. */
skv_world *fixture_tank(skv_law law, float spacing, int threads);

skv_world *fixture_tank_with(skv_law law, skv_solver_kind solver, float spacing);

/* The same with a block of fluid in the lower left corner, as a dam that breaks at once. */
skv_world *fixture_dam(skv_law law, float spacing, int threads);
skv_world *fixture_dam_of(const skv_world_def *def);

/* Viscous calibrated water 0.3 m deep in the tank, stepped until all of it sleeps. */
skv_world *fixture_sleeping_pool(float spacing, int threads);

/* A blob of about 300 particles in the middle of a weightless tank, away from all walls; viscosity
 * in 1/s and 1/m. */
skv_world *fixture_blob(skv_law law, skv_solver_kind solver, float viscosity);

/* How long, in frames, a tank's own swing takes to die down that a wall's drag ends in so many
 * seconds: without drag it loses 16 % instead of 21 % in a period (`skvalp lab slosh`). */
#define FIXTURE_SWING(seconds) ((seconds) * 60 * 4 / 3)

/* How much a particle at a distance from a wall, in spacings, counts for the layer there: 1 at the
 * wall, 0 from two spacings on. So the count is the fluid between the wall and a depth, averaged
 * over all depths up to two spacings: up to a single one it would be a row more or less, as rows
 * lie 0.55 to 1.2 spacings apart, by how they meet the wall. */
double fixture_wall_weight(double distance);

/* The particles so counted beside walls, against what fits there at rest, where water stands deeper
 * than three smoothing radii below `level`. Any walls. */
double fixture_wall_layer(const skv_world *world, double level);

/* Gives `slow`, which is empty, the particles of `fast`, and as many substeps. */
void fixture_take_over(skv_world *slow, const skv_world *fast);

/* Fails unless the particles of two worlds agree to the rounding of one substep. */
void fixture_expect_same_particles(const skv_world *fast, const skv_world *slow, float dt);

/* Gives `slow`, which is empty, the particles of `fast`, lets both take one substep, and fails
 * unless they agree to rounding; frees both. */
void fixture_expect_same_substep(skv_world *fast, skv_world *slow);

/* What skv_world_hash gives for a world of clear fluid that has these particles. */
uint64_t fixture_hash(const skv_particles *particles);

/* Adds an instrument whose readings are means over `window` seconds; fails the test on any error.
 */
skv_instrument fixture_instrument(skv_lab *lab, skv_instrument_kind kind, double window, double x0,
                                  double y0, double x1, double y1);

skv_packing fixture_packing(const skv_world *world);

/* A snapshot, whose bytes are the caller's to free; fails the test on any error. */
typedef struct fixture_saved {
    uint8_t *bytes;
    size_t size;
} fixture_saved;
fixture_saved fixture_save(const skv_world *world, bool with_terrain);

/* Runs the world, and fails the test unless a copy of it, what is loaded from its snapshot, and the
 * world itself, restored, come to the same hash. */
void fixture_expect_goes_on(skv_world *world, int frames);

/* Makes its checksum right again, so that a mutation gets past it. */
void fixture_seal(fixture_saved saved);

/* Makes a world and lets it run; fails the test unless it then has the same hash on several threads
 * and in scalar code; with SKV_LONG_TESTS=1 on more of them. */
typedef skv_world *fixture_run_of(int threads, skv_instruction_set set);
void fixture_expect_same_bits(fixture_run_of *run);

/* Puts a body into the world; and what is told of one. Both fail the test if there is none. */
skv_body_id fixture_add_body(skv_world *world, const skv_body_def *def);
skv_body fixture_body(const skv_world *world, skv_body_id id);

/* A tank 0.4 m wide that is filled to a depth, at 25 mm; with `sleep` what rests there may sleep.
 */
skv_world *fixture_shaft(float depth, bool sleep, int threads, skv_instruction_set set);
/* Adds a brick of 0.1 m; so many of 1900 kg/m^2 on each other in the shaft's middle, from below. */
enum { FIXTURE_BRICKS = 5 };
skv_body_id fixture_add_brick(skv_world *world, float x, float y, float density);
void fixture_add_stack(skv_world *world);

/* Steps whole 1/60 s frames. */
void fixture_run(skv_world *world, int frames);

/* Fails the test, naming the place, unless |actual - expected| <= tolerance. */
#define assert_near(actual, expected, tolerance)                                                   \
    fixture_assert_near(actual, expected, tolerance, __FILE__, __LINE__)
void fixture_assert_near(double actual, double expected, double tolerance, const char *file,
                         int line);

#endif
