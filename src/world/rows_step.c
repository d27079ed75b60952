/* The production solver for a world: its units and axes, and the walls as it sees them.
 *
 * The solver works in h and substeps, with rows across the longer side of the world: where the
 * world is wider than high, its x is the world's y. Invariant: the world's arrays hold the whole
 * state; what the solver keeps between frames is memory only.
 */
#include "world/frame.h"

#include <math.h>

/* What the boundary callbacks need. */
typedef struct view {
    const skv_world *world;
    bool swapped; /* the solver's x is the world's y */
    float h, inv_h;
} view;

static void swap(float *a, float *b)
{
    float kept = *a;
    *a = *b;
    *b = kept;
}

static float view_walls(const void *context, float x, float y, skv_row_wall *wall)
{
    const view *v = context;
    if (v->swapped)
        swap(&x, &y);
    skv_wall_sample sample;
    float distance = skv_walls_at(v->world, x * v->h, y * v->h, &sample);
    *wall = (skv_row_wall){sample.r, sample.rn, sample.f1x, sample.f1y, sample.f2x, sample.f2y};
    if (v->swapped) {
        swap(&wall->f1x, &wall->f1y);
        swap(&wall->f2x, &wall->f2y);
    }
    return distance * v->inv_h;
}

static float view_move(const void *context, float *x, float *y, float dx, float dy, float *distance)
{
    const view *v = context;
    float wx = *x * v->h, wy = *y * v->h, wdx = dx * v->h, wdy = dy * v->h;
    if (v->swapped) {
        swap(&wx, &wy);
        swap(&wdx, &wdy);
    }
    float share = skv_move_at_walls(v->world, &wx, &wy, wdx, wdy, distance);
    *distance *= v->inv_h;
    /* Not wx, wy turned back: a free move must give the same bits as one that did not ask. */
    *x += share < 1 ? share * dx : dx;
    *y += share < 1 ? share * dy : dy;
    return share;
}

static float view_contact(const void *context, float x, float y, float *nx, float *ny,
                          float *distance)
{
    const view *v = context;
    if (v->swapped)
        swap(&x, &y);
    float depth = skv_contact_depth(v->world, x * v->h, y * v->h, nx, ny, distance);
    *distance *= v->inv_h;
    if (v->swapped)
        swap(nx, ny);
    return depth * v->inv_h;
}

static bool view_near_thin(const void *context, float x, float y)
{
    const view *v = context;
    if (v->swapped)
        swap(&x, &y);
    return skv_wall_map_near_thin(v->world->walls, x * v->h, y * v->h);
}

static bool view_occluded(const void *context, float ax, float ay, float a_clearance, float bx,
                          float by, float b_clearance)
{
    const view *v = context;
    if (v->swapped) {
        swap(&ax, &ay);
        swap(&bx, &by);
    }
    const skv_world *world = v->world;
    return skv_wall_map_occluded(world->walls, world->terrain, ax * v->h, ay * v->h,
                                 a_clearance * v->h, bx * v->h, by * v->h, b_clearance * v->h);
}

static skv_row_constants row_constants(const skv_world *world, bool swapped)
{
    const skv_constants *c = &world->constants;
    float inv_h = c->inv_h, per_step = c->dt * c->inv_h;
    skv_row_constants r = {
        .gravity_x = world->gravity_x * c->dt * per_step,
        .gravity_y = world->gravity_y * c->dt * per_step,
        .max_speed = c->max_speed * per_step,
        .viscosity_linear = c->viscosity_linear * c->dt,
        /* beta u: u is in h a substep here. */
        .viscosity_quadratic = c->viscosity_quadratic * c->h,
        .rest_density = c->rest_density,
        .push_scale = c->push_scale * inv_h,
        .near_push_scale = c->near_push_scale * inv_h,
        .push_limit = c->push_limit * inv_h,
        .wall_virial = c->wall_virial,
        .response_slope = c->response_slope,
        .response_floor = c->response_floor,
        .near_share = c->near_share,
        .cohesion_scale = c->cohesion_scale * inv_h,
        .cohesion_below = c->cohesion_below,
        .cohesion_from = c->cohesion_from,
        .cohesion_slope = c->cohesion_slope,
        .tension_scale = c->tension_scale * inv_h,
        .tension_from = c->tension_from,
        .pressure_scale = c->pressure_scale * c->h * c->h,
        .contact_distance = c->contact_distance * inv_h,
        .softness = c->softness,
        .friction = c->friction,
        .wall_clearance = world->wall_clearance * inv_h,
        .iterations = world->fluid.iterations,
        .clavet = world->fluid.law == SKV_LAW_CLAVET,
        .pull_count = world->hand_count,
    };
    if (swapped)
        swap(&r.gravity_x, &r.gravity_y);
    return r;
}

static void make_pulls(const skv_world *world, bool swapped, skv_row_pull *pulls)
{
    const skv_constants *c = &world->constants;
    for (int i = 0; i < world->hand_count; i++) {
        skv_pull pull = skv_make_pull(&world->hands[i], c->dt);
        pulls[i] = (skv_row_pull){
            .x = pull.x * c->inv_h,
            .y = pull.y * c->inv_h,
            .vx = pull.vx * c->dt * c->inv_h,
            .vy = pull.vy * c->dt * c->inv_h,
            .inv_radius = pull.inv_radius * c->h,
            .attraction = pull.attraction * c->dt * c->dt * c->inv_h,
            .friction = pull.friction,
            .follow = pull.follow,
        };
        if (swapped) {
            swap(&pulls[i].x, &pulls[i].y);
            swap(&pulls[i].vx, &pulls[i].vy);
        }
    }
}

void skv_rows_substeps(skv_world *world, int count, float time)
{
    bool partial;
    int members = skv_sleep_plan(world, time, &partial);
    if (members == 0)
        return;
    const skv_constants *c = &world->constants;
    bool swapped = world->rows_swapped;
    skv_state *s = &world->state;
    view v = {world, swapped, c->h, c->inv_h};
    skv_row_boundary boundary = {
        .context = &v, .walls = view_walls, .move = view_move, .contact = view_contact};
    if (skv_wall_map_has_thin(world->walls)) {
        boundary.near_thin = view_near_thin;
        boundary.occluded = view_occluded;
    }
    skv_row_pull pulls[SKV_MAX_HANDS];
    make_pulls(world, swapped, pulls);
    skv_row_constants constants = row_constants(world, swapped);
    constants.pulls = pulls;
    skv_row_frame frame = {
        .count = members,
        .members = partial ? world->sleep.members : NULL,
        .x = swapped ? s->y : s->x,
        .y = swapped ? s->x : s->y,
        .vx = swapped ? s->vy : s->vx,
        .vy = swapped ? s->vx : s->vy,
        .clearance = s->clearance,
        .pressure = s->pressure,
        .length = c->inv_h,
        .speed = c->dt * c->inv_h,
    };
    skv_rows_step(world->rows, &frame, count, &constants, &boundary, world->pool);
    skv_sleep_watch(world, time);
}
