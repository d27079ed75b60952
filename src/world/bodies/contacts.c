/* Contacts of bodies with the terrain and with each other.
 *
 * Points of a body's rim are asked how far they are from the walls and from other bodies, whatever
 * their shapes are. Where one would come closer than it may within a substep, an impulse along the
 * normal stops it, and one along the surface holds it as far as Coulomb's friction can; rounds over
 * all contacts in turn spread what one does to the others (sequential impulses, Catto 2005).
 * Invariant: contacts are found and solved in the order of bodies and rim points.
 */
#include "base/exact.h"
#include "terrain/sample.h"
#include "world/bodies/bodies.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 20 };

/* How deep a contact may be, m: it stays one from substep to substep. */
#define SLOP 3e-4

/* What is deeper is parted by such a share in a substep, and at most so fast, m/s: a jolt would be
 * speed. */
#define PARTS      0.1
#define PARTS_MOST 0.5

/* Beside two contacts of a flat side one between them is spare: it would be deeper than they let it
 * be by less than a third of what a contact may, where normals differ by less than 2.6 degrees, and
 * so pushes by less than a twentieth. */
#define SPARE_BY    (SLOP / 3)
#define SPARE_ALIKE 0.999

/* m/s: what meets slower does not bounce. A fall of 5 mm. */
#define BOUNCES_FROM 0.3

typedef skv_body_contact contact;
typedef skv_body_contacts contacts;

/* How fast a moves away from b, there. */
static void velocity_at(const contact *c, double *x, double *y)
{
    *x = c->a->vx - c->a->spin * c->y;
    *y = c->a->vy + c->a->spin * c->x;
    if (c->b) {
        *x -= c->b->vx - c->b->spin * c->by;
        *y -= c->b->vy + c->b->spin * c->bx;
    }
}

/* The moment of (nx, ny) at (x, y) beside the centre of mass of what is pinned, about its pin. */
static double lever(const skv_rigid *r, double x, double y, double nx, double ny)
{
    return (x + r->arm_x) * ny - (y + r->arm_y) * nx;
}

static void push(const contact *c, double x, double y)
{
    skv_rigid_push(c->a, x, y, c->x * y - c->y * x);
    if (c->b)
        skv_rigid_push(c->b, -x, -y, c->by * x - c->bx * y);
}

/* The mass that an impulse along (nx, ny) moves; 0 if it moves nothing. */
static double mass_along(const contact *c, double nx, double ny)
{
    double moved = skv_mobility_along(&c->a->mobility, nx, ny, c->x * ny - c->y * nx);
    if (c->b)
        moved += skv_mobility_along(&c->b->mobility, nx, ny, c->bx * ny - c->by * nx);
    return moved > 0 ? 1 / moved : 0;
}

/* How fast what is too deep is parted at most: what is pinned no faster there than at its farthest
 * point, else a touch beside the pin would whirl it round. */
static double part_most(const contact *c)
{
    double most = PARTS_MOST;
    if (c->a->pinned)
        most *=
            skv_min(fabs(lever(c->a, c->x, c->y, c->nx, c->ny)) / c->a->shape->outline.reach, 1);
    if (c->b && c->b->pinned)
        most *=
            skv_min(fabs(lever(c->b, c->bx, c->by, c->nx, c->ny)) / c->b->shape->outline.reach, 1);
    return most;
}

/* Of rim point k of a, which is at (x, y). */
static void add(contacts *all, skv_rigid *a, skv_rigid *b, int k, double x, double y, double nx,
                double ny, double distance)
{
    if (all->count == SKV_MOST_CONTACTS)
        return;
    contact *c = &all->list[all->count++];
    *c = (contact){.a = a, .b = b, .rim = k, .x = x - a->x, .y = y - a->y, .nx = nx, .ny = ny};
    c->distance = distance;
    if (b) {
        c->bx = x - b->x;
        c->by = y - b->y;
    }
}

/* Finds what a contact resists, and what is asked of it. */
static void prepare(contact *c, double dt)
{
    c->normal_mass = mass_along(c, c->nx, c->ny);
    c->along_mass = mass_along(c, -c->ny, c->nx);
    if (c->distance > 0)
        c->part = -c->distance / dt; /* it may come as near as it likes */
    else if (c->distance < -SLOP)
        c->part = skv_min(-PARTS * (c->distance + SLOP) / dt, part_most(c));
    double vx, vy, bounce = (double)c->a->restitution;
    velocity_at(c, &vx, &vy);
    if (c->b)
        bounce = skv_max(bounce, (double)c->b->restitution);
    double speed = vx * c->nx + vy * c->ny;
    if (speed < -BOUNCES_FROM && c->distance + dt * speed < 0)
        c->part = skv_max(c->part, -bounce * speed);
}

/* How far what is nearer than that may come in a substep, to each other. */
static double reach_of(const skv_rigid *r, double dt)
{
    double speed = sqrt(r->vx * r->vx + r->vy * r->vy);
    return dt * (speed + fabs(r->spin) * r->shape->outline.reach);
}

static bool are_alike(const contact *a, const contact *b)
{
    return a->nx * b->nx + a->ny * b->ny > SPARE_ALIKE;
}

/* Whether what contact c asks for follows from what two others on its sides do: along one normal
 * speeds are as linear as a side's distances are. */
static bool is_spare(const contact *a, const contact *c, const contact *b)
{
    double ways = (b->y - a->y) * c->nx - (b->x - a->x) * c->ny;
    double way = (c->y - a->y) * c->nx - (c->x - a->x) * c->ny;
    double share = ways != 0 ? way / ways : -1;
    return are_alike(a, c) && are_alike(b, c) && share >= 0 && share <= 1 &&
           c->distance > a->distance + share * (b->distance - a->distance) - SPARE_BY;
}

/* Takes out what is spare from one on: what is left converges in fewer rounds. */
static void thin_out(contacts *all, int from)
{
    int kept = from;
    for (int k = from; k < all->count; k++) {
        while (kept >= from + 2 &&
               is_spare(&all->list[kept - 2], &all->list[kept - 1], &all->list[k]))
            kept--;
        all->list[kept++] = all->list[k];
    }
    all->count = kept;
}

/* m: what lies deeper in something may have points of its rim beyond that thing's middle, for no
 * body is thinner than a spacing. */
static double deep_in(const skv_world *world)
{
    return -(double)world->fluid.spacing / 2;
}

/* Contacts with walls, from one on, of what lies deep in them: across one or between two. The sides
 * that are nearest ask it out all ways. It could go along the sum of their normals; where one is
 * against that no motion parts all, and to ask for it takes energy out of nowhere. So nothing is
 * asked for, and it stays. */
static void let_wedged_be(contacts *all, int from, double deep)
{
    double x = 0, y = 0;
    bool lies_deep = false, against = false;
    for (int k = from; k < all->count; k++) {
        const contact *c = &all->list[k];
        x += c->distance < 0 ? c->nx : 0;
        y += c->distance < 0 ? c->ny : 0;
        lies_deep = lies_deep || c->distance < deep;
    }
    for (int k = from; k < all->count && lies_deep; k++) {
        const contact *c = &all->list[k];
        against = against || (c->distance < 0 && c->nx * x + c->ny * y <= 0);
    }
    for (int k = from; k < all->count && against; k++)
        all->list[k].distance = skv_max(all->list[k].distance, 0);
}

/* What is within a particle of its pin touches no wall, so that a gate can hang at one. */
static bool is_axle(const skv_world *world, const skv_rigid *r, double x, double y)
{
    double dx = x - r->pin_x, dy = y - r->pin_y, near = (double)world->fluid.spacing;
    return dx * dx + dy * dy < near * near;
}

static void meet_terrain(contacts *all, const skv_world *world, skv_rigid *a, double dt)
{
    const skv_terrain *terrain = world->terrain;
    double near = SLOP + reach_of(a, dt);
    int from = all->count;
    double middle = (double)skv_distance_at(terrain, (float)a->x, (float)a->y);
    if (a->fixed || a->hosted || a->asleep || middle > a->shape->outline.reach + near)
        return;
    for (int k = 0; k < a->shape->rims; k++) {
        double x, y;
        float nx, ny;
        skv_rigid_rim(a, k, &x, &y);
        if (a->pinned && is_axle(world, a, x, y))
            continue;
        double distance = (double)skv_normal_at(terrain, (float)x, (float)y, &nx, &ny);
        if (distance < near)
            add(all, a, NULL, k, x, y, (double)nx, (double)ny, distance);
    }
    let_wedged_be(all, from, deep_in(world));
    thin_out(all, from);
}

/* The rim points of a that are near b. */
static void meet_body(contacts *all, const skv_solid *solid, skv_rigid *a, skv_rigid *b, double dt)
{
    double near = SLOP + reach_of(a, dt) + reach_of(b, dt), reach = b->shape->outline.reach + near;
    double dx = a->x - b->x, dy = a->y - b->y, apart = reach + a->shape->outline.reach;
    int from = all->count;
    if ((a->fixed && b->fixed) || (a->hosted && b->hosted) ||
        !(skv_rigid_is_awake(a) || skv_rigid_is_awake(b)) || dx * dx + dy * dy > apart * apart)
        return;
    for (int k = 0; k < a->shape->rims; k++) {
        double x, y;
        skv_rigid_rim(a, k, &x, &y);
        if ((x - b->x) * (x - b->x) + (y - b->y) * (y - b->y) > reach * reach)
            continue;
        float lx = (float)x, ly = (float)y, nx, ny;
        skv_solid_enter(solid, &solid->now, &lx, &ly);
        double distance = (double)skv_normal_at(b->shape->terrain, lx, ly, &nx, &ny);
        if (!(distance < near))
            continue;
        skv_solid_turn(&solid->now, &nx, &ny);
        add(all, a, b, k, x, y, (double)nx, (double)ny, distance);
    }
    thin_out(all, from);
}

/* ---- What lies in each other ----------------------------------------------------------------- */

static int index_of(const skv_bodies *bodies, const skv_rigid *r)
{
    return (int)(r - bodies->body);
}

/* How far a's middle is from the sides of b, m. */
static double middle_to(const skv_world *world, const skv_rigid *a, const skv_rigid *b)
{
    const skv_solid *solid = &world->bodies->solids.solid[index_of(world->bodies, b)];
    float x = (float)a->x, y = (float)a->y;
    skv_solid_enter(solid, &solid->now, &x, &y);
    return (double)skv_distance_at(b->shape->terrain, x, y);
}

/* Whether a's middle lies in both. The middle of the thinnest body is as deep as deep: half of that
 * tells it from what lies on it. */
static bool share_middle(const skv_world *world, const skv_rigid *a, const skv_rigid *b,
                         double deep)
{
    return middle_to(world, a, b) < deep / 2 && middle_to(world, a, a) < deep / 2;
}

/* Which bodies each lies deep in, or has in it. As bits. Where sides coincide no rim is deep, and
 * all of it counts as that. */
static void find_tangled(const skv_world *world, uint64_t with[SKV_MAX_BODIES])
{
    contacts *all = &world->bodies->contacts;
    const double deep = deep_in(world);
    memset(with, 0, SKV_MAX_BODIES * sizeof *with);
    for (int k = 0; k < all->count; k++) {
        contact *c = &all->list[k];
        if (c->b && share_middle(world, c->a, c->b, deep))
            c->distance = skv_min(c->distance, deep);
        if (!c->b || c->distance > deep)
            continue;
        int a = index_of(world->bodies, c->a), b = index_of(world->bodies, c->b);
        with[a] |= 1ull << b;
        with[b] |= 1ull << a;
    }
}

/* Has a contact of two bodies that lie deep in each other part them along the line of their
 * centres; false: it would hold them. Of two in the very same place the older one goes up,
 * whoever's rim it is. */
static bool untangle(contact *c)
{
    double x = c->a->x - c->b->x, y = c->a->y - c->b->y, length = sqrt(x * x + y * y);
    double dx = length > 0 ? x / length : 0, dy = length > 0 ? y / length : c->a < c->b ? 1 : -1;
    if (c->distance > 0)
        return c->nx * dx + c->ny * dy > 0;
    c->nx = dx;
    c->ny = dy;
    return true;
}

/* The sides that are nearest to points of what lies deep in each other face all ways. Nothing can
 * go all of them at once, and what is asked to takes energy out of nowhere. */
static void untangle_all(skv_world *world)
{
    contacts *all = &world->bodies->contacts;
    uint64_t with[SKV_MAX_BODIES];
    find_tangled(world, with);
    int kept = 0;
    for (int k = 0; k < all->count; k++) {
        contact *c = &all->list[k];
        bool tangled =
            c->b && with[index_of(world->bodies, c->a)] >> index_of(world->bodies, c->b) & 1;
        if (!tangled || untangle(c))
            all->list[kept++] = *c;
    }
    all->count = kept;
}

/* ---- From substep to substep ----------------------------------------------------------------- */

static skv_body_touch name_of(const contact *c)
{
    return (skv_body_touch){.a = c->a->id, .b = c->b ? c->b->id : 0, .rim = c->rim};
}

/* Begins with what each contact bore in the last substep: both lists are in the same order. */
static void begin_warm(skv_bodies *bodies, double dt)
{
    int at = 0;
    for (int k = 0; k < bodies->contacts.count; k++) {
        contact *c = &bodies->contacts.list[k];
        skv_body_touch name = name_of(c);
        while (at < bodies->touches && skv_touch_precedes(&bodies->touch[at], &name))
            at++;
        const skv_body_touch *had = &bodies->touch[at];
        if (at == bodies->touches || skv_touch_precedes(&name, had))
            continue;
        c->normal = dt * had->normal;
        c->along = dt * had->along;
        push(c, c->normal * c->nx - c->along * c->ny, c->normal * c->ny + c->along * c->nx);
    }
}

static bool sleeps(const skv_bodies *bodies, skv_body_id id)
{
    bool asleep = false;
    for (int k = 0; k < bodies->count; k++)
        asleep = asleep || (bodies->body[k].asleep && bodies->body[k].id == id);
    return asleep;
}

/* Takes out what is not between sleepers; returns how many are left. */
static int keep_asleep(const skv_world *world)
{
    skv_bodies *bodies = world->bodies;
    int kept = 0, count = skv_bodies_sleep(world) ? bodies->touches : 0;
    for (int k = 0; k < count; k++) {
        const skv_body_touch *t = &bodies->touch[k];
        if (sleeps(bodies, t->a) || sleeps(bodies, t->b))
            bodies->touch[kept++] = *t;
    }
    return kept;
}

/* Notes what contacts bear, among what sleepers do: from the last one on, for both are in order. */
static void keep(const skv_world *world, double dt)
{
    skv_bodies *bodies = world->bodies;
    const contacts *all = &bodies->contacts;
    int asleep = keep_asleep(world), to = asleep;
    for (int k = 0; k < all->count; k++)
        to += all->list[k].normal > 0;
    if (to > SKV_MOST_CONTACTS) {
        to -= asleep;
        asleep = 0;
    }
    bodies->touches = to;
    for (int k = all->count - 1; k >= 0; k--) {
        const contact *c = &all->list[k];
        if (!(c->normal > 0))
            continue;
        skv_body_touch touch = name_of(c);
        touch.normal = c->normal / dt;
        touch.along = c->along / dt;
        while (asleep > 0 && skv_touch_precedes(&touch, &bodies->touch[asleep - 1]))
            bodies->touch[--to] = bodies->touch[--asleep];
        bodies->touch[--to] = touch;
    }
}

/* ---- Solving --------------------------------------------------------------------------------- */

static void solve(contact *c)
{
    double vx, vy, before = c->normal;
    velocity_at(c, &vx, &vy);
    double missing = c->part - (vx * c->nx + vy * c->ny);
    c->normal = skv_max(before + c->normal_mass * missing, 0);
    push(c, (c->normal - before) * c->nx, (c->normal - before) * c->ny);
    velocity_at(c, &vx, &vy);
    double friction = (double)c->a->friction;
    if (c->b)
        friction = sqrt(friction * (double)c->b->friction);
    double most = friction * c->normal, slip = vy * c->nx - vx * c->ny;
    before = c->along;
    c->along = skv_min(skv_max(before - c->along_mass * slip, -most), most);
    push(c, -(c->along - before) * c->ny, (c->along - before) * c->nx);
}

static void find_all(skv_world *world, double dt)
{
    skv_bodies *bodies = world->bodies;
    contacts *all = &bodies->contacts;
    all->count = 0;
    for (int i = 0; i < bodies->count; i++) {
        meet_terrain(all, world, &bodies->body[i], dt);
        for (int k = 0; k < bodies->count; k++)
            if (k != i)
                meet_body(all, &bodies->solids.solid[k], &bodies->body[i], &bodies->body[k], dt);
    }
}

void skv_bodies_solve_contacts(skv_world *world, double dt, bool weighs)
{
    skv_bodies *bodies = world->bodies;
    contacts *all = &bodies->contacts;
    do
        find_all(world, dt);
    while (skv_bodies_wake_touched(all));
    untangle_all(world);
    for (int k = 0; k < all->count; k++)
        prepare(&all->list[k], dt);
    if (weighs)
        begin_warm(bodies, dt);
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < all->count; k++)
            solve(&all->list[k]);
    if (weighs)
        keep(world, dt);
}
