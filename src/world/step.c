/* How a fluid moves: one substep as a list of passes.
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
 * Invariant: a pass writes a particle's own elements only, and none that the same pass reads from
 * others; so the result does not depend on the number of threads.
 */
#include "base/assert.h"
#include "base/clock.h"
#include "world/world_internal.h"

#include <math.h>
#include <string.h>

static const char *const pass_names[SKV_PASS_COUNT] = {
    "external forces", "viscosity", "advance",      "neighbours", "walls",
    "density",         "pressure",  "displacement", "contact",    "velocity",
};

/* What the passes of one substep share. */
typedef struct substep {
    skv_world *world;
    skv_state *state;
    const skv_constants *constants;
    skv_pull pulls[SKV_MAX_HANDS];
} substep;

/* Moves particle i by (dx, dy) as far as the walls allow; returns what it could not move. `clear`
 * is a lower bound of the distance to the nearest wall: only moves that exceed it look at the
 * terrain, which in a pool are one in ten. */
static void move_particle(const substep *sub, int i, float dx, float dy, float *lost_x,
                          float *lost_y)
{
    skv_state *s = sub->state;
    const skv_terrain *terrain = sub->world->terrain;
    float clearance = sub->world->wall_clearance;
    float length = sqrtf(dx * dx + dy * dy);
    *lost_x = *lost_y = 0;
    if (length == 0)
        return;
    float x = s->x[i] + dx, y = s->y[i] + dy;
    s->clear[i] -= length;
    if (s->clear[i] <= clearance) {
        float share = skv_terrain_sweep(terrain, s->x[i], s->y[i], x, y, clearance);
        if (share < 1) {
            x = s->x[i] + share * dx;
            y = s->y[i] + share * dy;
            *lost_x = (1 - share) * dx;
            *lost_y = (1 - share) * dy;
        }
        s->clear[i] = skv_terrain_distance(terrain, x, y);
    }
    s->x[i] = x;
    s->y[i] = y;
}

static void external_forces(int begin, int end, void *context)
{
    const substep *sub = context;
    const skv_world *world = sub->world;
    skv_pass_external_forces(sub->state, sub->constants, world->gravity_x, world->gravity_y,
                             sub->pulls, world->hand_count, begin, end);
}

static void viscosity(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_viscosity(sub->state, sub->constants, &sub->world->neighbours, begin, end);
}

static void apply_viscosity(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_apply_viscosity(sub->state, begin, end);
}

/* What a wall stops of the advance is a correction: it leaves the velocity. */
static void advance(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    skv_pass_advance(s, sub->constants, begin, end);
    for (int i = begin; i < end; i++) {
        float lost_x, lost_y;
        move_particle(sub, i, s->dx[i], s->dy[i], &lost_x, &lost_y);
        s->wx[i] = -lost_x;
        s->wy[i] = -lost_y;
    }
}

static void walls(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    for (int i = begin; i < end; i++) {
        skv_wall_sample wall;
        skv_wall_map_sample(sub->world->walls, s->x[i], s->y[i], &wall);
        s->wall_density[i] = wall.r;
        s->wall_near[i] = wall.rn;
        s->f1x[i] = wall.f1x;
        s->f1y[i] = wall.f1y;
        s->f2x[i] = wall.f2x;
        s->f2y[i] = wall.f2y;
    }
}

static void density(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_density(sub->state, sub->constants, &sub->world->neighbours, begin, end);
}

static void pressure(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pressure_law *law = sub->world->fluid.law == SKV_LAW_CLAVET ? skv_pass_pressure_clavet
                                                                    : skv_pass_pressure_calibrated;
    law(sub->state, sub->constants, begin, end);
}

static void displacement(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_displacement(sub->state, sub->constants, &sub->world->neighbours, begin, end);
}

/* Carries out the collected corrections and keeps what was carried out in w. */
static void correct(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    for (int i = begin; i < end; i++) {
        float lost_x, lost_y;
        move_particle(sub, i, s->dx[i], s->dy[i], &lost_x, &lost_y);
        s->wx[i] += s->dx[i] - lost_x;
        s->wy[i] += s->dy[i] - lost_y;
    }
}

/* Finds out how deep particles are inside the contact distance. In a gap narrower than twice that
 * distance the push ends in the middle: both walls pushing in turn would shake the fluid. */
static void find_contacts(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    const skv_terrain *terrain = sub->world->terrain;
    float contact = sub->constants->contact_distance;
    for (int i = begin; i < end; i++) {
        s->depth[i] = 0;
        if (s->clear[i] >= contact)
            continue;
        float distance =
            skv_terrain_normal(terrain, s->x[i], s->y[i], &s->normal_x[i], &s->normal_y[i]);
        s->clear[i] = distance;
        float depth = contact - distance;
        if (!(depth > 0))
            continue;
        float beyond = skv_terrain_distance(terrain, s->x[i] + depth * s->normal_x[i],
                                            s->y[i] + depth * s->normal_y[i]);
        float gain = fmaxf(-depth, fminf(depth, beyond - distance));
        s->depth[i] = 0.5f * (depth + gain);
    }
}

static void contact(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_contact(sub->state, sub->constants, begin, end);
}

static void update_velocity(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_update_velocity(sub->state, sub->constants, begin, end);
}

/* Runs one pass over all particles and books its time. */
static void run(substep *sub, skv_pass pass, skv_task *task)
{
    double start = skv_clock();
    skv_pool_run(sub->world->pool, sub->state->count, task, sub);
    sub->world->pass_seconds[pass] += skv_clock() - start;
}

static void update_neighbours(substep *sub)
{
    skv_world *world = sub->world;
    double start = skv_clock();
    skv_neighbours_build(&world->neighbours, &world->state, world->h, world->pool);
    world->lists_current = true;
    world->pass_seconds[SKV_PASS_NEIGHBOURS] += skv_clock() - start;
}

static void take_substep(substep *sub)
{
    const skv_fluid_def *fluid = &sub->world->fluid;
    run(sub, SKV_PASS_FORCES, external_forces);
    if (fluid->viscosity_linear > 0 || fluid->viscosity_quadratic > 0) {
        /* The lists of the last substep serve, unless particles came or went. */
        if (!sub->world->lists_current)
            update_neighbours(sub);
        run(sub, SKV_PASS_VISCOSITY, viscosity);
        run(sub, SKV_PASS_VISCOSITY, apply_viscosity);
    }
    run(sub, SKV_PASS_ADVANCE, advance);
    update_neighbours(sub);
    for (int i = 0; i < fluid->iterations; i++) {
        run(sub, SKV_PASS_WALLS, walls);
        run(sub, SKV_PASS_DENSITY, density);
        run(sub, SKV_PASS_PRESSURE, pressure);
        run(sub, SKV_PASS_DISPLACEMENT, displacement);
        run(sub, SKV_PASS_DISPLACEMENT, correct);
    }
    run(sub, SKV_PASS_CONTACT, find_contacts);
    run(sub, SKV_PASS_CONTACT, contact);
    run(sub, SKV_PASS_CONTACT, correct);
    run(sub, SKV_PASS_VELOCITY, update_velocity);
}

static void make_pulls(substep *sub)
{
    const skv_world *world = sub->world;
    float dt = sub->constants->dt;
    for (int i = 0; i < world->hand_count; i++) {
        const skv_hand *hand = &world->hands[i];
        sub->pulls[i] = (skv_pull){
            .x = hand->x,
            .y = hand->y,
            .vx = hand->vx,
            .vy = hand->vy,
            .inv_radius = 1 / hand->radius,
            .attraction = hand->attraction,
            /* Half each at most: more than the whole velocity would turn it round. */
            .friction = fminf(0.5f, dt * hand->friction),
            .follow = fminf(0.5f, dt * hand->follow),
        };
    }
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
        if (has_left(world, s->x[i], s->y[i]))
            continue;
        if (kept < i) {
            s->x[kept] = s->x[i];
            s->y[kept] = s->y[i];
            s->vx[kept] = s->vx[i];
            s->vy[kept] = s->vy[i];
            s->pressure[kept] = s->pressure[i];
            s->clear[kept] = s->clear[i];
            s->id[kept] = s->id[i];
        }
        kept++;
    }
    if (kept < s->count)
        world->lists_current = false;
    s->count = kept;
}

skv_result skv_world_step(skv_world *world, float dt)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!skv_within((double)dt, 1e-6, 0.1))
        return SKV_ERROR_VALUE;
    /* A frame of 1/60 s in float is a hair longer than in theory. */
    int count = (int)ceil((double)dt * 60 * world->substeps - 1e-4);
    if (count < 1)
        count = 1;
    float part = dt / (float)count;
    if (part != world->constants_dt) {
        world->constants = skv_make_constants(&world->fluid, part);
        world->constants_dt = part;
    }
    substep sub = {.world = world, .state = &world->state, .constants = &world->constants};
    make_pulls(&sub);
    for (int i = 0; i < count; i++) {
        skv_result result = skv_neighbours_reserve(&world->neighbours, world->state.count, NULL);
        if (result != SKV_OK)
            return result;
        take_substep(&sub);
        world->time += (double)part;
        world->steps++;
        if (skv_terrain_open_sides(world->terrain))
            remove_leavers(world);
    }
    return SKV_OK;
}

skv_profile skv_world_profile(skv_world *world, bool reset)
{
    skv_profile profile = {.count = SKV_PASS_COUNT};
    SKV_ASSERT_OR(world, profile);
    for (int i = 0; i < SKV_PASS_COUNT; i++) {
        profile.name[i] = pass_names[i];
        profile.seconds[i] = world->pass_seconds[i];
    }
    if (reset)
        memset(world->pass_seconds, 0, sizeof world->pass_seconds);
    return profile;
}
