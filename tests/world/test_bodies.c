/* Rigid bodies: what they weigh in water and how deep they float, by Archimedes; that momentum goes
 * from one to the other; that they stay out of walls and of each other; the rows against the
 * reference; the same bits on any threads and instruction sets; and what hosts ask of them. */
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define SPACING 0.0155f
#define EARTH   9.81

static const skv_solver_kind solvers[] = {SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE};

/* A tank so wide and 0.8 m high, filled to a depth. */
static skv_world *make_tank(const skv_world_def *like, float width, float depth)
{
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = (int)(width / terrain.pixel_size + 0.5f);
    terrain.height = 320;
    skv_world_def def = *like;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    if (depth > 0)
        fixture_fill(world, 0, 0, width, depth);
    return world;
}

static skv_world *make_pool(skv_solver_kind solver, int substeps, float width, float depth)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, SPACING, 1);
    def.substeps = substeps;
    def.depth = depth;
    return make_tank(&def, width, depth);
}

static skv_body_def box(float width, float height, float x, float y, float density)
{
    skv_body_def def = skv_default_body_def();
    def.shape = skv_box(-width / 2, -height / 2, width / 2, height / 2);
    def.x = x;
    def.y = y;
    def.density = density;
    return def;
}

/* The mean force upwards over ... frames, against what the water weighs that the body displaces. */
static double lift(skv_world *world, skv_body_id id, int frames)
{
    double sum = 0;
    for (int f = 0; f < frames; f++) {
        fixture_run(world, 1);
        sum += (double)fixture_body(world, id).force_y;
    }
    return sum / frames / (1000 * EARTH * (double)fixture_body(world, id).area);
}

/* In the middle of a pool, turned or not, and so near to the floor that there is but a film below
 * it. */
static void water_lifts_what_is_held(void **unused)
{
    (void)unused;
    static const struct {
        skv_solver_kind solver;
        float y, angle, least, most;
    } cases[] = {{SKV_SOLVER_FAST, 0.2f, 0.5f, 1, 1.04f},
                 {SKV_SOLVER_FAST, 0.055f, 0, 0.9f, 1.1f},
                 {SKV_SOLVER_REFERENCE, 0.2f, 0, 1, 1.04f}}; /* in the long form */
    for (int k = 0; k < (long_tests() ? 3 : 2); k++) {
        skv_world *world = make_pool(cases[k].solver, 0, 0.6f, 0.4f);
        skv_body_def def = box(0.2f, 0.1f, 0.3f, cases[k].y, 500);
        def.angle = cases[k].angle;
        def.fixed = true;
        skv_body_id id = fixture_add_body(world, &def);
        assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
        fixture_run(world, 120);
        double share = lift(world, id, 60);
        assert_true(share > (double)cases[k].least && share < (double)cases[k].most);
        skv_body body = fixture_body(world, id);
        assert_near((double)body.y, (double)cases[k].y, 1e-7);
        assert_near((double)body.angle, (double)def.angle, 1e-7);
        skv_world_destroy(world);
    }
}

/* Mean height of a body, and how much it moves about it. */
static double height(skv_world *world, skv_body_id id, int frames, double *jitter)
{
    double sum = 0, squares = 0;
    for (int f = 0; f < frames; f++) {
        fixture_run(world, 1);
        skv_body body = fixture_body(world, id);
        sum += (double)body.y;
        squares += (double)(body.vx * body.vx + body.vy * body.vy);
    }
    *jitter = sqrt(squares / frames);
    return sum / frames;
}

/* So stiff that water is not compressed, its level follows from how much there is. */
static void check_draught(float density)
{
    const double width = 1.2, long_ = 0.3, high = 0.1;
    skv_world *world = make_pool(SKV_SOLVER_FAST, 12, (float)width, 0.2f);
    skv_body_def def = box((float)long_, (float)high, (float)width / 2, 0.21f, density);
    skv_body_id id = fixture_add_body(world, &def);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    fixture_run(world, 480);
    double jitter, bottom = height(world, id, 240, &jitter) - high / 2;
    double s = (double)SPACING, water = skv_world_particle_count(world) * s * s;
    double level = (water - long_ * bottom) / (width - long_);
    assert_near(level - bottom, high * (double)density / 1000, 0.001);
    assert_near((double)fixture_body(world, id).angle, 0, 0.02);
    assert_true(jitter < 0.02);
    skv_world_destroy(world);
}

static void bodies_float_as_deep_as_they_are_heavy(void **unused)
{
    (void)unused;
    check_draught(500);
    if (long_tests()) {
        check_draught(100);
        check_draught(900);
    }
}

static void momentum_of(const skv_world *world, double sum[3])
{
    skv_particles p = skv_world_particles(world);
    double s = (double)skv_world_spacing(world), mass = 1000 * s * s;
    sum[0] = sum[1] = sum[2] = 0;
    for (int i = 0; i < p.count; i++) {
        double vx = mass * (double)p.vx[i], vy = mass * (double)p.vy[i];
        sum[0] += vx;
        sum[1] += vy;
        sum[2] += (double)p.x[i] * vy - (double)p.y[i] * vx;
    }
    for (int k = 0; k < skv_world_body_count(world); k++) {
        skv_body b;
        assert_true(skv_world_body_at(world, k, &b));
        double vx = (double)b.mass * (double)b.vx, vy = (double)b.mass * (double)b.vy;
        sum[0] += vx;
        sum[1] += vy;
        sum[2] += (double)b.inertia * (double)b.spin + (double)b.x * vy - (double)b.y * vx;
    }
}

/* Two bodies hit each other in a drop without weight. Angular momentum is that of the drop about
 * the origin: pairs that lag keep a spinning drop's to a hundredth a second. */
static void momentum_stays(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        skv_world *world = fixture_blob(SKV_LAW_CALIBRATED, solvers[k], 0);
        skv_body_def def = box(0.08f, 0.05f, 0.78f, 0.44f, 300);
        def.vx = 0.5f;
        def.spin = 3;
        fixture_add_body(world, &def);
        def.x = 0.85f;
        def.y = 0.48f;
        def.vx = -0.3f;
        fixture_add_body(world, &def);
        double before[3], after[3];
        momentum_of(world, before);
        double scale = 300 * 0.08 * 0.05 * (0.5 + 0.3), turning = 0.08 * scale;
        fixture_run(world, k == 0 ? 300 : 60);
        momentum_of(world, after);
        assert_near(after[0], before[0], 1e-6 * scale);
        assert_near(after[1], before[1], 1e-6 * scale);
        assert_near(after[2], before[2], 0.01 * turning);
        skv_world_destroy(world);
    }
}

/* What is heavy sinks and rests on the floor, and others rest upon it. */
static void walls_and_bodies_hold_bodies(void **unused)
{
    (void)unused;
    skv_world *world = make_pool(SKV_SOLVER_FAST, 0, 0.6f, 0);
    skv_body_id stack[3];
    for (int k = 0; k < 3; k++) {
        skv_body_def def = box(0.1f, 0.1f, 0.3f, 0.055f + 0.105f * (float)k, 2000);
        stack[k] = fixture_add_body(world, &def);
    }
    skv_body_def ball = skv_default_body_def();
    ball.shape = skv_circle(0, 0, 0.04f);
    ball.x = 0.1f;
    ball.y = 0.5f;
    ball.vx = -20;
    ball.vy = -30;
    skv_body_id thrown = fixture_add_body(world, &ball);
    for (int f = 0; f < 180; f++) {
        fixture_run(world, 1);
        skv_body body = fixture_body(world, thrown);
        assert_true(body.x > 0.038f && body.x < 0.562f && body.y > 0.038f && body.y < 0.762f);
    }
    for (int k = 0; k < 3; k++) {
        skv_body body = fixture_body(world, stack[k]);
        assert_true(fabsf(body.y - (0.05f + 0.1f * (float)k)) < 0.002f * (float)(k + 1));
    }
    skv_world_destroy(world);
}

static void heavy_bodies_sink_and_rest(void **unused)
{
    (void)unused;
    skv_world *world = make_pool(SKV_SOLVER_FAST, 0, 0.6f, 0.3f);
    skv_body_def def = box(0.1f, 0.06f, 0.3f, 0.4f, 2500);
    skv_body_id id = fixture_add_body(world, &def);
    fixture_run(world, 240);
    skv_body body = fixture_body(world, id);
    assert_near((double)body.y, 0.03, 0.002);
    assert_near((double)body.vy, 0, 0.01);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

/* What is heavier than water sinks to the floor and lies there where it came down: fluid below it,
 * which the film stands for, holds it no second time. */
static void bodies_lie_on_the_floor(void **unused)
{
    (void)unused;
    static const struct {
        float spacing, width, height, density;
    } cases[] = {{SPACING, 0.2f, 0.1f, 1500}, {0.019f, 0.15f, 0.07f, 1900}};
    for (int k = 0; k < 2; k++) {
        skv_world_def def =
            fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, cases[k].spacing, 1);
        skv_world *world = make_tank(&def, 0.6f, 0.4f);
        skv_body_def body = box(cases[k].width, cases[k].height, 0.3f, 0.2f, cases[k].density);
        skv_body_id id = fixture_add_body(world, &body);
        assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
        fixture_run(world, 180);
        skv_body lies = fixture_body(world, id);
        fixture_run(world, 180);
        skv_body rests = fixture_body(world, id);
        assert_near((double)rests.y, (double)cases[k].height / 2, 0.002);
        assert_near((double)rests.angle, 0, 0.02);
        assert_near((double)rests.x, (double)lies.x, 0.001);
        skv_world_destroy(world);
    }
}

/* Wood and what hardly floats come off the floor, what is heavier stays. */
static void light_bodies_leave_the_floor(void **unused)
{
    (void)unused;
    static const struct {
        float density;
        int frames;
        float least, most;
    } cases[] = {{500, 60, 0.15f, 0.5f}, {900, 180, 0.2f, 0.5f}, {2000, 120, 0.04f, 0.055f}};
    for (int k = 0; k < 3; k++) {
        skv_world *world = make_pool(SKV_SOLVER_FAST, 0, 0.8f, 0.4f);
        skv_body_def def = box(0.2f, 0.1f, 0.4f, 0.051f, cases[k].density);
        skv_body_id id = fixture_add_body(world, &def);
        fixture_run(world, cases[k].frames);
        float y = fixture_body(world, id).y;
        assert_true(y > cases[k].least && y < cases[k].most);
        skv_world_destroy(world);
    }
}

/* A body near the floor and one in the middle, both of which move. */
static void put_two(skv_world *world)
{
    skv_body_def def = box(0.15f, 0.1f, 0.2f, 0.07f, 700);
    def.angle = 0.1f;
    def.vx = 0.4f;
    def.spin = -1;
    fixture_add_body(world, &def);
    def.shape = skv_circle(0, 0, 0.06f);
    def.x = 0.42f;
    def.y = 0.2f;
    def.vy = -0.5f;
    fixture_add_body(world, &def);
}

static void rows_agree_with_the_reference(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        for (int k = 0; k < 4; k++) {
            skv_world *world[2];
            for (int s = 0; s < 2; s++) {
                skv_world_def def = fixture_def((skv_law)law, solvers[s], 0, SPACING, 1);
                def.gravity_x = 1;
                world[s] = make_tank(&def, 0.6f, s == 0 ? 0.4f : 0);
                put_two(world[s]);
            }
            fixture_run(world[0], 4 * k + 1);
            for (int b = 0; b < 2; b++) {
                skv_body body;
                assert_true(skv_world_body_at(world[0], b, &body));
                for (int s = 0; s < 2; s++) {
                    assert_int_equal(skv_world_set_body_pose(world[s], body.id, body.x, body.y,
                                                             body.angle, NULL),
                                     SKV_OK);
                    assert_int_equal(skv_world_set_body_velocity(world[s], body.id, body.vx,
                                                                 body.vy, body.spin, NULL),
                                     SKV_OK);
                }
            }
            float dt = 1.0f / 60 / (float)skv_world_substeps_per_frame(world[0]);
            fixture_take_over(world[1], world[0]);
            assert_int_equal(skv_world_step(world[0], dt, NULL), SKV_OK);
            assert_int_equal(skv_world_step(world[1], dt, NULL), SKV_OK);
            fixture_expect_same_particles(world[0], world[1], dt);
            for (int b = 0; b < 2; b++) {
                skv_body fast, slow;
                assert_true(skv_world_body_at(world[0], b, &fast));
                assert_true(skv_world_body_at(world[1], b, &slow));
                double weight = EARTH * (double)fast.mass;
                assert_near((double)fast.force_x, (double)slow.force_x, 2e-3 * weight);
                assert_near((double)fast.force_y, (double)slow.force_y, 2e-3 * weight);
                assert_near((double)fast.torque, (double)slow.torque, 2e-4 * weight);
            }
            skv_world_destroy(world[0]);
            skv_world_destroy(world[1]);
        }
    }
}

static skv_world *run_two(int threads, skv_instruction_set set)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, threads);
    def.instruction_set = set;
    skv_world *world = make_tank(&def, 0.6f, 0.4f);
    put_two(world);
    fixture_run(world, 60);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_two);
}

/* Draws a box of 0.2 x 0.1 m into the walls, line by line of pixels. */
static void draw_box(skv_world *world)
{
    enum { LINES = 40 };
    skv_brush_stroke strokes[LINES];
    for (int i = 0; i < LINES; i++) {
        float y = 0.14625f + 0.0025f * (float)i;
        strokes[i] = (skv_brush_stroke){.x0 = 0.20125f, .x1 = 0.39875f, .radius = 0.00125f};
        strokes[i].y0 = strokes[i].y1 = y;
    }
    skv_terrain *painted;
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), strokes, LINES, &painted, NULL),
                     SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, painted, NULL, NULL), SKV_OK);
}

/* Water around a box that is drawn, and around one that is a body held there. */
static void a_body_that_is_held_is_a_wall(void **unused)
{
    (void)unused;
    double force[2] = {0}, centre[2] = {0};
    for (int k = 0; k < 2; k++) {
        skv_world *world = make_pool(SKV_SOLVER_FAST, 0, 0.6f, 0);
        skv_body_def held = box(0.2f, 0.1f, 0.3f, 0.195f, 500);
        held.fixed = true;
        skv_lab *lab;
        skv_body_id id = 0;
        if (k == 0)
            id = fixture_add_body(world, &held);
        else
            draw_box(world);
        fixture_fill(world, 0, 0, 0.6f, 0.4f);
        assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
        fixture_run(world, 120);
        assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
        skv_instrument meter =
            fixture_instrument(lab, SKV_INSTRUMENT_FORCE, 1, 0.12, 0.08, 0.48, 0.32);
        double lifted = 0;
        for (int f = 0; f < 60; f++) {
            lifted += k == 0 ? lift(world, id, 1) / 60 : 0;
            if (k == 1)
                fixture_run(world, 1);
            assert_int_equal(skv_lab_sample(lab, world, NULL), SKV_OK);
        }
        double read = skv_lab_reading(lab, meter, 1) / (1000 * EARTH * 0.02);
        force[k] = k == 0 ? lifted : read;
        /* A meter of walls does not read bodies. */
        assert_true(k == 1 || fabs(read) < 0.01);
        centre[k] = skv_world_stats(world).centre_y;
        skv_lab_destroy(lab);
        skv_world_destroy(world);
    }
    assert_near(force[0], force[1], 0.02);
    assert_near(centre[0], centre[1], 0.001);
}

/* A world that goes on from a snapshot does what it would have done, whoever goes on. */
static void snapshots_hold_bodies(void **unused)
{
    (void)unused;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, 1);
    skv_world *world = make_tank(&def, 0.6f, 0.4f);
    size_t bare = skv_world_snapshot_size(world, false);
    put_two(world);
    fixture_run(world, 30);
    fixture_saved b = fixture_save(world, false);
    assert_true(b.size != bare);
    fixture_expect_goes_on(world, 30);
    /* Also to a world that has lost one by now. */
    uint64_t hash = skv_world_hash(world);
    skv_body body;
    assert_true(skv_world_body_at(world, 0, &body));
    assert_true(skv_world_remove_body(world, body.id));
    fixture_run(world, 1);
    assert_int_equal(skv_world_restore(world, b.bytes, b.size, NULL), SKV_OK);
    assert_int_equal(skv_world_body_count(world), 2);
    fixture_run(world, 30);
    assert_true(skv_world_hash(world) == hash);
    for (size_t cut = b.size - 1; cut > b.size - 400; cut -= 7)
        assert_int_not_equal(skv_world_restore(world, b.bytes, cut, NULL), SKV_OK);
    free(b.bytes);
    skv_world_destroy(world);
}

static void refuse(skv_world *world, const skv_body_def *def, const char *why)
{
    skv_error error = {0};
    skv_body_id id = 7;
    int before = skv_world_body_count(world);
    assert_int_equal(skv_world_add_body(world, def, &id, NULL, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, why));
    assert_int_equal(id, 0);
    assert_int_equal(skv_world_body_count(world), before);
}

static void what_is_no_body_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_pool(SKV_SOLVER_FAST, 0, 0.6f, 0.2f);
    skv_body_def def = box(0.1f, 0.1f, 0.3f, 0.3f, 5);
    refuse(world, &def, "density");
    def.density = 500;
    def.x = NAN;
    refuse(world, &def, "place");
    def.x = 0.3f;
    def.vy = 101;
    refuse(world, &def, "velocity");
    def.vy = 0;
    def.restitution = 1.1f;
    refuse(world, &def, "restitution");
    def.restitution = 0;
    def.shape = skv_box(0, 0, 0.01f, 0.01f);
    refuse(world, &def, "particle");
    def.shape = skv_box(0, 0, 17, 0.1f);
    refuse(world, &def, "reaches");
    const float crossed[] = {0, 0, 0.1f, 0.1f, 0.1f, 0, 0, 0.1f};
    def.shape = skv_polygon(crossed, 4);
    refuse(world, &def, "cross");
    def.shape = skv_polygon(crossed, 2);
    refuse(world, &def, "corners");
    skv_error error = {0};
    assert_int_equal(skv_world_set_body_pose(world, 3, 0, 0, 0, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "none named 3"));
    assert_int_equal(skv_world_set_body_velocity(world, 3, 0, 0, 0, NULL), SKV_ERROR_VALUE);
    assert_false(skv_world_remove_body(world, 3));
    skv_body body;
    assert_false(skv_world_body(world, 3, &body));
    skv_world_destroy(world);
}

static void bodies_come_and_go(void **unused)
{
    (void)unused;
    skv_body_def binders, ours = skv_default_body_def();
    skv_body_def_init(&binders, sizeof binders);
    assert_int_equal(binders.cookie, ours.cookie);
    assert_memory_equal(&binders.shape, &ours.shape, sizeof ours.shape);
    assert_true(binders.density == ours.density && binders.friction == ours.friction);
    skv_world *world = make_pool(SKV_SOLVER_FAST, 0, 0.6f, 0.4f);
    int count = skv_world_particle_count(world), removed;
    skv_body_def def = skv_default_body_def();
    const float corners[] = {0.1f, 0.1f, 0.1f, 0.3f, 0.3f, 0.1f}; /* clockwise */
    def.shape = skv_polygon(corners, 3);
    skv_body_id first, second;
    assert_int_equal(skv_world_add_body(world, &def, &first, &removed, NULL), SKV_OK);
    assert_true(removed > 0.8 * 0.02 / (double)(SPACING * SPACING));
    assert_int_equal(skv_world_particle_count(world), count - removed);
    skv_body body = fixture_body(world, first);
    assert_near((double)body.x, 0.5 / 3, 1e-6);
    assert_near((double)body.area, 0.02, 1e-6);
    assert_near((double)body.mass, 10, 1e-4);
    /* Of a right triangle about its centre of mass: area (a^2 + b^2)/36 * 2. */
    assert_near((double)body.inertia, 500 * 0.02 * (0.04 + 0.04) / 18, 1e-5);
    assert_int_equal(body.corners, 3);
    assert_int_equal(skv_world_add_particle(world, 0.15f, 0.15f, 0, 0, NULL), SKV_ERROR_VALUE);
    def.shape = skv_swept_circle(0.4f, 0.2f, 0.5f, 0.2f, 0.03f);
    second = fixture_add_body(world, &def);
    assert_near((double)fixture_body(world, second).area, 0.1 * 0.06 + 3.14159265 * 0.0009, 2e-5);
    assert_true(skv_world_remove_body(world, first));
    assert_false(skv_world_body(world, first, &body));
    assert_int_equal(body.corners, 0);
    assert_int_equal(fixture_body(world, second).id, second);
    assert_int_equal(skv_world_add_particle(world, 0.15f, 0.15f, 0, 0, NULL), SKV_OK);
    fixture_run(world, 10);
    assert_true(fixture_add_body(world, &def) > second);
    skv_world_destroy(world);
}

/* Bodies of the same picture have the same walls: what is drawn elsewhere, too, and when the one
 * that came first goes. Nothing tells them from those that have walls of their own. */
static void bodies_share_walls(void **unused)
{
    (void)unused;
    uint64_t hash[2];
    for (int alike = 0; alike < 2; alike++) {
        skv_world *world = make_pool(SKV_SOLVER_FAST, 0, 0.6f, 0.4f);
        skv_body_def def = box(alike ? 0.1f : 0.12f, 0.1f, 0.3f, 0.7f, 500);
        skv_body_id first = fixture_add_body(world, &def);
        def = skv_default_body_def();
        def.shape = skv_box(0.25f, 0.38f, 0.35f, 0.48f);
        fixture_add_body(world, &def);
        assert_true(skv_world_remove_body(world, first));
        fixture_run(world, 30);
        hash[alike] = skv_world_hash(world);
        skv_world_destroy(world);
    }
    assert_true(hash[0] == hash[1]);
}

/* Sleeping water wakes by a body, and one that moves keeps it awake. */
static void bodies_wake_water(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    skv_body_def def = box(0.1f, 0.1f, 0.4f, 0.6f, 800);
    skv_body_id id = fixture_add_body(world, &def);
    fixture_run(world, 60);
    assert_true(skv_world_awake_count(world) > 0);
    assert_true((double)fixture_body(world, id).y < 0.4);
    assert_true((double)fixture_body(world, id).y > 0.1);
    skv_world_destroy(world);
}

static void bodies_leave_through_open_sides(void **unused)
{
    (void)unused;
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.open_sides = SKV_SIDE_BOTTOM;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, 1);
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_body_def falling = box(0.1f, 0.1f, 0.4f, 0.2f, 800);
    fixture_add_body(world, &falling);
    fixture_run(world, 60);
    assert_int_equal(skv_world_body_count(world), 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_lifts_what_is_held),
        cmocka_unit_test(a_body_that_is_held_is_a_wall),
        cmocka_unit_test(bodies_float_as_deep_as_they_are_heavy),
        cmocka_unit_test(momentum_stays),
        cmocka_unit_test(walls_and_bodies_hold_bodies),
        cmocka_unit_test(heavy_bodies_sink_and_rest),
        cmocka_unit_test(bodies_lie_on_the_floor),
        cmocka_unit_test(light_bodies_leave_the_floor),
        cmocka_unit_test(rows_agree_with_the_reference),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(snapshots_hold_bodies),
        cmocka_unit_test(what_is_no_body_is_refused),
        cmocka_unit_test(bodies_come_and_go),
        cmocka_unit_test(bodies_share_walls),
        cmocka_unit_test(bodies_wake_water),
        cmocka_unit_test(bodies_leave_through_open_sides),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
