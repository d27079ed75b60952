/* The layer of fluid that lies on a body.
 *
 * In a substep the fluid meets a body that goes on as it went before, so what it gives the body is
 * right for that velocity alone. A body that is light against the fluid which lies on it would be
 * thrown back by more than it came with, and then by more again. So what pushes a body pushes its
 * layer, too, as if the two had hit each other without a bounce: across its sides the layer goes as
 * fast as the body does, along them by as much as walls hold what slips. Its mass is added to the
 * body's wherever that is given an impulse, and in the end its particles get what falls to them.
 *
 * Invariant: body and layer together get what the body was given, so momentum is kept; and what is
 * given nothing, or lies in the air, moves as it did.
 */
#include "base/exact.h"
#include "solver/wall_image.h"
#include "world/bodies/bodies.h"

/* Spacings from a body's side: the layer thins out from the first row of particles, which lies half
 * a spacing away, to the second. */
#define LAYER_BEGINS 0.5f
#define LAYER_ENDS   1.5f

/* Surface tension turns a body, too, as if its layer held such a share of its slip. It is twice
 * what keeps a disc from being whirled that is three particles wide and a hundredth as heavy as
 * water. */
#define LEAST_GRIP 0.1

/* A particle of a layer. */
typedef struct touch {
    int particle, body;
    double mass;             /* kg/m */
    double across;           /* share of the body's velocity that it takes across its side ... */
    double along;            /* ... and along it */
    double nx, ny;           /* out of the body */
    double x, y;             /* m, about the centre of mass ... */
    double about_x, about_y; /* ... and about what the body turns about */
} touch;

/* What goes over all of the layers. */
typedef struct layers {
    skv_world *world;
    skv_resistance resists[SKV_MAX_BODIES];
    double touched[SKV_MAX_BODIES], heavier[SKV_MAX_BODIES]; /* in particles of the first fluid */
    skv_motion change[SKV_MAX_BODIES];
} layers;

static bool may_move(const skv_rigid *r)
{
    return !r->asleep && (!r->fixed || r->held);
}

/* The share of its slip that a particle loses at a side that it touches. */
static double find_grip(const skv_world *world, int i)
{
    const skv_constants *c = &world->constants;
    float friction = c->slip_friction, pairs = c->wall_drag;
    if (world->state.several) {
        float drag = world->state.drag[i] / world->state.mass[i];
        friction = drag > 0 ? 0 : c->bare_slip;
        pairs = c->wall_stick * c->dt * drag;
    }
    return skv_max(LEAST_GRIP, (double)(skv_slip_taken(friction, pairs, SKV_TOUCH) + c->friction));
}

static bool find_touch(const skv_world *world, int i, int k, touch *t)
{
    const skv_rigid *r = &world->bodies->body[k];
    const skv_solid *s = &world->bodies->solids.solid[k];
    float spacing = world->fluid.spacing, end = LAYER_ENDS * spacing, nx, ny;
    float x = world->state.x[i], y = world->state.y[i], lx = x, ly = y;
    float dx = x - s->now.x, dy = y - s->now.y;
    if (!may_move(r) || dx * dx + dy * dy > (s->reach + end) * (s->reach + end))
        return false;
    skv_solid_enter(s, &s->now, &lx, &ly);
    float distance = skv_normal_at(s->shape->terrain, lx, ly, &nx, &ny);
    if (!(distance < end))
        return false;
    skv_solid_turn(&s->now, &nx, &ny);
    /* What lies in a film is held by the terrain. */
    float film = skv_solids_film(&world->boundary, k + 1, x, y);
    float share = skv_clamp((end - distance) / ((LAYER_ENDS - LAYER_BEGINS) * spacing), 0, 1);
    double mass = (double)world->fluid.density * (double)spacing * (double)spacing;
    *t = (touch){
        .particle = i,
        .body = k,
        .mass = world->state.several ? mass * (double)world->state.mass[i] : mass,
        .across = (double)(share * (1 - film)),
        .nx = (double)nx,
        .ny = (double)ny,
        .x = (double)x - r->x,
        .y = (double)y - r->y,
        .about_x = (double)x - (r->pinned ? r->pin_x : r->x),
        .about_y = (double)y - (r->pinned ? r->pin_y : r->y),
    };
    t->along = t->across * find_grip(world, i);
    return true;
}

/* Goes over all particles of all layers, in the order of particles. */
static void visit(layers *l, void (*each)(layers *l, const touch *t))
{
    const skv_world *world = l->world;
    const skv_solids *solids = &world->bodies->solids;
    const float end = LAYER_ENDS * world->fluid.spacing;
    for (int i = 0; i < world->state.count; i++) {
        if (world->state.clearance[i] >= end)
            continue;
        uint64_t left = solids->beside[skv_strip_of(solids, world->state.x[i])];
        for (touch t; left; left &= left - 1)
            if (find_touch(world, i, __builtin_ctzll(left), &t))
                each(l, &t);
    }
}

/* ---- Joining --------------------------------------------------------------------------------- */

static void add_along(skv_resistance *sum, const touch *t, double nx, double ny, double mass)
{
    double moment = t->about_x * ny - t->about_y * nx;
    sum->xx += mass * nx * nx;
    sum->xy += mass * nx * ny;
    sum->yy += mass * ny * ny;
    sum->xt += mass * nx * moment;
    sum->yt += mass * ny * moment;
    sum->tt += mass * moment * moment;
}

static void resist(layers *l, const touch *t)
{
    add_along(&l->resists[t->body], t, t->nx, t->ny, t->across * t->mass);
    add_along(&l->resists[t->body], t, -t->ny, t->nx, t->along * t->mass);
    l->touched[t->body] += t->across;
    if (l->world->state.several)
        l->heavier[t->body] += t->across * ((double)l->world->state.mass[t->particle] - 1);
}

/* What gives way resists, too, by what it pushes less. */
static void resist_by_faces(layers *l)
{
    const skv_bodies *b = l->world->bodies;
    for (int i = 0; i < b->faces; i++) {
        const skv_body_face *f = &b->face[i];
        skv_resistance *sum = &l->resists[f->body];
        sum->xx += f->stiffness * f->x * f->x;
        sum->xy += f->stiffness * f->x * f->y;
        sum->yy += f->stiffness * f->y * f->y;
        sum->xt += f->stiffness * f->x * f->turn;
        sum->yt += f->stiffness * f->y * f->turn;
        sum->tt += f->stiffness * f->turn * f->turn;
    }
}

/* The mobility of a body with its layer, whose resistance is given. */
static skv_mobility join(const skv_rigid *r, skv_resistance m)
{
    m.xx += r->mass;
    m.yy += r->mass;
    m.tt += r->inertia;
    if (r->pinned)
        return skv_mobility_about_pin(r, 1 / m.tt);
    double flat = m.xx * m.yy - m.xy * m.xy;
    if (r->fixed)
        return (skv_mobility){.xx = m.yy / flat, .xy = -m.xy / flat, .yy = m.xx / flat};
    double xx = m.yy * m.tt - m.yt * m.yt, xy = m.xt * m.yt - m.xy * m.tt;
    double xt = m.xy * m.yt - m.yy * m.xt, yt = m.xy * m.xt - m.xx * m.yt;
    double part = 1 / (m.xx * xx + m.xy * xy + m.xt * xt);
    return (skv_mobility){.xx = part * xx,
                          .xy = part * xy,
                          .yy = part * (m.xx * m.tt - m.xt * m.xt),
                          .xt = part * xt,
                          .yt = part * yt,
                          .tt = part * flat};
}

void skv_bodies_join_layers(skv_world *world, skv_motion before[SKV_MAX_BODIES])
{
    layers l = {.world = world};
    visit(&l, resist);
    for (int k = 0; k < world->bodies->count; k++) {
        skv_rigid *r = &world->bodies->body[k];
        before[k] = (skv_motion){r->vx, r->vy, r->spin};
        r->layer[0] = (l.resists[k].xx + l.resists[k].yy) / 2;
        r->layer[1] = l.resists[k].tt;
        r->around = (double)world->fluid.density;
        if (l.touched[k] > 0)
            r->around *= 1 + l.heavier[k] / l.touched[k];
    }
    resist_by_faces(&l);
    for (int k = 0; k < world->bodies->count; k++)
        if (may_move(&world->bodies->body[k]))
            world->bodies->body[k].mobility = join(&world->bodies->body[k], l.resists[k]);
}

/* ---- Parting --------------------------------------------------------------------------------- */

/* Gives a particle what falls to it, which the body has not got. */
static void hand_on(layers *l, const touch *t)
{
    const skv_motion *c = &l->change[t->body];
    skv_impulse *felt = &l->world->bodies->body[t->body].felt;
    double wx = c->x - c->turn * t->about_y, wy = c->y + c->turn * t->about_x;
    double across = t->across * (wx * t->nx + wy * t->ny);
    double along = t->along * (wy * t->nx - wx * t->ny);
    double x = across * t->nx - along * t->ny, y = across * t->ny + along * t->nx;
    l->world->state.vx[t->particle] += (float)x;
    l->world->state.vy[t->particle] += (float)y;
    felt->x -= t->mass * x;
    felt->y -= t->mass * y;
    felt->moment -= t->mass * (t->x * y - t->y * x);
}

/* Takes from what bodies felt what faces did not push. */
static void give_way(const layers *l)
{
    skv_bodies *b = l->world->bodies;
    for (int i = 0; i < b->faces; i++) {
        const skv_body_face *f = &b->face[i];
        skv_rigid *r = &b->body[f->body];
        double less = f->stiffness * skv_face_rate(f, r, l->change[f->body]);
        r->felt.x -= less * f->x;
        r->felt.y -= less * f->y;
        r->felt.moment -= less * skv_face_moment(f, r);
    }
    b->faces = 0;
}

void skv_bodies_part_from_layers(skv_world *world, const skv_motion before[SKV_MAX_BODIES])
{
    layers l = {.world = world};
    for (int k = 0; k < world->bodies->count; k++) {
        skv_rigid *r = &world->bodies->body[k];
        l.change[k] = (skv_motion){.turn = r->spin - before[k].turn};
        if (!r->pinned) {
            l.change[k].x = r->vx - before[k].x;
            l.change[k].y = r->vy - before[k].y;
        }
        skv_rigid_free(r);
    }
    visit(&l, hand_on);
    give_way(&l);
}

void skv_bodies_spur_layers(skv_world *world)
{
    layers l = {.world = world};
    bool any = false;
    for (int k = 0; k < world->bodies->count; k++) {
        skv_rigid *r = &world->bodies->body[k];
        l.change[k] = r->spurred;
        any = any || r->spurred.x != 0 || r->spurred.y != 0 || r->spurred.turn != 0;
        r->spurred = (skv_motion){0};
    }
    if (any)
        visit(&l, hand_on);
}
