/* Settling: fluid put down as a lattice is relaxed where it lies, so that it begins at rest.
 *
 * A fresh lattice is no fluid at rest: it bears no weight yet, and it does not fit its walls. The
 * corrections of the first substeps would become velocities, the greater, the shorter a substep is.
 * Here the lattice takes on the weight above it, sinking by as much as that will compress it, and
 * takes substeps of which it keeps the places alone. Velocities last from one to the next, a little
 * less each time: so disorder travels to where it can leave instead of creeping there. They begin
 * in the longest substeps that hold the fluid, which become shorter by halves down to the world's
 * own: a stiff fluid hardly moves once its neighbours are in its way. They end when all is calm.
 *
 * Only fluid that rests has its weight meanwhile. What is going to flow or to fall is relaxed
 * without any, and so keeps its shape; it takes on the weight at last. Fluid that rests below an
 * uneven surface is held up by a force with the potential of that surface's height.
 *
 * Invariant: time, velocities and the order of the particles stay; the same world gives the same
 * places on any number of threads.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "base/memory.h"
#include "calm/regions.h"
#include "world/air/air.h"
#include "world/liquids.h"
#include "world/springs/springs.h"

#include <math.h>
#include <string.h>

/* MOST_WORK is particles times rounds of one length: many particles get fewer rounds. */
enum { LEAST_ROUNDS = 20, MOST_WORK = 5000000 };

/* A lattice that bears weight becomes disordered, which takes the first 150 rounds. Where not all
 * rounds can be had it is shaken at once, by up to so many spacings: then half of them do as well,
 * and fewer than SHAKEN_ROUNDS are spared none. With a few rounds order is calmer. */
#define SHAKE 0.3f
enum { SHAKEN_ROUNDS = 250, LEAST_SHAKEN = 120 };
/* The last share of these rounds that takes more of the velocity, and how many times as much. */
#define COOLED  0.2f
#define COOLING 2.5f

/* Near a thin wall each pair is asked whether it sees the other. Where the radius is longer than
 * distances reach, that takes long ways through the picture. With a radius of 150 pixels, three
 * times their reach, and a wall between most pairs, a particle costs as much as 65 others. */
#define SIGHT_COST 30

/* Rounds, at most, of the longest substeps, of each length between and of the world's own; the rms
 * speed that is calm, as a share of that of a fall through the fluid's depth; and the share of the
 * velocity that a round of the longest substeps takes, for each iteration: the more there are, the
 * livelier the fluid. */
typedef struct plan {
    int first, later, last;
    double calm;
    float lost;
    bool slows; /* shorter substeps put it in order more slowly */
} plan;

static const plan aided = {500, 200, 1000, 0.002, 0.01f, true};
/* Where nothing rests: fluid that is more relaxed is more ordered, and sets out later. */
static const plan flowing = {200, 60, 200, 0, 0.015f, true};
/* For a law that does not say how far to sink, and pushes as far in a substep of any length. */
static const plan unaided = {1200, 1200, 1200, 0.002, 0.01f, false};

/* Of the area. Less makes no level wrong by a tenth of what may be. */
#define LEAST_COMPRESSION 0.0005

#define FALL 9.81f /* m/s^2, of that fall; of the world's gravity nothing may be left */

typedef struct settling {
    skv_world *world;
    skv_fluid_def fluid; /* without friction of any kind */
    skv_lies lies;
    float *vx, *vy; /* what the particles had */
    float *before;  /* what they had before the last round */
    double carried; /* 1/c^2 of the substeps whose weight they have taken on, s^2/m^2 */
    double calm;    /* m/s, in the substeps that are taken */
    float kept;     /* share of the velocity, from one round to the next */
    double work;    /* of a round: particles, weighed by what they cost */
    bool shaken;
    bool drawn; /* it is known where the fluid is drawn */
    skv_constants constants;
} settling;

/* 1/c^2; 0 for a law that has no speed of sound: its fluid sinks, wave by wave, as it is relaxed.
 */
static double softness_of(const settling *s, int substeps)
{
    double c = skv_speed_of_sound(&s->fluid, 1.0 / 60 / substeps);
    return c > 0 ? 1 / (c * c) : 0;
}

/* Moves those that lie like this along gravity by what their column gives way. */
static void sink(const settling *s, skv_lie lie, double softness)
{
    skv_world *world = s->world;
    skv_state *p = &world->state;
    for (int i = 0; i < p->count; i++) {
        if (s->lies.lie[i] != lie)
            continue;
        float way = (float)((double)s->lies.weight[i] * softness);
        skv_boundary_move(&world->boundary, &p->x[i], &p->y[i], way * world->gravity_x,
                          way * world->gravity_y, &p->clearance[i]);
    }
}

enum { BEGINNINGS = 6 };

/* Keeps what a round begins from, or takes it `back`. */
static void keep_beginning(const settling *s, bool back)
{
    const skv_state *p = &s->world->state;
    float *const arrays[BEGINNINGS] = {p->x, p->y, p->vx, p->vy, p->warm_lambda, p->clearance};
    size_t count = (size_t)p->count;
    for (size_t k = 0; k < BEGINNINGS; k++) {
        float *kept = s->before + k * count;
        memcpy(back ? arrays[k] : kept, back ? kept : arrays[k], count * sizeof *kept);
    }
}

/* The slope of the surface that is drawn above a particle, to the right of upwards. */
static float find_slope(const settling *s, int i)
{
    const skv_state *p = &s->world->state;
    const skv_drawn_surface *drawn = s->lies.drawn[i];
    float height, slope = 0;
    if (drawn)
        skv_drawn_look(drawn, p->x[i] * s->lies.uy - p->y[i] * s->lies.ux, &height, &slope);
    return slope;
}

/* Takes a round. Pressures cost a seventh, so only the last one has them. Where it turns out to
 * have been the last when it is over, it is taken `again`. */
static skv_result take_round(const settling *s, bool last, bool again, skv_error *error)
{
    skv_world *world = s->world;
    skv_state *p = &world->state;
    if (again || !last)
        keep_beginning(s, again);
    float x = world->gravity_x * s->constants.dt, y = world->gravity_y * s->constants.dt;
    for (int i = 0; i < p->count; i++) {
        float weighs = s->lies.lie[i] == SKV_RESTS ? 1 : 0, slope = find_slope(s, i);
        p->vx[i] = s->kept * p->vx[i] + weighs * (x - slope * y);
        p->vy[i] = s->kept * p->vy[i] + weighs * (y + slope * x);
    }
    skv_springs_hold(world, s->constants.dt);
    skv_air_hold(world, s->constants.dt);
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    skv_solver_step step = skv_world_describe_step(world, &s->constants, forces);
    step.gravity_x = step.gravity_y = 0;
    step.force_count = 0;
    step.particles.drag = NULL; /* as the fluid's: none */
    step.ungauged = !last;
    skv_result result = world->solver->type->reserve(world->solver, &step, error);
    if (result == SKV_OK)
        world->solver->type->advance(world->solver, &step);
    return result;
}

static bool anything_rests(const settling *s)
{
    for (int i = 0; i < s->world->state.count; i++)
        if (s->lies.lie[i] == SKV_RESTS)
            return true;
    return false;
}

/* The deepest column's depth, m, if all of the fluid rests; else 0. At its top the integral of the
 * depth is half of the depth's square; of layers, which are lighter above, no less. */
static float resting_depth(const settling *s)
{
    float most = 0;
    for (int i = 0; i < s->world->state.count; i++) {
        if (s->lies.lie[i] != SKV_RESTS)
            return 0;
        most = skv_maxf(most, s->lies.weight[i]);
    }
    return sqrtf(2 * most);
}

/* Where fluid rests as it is drawn, its lattice becomes wider by what weight compresses it: so the
 * level stays. */
static void loosen(const settling *s, float g)
{
    skv_world *world = s->world;
    double compression = (double)g * s->lies.depth * softness_of(s, world->load.wanted);
    if (!(compression > LEAST_COMPRESSION))
        return;
    world->compression = (float)skv_min(compression, SKV_MOST_COMPRESSION);
    world->constants_stale = true;
}

static bool is_calm(const settling *s)
{
    const skv_state *p = &s->world->state;
    double squares = 0, most = s->calm * s->calm * p->count;
    for (int i = 0; i < p->count && squares <= most; i++)
        squares += (double)(p->vx[i] * p->vx[i] + p->vy[i] * p->vy[i]);
    return squares <= most;
}

/* What a round costs, in particles with no thin wall near. */
static double measure_work(const skv_world *world)
{
    const skv_state *p = &world->state;
    const skv_boundary *walls = &world->boundary;
    double reaches = (double)(world->h * walls->terrain->per_metre) / SKV_TERRAIN_REACH;
    int near = 0;
    for (int i = 0; reaches > 1 && i < p->count; i++)
        near += skv_boundary_near_thin(walls, p->x[i], p->y[i]);
    return p->count + SIGHT_COST * skv_max(reaches - 1, 0) * near;
}

/* The rounds of one length that can be had. */
static int most_rounds(const settling *s)
{
    double most = skv_max(MOST_WORK / s->work, LEAST_ROUNDS);
    return (int)(s->shaken ? skv_max(most / 2, skv_min(most, SHAKEN_ROUNDS)) : most);
}

/* Puts what rests out of order, if it would not get as many rounds as wanted. */
static void shake(settling *s, int wanted)
{
    skv_world *world = s->world;
    skv_state *p = &world->state;
    int most = most_rounds(s);
    s->shaken = most < wanted && most >= LEAST_SHAKEN;
    float way = 2 * SHAKE * world->fluid.spacing;
    for (int i = 0; s->shaken && i < p->count; i++)
        if (s->lies.lie[i] == SKV_RESTS)
            skv_boundary_move(&world->boundary, &p->x[i], &p->y[i], way * skv_scatter(2 * p->id[i]),
                              way * skv_scatter(2 * p->id[i] + 1), &p->clearance[i]);
}

/* Relaxes in substeps of one length. */
static skv_result relax(settling *s, int substeps, int rounds, skv_error *error)
{
    double softness = softness_of(s, substeps);
    int most = most_rounds(s);
    rounds = rounds < most ? rounds : most;
    s->constants =
        skv_make_constants(&s->fluid, s->world->compression, 1.0f / 60 / (float)substeps);
    sink(s, SKV_RESTS, softness - s->carried);
    s->carried = softness;
    skv_result result = SKV_OK;
    bool last = false;
    int cools = s->shaken ? (int)((1 - COOLED) * (float)rounds) : rounds;
    for (int r = 0; result == SKV_OK && !last; r++) {
        if (r == cools)
            s->kept = 1 - COOLING * (1 - s->kept);
        bool again = r >= LEAST_ROUNDS && is_calm(s);
        last = again || r + 1 == rounds;
        result = skv_pool_asks_to_stop(s->world->pool)
                     ? skv_fail(error, SKV_STOPPED, "settling was stopped")
                     : take_round(s, last, again, error);
    }
    return result;
}

/* Relaxes in all lengths. The shorter the substeps, the less has a round done about a speed, and
 * the less is calm. */
static skv_result relax_all(settling *s, skv_error *error)
{
    skv_world *world = s->world;
    const plan *most = anything_rests(s) ? &aided : &flowing;
    if (!(softness_of(s, world->load.wanted) > 0))
        most = &unaided;
    /* Without weight, images draw fluid to where a row fits them, and leave cavities between. */
    if (most == &flowing)
        s->fluid.wall_images = false;
    float g = sqrtf(world->gravity_x * world->gravity_x + world->gravity_y * world->gravity_y);
    float depth = world->filled * skv_extent_along_gravity(world);
    float resting = resting_depth(s);
    if (resting > 0) {
        skv_load_rest(world, resting);
        if (s->drawn)
            loosen(s, g);
    }
    int last = world->load.wanted,
        first = skv_substep_rule(&s->fluid, skv_load_of_depth(g, depth, 0));
    first = first < last ? first : last;
    if (most == &aided)
        shake(s, most->last);
    double calm = most->calm * sqrt((double)(FALL * depth));
    float lost = most->lost * (float)s->fluid.iterations;
    skv_result result = SKV_OK;
    for (int substeps = first, next; substeps > 0 && result == SKV_OK; substeps = next) {
        float length = (float)first / (float)substeps;
        next = substeps == last ? 0 : 2 * substeps < last ? 2 * substeps : last;
        s->calm = calm * (double)length;
        s->kept = 1 - lost * (most->slows ? sqrtf(length) : 1);
        int rounds = !next ? most->last : substeps == first ? most->first : most->later;
        result = relax(s, substeps, rounds, error);
    }
    if (result == SKV_OK)
        sink(s, SKV_LEANS, s->carried);
    return result;
}

/* Gives back the velocities; the places are where the fluid is now. The pressure of what bore no
 * weight tells nothing. */
static void finish(const settling *s)
{
    skv_world *world = s->world;
    skv_state *p = &world->state;
    size_t bytes = (size_t)p->count * sizeof(float);
    memcpy(p->vx, s->vx, bytes);
    memcpy(p->vy, s->vy, bytes);
    memcpy(p->anchor_x, p->x, bytes);
    memcpy(p->anchor_y, p->y, bytes);
    for (int i = 0; i < p->count; i++)
        if (s->lies.lie[i] != SKV_RESTS)
            p->pressure[i] = p->warm_lambda[i] = 0;
    world->load.stiffness = (float)world->load.wanted; /* in which it has come to rest */
    skv_sleep_wake_all(world);
    skv_world_revise(world);
}

skv_result skv_world_settle(skv_world *world, skv_error *error)
{
    return skv_world_settle_drawn(world, NULL, NULL, error);
}

skv_result skv_world_settle_drawn(skv_world *world, skv_inside *inside, void *user,
                                  skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world), SKV_ERROR_VALUE);
    skv_state *p = &world->state;
    size_t count = (size_t)p->count;
    if (count == 0)
        return SKV_OK;
    settling s = {.world = world, .fluid = skv_ramp_fluid(&world->fluid, &world->ramp)};
    s.fluid.viscosity = s.fluid.viscosity_linear = s.fluid.viscosity_quadratic = 0;
    s.fluid.wall_friction = 0;
    s.fluid.cohesion = skv_world_most_cohesion(world);
    s.drawn = inside != NULL;
    s.work = measure_work(world);
    float *numbers = skv_calloc((2 + BEGINNINGS) * count, sizeof *numbers);
    world->busy = SKV_READ;
    skv_result result = skv_world_find_lies(world, &(skv_drawing){inside, user}, &s.lies, error);
    world->busy = SKV_IDLE;
    /* What has springs keeps the shape in which it was put down. */
    if (result == SKV_OK)
        result = skv_springs_prepare(world, error);
    if (!numbers) {
        result = skv_fail(error, SKV_ERROR_MEMORY, "out of memory for settling");
    } else if (result == SKV_OK) {
        s.vx = numbers;
        s.vy = numbers + count;
        s.before = numbers + 2 * count;
        memcpy(s.vx, p->vx, count * sizeof(float));
        memcpy(s.vy, p->vy, count * sizeof(float));
        memset(p->vx, 0, count * sizeof(float));
        memset(p->vy, 0, count * sizeof(float));
        world->busy = SKV_AT_WORK;
        skv_pool_go(world->pool);
        result = relax_all(&s, error);
        world->busy = SKV_IDLE;
        finish(&s);
    }
    skv_free(numbers);
    skv_lies_destroy(&s.lies);
    return result;
}
