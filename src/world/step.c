/* How a fluid moves: a frame in substeps, and a substep as a list of passes.
 *
 * A substep predicts every particle's position from its velocity, relaxes the positions until the
 * density is right, and takes the velocity from where the particles have ended (prediction and
 * relaxation, thesis section 3.1.1). The order of the passes is the method:
 *
 *   external forces      v += dt (g + a_hand)                                  Algorithm 2
 *   viscosity            pairs that approach exchange impulses                 Algorithm 3
 *   advance              x += dt v, stopped at walls                           Algorithm 4
 *   neighbours           lists of pairs within h                               Algorithm 5
 *   repeat `iterations` times:                                                 Algorithm 6
 *     walls              what the solid adds to the sums (wall density maps)
 *     density            rho, near density and gradient
 *     pressure           P and N from the densities: the calibrated or the clavet law
 *     displacement       x moves along the pressure differences, stopped at walls
 *   contact              friction and push at walls                            Algorithm 7
 *   velocity             v += (sum of corrections) / dt                        Algorithm 8
 *
 * Two solvers run these passes. reference_step.c does so literally, one after the other; the
 * production solver (rows_step.c, src/solver/rows) does the same for one row of space after the
 * other, with viscosity read in the first density pass. Invariant: neither result depends on the
 * number of threads.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "world/frame.h"

#include <math.h>
#include <string.h>

/* s; of skv_world_step, as floats like its argument. */
#define LEAST_STEP   1e-6f
#define LONGEST_STEP 0.1f
#define DT_ROUNDING  1e-6 /* how far off, relatively, a sum of float dt may be */

skv_pull skv_make_pull(const skv_hand *hand, float dt)
{
    return (skv_pull){
        .x = hand->x,
        .y = hand->y,
        .vx = hand->vx,
        .vy = hand->vy,
        .inv_radius = 1 / hand->radius,
        .attraction = hand->attraction,
        /* Half each at most: more than the whole velocity would turn it round. */
        .friction = skv_minf(0.5f, dt * hand->friction),
        .follow = skv_minf(0.5f, dt * hand->follow),
    };
}

/* True for a particle that has left through an open side: by more than h, or round the corner,
 * where it would meet a closed side from behind. */
static bool has_left(const skv_world *world, float x, float y)
{
    unsigned open = skv_terrain_open_sides(world->terrain);
    float width = skv_terrain_width(world->terrain), height = skv_terrain_height(world->terrain);
    float h = world->h;
    bool beside = ((open & SKV_SIDE_LEFT) && x < 0) || ((open & SKV_SIDE_RIGHT) && x > width);
    bool above_or_below =
        ((open & SKV_SIDE_BOTTOM) && y < 0) || ((open & SKV_SIDE_TOP) && y > height);
    return (beside && (x < -h || x > width + h || y < 0 || y > height)) ||
           (above_or_below && (y < -h || y > height + h || x < 0 || x > width));
}

/* Takes out who has left; the order of the rest is kept. */
static void remove_leavers(skv_world *world)
{
    skv_state *s = &world->state;
    int kept = 0;
    for (int i = 0; i < s->count; i++) {
        if (has_left(world, s->x[i], s->y[i])) {
            skv_sleep_wake(world, i);
            continue;
        }
        if (kept < i) {
            s->x[kept] = s->x[i];
            s->y[kept] = s->y[i];
            s->vx[kept] = s->vx[i];
            s->vy[kept] = s->vy[i];
            s->pressure[kept] = s->pressure[i];
            s->clearance[kept] = s->clearance[i];
            s->id[kept] = s->id[i];
            world->sleep.anchor_x[kept] = world->sleep.anchor_x[i];
            world->sleep.anchor_y[kept] = world->sleep.anchor_y[i];
            world->sleep.unrest[kept] = world->sleep.unrest[i];
        }
        kept++;
    }
    if (kept < s->count)
        world->lists_current = false;
    s->count = kept;
}

/* Memory for the next substeps: nothing to do once the world is warm. */
static skv_result reserve(skv_world *world, skv_error *error)
{
    if (world->solver == SKV_SOLVER_REFERENCE)
        return skv_neighbours_reserve(&world->neighbours, world->state.count, error);
    const skv_constants *c = &world->constants;
    bool viscous = c->viscosity_linear > 0 || c->viscosity_quadratic > 0;
    return skv_rows_reserve(world->rows, world->state.count, skv_pool_threads(world->pool), viscous,
                            error);
}

/* Adds dt to the time that is owed and takes the whole substeps out of it. What is whole but for
 * the rounding of a float dt is whole, so 1/60 s is a frame, always. */
static int take_due(skv_world *world, double dt)
{
    double due = world->due + dt * 60 * world->substeps;
    double whole = floor(due + 0.5);
    if (fabs(due - whole) > DT_ROUNDING * whole)
        whole = floor(due);
    else
        due = whole;
    world->due = due - whole;
    return (int)whole;
}

skv_result skv_world_step(skv_world *world, float dt, skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!skv_within((double)dt, (double)LEAST_STEP, (double)LONGEST_STEP))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "step: dt %g s is out of range; allowed is %g..%g s", (double)dt,
                        (double)LEAST_STEP, (double)LONGEST_STEP);
    int count = take_due(world, (double)dt);
    float part = 1.0f / 60 / (float)world->substeps;
    if (part != world->constants_dt) {
        world->constants = skv_make_constants(&world->fluid, part);
        world->constants_dt = part;
    }
    /* Who leaves through an open side is taken out after every substep, else after all of them. */
    bool open = skv_terrain_open_sides(world->terrain) != 0;
    int at_once = open || world->solver == SKV_SOLVER_REFERENCE ? 1 : count;
    for (int done = 0; done < count; done += at_once) {
        skv_result result = reserve(world, error);
        if (result != SKV_OK)
            return result;
        double time = at_once / (60.0 * world->substeps);
        if (world->solver == SKV_SOLVER_REFERENCE) {
            skv_reference_substep(world);
            world->sleep.stepped = world->state.count;
        } else {
            skv_rows_substeps(world, at_once, (float)time);
        }
        if (open)
            remove_leavers(world);
        world->time += time;
        world->steps += at_once;
    }
    return SKV_OK;
}

skv_profile skv_world_profile(skv_world *world, bool reset)
{
    static const char *const pass_names[SKV_PASS_COUNT] = {
        "external forces", "viscosity", "advance",      "neighbours", "walls",
        "density",         "pressure",  "displacement", "contact",    "velocity",
    };
    static const char *const phase_names[] = {"advance", "sort", "relaxation", "transfer"};
    skv_profile profile = {0};
    SKV_ASSERT_OR(world, profile);
    if (world->solver == SKV_SOLVER_FAST) {
        profile.count = 4;
        memcpy(profile.name, phase_names, sizeof phase_names);
        skv_rows_profile(world->rows, reset, profile.seconds);
        return profile;
    }
    profile.count = SKV_PASS_COUNT;
    memcpy(profile.name, pass_names, sizeof pass_names);
    memcpy(profile.seconds, world->pass_seconds, sizeof world->pass_seconds);
    if (reset)
        memset(world->pass_seconds, 0, sizeof world->pass_seconds);
    return profile;
}
