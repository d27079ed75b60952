/* What hosts need: particles added by the thousand, named and removed; views that say when they are
 * stale; events, a callback before substeps, a log. */
#include "support/failing_memory.h"
#include "support/fixture.h"
#include "support/host.h"
#include "support/misuse.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static skv_world *open_tank(float spacing, unsigned sides, bool sleep)
{
    skv_terrain_def tank = skv_default_terrain_def();
    tank.open_sides = sides;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = spacing;
    def.sleep = sleep;
    def.threads = 1;
    skv_world *world;
    assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

static void many_are_added_where_there_is_room(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    assert_int_equal(fixture_fill(world, 0, 0, 1.6f, 0.2f) > 700, 1);
    int before = skv_world_particle_count(world);
    /* A dense block: into the fluid, into the wall on the left, and above. */
    enum { COLUMNS = 50, ROWS = 32, ALL = COLUMNS * ROWS };
    static skv_particle particles[ALL];
    static skv_particle_id ids[ALL];
    for (int i = 0; i < ALL; i++)
        particles[i] = (skv_particle){-0.1f + 0.009f * (float)(i % COLUMNS),
                                      0.1f + 0.009f * (float)(i / COLUMNS), 0.25f, 0};
    skv_placed placed;
    assert_int_equal(skv_world_add_particles(world, particles, ALL, ids, &placed, NULL), SKV_OK);
    assert_int_equal(placed.added + placed.occupied + placed.blocked, ALL);
    assert_int_equal(placed.blocked, 12 * ROWS);
    assert_true(placed.added > 150 && placed.occupied > 500);
    assert_int_equal(placed.first, before);
    int named = 0;
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < ALL; i++) {
        if (ids[i] == SKV_NO_PARTICLE)
            continue;
        assert_int_equal(ids[i], before + named++);
        int at = skv_world_index(world, ids[i]);
        assert_true(p.x[at] == particles[i].x && p.y[at] == particles[i].y && p.vx[at] == 0.25f);
    }
    assert_int_equal(named, placed.added);
    for (int i = 0; i < p.count; i++)
        for (int j = before > i + 1 ? before : i + 1; j < p.count; j++)
            assert_true(hypotf(p.x[i] - p.x[j], p.y[i] - p.y[j]) > 0.7f * 0.02f - 1e-7f);
    /* They did so at 29 m/s when they were taken as they came. */
    fixture_run(world, 10);
    assert_true(skv_world_stats(world).max_speed < 3);
    skv_world_destroy(world);
}

static void adding_many_is_all_or_nothing(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.03f, 1);
    int before = skv_world_particle_count(world);
    static skv_particle many[3000];
    for (int i = 0; i < 3000; i++)
        many[i] =
            (skv_particle){0.5f + 0.05f * (float)(i % 20), 0.05f + 0.005f * (float)(i / 20), 0, 0};
    skv_error error;
    many[2999].vx = NAN;
    assert_int_equal(skv_world_add_particles(world, many, 3000, NULL, NULL, &error),
                     SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "particle 2999"));
    many[2999].vx = 0;
    skv_result result = SKV_ERROR_MEMORY;
    int failures = 0;
    for (; result != SKV_OK; failures++) {
        assert_int_equal(skv_world_particle_count(world), before);
        failing_memory memory;
        failing_memory_start(&memory, failures);
        result = skv_world_add_particles(world, many, 3000, NULL, NULL, NULL);
        failing_memory_stop();
    }
    assert_true(failures > 2);
    assert_true(skv_world_particle_count(world) > before + 300);
    skv_world_destroy(world);
}

static void ids_outlive_removal(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    int all = skv_world_particle_count(world), removed;
    uint32_t revision = skv_world_revision(world);
    skv_particles old = skv_world_particles(world);
    float x7 = old.x[7];
    fixture_run(world, 3);
    assert_int_equal(skv_world_revision(world), revision);
    assert_ptr_equal(skv_world_particles(world).x, old.x);
    x7 = old.x[7];
    const skv_particle_id gone[] = {5, 3, 5, 0, 4000000, SKV_NO_PARTICLE};
    assert_int_equal(skv_world_remove(world, gone, 6, &removed, NULL), SKV_OK);
    assert_int_equal(removed, 3);
    assert_int_equal(skv_world_particle_count(world), all - 3);
    assert_true(skv_world_revision(world) != revision);
    assert_int_equal(skv_world_index(world, 5), -1);
    assert_int_equal(skv_world_index(world, 7), 4);
    assert_int_equal(skv_world_index(world, SKV_NO_PARTICLE), -1);
    assert_true(skv_world_particles(world).x[4] == x7);
    assert_int_equal(skv_world_remove(world, gone, 6, &removed, NULL), SKV_OK);
    assert_int_equal(removed, 0);
    /* The last is removed; its id isn't given again. */
    skv_particle_id last = (skv_particle_id)all - 1;
    assert_int_equal(skv_world_remove(world, &last, 1, NULL, NULL), SKV_OK);
    revision = skv_world_revision(world);
    assert_int_equal(skv_world_add_particle(world, 1.2f, 0.5f, 0, 0, NULL), SKV_OK);
    assert_true(skv_world_revision(world) != revision);
    skv_particles p = skv_world_particles(world);
    assert_int_equal(p.id[p.count - 1], all);
    assert_int_equal(skv_world_index(world, (skv_particle_id)all), p.count - 1);
    skv_world_destroy(world);
}

static void an_area_is_emptied(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    const float triangle[] = {0, 0, 0.4f, 0, 0, 0.4f};
    skv_area areas[] = {skv_circle(0.2f, 0.5f, 0.1f), skv_box(0, 0, 0.1f, 0.1f),
                        skv_polygon(triangle, 3), skv_circle(0.2f, 0.2f, -1)};
    for (int a = 0; a < 4; a++) {
        int before = skv_world_particle_count(world), removed = -1;
        int there = skv_world_query(world, &areas[a], NULL, 0);
        assert_true(a == 3 ? there == 0 : there > 10);
        assert_int_equal(skv_world_remove_area(world, &areas[a], &removed, NULL), SKV_OK);
        assert_int_equal(removed, there);
        assert_int_equal(skv_world_particle_count(world), before - there);
        assert_int_equal(skv_world_query(world, &areas[a], NULL, 0), 0);
    }
    fixture_run(world, 5);
    skv_world_destroy(world);
}

/* The lists of neighbours follow: nothing is pushed by who is gone. */
static void who_is_removed_pushes_no_more(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, (skv_solver_kind)solver, 2, 0.03f, 1);
        skv_world *world = fixture_dam_of(&def);
        fixture_run(world, 20);
        skv_area box = skv_box(0, 0, 0.3f, 0.1f);
        assert_int_equal(skv_world_remove_area(world, &box, NULL, NULL), SKV_OK);
        fixture_run(world, 20);
        assert_int_equal(skv_world_stats(world).not_finite, 0);
        assert_true(skv_world_stats(world).max_speed < 6);
        skv_world_destroy(world);
    }
}

static void a_hole_in_sleeping_fluid_is_filled(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.03f, 1);
    skv_area hole = skv_box(0.3f, 0, 0.5f, 0.15f);
    double before = skv_world_stats(world).centre_y;
    int removed;
    assert_int_equal(skv_world_remove_area(world, &hole, &removed, NULL), SKV_OK);
    assert_true(removed > 20);
    /* What lay beside it is awake by now: a host that steps no sleeping world goes on. */
    assert_in_range(skv_world_awake_count(world), 50, skv_world_particle_count(world) - 50);
    fixture_run(world, 1);
    assert_in_range(skv_world_awake_count(world), 50, skv_world_particle_count(world) - 50);
    fixture_run(world, 60);
    assert_true(skv_world_query(world, &hole, NULL, 0) > removed * 9 / 10);
    assert_true(skv_world_stats(world).centre_y < before);
    skv_world_destroy(world);
}

static void set_velocities_wakes_what_it_changes(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.03f, 1);
    enum { SOME = 20 };
    float vx[SOME] = {0}, vy[SOME] = {0};
    assert_int_equal(skv_world_set_velocities(world, 5, SOME, vx, vy, NULL), SKV_OK);
    fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    vx[3] = 0.5f;
    assert_int_equal(skv_world_set_velocities(world, 5, SOME, vx, vy, NULL), SKV_OK);
    assert_true(skv_world_particles(world).vx[8] == 0.5f);
    fixture_run(world, 1);
    assert_in_range(skv_world_awake_count(world), 1, skv_world_particle_count(world) - 1);
    vy[19] = INFINITY;
    vx[3] = 0.75f;
    float kept = skv_world_particles(world).vx[8];
    skv_error error;
    assert_int_equal(skv_world_set_velocities(world, 5, SOME, vx, vy, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "particle 24"));
    assert_true(skv_world_particles(world).vx[8] == kept);
    vy[19] = 0;
    int count = skv_world_particle_count(world);
    assert_int_equal(skv_world_set_velocities(world, count - 3, SOME, vx, vy, &error),
                     SKV_ERROR_VALUE);
    assert_int_equal(skv_world_set_velocities(world, -1, 1, vx, vy, &error), SKV_ERROR_VALUE);
    skv_world_destroy(world);
}

/* What the callback has seen; it lifts fluid at 3 g in the left half. */
typedef struct lift {
    int calls;
    double time;
    bool acts;
} lift;

static void lift_left(skv_world *world, float dt, void *user)
{
    lift *l = user;
    l->calls++;
    l->time += (double)dt;
    if (!l->acts)
        return;
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++)
        if (p.x[i] < 0.4f)
            assert_int_equal(skv_world_add_velocity(world, i, 1, 0, 3 * 9.81f * dt, NULL), SKV_OK);
}

static void the_host_is_called_before_each_substep(void **unused)
{
    (void)unused;
    uint64_t hash[3];
    for (int threads = 1; threads <= 3; threads++) {
        skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.03f, threads);
        lift l = {.acts = true};
        skv_world_set_before_substep(world, lift_left, &l);
        fixture_run(world, 10);
        assert_int_equal(l.calls, 10 * skv_world_substeps_per_frame(world));
        assert_int_equal(l.calls, skv_world_substep_count(world));
        assert_near(l.time, 1.0 / 6, 1e-6);
        /* Free flight at 2 g upwards, but for what flows out below. */
        assert_true(skv_world_stats(world).momentum_y > 0);
        skv_world_set_before_substep(world, NULL, NULL);
        fixture_run(world, 1);
        assert_int_equal(l.calls, 10 * skv_world_substeps_per_frame(world));
        hash[threads - 1] = skv_world_hash(world);
        assert_true(hash[threads - 1] == hash[0]);
        skv_world_destroy(world);
    }
}

static void a_sleeping_world_still_calls(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.03f, 1);
    lift l = {0};
    skv_world_set_before_substep(world, lift_left, &l);
    fixture_run(world, 2);
    assert_int_equal(l.calls, 2 * skv_world_substeps_per_frame(world));
    assert_int_equal(skv_world_awake_count(world), 0);
    double before = skv_world_stats(world).centre_y;
    l.acts = true;
    fixture_run(world, 12);
    assert_true(skv_world_stats(world).centre_y > before + 0.005);
    skv_world_destroy(world);
}

/* Adds, removes, turns gravity and changes the fluid from within, and tries to step. */
static void meddle(skv_world *world, float dt, void *user)
{
    int *calls = user;
    float x = 0.5f + 0.01f * (float)(*calls % 100);
    assert_true(dt > 0);
    assert_int_equal(skv_world_add_particle(world, x, 0.85f, 0, 0, NULL), SKV_OK);
    if (*calls % 7 == 6) {
        skv_area spot = skv_circle(0.1f, 0.1f, 0.02f);
        assert_int_equal(skv_world_remove_area(world, &spot, NULL, NULL), SKV_OK);
    }
    assert_int_equal(skv_world_set_gravity(world, *calls % 2 ? 40.0f : 0, -9.81f, NULL), SKV_OK);
    assert_int_equal(skv_world_set(world, "fluid.wall_friction", *calls % 3 ? "0.1" : "0.05", NULL),
                     SKV_OK);
    assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_ERROR_VALUE);
    ++*calls;
}

static void the_callback_may_change_the_world(void **unused)
{
    (void)unused;
    misuse_begin(NULL);
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, (skv_solver_kind)solver, 0, 0.04f, 1);
        skv_world *world = fixture_dam_of(&def);
        int calls = 0, before = skv_world_particle_count(world);
        skv_world_set_before_substep(world, meddle, &calls);
        fixture_run(world, 12);
        assert_near(skv_world_time(world), 0.2, 1e-6);
        assert_int_equal(calls, skv_world_substep_count(world));
        int count;
        skv_world_events(world, &count);
        assert_in_range(skv_world_particle_count(world), before + calls / 2, before + calls);
        assert_int_equal(skv_world_stats(world).not_finite, 0);
        assert_int_equal(misuses, calls);
        misuses = 0;
        skv_world_destroy(world);
    }
    misuse_end(NULL);
}

static void a_step_tells_who_left(void **unused)
{
    (void)unused;
    skv_world *world = open_tank(0.03f, SKV_SIDE_RIGHT, true);
    int all = fixture_fill(world, 0, 0, 1.6f, 0.4f), gone = 0, count;
    static bool seen[5000];
    memset(seen, 0, sizeof seen);
    skv_world_events(world, &count);
    assert_int_equal(count, 0);
    for (int frame = 0; frame < 120; frame++) {
        int before = skv_world_particle_count(world);
        fixture_run(world, 1);
        const skv_event *events = skv_world_events(world, &count);
        assert_int_equal(count, before - skv_world_particle_count(world));
        for (int e = 0; e < count; e++) {
            assert_int_equal(events[e].kind, SKV_EVENT_LEFT);
            assert_false(seen[events[e].particle]);
            assert_int_equal(skv_world_index(world, events[e].particle), -1);
            seen[events[e].particle] = true;
        }
        gone += count;
        assert_true(skv_world_awake_count(world) <= skv_world_particle_count(world));
    }
    assert_true(gone > all / 3);
    assert_int_equal(gone, all - skv_world_particle_count(world));
    skv_world_destroy(world);
}

/* Out to the right, and then up past the closed top's end: gone as soon as it is round the corner.
 */
static void who_goes_round_a_corner_has_left(void **unused)
{
    (void)unused;
    const struct {
        unsigned open;
        float x, y, vx, vy;
    } ways[] = {
        {SKV_SIDE_RIGHT, 1.63f, 0.895f, 0, 1},
        {SKV_SIDE_LEFT, -0.03f, 0.005f, 0, -1},
        {SKV_SIDE_TOP, 0.005f, 0.93f, -1, 0},
        {SKV_SIDE_BOTTOM, 1.595f, -0.03f, 1, 0},
    };
    for (int i = 0; i < 4; i++) {
        skv_world *world = open_tank(0.03f, ways[i].open, false);
        assert_int_equal(skv_world_set_gravity(world, 0, 0, NULL), SKV_OK);
        assert_int_equal(
            skv_world_add_particle(world, ways[i].x, ways[i].y, ways[i].vx, ways[i].vy, NULL),
            SKV_OK);
        fixture_run(world, 1); /* 17 mm, of which 5 to the corner, and 90 were to h */
        assert_int_equal(skv_world_particle_count(world), 0);
        skv_world_destroy(world);
    }
}

static void removals_are_events_of_the_next_step(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.03f, 1);
    fixture_run(world, 1);
    const skv_particle_id first[] = {9, 2}, second = 4;
    int count;
    assert_int_equal(skv_world_remove(world, first, 2, NULL, NULL), SKV_OK);
    assert_int_equal(skv_world_remove(world, &second, 1, NULL, NULL), SKV_OK);
    fixture_run(world, 1);
    const skv_event *events = skv_world_events(world, &count);
    assert_int_equal(count, 3);
    assert_true(events[0].particle == 9 && events[1].particle == 2 && events[2].particle == 4);
    assert_int_equal(events[0].kind, SKV_EVENT_REMOVED);
    fixture_run(world, 1);
    skv_world_events(world, &count);
    assert_int_equal(count, 0);
    /* No memory for the events: nothing is removed. */
    int before = skv_world_particle_count(world);
    skv_area all = skv_box(-1, -1, 2, 2);
    failing_memory memory;
    failing_memory_start(&memory, 0);
    skv_result result = skv_world_remove_area(world, &all, NULL, NULL);
    failing_memory_stop();
    assert_int_equal(result, SKV_ERROR_MEMORY);
    assert_int_equal(skv_world_particle_count(world), before);
    assert_int_equal(skv_world_remove_area(world, &all, NULL, NULL), SKV_OK);
    assert_int_equal(skv_world_particle_count(world), 0);
    fixture_run(world, 2);
    skv_world_destroy(world);
}

static void a_warm_step_through_an_open_side_allocates_nothing(void **unused)
{
    (void)unused;
    failing_memory memory;
    failing_memory_start(&memory, -1);
    skv_world *world = open_tank(0.03f, SKV_SIDE_LEFT, false);
    fixture_fill(world, 0, 0, 1.6f, 0.4f);
    fixture_run(world, 10);
    int before = memory.calls;
    fixture_run(world, 60);
    assert_int_equal(memory.calls, before);
    skv_world_destroy(world);
    assert_int_equal(memory.live, 0);
    failing_memory_stop();
}

/* Two worlds with one terrain, stepped on two threads at the same time and one after the other. */
typedef struct pair {
    skv_world *world[2];
    atomic_int next;
} pair;

static void run_one(void *user)
{
    pair *p = user;
    fixture_run(p->world[atomic_fetch_add(&p->next, 1)], 40);
}

static void worlds_that_share_a_terrain_step_side_by_side(void **unused)
{
    (void)unused;
    skv_terrain_def tank = skv_default_terrain_def();
    skv_terrain *terrain;
    uint64_t hash[2];
    assert_int_equal(skv_terrain_create(&tank, &terrain, NULL), SKV_OK);
    for (int at_once = 0; at_once < 2; at_once++) {
        pair p = {.next = 0};
        for (int i = 0; i < 2; i++) {
            skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.03f, 1);
            def.terrain = skv_terrain_share(terrain);
            p.world[i] = fixture_dam_of(&def);
            assert_ptr_equal(skv_world_terrain(p.world[i]), terrain);
        }
        if (at_once) {
            host_run(2, run_one, &p);
        } else {
            run_one(&p);
            run_one(&p);
        }
        hash[at_once] = skv_world_hash(p.world[0]);
        assert_true(hash[at_once] == skv_world_hash(p.world[1]));
        skv_world_destroy(p.world[0]);
        skv_world_destroy(p.world[1]);
    }
    assert_true(hash[0] == hash[1]);
    skv_terrain_destroy(terrain);
}

/* Beside a closed side and above a closed top there is solid, whatever is open elsewhere. */
static void nothing_is_added_beyond_a_closed_side(void **unused)
{
    (void)unused;
    const float h = 3 * 0.03f, width = 1.6f, height = 0.9f;
    for (unsigned open = 0; open < 16; open++) {
        skv_world *world = open_tank(0.03f, open, false);
        const struct {
            unsigned needs;
            float x, y;
        } places[] = {
            {SKV_SIDE_LEFT, -0.5f * h, 0.4f},
            {SKV_SIDE_RIGHT, width + 0.5f * h, 0.4f},
            {SKV_SIDE_BOTTOM, 0.8f, -0.5f * h},
            {SKV_SIDE_TOP, 0.8f, height + 0.5f * h},
            {16, -0.5f * h, -0.5f * h},
            {16, -0.5f * h, height + 0.5f * h},
            {16, width + 0.5f * h, -0.5f * h},
            {16, width + 0.5f * h, height + 0.5f * h},
            {16, -2 * h, 0.4f},
            {16, 0.8f, height + 2 * h},
            {16, width + 50 * h, 0.4f},
            {16, 0.8f, -50 * h},
            {16, -50, 50},
            {16, 50, -50},
        };
        for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
            skv_error error;
            skv_result result =
                skv_world_add_particle(world, places[i].x, places[i].y, 0, 0, &error);
            assert_int_equal(result, open & places[i].needs ? SKV_OK : SKV_ERROR_VALUE);
        }
        /* None is taken for one that has left at once. */
        int count = skv_world_particle_count(world);
        fixture_run(world, 1);
        assert_int_equal(skv_world_particle_count(world), count);
        skv_world_destroy(world);
    }
}

typedef struct journal {
    int lines;
    char last[256];
} journal;

static void write_down(const char *text, void *user)
{
    journal *j = user;
    j->lines++;
    strncpy(j->last, text, sizeof j->last - 1);
    assert_null(strchr(text, '\n'));
}

static void a_world_says_what_is_worth_knowing(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.03f, 1);
    journal j = {0};
    skv_world_set_log(world, write_down, &j);
    int full = fixture_fill(world, 0, 0, 1.6f, 0.9f);
    assert_int_equal(j.lines, 0);
    assert_near(full * 0.03 * 0.03, skv_terrain_free_area(skv_world_terrain(world)), 0.1);
    /* Up to 1.1 of the free area it comes to rest, from 1.2 on it boils. */
    double share = 0;
    for (int i = 0; i < full / 5; i++) {
        assert_int_equal(
            skv_world_add_particle(world, 0.1f + 0.002f * (float)i, 0.405f, 0, 0, NULL), SKV_OK);
        share = skv_world_particle_count(world) * 0.03 * 0.03 /
                skv_terrain_free_area(skv_world_terrain(world));
        assert_int_equal(strstr(j.last, "overfull") != NULL, share > 1.1);
    }
    assert_true(share > 1.15);
    assert_int_equal(j.lines, 2);
    skv_world_set_log(world, NULL, NULL);
    skv_world_destroy(world);

    world = fixture_tank(SKV_LAW_CALIBRATED, 0.03f, 1);
    assert_null(skv_world_user(world));
    skv_world_set_user(world, &j);
    assert_ptr_equal(skv_world_user(world), &j);
    skv_world_set_log(world, write_down, &j);
    fixture_fill(world, 0, 0, 0.4f, 0.4f);
    fixture_fill(world, 0.6f, 0, 0.8f, 0.4f);
    assert_int_equal(j.lines, 3);
    assert_non_null(strstr(j.last, "capacity"));
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(many_are_added_where_there_is_room),
        cmocka_unit_test(adding_many_is_all_or_nothing),
        cmocka_unit_test(ids_outlive_removal),
        cmocka_unit_test(an_area_is_emptied),
        cmocka_unit_test(who_is_removed_pushes_no_more),
        cmocka_unit_test(a_hole_in_sleeping_fluid_is_filled),
        cmocka_unit_test(set_velocities_wakes_what_it_changes),
        cmocka_unit_test(the_host_is_called_before_each_substep),
        cmocka_unit_test(a_sleeping_world_still_calls),
        cmocka_unit_test(the_callback_may_change_the_world),
        cmocka_unit_test(a_step_tells_who_left),
        cmocka_unit_test(who_goes_round_a_corner_has_left),
        cmocka_unit_test(removals_are_events_of_the_next_step),
        cmocka_unit_test(a_warm_step_through_an_open_side_allocates_nothing),
        cmocka_unit_test(worlds_that_share_a_terrain_step_side_by_side),
        cmocka_unit_test(nothing_is_added_beyond_a_closed_side),
        cmocka_unit_test(a_world_says_what_is_worth_knowing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
