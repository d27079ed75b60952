/* Rigid bodies in the fluid.
 *
 * In a substep the bodies move first, as fast as they are. Then the solver moves the fluid, which
 * meets them as walls that have come from where they were (terrain/solids.h), and tells what they
 * gave it. That, gravity, and contacts with walls and with each other change their velocities, and
 * those of the fluid that lies on them (bodies/layer.c). So a body at rest has no velocity between
 * substeps. Once a frame would be too seldom: what is lighter than the water that it moves would
 * swing ever more.
 *
 * Invariant: what the fluid gets from a body the body loses, and all of it is summed in fixed
 * orders or in fixed point; so threads change nothing. Where a world has no bodies, none of this is
 * asked.
 */
#include "world/bodies/bodies.h"

#include "base/exact.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

/* ---- The list -------------------------------------------------------------------------------- */

skv_bodies *skv_bodies_create(void)
{
    skv_bodies *bodies = skv_calloc(1, sizeof *bodies);
    if (!bodies)
        return NULL;
    bodies->next_id = 1;
    skv_image_law_make(true, &bodies->solids.law);
    return bodies;
}

void skv_bodies_destroy(skv_bodies *bodies)
{
    for (int k = 0; bodies && k < bodies->count; k++)
        skv_body_shape_destroy(bodies->body[k].shape);
    skv_free(bodies);
}

void skv_bodies_take_over(skv_world *world, skv_bodies *bodies)
{
    skv_bodies_destroy(world->bodies);
    world->bodies = bodies;
    world->boundary.solids = NULL;
    if (bodies)
        skv_bodies_show(world);
}

static skv_pose pose_of(const skv_rigid *r)
{
    return (skv_pose){(float)r->x, (float)r->y, (float)r->cos, (float)r->sin};
}

/* A body as a host sees it. */
static skv_body tell(const skv_rigid *r)
{
    const skv_outline *o = &r->shape->outline;
    double per_second = r->felt_for > 0 ? 1 / r->felt_for : 0;
    skv_body body = {
        .id = r->id,
        .x = (float)r->x,
        .y = (float)r->y,
        .angle = (float)r->angle,
        .vx = (float)r->vx,
        .vy = (float)r->vy,
        .spin = (float)r->spin,
        .density = r->density,
        .friction = r->friction,
        .restitution = r->restitution,
        .fixed = r->fixed,
        .pinned = r->pinned,
        .hosted = r->hosted,
        .pin_x = (float)r->pin_x,
        .pin_y = (float)r->pin_y,
        .motor_speed = r->motor_speed,
        .motor_torque = r->motor_torque,
        .area = (float)o->area,
        .mass = (float)((double)r->density * o->area),
        .inertia = (float)((double)r->density * o->inertia),
        .moved_mass = (float)((double)r->density * o->area + r->layer[0]),
        .moved_inertia = (float)((double)r->density * o->inertia + r->layer[1]),
        .force_x = (float)(per_second * r->felt.x),
        .force_y = (float)(per_second * r->felt.y),
        .torque = (float)(per_second * r->felt.moment),
        .corners = o->corners,
    };
    for (int k = 0; k < 2 * o->corners; k++)
        body.outline[k] = (float)o->corner[k / 2][k % 2];
    return body;
}

void skv_bodies_show(skv_world *world)
{
    skv_bodies *b = world->bodies;
    b->solids.count = b->count;
    b->solids.spacing = world->fluid.spacing;
    for (int k = 0; k < b->count; k++) {
        const skv_rigid *r = &b->body[k];
        const skv_body_shape *shape = r->shape;
        b->solids.solid[k] = (skv_solid){
            .shape = &shape->boundary,
            .middle_x = shape->middle_x,
            .middle_y = shape->middle_y,
            .reach = (float)shape->outline.reach,
            .before = pose_of(r),
            .now = pose_of(r),
        };
        b->shown[k] = tell(r);
    }
    skv_solids_arrange(&b->solids, world->h);
    world->boundary.solids = b->count ? &b->solids : NULL;
}

void skv_bodies_take_out(skv_world *world, int index)
{
    skv_bodies *b = world->bodies;
    skv_body_shape_destroy(b->body[index].shape);
    memmove(&b->body[index], &b->body[index + 1], (size_t)(b->count - index - 1) * sizeof *b->body);
    b->count--;
    skv_bodies_show(world);
}

/* ---- The fluid around ------------------------------------------------------------------------ */

float skv_body_distance(const skv_world *world, int index, float x, float y)
{
    const skv_solid *s = &world->bodies->solids.solid[index];
    float rx = x - s->now.x, ry = y - s->now.y;
    float away = sqrtf(rx * rx + ry * ry) - s->reach;
    if (away > world->h)
        return away;
    skv_solid_enter(s, &s->now, &x, &y);
    return skv_maxf(skv_minf(skv_distance_at(s->shape->terrain, x, y), world->h), away);
}

float skv_bodies_distance(const skv_world *world, float x, float y)
{
    float least = INFINITY;
    for (int k = 0; k < skv_world_has_bodies(world); k++)
        least = skv_minf(skv_body_distance(world, k, x, y), least);
    return least;
}

uint64_t skv_bodies_hash(uint64_t hash, const skv_bodies *bodies)
{
    skv_writer w = {NULL, 0};
    for (int k = 0; k < bodies->count; k++) {
        const skv_rigid *r = &bodies->body[k];
        const double state[] = {r->x, r->y, r->angle, r->vx, r->vy, r->spin};
        uint8_t bytes[sizeof state];
        w = (skv_writer){bytes, 0};
        for (size_t i = 0; i < sizeof state / sizeof *state; i++)
            skv_put_double(&w, state[i]);
        hash = skv_hash_bytes(hash, bytes, w.used);
    }
    for (int k = 0; k < bodies->touches; k++) {
        uint8_t bytes[2 * sizeof(double)];
        w = (skv_writer){bytes, 0};
        skv_put_double(&w, bodies->touch[k].normal);
        skv_put_double(&w, bodies->touch[k].along);
        hash = skv_hash_bytes(hash, bytes, w.used);
    }
    return hash;
}

/* ---- A substep ------------------------------------------------------------------------------- */

void skv_bodies_begin_step(skv_world *world)
{
    if (world->bodies)
        world->bodies->begins = true;
}

/* Forgets what those felt in the last step that feel this one; who sleeps goes on as it was. */
static void begin_to_feel(skv_bodies *b)
{
    for (int k = 0; k < b->count && b->begins; k++) {
        if (b->body[k].asleep)
            continue;
        b->body[k].felt = (skv_impulse){0};
        b->body[k].felt_for = 0;
    }
    b->begins = false;
}

/* Moves one and tells how far its centre of mass goes and how far it turns: of one that turns about
 * a pin, on an arc; of one that its host has led, from where it was before. */
static skv_motion move(skv_rigid *r, double dt)
{
    skv_motion way = {dt * r->vx, dt * r->vy, dt * r->spin};
    double x = r->x, y = r->y;
    r->x += way.x;
    r->y += way.y;
    r->angle += way.turn;
    skv_rigid_derive(r);
    if (r->pinned) {
        way.x = r->x - x;
        way.y = r->y - y;
    }
    if (r->hosted) {
        way = (skv_motion){way.x + r->led.x, way.y + r->led.y, way.turn + r->led.turn};
        r->led = (skv_motion){0};
    }
    return way;
}

void skv_bodies_move(skv_world *world, double dt)
{
    skv_bodies *b = world->bodies;
    if (!skv_world_has_bodies(world))
        return;
    skv_bodies_take_hold(world);
    for (int k = 0; k < b->count; k++)
        b->given[k] = (skv_impulse){0};
    if (!skv_bodies_awake(world))
        return;
    begin_to_feel(b); /* what spurs one comes before what it feels */
    if (b->set)
        skv_bodies_solve_contacts(world, dt, false);
    b->set = false;
    skv_bodies_spur_layers(world);
    skv_motion way[SKV_MAX_BODIES];
    for (int k = 0; k < b->count; k++)
        way[k] = move(&b->body[k], dt);
    skv_pose before[SKV_MAX_BODIES];
    for (int k = 0; k < b->count; k++)
        before[k] = b->solids.solid[k].now;
    skv_bodies_show(world);
    for (int k = 0; k < b->count; k++) {
        skv_solid *s = &b->solids.solid[k];
        s->before = before[k];
        s->dx = (float)way[k].x;
        s->dy = (float)way[k].y;
        s->turn = (float)way[k].turn;
    }
    skv_solids_arrange(&b->solids, world->h);
}

void skv_bodies_feel(skv_world *world, double dt, bool moves)
{
    skv_bodies *b = world->bodies;
    if (!skv_world_has_bodies(world) || !(moves || skv_bodies_awake(world)))
        return;
    begin_to_feel(b);
    double s = (double)world->fluid.spacing;
    double scale = -(double)world->fluid.density * s * s / dt;
    skv_motion before[SKV_MAX_BODIES];
    skv_bodies_press_films(world, dt);
    skv_bodies_join_layers(world, before);
    for (int k = 0; k < b->count; k++) {
        skv_rigid *r = &b->body[k];
        if (r->asleep)
            continue;
        double x = r->owed.x + scale * b->given[k].x, y = r->owed.y + scale * b->given[k].y;
        double moment = r->owed.moment + scale * b->given[k].moment;
        double weight = r->fixed ? 0 : dt * r->mass;
        r->owed = (skv_impulse){0};
        r->felt.x += x;
        r->felt.y += y;
        r->felt.moment += moment;
        r->felt_for += dt;
        skv_rigid_push(r, x + weight * (double)world->gravity_x,
                       y + weight * (double)world->gravity_y, moment);
    }
    skv_bodies_drive_motors(b, dt);
    skv_bodies_follow_hands(world, dt);
    skv_bodies_solve_contacts(world, dt, true);
    skv_bodies_part_from_layers(world, before);
    skv_bodies_show(world); /* at rest, for who asks between substeps */
}

void skv_bodies_remove_leavers(skv_world *world)
{
    unsigned open = skv_terrain_open_sides(world->terrain);
    double width = (double)skv_terrain_width(world->terrain);
    double height = (double)skv_terrain_height(world->terrain);
    for (int k = skv_world_has_bodies(world) - 1; k >= 0; k--) {
        const skv_rigid *r = &world->bodies->body[k];
        double beyond = r->shape->outline.reach + (double)world->h;
        if ((r->x < -beyond && open & SKV_SIDE_LEFT) ||
            (r->x > width + beyond && open & SKV_SIDE_RIGHT) ||
            (r->y < -beyond && open & SKV_SIDE_BOTTOM) ||
            (r->y > height + beyond && open & SKV_SIDE_TOP))
            skv_bodies_take_out(world, k);
    }
}
