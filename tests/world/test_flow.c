/* Emitters and drains: the rates are right, freely and under water; every particle that comes or
 * goes is an event and is counted; what is full takes no more; and the future is one. */
#include "base/fields.h"
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

/* A tank of 1.6 x 0.9 m with fluid up to a level. */
static skv_world *make_world(skv_solver_kind solver, skv_law law, float spacing, float level,
                             unsigned open_sides, int threads)
{
    skv_world_def def = fixture_def(law, solver, 0, spacing, threads);
    skv_terrain_def tank = skv_default_terrain_def();
    tank.open_sides = open_sides;
    skv_world *world;
    assert_int_equal(skv_terrain_create(&tank, &def.terrain, NULL), SKV_OK);
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    if (level > 0)
        fixture_fill(world, 0, 0, 1.6f, level);
    return world;
}

static void open_tap(skv_world *world, skv_emitter emitter)
{
    skv_error error;
    if (skv_world_set_emitters(world, &emitter, 1, &error) != SKV_OK)
        fail_msg("%s", error.text);
}

static void open_drain(skv_world *world, skv_area area, float rate)
{
    skv_drain drain = {area, rate};
    assert_int_equal(skv_world_set_drains(world, &drain, 1, NULL), SKV_OK);
}

/* Nothing is blocked, and the area that has come is width * speed * time but for less than a row.
 */
static void expect_rate(skv_world *world, skv_emitter e, float seconds)
{
    open_tap(world, e);
    fixture_run(world, (int)(60 * seconds));
    double s = (double)skv_world_spacing(world), speed = sqrt((double)(e.vx * e.vx + e.vy * e.vy));
    double nominal = (double)e.width * speed * (double)seconds;
    skv_flow flow = skv_world_flow(world);
    double error = ((double)flow.emitted * s * s - nominal) / nominal;
    if (flow.blocked != 0 || fabs(error) > 0.02)
        fail_msg("at (%g, %g), %g m/s, s = %g: blocked %d, rate off by %g", (double)e.x,
                 (double)e.y, speed, s, (int)flow.blocked, error);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

static void a_tap_gives_what_it_says(void **unused)
{
    (void)unused;
    const float spacings[] = {0.02f, 0.012f}, speeds[] = {0.5f, 1, 3};
    for (int k = 0; k < (long_tests() ? 2 : 1); k++) {
        for (int v = 0; v < 3; v++) {
            float speed = speeds[v], s = spacings[k], seconds = v == 0 ? 3 : 1.5f;
            skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, s, 0, 0, 1);
            expect_rate(world, (skv_emitter){0.8f, 0.8f, 0, -speed, 0.1f, 0, 0}, seconds);
            world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, s, 0, 0, 1);
            expect_rate(world, (skv_emitter){0, 0.5f, speed, 0, 0.07f, 0, 0}, seconds);
            world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, s, 0.4f, 0, 1);
            expect_rate(world, (skv_emitter){0.5f, 0.2f, 0.6f * speed, -0.8f * speed, 0.05f, 0, 0},
                        seconds);
            world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, s, 0.4f, 0, 1);
            expect_rate(world, (skv_emitter){0.8f, 0, 0, speed, 0.083f, 0, 0}, seconds);
        }
    }
    skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CLAVET, 0.02f, 0.4f, 0, 1);
    expect_rate(world, (skv_emitter){0.5f, 0.2f, 1, 0, 0.1f, 0, 0}, 1.5f);
    world = make_world(SKV_SOLVER_REFERENCE, SKV_LAW_CALIBRATED, 0.03f, 0.4f, 0, 1);
    expect_rate(world, (skv_emitter){0.5f, 0.2f, 1, 0, 0.1f, 0, 0}, 1.5f);
}

/* The jet keeps the speed, and so much fluid in a length as the width gives it. */
static void a_free_jet_has_the_tap_s_speed(void **unused)
{
    (void)unused;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.0155f, 1);
    def.gravity_y = 0;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    open_tap(world, (skv_emitter){0.1f, 0.45f, 1, 0, 0.1f, 0, 0});
    fixture_run(world, 60);
    skv_particles p = skv_world_particles(world);
    /* Behind its tip, which the surface tension draws back. */
    double speed = 0;
    int count = 0;
    for (int i = 0; i < p.count; i++) {
        if (p.x[i] < 0.2f || p.x[i] > 0.4f)
            continue;
        speed += (double)p.vx[i];
        count++;
    }
    assert_near(speed / count, 1, 0.05);
    assert_near(count * 0.0155 * 0.0155, 0.2 * 0.1, 0.001);
    skv_area jet = skv_box(0, 0.45f - 0.08f, 1.6f, 0.45f + 0.08f);
    assert_true(skv_world_query(world, &jet, NULL, 0) > p.count * 95 / 100);
    skv_world_destroy(world);
}

/* Rows lie as in the rest lattice, each shifted by half a column against the one before. */
static void rows_alternate(void **unused)
{
    (void)unused;
    enum { COLUMNS = 5 };
    skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, 0.02f, 0, 0, 1);
    open_tap(world, (skv_emitter){0.8f, 0.8f, 0, -3, 0.1f, 0, 0});
    fixture_run(world, 2);
    skv_particles p = skv_world_particles(world);
    assert_true(p.count >= 3 * COLUMNS);
    for (int i = p.count - 2 * COLUMNS; i < p.count - COLUMNS; i++)
        assert_near(fabs((double)p.x[i] - (double)p.x[i + COLUMNS]), 0.01, 0.003);
    skv_world_destroy(world);
}

/* Of a line that is half in a wall the other half emits. */
static void taken_places_stay_empty(void **unused)
{
    (void)unused;
    for (int up = -1; up <= 1; up += 2) {
        skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, 0.02f, 0, 0, 1);
        open_tap(world, (skv_emitter){0, 0.4f, 0, 2 * (float)up, 0.2f, 0, 0});
        fixture_run(world, 2);
        skv_flow flow = skv_world_flow(world);
        assert_true(flow.emitted >= 8 && flow.blocked >= 8);
        skv_particles p = skv_world_particles(world);
        for (int i = 0; i < p.count; i++)
            assert_true(p.x[i] > 0.0045f && p.x[i] < 0.11f); /* contact is at 0.004 */
        skv_world_destroy(world);
    }
}

static void a_drain_takes_what_it_may(void **unused)
{
    (void)unused;
    const float spacings[] = {0.02f, 0.012f};
    for (int k = 0; k < 2; k++) {
        skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, spacings[k], 0.4f, 0, 1);
        double s = (double)skv_world_spacing(world);
        open_drain(world, skv_box(0.7f, 0, 0.9f, 0.1f), 0.05f);
        fixture_run(world, 120);
        assert_near((double)skv_world_flow(world).drained * s * s / 0.1, 1, 0.02);
        open_drain(world, skv_circle(0.8f, 0.1f, 0.1f), 0);
        fixture_run(world, 1);
        skv_area inner = skv_circle(0.8f, 0.1f, 0.07f);
        assert_int_equal(skv_world_query(world, &inner, NULL, 0), 0);
        assert_int_equal(skv_world_set_drains(world, NULL, 0, NULL), SKV_OK);
        int left = skv_world_particle_count(world);
        fixture_run(world, 10);
        assert_int_equal(skv_world_particle_count(world), left);
        skv_world_destroy(world);
    }
}

static void every_particle_is_accounted_for(void **unused)
{
    (void)unused;
    const skv_solver_kind solvers[] = {SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE};
    for (int k = 0; k < 2; k++) {
        skv_world *world =
            make_world(solvers[k], SKV_LAW_CALIBRATED, 0.03f, 0.2f, SKV_SIDE_RIGHT, 1);
        const skv_emitter taps[] = {{0.3f, 0.6f, 1, 0, 0.1f, 0, 0}, {0.8f, 0.1f, 0, 1, 0.1f, 0, 0}};
        const skv_drain drains[] = {{skv_box(0, 0, 0.2f, 0.05f), 0.1f},
                                    {skv_circle(1, 0.05f, 0.05f), 0}};
        assert_int_equal(skv_world_set_emitters(world, taps, 2, NULL), SKV_OK);
        assert_int_equal(skv_world_set_drains(world, drains, 2, NULL), SKV_OK);
        int64_t seen[SKV_EVENT_REPLACED + 1] = {0}, sources[2] = {0}, taken[2] = {0};
        int before = skv_world_particle_count(world);
        for (int f = 0; f < 60; f++) {
            int count;
            fixture_run(world, 1);
            const skv_event *events = skv_world_events(world, &count);
            for (int e = 0; e < count; e++) {
                seen[events[e].kind]++;
                bool flows =
                    events[e].kind == SKV_EVENT_EMITTED || events[e].kind == SKV_EVENT_DRAINED;
                assert_int_equal(events[e].source != 0, flows);
                int place = flows ? skv_world_acting_index(world, events[e].source, NULL) : 0;
                if (events[e].kind == SKV_EVENT_EMITTED)
                    sources[place]++;
                if (events[e].kind == SKV_EVENT_DRAINED)
                    taken[place]++;
            }
        }
        skv_flow flow = skv_world_flow(world);
        assert_int_equal(skv_world_particle_count(world) - before,
                         flow.emitted - flow.drained - flow.left);
        assert_int_equal(seen[SKV_EVENT_EMITTED], flow.emitted);
        assert_int_equal(seen[SKV_EVENT_DRAINED], flow.drained);
        assert_int_equal(seen[SKV_EVENT_LEFT], flow.left);
        assert_true(sources[0] > 50 && sources[1] > 50);
        assert_true(taken[0] > 20 && taken[1] > 20 && flow.left > 20);
        skv_world_destroy(world);
    }
}

static void a_full_world_stops_or_replaces(void **unused)
{
    (void)unused;
    for (int replaces = 0; replaces < 2; replaces++) {
        skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, 0.02f, 0.1f, 0, 1);
        int before = skv_world_particle_count(world);
        char limit[16];
        skv_format(limit, sizeof limit, "%d", before + 100);
        assert_int_equal(skv_world_set(world, "emission.limit", limit, NULL), SKV_OK);
        assert_int_equal(
            skv_world_set(world, "emission.replaces", replaces ? "true" : "false", NULL), SKV_OK);
        open_tap(world, (skv_emitter){0.8f, 0.7f, 0, -1, 0.1f, 0, 0});
        fixture_run(world, 120);
        skv_flow flow = skv_world_flow(world);
        assert_int_equal(skv_world_particle_count(world), before + 100);
        int id = (int)skv_world_particles(world).id[0];
        if (replaces) {
            assert_int_equal(id, flow.replaced);
            assert_int_equal(flow.emitted, flow.replaced + 100);
            assert_near((double)flow.emitted * 0.02 * 0.02, 0.2, 0.004);
            assert_int_equal(flow.blocked, 0);
        } else {
            assert_int_equal(flow.emitted, 100);
            assert_true(flow.blocked > 300 && id == 0 && flow.replaced == 0);
            int count, blocked = 0;
            fixture_run(world, 5);
            const skv_event *events = skv_world_events(world, &count);
            for (int e = 0; e < count; e++)
                blocked += events[e].kind == SKV_EVENT_BLOCKED &&
                           events[e].particle == SKV_NO_PARTICLE &&
                           events[e].source == skv_world_acting_id(world, SKV_ACTING_EMITTER, 0);
            assert_true(blocked > 0);
            /* As soon as there is room it goes on. */
            assert_int_equal(skv_world_set(world, "emission.limit", "20000", NULL), SKV_OK);
            fixture_run(world, 30);
            assert_true(skv_world_particle_count(world) > before + 200);
        }
        skv_world_destroy(world);
    }
}

static void note_full(const char *text, void *user)
{
    *(int *)user += strncmp(text, "the world is full", 17) == 0;
}

/* Into a closed tank goes no more than it holds, and it is said once that it is full. */
static void a_full_tank_takes_no_more(void **unused)
{
    (void)unused;
    skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, 0.02f, 0.8f, 0, 1);
    int said = 0;
    skv_world_set_log(world, note_full, &said);
    open_tap(world, (skv_emitter){0.8f, 0.3f, 0, 1, 0.1f, 0, 0});
    fixture_run(world, 240);
    assert_int_equal(skv_world_set_emitters(world, NULL, 0, NULL), SKV_OK);
    fixture_run(world, 60);
    skv_stats stats = skv_world_stats(world);
    double share = stats.particles * 0.02 * 0.02 / (1.6 * 0.9);
    assert_true(skv_world_flow(world).blocked > 100);
    assert_int_equal(said, share > 1);
    if (share < 0.97 || share > 1.1 || stats.rms_speed > 0.1 || stats.escaped)
        fail_msg("full to %g, %g m/s, %d escaped", share, stats.rms_speed, stats.escaped);
    skv_world_destroy(world);
}

static void the_future_is_the_same_for_threads_and_snapshots(void **unused)
{
    (void)unused;
    const skv_emitter taps[] = {{0.3f, 0.6f, 1, -0.5f, 0.1f, 0, 0}, {0.8f, 0.1f, 0, 1, 0.1f, 0, 0}};
    const skv_drain drain = {skv_circle(1.2f, 0.1f, 0.1f), 0.07f};
    const skv_solver_kind solvers[] = {SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE};
    for (int k = 0; k < 2; k++) {
        uint64_t hash[2];
        for (int t = 0; t < 2; t++) {
            skv_world *other, *world = make_world(solvers[k], SKV_LAW_CALIBRATED, 0.03f, 0.2f,
                                                  SKV_SIDE_LEFT, t ? 3 : 1);
            assert_int_equal(skv_world_set_emitters(world, taps, 2, NULL), SKV_OK);
            assert_int_equal(skv_world_set_drains(world, &drain, 1, NULL), SKV_OK);
            fixture_run(world, 25);
            assert_int_equal(skv_world_copy(world, fixture_host(2), &other, NULL), SKV_OK);
            int count;
            assert_true(skv_world_emitters(other, &count)[1].vy == 1 && count == 2);
            assert_true(skv_world_drains(other, &count)->rate == 0.07f && count == 1);
            fixture_run(world, 25);
            /* To set what is there already changes nothing. */
            assert_int_equal(skv_world_set_emitters(other, taps, 2, NULL), SKV_OK);
            fixture_run(other, 25);
            hash[t] = skv_world_hash(world);
            assert_int_equal(skv_world_hash(other), hash[t]);
            assert_int_equal(skv_world_flow(other).emitted, skv_world_flow(world).emitted);
            assert_true(skv_world_flow(other).left > 0 || k);
            skv_world_destroy(world);
            skv_world_destroy(other);
        }
        assert_int_equal(hash[0], hash[1]);
    }
}

static void a_tap_keeps_its_surroundings_awake(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    /* A closed one disturbs nobody; a slow one wakes what is near, and what sleeps gives way. At
     * one of 20 heights a particle lies in the way by chance. */
    const float height = 0.16f;
    open_tap(world, (skv_emitter){0.4f, height, 0, 0, 0.1f, 0, 0});
    fixture_run(world, 60);
    assert_int_equal(skv_world_awake_count(world), 0);
    open_tap(world, (skv_emitter){0.4f, height, 0.2f, 0, 0.1f, 0, 0});
    fixture_run(world, 300);
    assert_int_equal(skv_world_flow(world).blocked, 0);
    assert_near((double)skv_world_flow(world).emitted * 0.02 * 0.02, 0.1, 0.002);
    assert_true(skv_world_awake_count(world) > 100);
    /* A drain wakes what lies beside it, and sleepers that it takes are gone. */
    assert_int_equal(skv_world_set_emitters(world, NULL, 0, NULL), SKV_OK);
    for (int f = 0; f < 7200 && skv_world_awake_count(world) > 0; f++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    open_drain(world, skv_circle(1.2f, 0.1f, 0.04f), 0);
    fixture_run(world, 1);
    assert_true(skv_world_flow(world).drained > 5);
    assert_true(skv_world_awake_count(world) > 30);
    skv_world_destroy(world);
}

static void nonsense_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_world(SKV_SOLVER_FAST, SKV_LAW_CALIBRATED, 0.02f, 0.1f, 0, 1);
    const skv_emitter bad[] = {{NAN, 0, 1, 0, 0.1f, 0, 0},
                               {0, 0, 21, 0, 0.1f, 0, 0},
                               {0, 0, 1, 0, 0, 0, 0},
                               {0, 0, 0, INFINITY, 1, 0, 0}};
    for (int i = 0; i < 4; i++) {
        skv_error error = {0};
        assert_int_equal(skv_world_set_emitters(world, &bad[i], 1, &error), SKV_ERROR_VALUE);
        assert_string_equal(error.text, "emitter 0: a place within 100 m, velocities of +-20 m/s "
                                        "and a width of 0.0001..100 m are allowed");
    }
    skv_emitter wide = {0, 0, 1, 0, 20.000002f, 0, 0};
    skv_error error = {0};
    assert_int_equal(skv_world_set_emitters(world, &wide, 1, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "emitter 0: its mouth is 20.000002 m wide; allowed are 1000 spacings, "
                        "20 m, so make it narrower or choose fewer particles");
    const skv_drain drains[] = {{skv_circle(0, 0, -1), 0}, {skv_box(0, 0, 1, 1), -1}};
    for (int i = 0; i < 2; i++)
        assert_int_equal(skv_world_set_drains(world, &drains[i], 1, NULL), SKV_ERROR_VALUE);
    const skv_emitter many[SKV_MAX_EMITTERS + 1] = {{0, 0, 1, 0, 1, 0, 0}};
    assert_int_equal(skv_world_set_emitters(world, many, SKV_MAX_EMITTERS + 1, NULL),
                     SKV_ERROR_LIMIT);
    const skv_drain holes[SKV_MAX_DRAINS + 1] = {{skv_box(0, 0, 1, 1), 0}};
    assert_int_equal(skv_world_set_drains(world, holes, SKV_MAX_DRAINS + 1, NULL), SKV_ERROR_LIMIT);
    /* A tap inside a wall gives nothing, and says so. */
    open_tap(world, (skv_emitter){-0.2f, 0.5f, 1, 0, 0.1f, 0, 0});
    int before = skv_world_particle_count(world);
    fixture_run(world, 30);
    assert_int_equal(skv_world_particle_count(world), before);
    assert_true(skv_world_flow(world).blocked > 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tap_gives_what_it_says),
        cmocka_unit_test(a_free_jet_has_the_tap_s_speed),
        cmocka_unit_test(rows_alternate),
        cmocka_unit_test(taken_places_stay_empty),
        cmocka_unit_test(a_drain_takes_what_it_may),
        cmocka_unit_test(every_particle_is_accounted_for),
        cmocka_unit_test(a_full_world_stops_or_replaces),
        cmocka_unit_test(a_full_tank_takes_no_more),
        cmocka_unit_test(the_future_is_the_same_for_threads_and_snapshots),
        cmocka_unit_test(a_tap_keeps_its_surroundings_awake),
        cmocka_unit_test(nonsense_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
