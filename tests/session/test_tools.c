/* Tools: hands and brushes, as pictures show them and the water feels them. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include "support/fixture.h"

/* At this view 1000 pixels are a metre. */
static int setup(void **state)
{
    *state = stage_open_pool(800, false);
    return 0;
}

/* Where a pointer is taken to be: the nearest of the steps in which replays count. */
static double in_steps(double metres)
{
    return floor(metres * 4096 + 0.5) / 4096;
}

static void mouse(skv_stage *stage, skv_phase phase, double px, double py, double time)
{
    stage_touch(stage, phase, SKV_DEVICE_MOUSE, 0, px, py, time);
}

static skv_mark only_mark(skv_stage *stage)
{
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_int_equal(picture.mark_count, 1);
    return picture.marks[0];
}

static skv_hand only_hand(skv_stage *stage)
{
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_int_equal(picture.hand_count, 1);
    return picture.hands[0];
}

static void test_a_hand_comes_and_goes(void **state)
{
    skv_stage *stage = *state;
    skv_picture picture;
    mouse(stage, SKV_PHASE_DOWN, 400, 700, 0);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 1);
    skv_mark mark = only_mark(stage);
    assert_int_equal(mark.role, SKV_MARK_HAND);
    assert_int_equal(mark.shape, SKV_MARK_CIRCLE);
    assert_near((double)mark.x0, in_steps(0.4), 1e-6);
    assert_near((double)mark.y0, in_steps(0.2), 1e-6);
    assert_near((double)mark.radius, 0.16, 1e-6);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
    skv_hand hand = only_hand(stage);
    assert_near((double)hand.x, in_steps(0.4), 1e-6);
    assert_near((double)hand.radius, 0.16, 1e-6);
    assert_near((double)hand.attraction, 300, 1e-9);
    mouse(stage, SKV_PHASE_UP, 400, 700, 0.1);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
    stage_copy(stage, &picture);
    assert_int_equal(picture.hand_count, 0);
    assert_int_equal(picture.mark_count, 0);
}

static void test_more_fingers_than_hands(void **state)
{
    skv_stage *stage = *state;
    for (uint64_t i = 0; i < SKV_MAX_HANDS + 4; i++)
        stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_FINGER, 1 + i, 90.0 * (double)i, 800, 0);
    assert_int_equal(skv_stage_pointer_count(stage, 0), SKV_MAX_HANDS);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_int_equal(picture.hand_count, SKV_MAX_HANDS);
    skv_stage_cancel_pointers(stage);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 0);
    stage_advance(stage, 1.0 / 60);
    stage_copy(stage, &picture);
    assert_int_equal(picture.hand_count, 0);
}

static void test_brush_sets_the_grip(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_brush(stage, 0.05);
    mouse(stage, SKV_PHASE_DOWN, 800, 450, 0);
    assert_near((double)only_mark(stage).radius, 0.05, 1e-6);
    skv_stage_set_brush(stage, 0);
    skv_stage_wait(stage);
    assert_near((double)only_mark(stage).radius, 0.16, 1e-6);
}

static void test_a_finger_stays_when_the_view_changes(void **state)
{
    skv_stage *stage = *state;
    mouse(stage, SKV_PHASE_DOWN, 800, 450, 0);
    assert_near((double)only_mark(stage).x0, in_steps(0.8), 1e-6);
    skv_stage_set_view(stage, 0, 800, 450);
    skv_stage_wait(stage);
    assert_near((double)only_mark(stage).x0, in_steps(1.6), 1e-6);
}

/* A call of four frames moves a hand four times, not once: at 15 pictures a second the water must
 * not be left behind. */
static void test_the_way_is_shared_among_frames(void **state)
{
    skv_stage *stage = *state;
    mouse(stage, SKV_PHASE_DOWN, 400, 700, 0);
    stage_advance(stage, 1.0 / 60);
    mouse(stage, SKV_PHASE_MOVE, 440, 700, 4.0 / 60);
    assert_int_equal(stage_advance(stage, 4.0 / 60), 4);
    assert_near((double)only_hand(stage).x, in_steps(0.44), 1e-6);
    /* Back along the log: where it was after each of them. */
    for (int i = 1; i <= 4; i++) {
        skv_stage_seek(stage, 1 + i);
        skv_stage_wait(stage);
    }
    assert_int_equal(stage_moment(stage), 5);
}

/* In slow motion a finger is fast for the water: what is held follows at 2 m/s at most, and both
 * show. */
static void test_slow_motion_holds_the_hand_back(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_speed(stage, 0.1);
    mouse(stage, SKV_PHASE_DOWN, 200, 700, 0);
    double time = 0, x = in_steps(0.2);
    for (int i = 0; i < 60; i++) {
        time += 1.0 / 60;
        mouse(stage, SKV_PHASE_MOVE, 200 + 500 * time, 700, time);
        if (stage_advance(stage, 1.0 / 60) == 0)
            continue;
        skv_hand hand = only_hand(stage);
        assert_true((double)hand.x - x <= 2.0 / 60 + 1e-6);
        assert_true(hypot((double)hand.vx, (double)hand.vy) <= 2 + 1e-5);
        x = (double)hand.x;
    }
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_int_equal(picture.mark_count, 3); /* what is held, the finger, and the way between */
    assert_near((double)picture.marks[0].x0, x, 1e-6);
    assert_near((double)picture.marks[2].x0, in_steps(0.7), 1e-6);
    assert_true(x < 0.45);
    /* It arrives. */
    for (int i = 0; i < 120; i++)
        stage_advance(stage, 1.0 / 60);
    assert_near((double)only_mark(stage).x0, in_steps(0.7), 1e-6);
}

static void test_speed_of_a_hand(void **state)
{
    skv_stage *stage = *state;
    mouse(stage, SKV_PHASE_DOWN, 200, 500, 0);
    for (int i = 1; i <= 30; i++) {
        mouse(stage, SKV_PHASE_MOVE, 200 + 10 * i, 500 - 5 * i, i / 60.0);
        stage_advance(stage, 1.0 / 60);
    }
    assert_near((double)only_hand(stage).vx, 0.6, 0.01);
    assert_near((double)only_hand(stage).vy, 0.3, 0.01); /* up in the world is up in the view */
    /* A flick of 100 m/s is cut, in the same direction. */
    for (int i = 31; i <= 60; i++) {
        mouse(stage, SKV_PHASE_MOVE, 1000.0 * i, 900 - 500.0 * i, i / 60.0);
        stage_advance(stage, 1.0 / 60);
    }
    skv_hand hand = only_hand(stage);
    double speed = hypot((double)hand.vx, (double)hand.vy);
    assert_true(speed <= 10 && speed > 10 - 2.0 / 64); /* in steps of 1/64 m/s */
}

static double mean_height_near(skv_stage *stage, double x, double reach)
{
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    const skv_particles *particles = &picture->frame.particles;
    double sum = 0;
    int count = 0;
    for (int i = 0; i < particles->count; i++)
        if (fabs((double)particles->x[i] - x) < reach) {
            sum += (double)particles->y[i];
            count++;
        }
    return sum / count;
}

/* Two fingers lift two chunks, and the fluid falls back when they let go. */
static void test_two_fingers_lift_fluid(void **state)
{
    skv_stage *stage = *state;
    double before = mean_height_near(stage, 0.4, 0.1);
    double middle = mean_height_near(stage, 0.8, 0.1);
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_FINGER, 1, 400, 500, 0);
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_FINGER, 2, 1200, 500, 0);
    for (int i = 1; i <= 40; i++) {
        double y = fmax(500 - 8 * i, 300);
        stage_touch(stage, SKV_PHASE_MOVE, SKV_DEVICE_FINGER, 1, 400, y, i / 60.0);
        stage_touch(stage, SKV_PHASE_MOVE, SKV_DEVICE_FINGER, 2, 1200, y, i / 60.0);
        stage_advance(stage, 1.0 / 60);
    }
    assert_true(mean_height_near(stage, 0.4, 0.1) > before + 0.03);
    assert_true(mean_height_near(stage, 1.2, 0.1) > before + 0.03);
    assert_true(mean_height_near(stage, 0.8, 0.1) < middle + 0.02);
    stage_touch(stage, SKV_PHASE_UP, SKV_DEVICE_FINGER, 1, 400, 300, 1);
    stage_touch(stage, SKV_PHASE_UP, SKV_DEVICE_FINGER, 2, 1200, 300, 1);
    /* Eight seconds, until the waves have passed: they are as high as what is asserted. */
    for (int i = 0; i < 480; i++)
        stage_advance(stage, 1.0 / 60);
    assert_near(mean_height_near(stage, 0.4, 0.1), before, 0.02);
}

/* What a hand carries when it goes straight up out of the pool: the share of what it held, after
 * 0.3 m, that is within its radius. */
static int carried(double speed)
{
    skv_stage *stage = stage_open_pool(3000, false);
    double time = 0, y = 0.3;
    mouse(stage, SKV_PHASE_DOWN, 800, 900 - 1000 * y, time);
    for (int i = 0; i < 10; i++)
        stage_advance(stage, 1.0 / 60);
    while (y < 0.6) {
        time += 1.0 / 60;
        y += speed / 60;
        mouse(stage, SKV_PHASE_MOVE, 800, 900 - 1000 * y, time);
        stage_advance(stage, 1.0 / 60);
    }
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    const skv_particles *p = &picture->frame.particles;
    int count = 0;
    for (int i = 0; i < p->count; i++)
        count += hypot((double)p->x[i] - 0.8, (double)p->y[i] - y) < 0.16;
    skv_stage_destroy(stage);
    return count;
}

/* The hand of before lost nearly all at 3 m/s. */
static void test_a_hand_carries_water(void **state)
{
    (void)state;
    int slow = carried(1), fast = carried(3);
    print_message("a hand at 1 and 3 m/s carries %d and %d particles\n", slow, fast);
    assert_true(slow > 100);
    assert_true(fast > 50);
}

static int particles(skv_stage *stage)
{
    skv_picture picture;
    stage_copy(stage, &picture);
    return picture.frame.particles.count;
}

static int tool_named(const char *name)
{
    int i = 0;
    while (skv_tool_info(i) && strcmp(skv_tool_info(i)->name, name) != 0)
        i++;
    assert_non_null(skv_tool_info(i));
    return i;
}

static void test_water_is_poured_and_taken(void **state)
{
    skv_stage *stage = *state;
    int before = particles(stage);
    skv_stage_set_paused(stage, true);
    skv_stage_set_tool(stage, tool_named("water"));
    assert_int_equal(skv_stage_tool(stage), tool_named("water"));
    mouse(stage, SKV_PHASE_DOWN, 800, 100, 0);
    mouse(stage, SKV_PHASE_MOVE, 1000, 100, 0.1);
    mouse(stage, SKV_PHASE_UP, 1000, 100, 0.2);
    int poured = particles(stage) - before;
    /* A stroke of 0.2 m with a brush of 0.04 m radius. */
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    double s = (double)picture->frame.spacing;
    assert_near(poured * s * s, 0.2 * 0.08 + 3.14159 * 0.04 * 0.04, 0.005);

    /* The right button erases, whatever tool there is. */
    skv_stage_pointer(
        stage, 0,
        &(skv_pointer_event){.phase = SKV_PHASE_DOWN, .px = 800, .py = 100, .secondary = true});
    skv_stage_wait(stage);
    mouse(stage, SKV_PHASE_MOVE, 1000, 100, 0.5);
    mouse(stage, SKV_PHASE_UP, 1000, 100, 0.6);
    assert_int_equal(particles(stage), before);

    /* Each stroke is one edit. */
    skv_stage_undo(stage);
    skv_stage_wait(stage);
    assert_int_equal(particles(stage), before + poured);
    skv_stage_undo(stage);
    skv_stage_wait(stage);
    assert_int_equal(particles(stage), before);
    skv_stage_redo(stage);
    skv_stage_redo(stage);
    skv_stage_wait(stage);
    assert_int_equal(particles(stage), before);
}

static double distance_at(skv_stage *stage, float x, float y)
{
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    double distance = (double)skv_terrain_distance(picture->frame.terrain, x, y);
    return distance;
}

static void test_walls_are_drawn_and_erased(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_tool(stage, tool_named("wall"));
    mouse(stage, SKV_PHASE_DOWN, 400, 300, 0);
    assert_true(distance_at(stage, 0.4f, 0.6f) < 0); /* in the very next picture */
    /* Round a corner between two pictures: the corner is not cut. */
    skv_stage_pointer(
        stage, 0,
        &(skv_pointer_event){.phase = SKV_PHASE_MOVE, .px = 800, .py = 300, .time = 0.01});
    skv_stage_pointer(
        stage, 0,
        &(skv_pointer_event){.phase = SKV_PHASE_MOVE, .px = 800, .py = 100, .time = 0.02});
    mouse(stage, SKV_PHASE_UP, 800, 100, 0.03);
    assert_true(distance_at(stage, 0.79f, 0.6f) < 0);
    assert_true(distance_at(stage, 0.8f, 0.7f) < 0);
    assert_true(distance_at(stage, 0.6f, 0.7f) > 0.05);
    stage_advance(stage, 1.0 / 60);
    skv_stage_undo(stage);
    skv_stage_wait(stage);
    assert_true(distance_at(stage, 0.4f, 0.6f) > 0.1);
    skv_stage_redo(stage);
    skv_stage_wait(stage);
    assert_true(distance_at(stage, 0.4f, 0.6f) < 0);
    /* A pen's other end erases. */
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_ERASER, 7, 400, 300, 1);
    stage_touch(stage, SKV_PHASE_UP, SKV_DEVICE_ERASER, 7, 400, 300, 1.1);
    assert_true(distance_at(stage, 0.4f, 0.6f) > 0.01);
    assert_true(distance_at(stage, 0.6f, 0.6f) < 0);
}

static void test_taps_and_drains(void **state)
{
    skv_stage *stage = *state;
    skv_picture picture;
    int before = particles(stage);
    skv_stage_set_tool(stage, tool_named("tap"));
    mouse(stage, SKV_PHASE_DOWN, 300, 200, 0);
    mouse(stage, SKV_PHASE_MOVE, 400, 200, 0.1);
    mouse(stage, SKV_PHASE_UP, 400, 200, 0.2); /* 0.1 m to the right: 1 m/s */
    stage_copy(stage, &picture);
    assert_int_equal(picture.marks[picture.mark_count - 1].role, SKV_MARK_SOURCE);
    for (int i = 0; i < 120; i++)
        stage_advance(stage, 1.0 / 60);
    int poured = particles(stage) - before;
    stage_copy(stage, &picture);
    double s = (double)picture.frame.spacing;
    assert_near(poured * s * s, 2 * 1.0 * 0.04, 0.01); /* 2 s of 1 m/s times 4 cm */

    skv_stage_set_tool(stage, tool_named("drain"));
    mouse(stage, SKV_PHASE_DOWN, 1200, 850, 3);
    mouse(stage, SKV_PHASE_UP, 1200, 850, 3.1);
    /* The eraser takes the tap away. */
    skv_stage_set_tool(stage, tool_named("eraser"));
    mouse(stage, SKV_PHASE_DOWN, 300, 200, 4);
    mouse(stage, SKV_PHASE_UP, 300, 200, 4.1);
    for (int i = 0; i < 60; i++)
        stage_advance(stage, 1.0 / 60);
    stage_copy(stage, &picture);
    assert_true(particles(stage) < before + poured - 20);
    assert_int_equal(picture.marks[picture.mark_count - 1].role, SKV_MARK_SINK);
    skv_stage_undo(stage); /* the eraser, */
    skv_stage_undo(stage); /* the drain, */
    skv_stage_undo(stage); /* the tap */
    skv_stage_wait(stage);
    assert_int_equal(particles(stage), before);
}

static int fans(skv_stage *stage)
{
    skv_picture picture;
    int count = 0;
    stage_copy(stage, &picture);
    for (int i = 0; i < picture.mark_count; i++)
        count += picture.marks[i].role == SKV_MARK_WIND;
    return count / 2;
}

static double mean_flow(skv_stage *stage)
{
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    const skv_particles *p = &picture->frame.particles;
    double sum = 0;
    for (int i = 0; i < p->count; i++)
        sum += (double)p->vx[i] / p->count;
    return sum;
}

/* Wind blows the way that was drawn, until it is erased; back and on again it blows the same. */
static void test_wind(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_tool(stage, tool_named("wind"));
    mouse(stage, SKV_PHASE_DOWN, 600, 800, 0);
    mouse(stage, SKV_PHASE_MOVE, 800, 800, 0.1);
    assert_int_equal(fans(stage), 0);
    mouse(stage, SKV_PHASE_UP, 800, 800, 0.2);
    assert_int_equal(fans(stage), 1);
    for (int i = 0; i < 10; i++)
        stage_advance(stage, 1.0 / 60);
    assert_true(mean_flow(stage) > 0.02);
    uint64_t hash = stage_hash(stage, 0);
    int64_t moment = stage_moment(stage);
    skv_stage_seek(stage, 0);
    skv_stage_wait(stage);
    skv_stage_seek(stage, moment);
    skv_stage_wait(stage);
    assert_true(stage_hash(stage, 0) == hash);

    skv_stage_set_tool(stage, tool_named("eraser"));
    mouse(stage, SKV_PHASE_DOWN, 640, 500, 3); /* not over its middle */
    mouse(stage, SKV_PHASE_UP, 640, 500, 3.1);
    assert_int_equal(fans(stage), 1);
    mouse(stage, SKV_PHASE_DOWN, 700, 800, 4);
    mouse(stage, SKV_PHASE_UP, 700, 800, 4.1);
    assert_int_equal(fans(stage), 0);
    skv_stage_undo(stage);
    skv_stage_wait(stage);
    assert_int_equal(fans(stage), 1);
    skv_stage_undo(stage); /* the eraser's first */
    skv_stage_undo(stage); /* the fan */
    skv_stage_wait(stage);
    assert_int_equal(fans(stage), 0);
}

static int particles_dyed(skv_stage *stage, int dye)
{
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    int count = 0;
    for (int i = 0; i < picture->frame.particles.count; i++)
        count += picture->frame.particles.dye[i] == dye;
    return count;
}

/* What the pointer comes over takes the colour, and so does what flows from taps there. */
static void test_dye(void **state)
{
    skv_stage *stage = *state;
    int tool = tool_named("dye");
    assert_true(skv_tool_info(tool)->dyes && !skv_tool_info(0)->dyes);
    assert_int_equal(skv_stage_dye(stage), 1);
    skv_stage_set_tool(stage, tool_named("tap"));
    mouse(stage, SKV_PHASE_DOWN, 300, 200, 0);
    mouse(stage, SKV_PHASE_UP, 300, 200, 0.1);
    for (int i = 0; i < 20; i++)
        stage_advance(stage, 1.0 / 60);
    assert_true(particles_dyed(stage, 0) == particles(stage));

    skv_stage_set_tool(stage, tool);
    mouse(stage, SKV_PHASE_DOWN, 300, 850, 1);
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_int_equal(picture.marks[0].dye, 1);
    mouse(stage, SKV_PHASE_MOVE, 1300, 850, 1.1);
    mouse(stage, SKV_PHASE_UP, 1300, 850, 1.2);
    int rose = particles_dyed(stage, 1);
    assert_in_range(rose, 70, 110); /* 1 m of 8 cm: 89 of 800 on 0.72 m^2 */
    skv_stage_set_dye(stage, 4);
    mouse(stage, SKV_PHASE_DOWN, 300, 200, 2);
    mouse(stage, SKV_PHASE_UP, 300, 200, 2.1);
    int violet = particles_dyed(stage, 4);
    for (int i = 0; i < 30; i++)
        stage_advance(stage, 1.0 / 60);
    assert_true(particles_dyed(stage, 4) > violet + 10);
    assert_int_equal(particles_dyed(stage, 1), rose);
    uint64_t hash = stage_hash(stage, 0);

    /* Back and on again: the same colours; and washed out. */
    skv_stage_undo(stage);
    skv_stage_wait(stage);
    assert_int_equal(particles_dyed(stage, 4), 0);
    assert_int_equal(particles_dyed(stage, 1), rose);
    skv_stage_redo(stage);
    skv_stage_wait(stage);
    assert_true(stage_hash(stage, 0) == hash);
    skv_stage_set_dye(stage, 0);
    skv_stage_set_brush(stage, 10);
    mouse(stage, SKV_PHASE_DOWN, 800, 450, 3);
    mouse(stage, SKV_PHASE_UP, 800, 450, 3.1);
    assert_true(particles_dyed(stage, 0) == particles(stage));
}

static void test_straight_lines(void **state)
{
    skv_stage *stage = *state;
    int before = particles(stage);
    skv_stage_set_paused(stage, true);
    skv_stage_set_tool(stage, tool_named("water"));
    skv_pointer_event event = {.phase = SKV_PHASE_DOWN, .px = 400, .py = 200, .straight = true};
    skv_stage_pointer(stage, 0, &event);
    mouse(stage, SKV_PHASE_MOVE, 700, 100, 0.1); /* the way there does not count */
    mouse(stage, SKV_PHASE_MOVE, 1000, 200, 0.2);
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_int_equal(picture.mark_count, 2);
    assert_int_equal(picture.marks[1].shape, SKV_MARK_SEGMENT);
    assert_int_equal(particles(stage), before);
    mouse(stage, SKV_PHASE_UP, 1000, 200, 0.3);
    assert_true(particles(stage) > before);
    skv_stage_look(stage);
    const skv_picture *newest = skv_stage_picture(stage, 0);
    const skv_particles *p = &newest->frame.particles;
    for (int i = before; i < p->count; i++)
        assert_near((double)p->y[i], 0.7, 0.041);
}

/* A stroke that is broken off does not happen any further, and hovering shows the brush. */
static void test_leaving_and_hovering(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_tool(stage, tool_named("eraser"));
    mouse(stage, SKV_PHASE_MOVE, 300, 300, 0);
    skv_mark mark = only_mark(stage);
    assert_int_equal(mark.role, SKV_MARK_BRUSH);
    assert_near((double)mark.x0, in_steps(0.3), 1e-6);
    mouse(stage, SKV_PHASE_LEAVE, 300, 300, 0);
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_int_equal(picture.mark_count, 0);
}

static double finger_x(skv_stage *stage)
{
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_true(picture.mark_count > 0);
    return (double)picture.marks[picture.mark_count - 1].x0;
}

static void test_keys_move_a_hand(void **state)
{
    skv_stage *stage = *state;
    skv_stage_keyboard(stage, 0, 0, 0, true);
    skv_stage_wait(stage);
    assert_near((double)only_mark(stage).x0, in_steps(0.8), 1e-6);
    skv_stage_keyboard(stage, 0, 1, 0, true);
    for (int i = 0; i < 30; i++)
        stage_advance(stage, 1.0 / 60);
    double x = finger_x(stage);
    assert_true(x > 0.85 && x < 1.6);
    for (int i = 0; i < 300; i++)
        stage_advance(stage, 1.0 / 60);
    assert_near(finger_x(stage), in_steps(1.6), 1e-6); /* not out of the view */
    skv_stage_keyboard(stage, 0, 0, 0, false);
    skv_stage_wait(stage);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_hand_comes_and_goes, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_more_fingers_than_hands, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_brush_sets_the_grip, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_a_finger_stays_when_the_view_changes, setup,
                                        stage_teardown),
        cmocka_unit_test_setup_teardown(test_the_way_is_shared_among_frames, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_slow_motion_holds_the_hand_back, setup,
                                        stage_teardown),
        cmocka_unit_test_setup_teardown(test_speed_of_a_hand, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_two_fingers_lift_fluid, setup, stage_teardown),
        cmocka_unit_test(test_a_hand_carries_water),
        cmocka_unit_test_setup_teardown(test_water_is_poured_and_taken, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_walls_are_drawn_and_erased, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_taps_and_drains, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_wind, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_dye, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_straight_lines, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_leaving_and_hovering, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_keys_move_a_hand, setup, stage_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
