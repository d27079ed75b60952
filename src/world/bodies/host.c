/* What a host does with bodies: adding, setting, looking, taking hold and away. Invariant: nothing
 * changes on failure; where a body is put no particle is left inside it. */
#include "world/bodies/bodies.h"

#include "base/assert.h"
#include "base/defs.h"
#include "base/exact.h"
#include "world/remove.h"

enum { BODY_COOKIE = 0x424f };

/* m/s and rad/s: no body is told to be faster. */
#define MOST_SPEED 100.0
#define MOST_SPIN  1000.0

/* s: a host's engine may correct a pose by as much as the fastest body goes and turns in about a
 * substep, over which the fluid on its way is swept along. */
#define LED_FOR 1e-3

skv_body_def skv_default_body_def(void)
{
    return (skv_body_def){.cookie = SKV_COOKIE(BODY_COOKIE, skv_body_def),
                          .shape = skv_box(-0.05f, -0.05f, 0.05f, 0.05f),
                          .density = 500,
                          .friction = 0.3f,
                          .restitution = 0.2f};
}

void skv_body_def_init(skv_body_def *def, size_t size)
{
    const skv_body_def standard = skv_default_body_def();
    skv_def_init(def, size, &standard, sizeof standard);
}

static const skv_body_def *open_def(const skv_body_def *def, skv_body_def *own)
{
    *own = skv_default_body_def();
    return skv_def_open(def, own, sizeof *own);
}

static int find(const skv_world *world, skv_body_id id)
{
    for (int k = 0; k < skv_world_has_bodies(world); k++)
        if (world->bodies->body[k].id == id)
            return k;
    return -1;
}

static void wake_around(skv_world *world, int index)
{
    const skv_state *s = &world->state;
    const skv_rigid *r = &world->bodies->body[index];
    for (int i = 0; i < s->count; i++)
        if (skv_rigid_stirs(r, s->x[i], s->y[i], world->h))
            skv_sleep_wake(world, i);
    for (int k = 0; k < world->bodies->count; k++) {
        skv_rigid *other = &world->bodies->body[k];
        double dx = other->x - r->x, dy = other->y - r->y, h = (double)world->h;
        double reach = r->shape->outline.reach + other->shape->outline.reach + h;
        if (dx * dx + dy * dy <= reach * reach)
            skv_rigid_wake(other);
    }
}

/* Takes out the particles inside a body; there is room to note it. Returns their number. */
static int clear(skv_world *world, int index)
{
    int count = 0;
    wake_around(world, index);
    for (int i = 0; i < world->state.count; i++) {
        if (skv_body_distance(world, index, world->state.x[i], world->state.y[i]) > 0)
            continue;
        skv_world_remove_one(world, i);
        count++;
    }
    skv_world_end_removal(world, count);
    return count;
}

static skv_result check_pose(float x, float y, float angle, skv_error *error)
{
    if (skv_within((double)x, -100, 100) && skv_within((double)y, -100, 100) &&
        skv_within((double)angle, -100, 100))
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE,
                    "body: its place or angle is out of range; allowed is -100..100 m and rad");
}

/* Whether it is what the fastest body does in so many seconds, at most. */
static bool is_within(double x, double y, double turn, double time)
{
    double way = time * MOST_SPEED, most = time * MOST_SPIN;
    return skv_within(x, -way, way) && skv_within(y, -way, way) && skv_within(turn, -most, most);
}

static skv_result check_motion(float vx, float vy, float spin, skv_error *error)
{
    if (is_within((double)vx, (double)vy, (double)spin, 1))
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE,
                    "body: its velocity or spin is out of range; allowed is -100..100 m/s and "
                    "-1000..1000 rad/s");
}

static skv_result check_motor(float speed, float torque, skv_error *error)
{
    if (skv_within((double)speed, -1000, 1000) && skv_within((double)torque, 0, 1e6))
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE,
                    "body: its motor is out of range; allowed is -1000..1000 rad/s and 0..1000000 "
                    "N m/m");
}

static skv_result refuse_motor(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_VALUE,
                    "body: its motor turns nothing; it takes a pin, and a body that is not fixed");
}

static skv_result check_owner(const skv_body_def *def, skv_error *error)
{
    if (!def->hosted || !(def->fixed || def->pinned))
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE,
                    "body: a hosted one is neither fixed nor pinned; its engine does that");
}

static skv_result check_pin(const skv_body_def *def, skv_error *error)
{
    if (def->pinned &&
        !(skv_within((double)def->pin_x, -100, 100) && skv_within((double)def->pin_y, -100, 100)))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "body: its pin is out of range; allowed is -100..100 m");
    if (def->motor_torque != 0 && (!def->pinned || def->fixed))
        return refuse_motor(error);
    return check_motor(def->motor_speed, def->motor_torque, error);
}

static skv_result check_def(const skv_body_def *def, skv_error *error)
{
    skv_result result = check_pose(def->x, def->y, def->angle, error);
    if (result == SKV_OK)
        result = check_motion(def->vx, def->vy, def->spin, error);
    if (result != SKV_OK)
        return result;
    if (!skv_within((double)def->density, 10, 50000))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "body: its density is out of range; allowed is 10..50000 kg/m^2");
    if (!skv_within((double)def->friction, 0, 10) || !skv_within((double)def->restitution, 0, 1))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "body: its friction or restitution is out of range; allowed is 0..10 and "
                        "0..1");
    result = check_owner(def, error);
    return result == SKV_OK ? check_pin(def, error) : result;
}

/* Gives a body of an outline what a definition says. */
static void set_up(skv_rigid *r, const skv_body_def *def)
{
    const skv_outline *o = &r->shape->outline;
    double angle = (double)def->angle, c = skv_cos(angle), s = skv_sin(angle);
    r->x = (double)def->x + c * o->middle_x - s * o->middle_y;
    r->y = (double)def->y + s * o->middle_x + c * o->middle_y;
    r->angle = angle;
    r->vx = (double)def->vx;
    r->vy = (double)def->vy;
    r->spin = (double)def->spin;
    r->density = def->density;
    r->friction = def->friction;
    r->restitution = def->restitution;
    r->fixed = def->fixed;
    r->hosted = def->hosted;
    r->motor_speed = def->motor_speed;
    r->motor_torque = def->motor_torque;
    skv_rigid_derive(r);
    if (def->pinned)
        skv_rigid_pin(r, (double)def->pin_x, (double)def->pin_y);
}

/* Makes the list of a world that has none yet. */
static skv_result admit(skv_world *world, skv_error *error)
{
    if (!world->bodies)
        world->bodies = skv_bodies_create();
    return world->bodies ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for bodies");
}

skv_result skv_world_add_body(skv_world *world, const skv_body_def *def, skv_body_id *id,
                              int *removed, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world), SKV_ERROR_VALUE);
    skv_body_def own;
    SKV_ASSERT_INITIALISED(def, open_def(def, &own), SKV_ERROR_VALUE);
    if (id)
        *id = 0;
    skv_outline outline;
    skv_body_shape *shape = NULL;
    skv_result result = check_def(def, error);
    if (result == SKV_OK)
        result = skv_outline_make(&def->shape, world->fluid.spacing, &outline, error);
    if (result == SKV_OK)
        result = admit(world, error);
    if (result == SKV_OK && world->bodies->count == SKV_MAX_BODIES)
        result = skv_fail(error, SKV_ERROR_LIMIT, "body: there are %d; that is all there may be",
                          SKV_MAX_BODIES);
    if (result == SKV_OK)
        result = skv_world_begin_removal(world, world->state.count, error);
    if (result == SKV_OK)
        result = skv_body_shape_create(world, world->bodies, &outline, &shape, error);
    if (result != SKV_OK)
        return result;
    skv_rigid *r = &world->bodies->body[world->bodies->count++];
    *r = (skv_rigid){.shape = shape};
    set_up(r, def);
    r->id = world->bodies->next_id++;
    world->bodies->set = true;
    skv_bodies_show(world);
    int count = clear(world, world->bodies->count - 1);
    if (id)
        *id = r->id;
    if (removed)
        *removed = count;
    return SKV_OK;
}

bool skv_world_remove_body(skv_world *world, skv_body_id id)
{
    SKV_ASSERT_OR(skv_may_change(world), false);
    int index = find(world, id);
    if (index < 0)
        return false;
    wake_around(world, index);
    skv_bodies_take_out(world, index);
    return true;
}

int skv_world_body_count(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return skv_world_has_bodies(world);
}

bool skv_world_body_at(const skv_world *world, int index, skv_body *body)
{
    SKV_ASSERT_OR(world && body, false);
    *body = (skv_body){0};
    if (index < 0 || index >= skv_world_has_bodies(world))
        return false;
    *body = world->bodies->shown[index];
    return true;
}

bool skv_world_body(const skv_world *world, skv_body_id id, skv_body *body)
{
    SKV_ASSERT_OR(world && body, false);
    return skv_world_body_at(world, find(world, id), body);
}

static skv_result refuse_id(skv_body_id id, skv_error *error)
{
    return skv_fail(error, SKV_ERROR_VALUE, "body: there is none named %u (any more)",
                    (unsigned)id);
}

skv_result skv_world_set_body_pose(skv_world *world, skv_body_id id, float x, float y, float angle,
                                   skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world), SKV_ERROR_VALUE);
    int index = find(world, id);
    skv_result result = index < 0 ? refuse_id(id, error) : check_pose(x, y, angle, error);
    if (result == SKV_OK)
        result = skv_world_begin_removal(world, world->state.count, error);
    if (result != SKV_OK)
        return result;
    wake_around(world, index);
    skv_rigid *r = &world->bodies->body[index];
    skv_rigid_put(r, (double)x, (double)y, (double)angle);
    world->bodies->set = true;
    skv_bodies_show(world);
    clear(world, index);
    return SKV_OK;
}

skv_result skv_world_set_body_velocity(skv_world *world, skv_body_id id, float vx, float vy,
                                       float spin, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world), SKV_ERROR_VALUE);
    int index = find(world, id);
    skv_result result = index < 0 ? refuse_id(id, error) : check_motion(vx, vy, spin, error);
    if (result != SKV_OK)
        return result;
    skv_rigid *r = &world->bodies->body[index];
    r->vx = (double)vx;
    r->vy = (double)vy;
    r->spin = (double)spin;
    if (r->pinned)
        skv_rigid_swing(r);
    skv_rigid_wake(r);
    world->bodies->set = true;
    skv_bodies_show(world);
    return SKV_OK;
}

static skv_result check_lead(const skv_rigid *r, const skv_motion *way, skv_error *error)
{
    if (!r->hosted)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "body: %u is not hosted, so nobody leads it; set its pose or its velocity",
                        (unsigned)r->id);
    if (is_within(way->x, way->y, way->turn, LED_FOR))
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE,
                    "body: it is led too far from where it is; allowed is %g m and 1 rad",
                    LED_FOR * MOST_SPEED);
}

/* What the host was told is rounded; what it leaves alone is no change. */
static double change_of(float to, double from)
{
    return to == (float)from ? 0 : (double)to - from;
}

static skv_motion add_motions(const skv_motion *a, const skv_motion *b)
{
    return (skv_motion){a->x + b->x, a->y + b->y, a->turn + b->turn};
}

skv_result skv_world_lead_body(skv_world *world, skv_body_id id, float x, float y, float angle,
                               float vx, float vy, float spin, skv_error *error)
{
    SKV_ASSERT_OR(world && world->busy == SKV_IN_SUBSTEPS, SKV_ERROR_VALUE);
    int index = find(world, id);
    skv_result result = index < 0 ? refuse_id(id, error) : check_motion(vx, vy, spin, error);
    if (result != SKV_OK)
        return result;
    skv_rigid *r = &world->bodies->body[index];
    skv_motion way = {change_of(x, r->x), change_of(y, r->y), change_of(angle, r->angle)};
    skv_motion spur = {change_of(vx, r->vx), change_of(vy, r->vy), change_of(spin, r->spin)};
    result = check_lead(r, &way, error);
    if (result != SKV_OK)
        return result;
    r->led = add_motions(&r->led, &way);
    r->spurred = add_motions(&r->spurred, &spur);
    skv_rigid_put(r, r->x + way.x, r->y + way.y, r->angle + way.turn);
    r->vx += spur.x;
    r->vy += spur.y;
    r->spin += spur.turn;
    return SKV_OK;
}

skv_result skv_world_set_body_motor(skv_world *world, skv_body_id id, float speed, float torque,
                                    skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world), SKV_ERROR_VALUE);
    int index = find(world, id);
    if (index < 0)
        return refuse_id(id, error);
    skv_rigid *r = &world->bodies->body[index];
    if (torque != 0 && (!r->pinned || r->fixed))
        return refuse_motor(error);
    skv_result result = check_motor(speed, torque, error);
    if (result != SKV_OK)
        return result;
    r->motor_speed = speed;
    r->motor_torque = torque;
    skv_rigid_wake(r);
    skv_bodies_show(world);
    return SKV_OK;
}

bool skv_world_grasp(const skv_world *world, float x, float y, float reach, skv_hand *hand)
{
    SKV_ASSERT_OR(world && hand, false);
    int nearest = -1;
    float least = skv_minf(reach, world->h);
    hand->body = 0;
    if (!skv_within((double)x, -1000, 1000) || !skv_within((double)y, -1000, 1000))
        return false;
    for (int k = 0; k < skv_world_has_bodies(world); k++) {
        float distance = skv_body_distance(world, k, x, y);
        if (!(distance <= least))
            continue;
        least = distance;
        nearest = k;
    }
    if (nearest < 0)
        return false;
    const skv_rigid *r = &world->bodies->body[nearest];
    double rx = (double)x - r->x, ry = (double)y - r->y;
    hand->body = r->id;
    hand->at_x = (float)(r->cos * rx + r->sin * ry);
    hand->at_y = (float)(r->cos * ry - r->sin * rx);
    return true;
}
