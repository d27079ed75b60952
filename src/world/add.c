/* Adding single particles, and many at once.
 *
 * Invariant: what is added lies in the free region, or at most a smoothing radius beyond an open
 * side: there the world ends, and what has gone farther is taken out.
 */
#include "world/add.h"

#include "base/assert.h"
#include "world/bodies/bodies.h"

#include <math.h>

/* Shares of the free area that particles at rest may take before the host is told. */
#define MOST_FULL    1.1
#define FULL         1.0 /* by emitters ... */
#define FULL_NO_MORE 0.9 /* ... who are told again once it was less */

skv_result skv_world_make_room(skv_world *world, int more, skv_error *error)
{
    if (more > SKV_MAX_PARTICLES - world->state.count)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "%d particles more are too many; at most %d are allowed", more,
                        SKV_MAX_PARTICLES);
    if ((uint32_t)more > SKV_NO_PARTICLE - world->next_id)
        return skv_fail(
            error, SKV_ERROR_LIMIT,
            "this world has named 4294967295 particles and has no id left; make another");
    return skv_world_reserve(world, world->state.count + more, error);
}

skv_result skv_world_find_taken(const skv_world *world, const skv_region *box, int more,
                                float spacings, skv_occupancy *taken, skv_error *error)
{
    float reach = spacings * world->fluid.spacing, around = 2 * reach;
    skv_region near = {.x0 = -INFINITY, .y0 = -INFINITY, .x1 = INFINITY, .y1 = INFINITY};
    if (box)
        near = (skv_region){.x0 = box->x0 - around,
                            .y0 = box->y0 - around,
                            .x1 = box->x1 + around,
                            .y1 = box->y1 + around};
    near.radius = -1;
    skv_result result = skv_occupancy_create(taken, &world->state, &near, more, reach, error);
    if (skv_boundary_has_thin(&world->boundary))
        taken->boundary = &world->boundary;
    return result;
}

/* Share of the free area that so many particles take at rest. */
static double share_of(const skv_world *world, int count)
{
    double s = (double)world->fluid.spacing;
    return count * s * s / skv_terrain_free_area(world->terrain);
}

static void say_if_overfull(skv_world *world, int added)
{
    int count = world->state.count;
    double now = share_of(world, count), before = share_of(world, count - added);
    if (now > MOST_FULL && before <= MOST_FULL && skv_terrain_open_sides(world->terrain) == 0)
        skv_world_say(world,
                      "the fluid is overfull: %d particles at rest take %.2f of the free area; it "
                      "may boil; remove some or use a larger world",
                      count, now);
}

void skv_world_say_if_full(skv_world *world)
{
    double now = share_of(world, world->state.count);
    if (now < FULL_NO_MORE)
        world->told_full = false;
    if (!(now > FULL) || world->told_full || skv_terrain_open_sides(world->terrain) != 0)
        return;
    world->told_full = true;
    skv_world_say(world,
                  "the world is full: %d particles at rest take all of the free area, and emitters "
                  "press them closer; close them or open a drain",
                  world->state.count);
}

void skv_world_note_added(skv_world *world, int added)
{
    skv_load_add(world, added);
    say_if_overfull(world, added);
}

/* True if a place is beyond a closed side, round a corner, or too far beyond an open side. */
static bool is_outside(const skv_world *world, float x, float y)
{
    float width = skv_terrain_width(world->terrain), height = skv_terrain_height(world->terrain);
    bool beside = x < 0 || x > width, beyond = y < 0 || y > height;
    if (!beside && !beyond)
        return false;
    if (beside && beyond)
        return true;
    float h = world->h;
    unsigned side = x < 0       ? SKV_SIDE_LEFT
                    : x > width ? SKV_SIDE_RIGHT
                    : y < 0     ? SKV_SIDE_BOTTOM
                                : SKV_SIDE_TOP;
    return !(skv_terrain_open_sides(world->terrain) & side) || x < -h || x > width + h || y < -h ||
           y > height + h;
}

bool skv_world_is_blocked(const skv_world *world, float x, float y)
{
    return is_outside(world, x, y) || skv_terrain_distance(world->terrain, x, y) <= 0 ||
           skv_bodies_distance(world, x, y) <= 0;
}

static bool is_sane(float x, float y, float vx, float vy)
{
    return skv_within((double)x, -100, 100) && skv_within((double)y, -100, 100) &&
           skv_within((double)vx, -1000, 1000) && skv_within((double)vy, -1000, 1000);
}

int skv_world_index(const skv_world *world, skv_particle_id id)
{
    SKV_ASSERT_OR(world, -1);
    const skv_state *s = &world->state;
    int low = 0, high = s->count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (s->id[middle] < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < s->count && s->id[low] == id ? low : -1;
}

/* Adds those that find room; memory for all has been reserved. */
static skv_placed add_where_free(skv_world *world, const skv_particle *particles, int count,
                                 skv_occupancy *taken, skv_particle_id *ids)
{
    skv_placed placed = {.first = SKV_NO_PARTICLE};
    for (int i = 0; i < count; i++) {
        const skv_particle *p = &particles[i];
        if (ids)
            ids[i] = SKV_NO_PARTICLE;
        if (skv_world_is_blocked(world, p->x, p->y)) {
            placed.blocked++;
        } else if (skv_is_occupied(taken, p->x, p->y)) {
            placed.occupied++;
        } else {
            if (placed.added++ == 0)
                placed.first = world->next_id;
            if (ids)
                ids[i] = world->next_id;
            skv_occupy(taken, p->x, p->y);
            skv_world_append(world, p->x, p->y, p->vx, p->vy, 0, 0);
        }
    }
    return placed;
}

skv_result skv_world_add_particles(skv_world *world, const skv_particle *particles, int count,
                                   skv_particle_id *ids, skv_placed *placed, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && count >= 0 && (particles || count == 0),
                  SKV_ERROR_VALUE);
    for (int i = 0; i < count; i++)
        if (!is_sane(particles[i].x, particles[i].y, particles[i].vx, particles[i].vy))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "particle %d: position or velocity is not finite or beyond 100 m, "
                            "1000 m/s",
                            i);
    skv_result result = skv_world_make_room(world, count, error);
    skv_occupancy taken = {0};
    if (result == SKV_OK)
        result = skv_world_find_taken(world, NULL, count, SKV_LEAST_SPACING, &taken, error);
    if (result != SKV_OK)
        return result;
    skv_placed all = add_where_free(world, particles, count, &taken, ids);
    skv_occupancy_destroy(&taken);
    if (placed)
        *placed = all;
    skv_world_note_added(world, all.added);
    return SKV_OK;
}

skv_result skv_world_add_particle(skv_world *world, float x, float y, float vx, float vy,
                                  skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world), SKV_ERROR_VALUE);
    if (!is_sane(x, y, vx, vy))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "particle: position or velocity is not finite or beyond 100 m, 1000 m/s");
    if (skv_world_is_blocked(world, x, y))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "particle: (%g, %g) is in solid or outside the world; choose a free place",
                        (double)x, (double)y);
    skv_result result = skv_world_make_room(world, 1, error);
    if (result != SKV_OK)
        return result;
    skv_world_append(world, x, y, vx, vy, 0, 0);
    skv_world_note_added(world, 1);
    return SKV_OK;
}
