/* The bodies of a world: their list, and what a substep does with them; see bodies.c. */
#ifndef SKV_WORLD_BODIES_H
#define SKV_WORLD_BODIES_H

#include "base/bytes.h"
#include "skvalp/bodies.h"
#include "terrain/solids.h"
#include "world/bodies/shape.h"

/* How a body's velocity and spin change by an impulse and its moment about the centre of mass:
 * symmetric, of x, y and the turn; 1/kg, 1/(kg m) and so on, for a metre of depth. */
typedef struct skv_mobility {
    double xx, xy, yy, xt, yt, tt;
} skv_mobility;

/* What resists a change of velocity, as the inverse of a mobility has it. */
typedef struct skv_resistance {
    double xx, xy, yy, xt, yt, tt;
} skv_resistance;

/* A change of place and angle, or the velocities. */
typedef struct skv_motion {
    double x, y, turn;
} skv_motion;

/* A body at work. Double precision: a substep's changes are small against what they change. */
typedef struct skv_rigid {
    skv_body_id id;
    skv_body_shape *shape;
    double x, y, angle; /* centre of mass, m, and rad */
    double cos, sin;    /* of the angle */
    double vx, vy, spin;
    double mass, inertia;  /* by its density, kg/m and kg m; of pinned ones about the pin */
    double pin_x, pin_y;   /* m: what it turns about, if it is pinned; else 0 ... */
    double at_x, at_y;     /* ... and from there to its centre of mass, in its own axes ... */
    double arm_x, arm_y;   /* ... and in the world's */
    skv_mobility mobility; /* of the body alone; while it feels, with the fluid that lies on it */
    float density, friction, restitution;
    float motor_speed, motor_torque;
    bool fixed, pinned;
    bool held;          /* by a hand, and fixed: see bodies/grip.c */
    bool asleep;        /* bodies/rest.c: is not moved ... */
    bool still;         /* ... has not gone far since sleep's last look round ... */
    skv_motion anchor;  /* ... from where it was then, m, m and rad */
    bool hosted;        /* a host's engine moves it, and lets it meet walls and others of its own */
    skv_motion led;     /* by how much its host has changed its pose, m, m and rad ... */
    skv_motion spurred; /* ... and its velocity since the last substep */
    double around;      /* density of the fluid that lies on it, else of the first one, kg/m^2 */
    double layer[2];    /* mass and inertia of the fluid that lies on it, kg/m and kg m */
    skv_impulse felt;   /* from the fluid in the last step that it felt: N s/m and N s ... */
    double felt_for;    /* ... and for how long, s */
    skv_impulse owed;   /* by air and films, until it feels them in the same substep */
} skv_rigid;

/* What gives way as a body moves, as a pocket of air does, from when it pushes until bodies feel
 * that. Its push is so much less for each m^2/s by which the body makes it grow. */
typedef struct skv_body_face {
    int body, label; /* this one of the pockets */
    double x, y;     /* how it grows with the body's motion, m ... */
    double turn;     /* ... and turn, about its pin or its centre of mass, m^2 */
    double stiffness;
} skv_body_face;

/* More are passed over. */
enum { SKV_MOST_FACES = 1024 };

/* A contact of body a, made for a substep; see bodies/contacts.c. */
typedef struct skv_body_contact {
    skv_rigid *a, *b; /* b null: the terrain */
    int rim;          /* the point of a's rim that touches */
    double x, y;      /* where, against a's centre of mass and b's */
    double bx, by;
    double nx, ny;                  /* out of b */
    double distance;                /* m, below 0 in b */
    double part;                    /* speed along the normal that it is to have at least, m/s */
    double normal, along;           /* impulses so far */
    double normal_mass, along_mass; /* what resists these */
} skv_body_contact;

/* More are passed over. */
enum { SKV_MOST_CONTACTS = 1024 };
typedef struct skv_body_contacts {
    int count;
    skv_body_contact list[SKV_MOST_CONTACTS];
} skv_body_contacts;

/* What a contact bore in the last substep. */
typedef struct skv_body_touch {
    skv_body_id a, b; /* b 0: the terrain */
    int rim;
    double normal, along; /* N/m */
} skv_body_touch;

/* In the order in which contacts are found. */
static inline bool skv_touch_precedes(const skv_body_touch *one, const skv_body_touch *other)
{
    if (one->a != other->a)
        return one->a < other->a;
    return one->b != other->b ? one->b < other->b : one->rim < other->rim;
}

typedef struct skv_bodies {
    int count;
    skv_rigid body[SKV_MAX_BODIES]; /* in the order in which they were added */
    skv_body_id next_id;
    bool set;    /* somebody has added or set one: contacts are yet to be solved */
    bool begins; /* a step; what bodies felt in the last one is yet to be forgotten */
    skv_solids solids;
    skv_impulse given[SKV_MAX_BODIES]; /* by the solver, m and m^2 */
    skv_body_contacts contacts;
    int touches;
    skv_body_touch touch[SKV_MOST_CONTACTS];
    int faces; /* in the order of bodies; none between substeps */
    skv_body_face face[SKV_MOST_FACES];
    skv_body shown[SKV_MAX_BODIES]; /* as a host sees them */
} skv_bodies;

static inline int skv_world_has_bodies(const skv_world *world)
{
    return world->bodies ? world->bodies->count : 0;
}

/* A substep of `dt`: bodies move before the solver does, which is to tell what they gave; then they
 * feel it, if any `moves`, and gravity, and each other. Without bodies nothing. */
void skv_bodies_begin_step(skv_world *world);
void skv_bodies_move(skv_world *world, double dt);
void skv_bodies_feel(skv_world *world, double dt, bool moves);

/* bodies/layer.c: between these two bodies are as hard to move as they are with the fluid that lies
 * on them, which in the end gets its part of what has changed their velocities. */
void skv_bodies_join_layers(skv_world *world, skv_motion before[SKV_MAX_BODIES]);
void skv_bodies_part_from_layers(skv_world *world, const skv_motion before[SKV_MAX_BODIES]);
/* What has spurred a body on goes to its layer, too. */
void skv_bodies_spur_layers(skv_world *world);

/* Takes one out, and those that have left through open sides. */
void skv_bodies_take_out(skv_world *world, int index);
void skv_bodies_remove_leavers(skv_world *world);

/* Whether fluid at (x, y) wakes when the body moves, comes or goes: within two smoothing radii, as
 * around what moves in the fluid itself (calm/sleep.c). */
static inline bool skv_rigid_stirs(const skv_rigid *body, float x, float y, float h)
{
    double dx = (double)x - body->x, dy = (double)y - body->y;
    double reach = body->shape->outline.reach + 2 * (double)h;
    return dx * dx + dy * dy <= reach * reach;
}

/* A point of the rim in the world's axes, m. */
static inline void skv_rigid_rim(const skv_rigid *body, int point, double *x, double *y)
{
    double rx = (double)body->shape->rim[point][0], ry = (double)body->shape->rim[point][1];
    *x = body->x + body->cos * rx - body->sin * ry;
    *y = body->y + body->sin * rx + body->cos * ry;
}

/* What turns about a pin moves as it turns. */
static inline void skv_rigid_swing(skv_rigid *body)
{
    body->vx = -body->spin * body->arm_y;
    body->vy = body->spin * body->arm_x;
}

/* That of a body which turns about a pin, by how easily it does. */
static inline skv_mobility skv_mobility_about_pin(const skv_rigid *body, double tt)
{
    double ax = body->arm_x, ay = body->arm_y;
    return (skv_mobility){tt * ay * ay, -tt * ax * ay, tt * ax * ax, -tt * ay, tt * ax, tt};
}

/* The velocity along an impulse (nx, ny) with its moment that this gives. */
static inline double skv_mobility_along(const skv_mobility *m, double nx, double ny, double moment)
{
    return m->xx * nx * nx + m->yy * ny * ny + m->tt * moment * moment +
           2 * (m->xy * nx * ny + m->xt * nx * moment + m->yt * ny * moment);
}

/* Gives a body an impulse (N s/m) and its moment about the centre of mass (N s), of which it takes
 * what it is free to follow. */
static inline void skv_rigid_push(skv_rigid *body, double jx, double jy, double moment)
{
    const skv_mobility *m = &body->mobility;
    body->vx += m->xx * jx + m->xy * jy + m->xt * moment;
    body->vy += m->xy * jx + m->yy * jy + m->yt * moment;
    body->spin += m->xt * jx + m->yt * jy + m->tt * moment;
    if (body->pinned)
        skv_rigid_swing(body);
}

/* A film or air owes a body an impulse (N s/m) at a point of its rim. */
static inline void skv_rigid_press(skv_rigid *body, double jx, double jy, double x, double y)
{
    body->owed.x += jx;
    body->owed.y += jy;
    body->owed.moment += (x - body->x) * jy - (y - body->y) * jx;
}

/* How fast a face grows as its body moves so and turns, m^2/s. */
static inline double skv_face_rate(const skv_body_face *f, const skv_rigid *body, skv_motion m)
{
    return f->turn * m.turn + (body->pinned ? 0 : f->x * m.x + f->y * m.y);
}

/* The moment about the centre of mass of a push of 1 Pa m on a face. */
static inline double skv_face_moment(const skv_body_face *f, const skv_rigid *body)
{
    return f->turn - (body->pinned ? body->arm_x * f->y - body->arm_y * f->x : 0);
}

/* bodies/rest.c: who is awake, of those that are not fixed where they are; whether any sleeps, and
 * whether a particle is kept awake by one that does not. */
static inline bool skv_rigid_is_awake(const skv_rigid *r)
{
    return !r->asleep && (!r->fixed || r->held || r->vx != 0 || r->vy != 0 || r->spin != 0);
}
int skv_bodies_awake(const skv_world *world);
bool skv_bodies_sleep(const skv_world *world);
bool skv_bodies_stir(const skv_world *world, int particle);
/* Wakes one, all, who sleeps within reach of a particle that does not (at a look round: who is
 * still), and who sleeps and touches who does not: whether there was any. */
void skv_rigid_wake(skv_rigid *r);
void skv_bodies_wake_all(skv_world *world);
void skv_bodies_disturb(skv_world *world, int particle, bool look_round);
bool skv_bodies_wake_touched(skv_body_contacts *contacts);
/* After substeps: who goes farther than `most`, m, is not still. At a look round those that are
 * fall asleep, and all are watched anew. */
void skv_bodies_watch(skv_world *world, float most);
void skv_bodies_come_to_rest(skv_world *world);

/* Adds what decides their future to a hash. */
uint64_t skv_bodies_hash(uint64_t hash, const skv_bodies *bodies);

/* The distance of a place from a body's surface, below 0 inside; a lower bound of it farther away
 * than h, which is as far as the shape's picture reaches around it. */
float skv_body_distance(const skv_world *world, int index, float x, float y);
/* Lower bound of a place's distance from all bodies, below 0 in one; INFINITY if there is none. */
float skv_bodies_distance(const skv_world *world, float x, float y);

/* bodies/pins.c: finds what follows from a body's shape, density, angle and pin: where a pinned one
 * is, too; a body turns about that point from now on; it comes to another place, with its pin if it
 * has one; motors act for `dt`. */
void skv_rigid_derive(skv_rigid *body);
void skv_rigid_free(skv_rigid *body); /* finds its mobility, of the body alone */
void skv_rigid_pin(skv_rigid *body, double x, double y);
void skv_rigid_put(skv_rigid *body, double x, double y, double angle);
void skv_bodies_drive_motors(skv_bodies *bodies, double dt);
/* Tells the solver's boundary of all bodies, at rest where they are. */
void skv_bodies_show(skv_world *world);
/* An empty list. */
skv_bodies *skv_bodies_create(void);
void skv_bodies_destroy(skv_bodies *bodies);
/* Gives a world another list, and frees its own. */
void skv_bodies_take_over(skv_world *world, skv_bodies *bodies);

/* bodies/snapshot.c: in a snapshot, and whether touches are part of it. Reading checks all of it;
 * loading makes a list of what has been read, with the shapes that the world has already, for a
 * world that is like the snapshot's. */
void skv_bodies_save(skv_writer *writer, const skv_bodies *bodies);
static inline bool skv_bodies_touch(const skv_bodies *bodies)
{
    return bodies && bodies->touches > 0;
}
/* Whether a body is still, whose anchor then is part of it. */
bool skv_bodies_are_watched(const skv_bodies *bodies);
skv_result skv_bodies_check(skv_reader *reader, float spacing, bool with_touches, skv_error *error);
skv_result skv_bodies_load(const skv_world *world, skv_reader reader, bool with_touches,
                           skv_bodies **bodies, skv_error *error);

/* bodies/film.c: whether films between bodies and walls may ask for pressures; these act on the
 * bodies for `dt`. */
bool skv_bodies_may_have_films(const skv_world *world);
void skv_bodies_press_films(const skv_world *world, double dt);

/* bodies/grip.c: hands take hold and let go; they pull at what they hold for `dt`, and move on. */
void skv_bodies_take_hold(skv_world *world);
void skv_bodies_follow_hands(skv_world *world, double dt);
/* A fixed body is moved as if it were of steel, at least, kg/m^2. */
#define SKV_STEEL 7850.0f

/* bodies/contacts.c: lets no body move into the terrain or another in the next `dt`; whether they
 * have had their weight for it, which contacts go on bearing. */
void skv_bodies_solve_contacts(skv_world *world, double dt, bool weighs);

#endif
