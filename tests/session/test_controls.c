/* What every front end offers: that the tables are whole and their entries work, and what buttons
 * and keys do to a stage. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/controls.h>
#include <skvalp/parameters.h>

#include "support.h"

/* What controls do goes out from the pictures that the face has looked at. */
static skv_stage *open_pool(int particles)
{
    skv_stage *stage = stage_open_pool(particles, false);
    stage_look(stage, 0);
    return stage;
}

static void pass_frames(skv_stage *stage, int frames)
{
    stage_pass_frames(stage, frames);
    stage_look(stage, 0);
}

/* Every field of numbers takes its ends and refuses what is beyond them, or no number, in words
 * with both ends in them. */
static void test_refusals(void **state)
{
    (void)state;
    const skv_field *field;
    int numbers = 0;
    for (int i = 0; (field = skv_world_field(i)); i++) {
        char text[32];
        bool whole = field->type == SKV_FIELD_INTEGER;
        if (field->type != SKV_FIELD_NUMBER && !whole) {
            assert_null(skv_field_refusal(field, "anything"));
            continue;
        }
        numbers++;
        for (int end = 0; end < 2; end++) {
            double at = end ? field->maximum : field->minimum;
            skv_format(text, sizeof text, "%.9g", at);
            assert_null(skv_field_refusal(field, text));
            skv_format(text, sizeof text, "%.9g", end ? 2 * fabs(at) + 1 : -2 * fabs(at) - 1);
            assert_non_null(skv_field_refusal(field, text));
        }
        assert_ptr_equal(skv_field_refusal(field, "three"), skv_refusal_words(whole));
        assert_ptr_equal(skv_field_refusal(field, ""), skv_refusal_words(whole));
        skv_format(text, sizeof text, "%.9g", field->minimum + 0.5);
        if (whole)
            assert_ptr_equal(skv_field_refusal(field, text), skv_refusal_words(1));
    }
    assert_true(numbers > 10);
    for (int i = 0; skv_refusal_words(i); i++)
        assert_non_null(strstr(strstr(skv_refusal_words(i), "%s") + 2, "%s"));
    assert_null(skv_refusal_words(-1));
}

static void test_speeds(void **state)
{
    (void)state;
    skv_stage *stage = open_pool(200);
    const skv_named_number *speed;
    int count = 0;
    for (; (speed = skv_speed_at(count)); count++) {
        skv_stage_set_speed(stage, speed->number);
        assert_true(skv_stage_speed(stage) == speed->number); /* each can be had */
        assert_true(count == 0 || speed->number < skv_speed_at(count - 1)->number);
    }
    assert_int_equal(count, 5);
    assert_null(skv_speed_at(-1));
    static const double slower[][2] = {{2, 1}, {1, 0.5}, {0.3, 0.25}, {0.1, 0.1}, {0.05, 0.1}};
    static const double faster[][2] = {{0.1, 0.25}, {0.3, 1}, {1, 2}, {2, 2}};
    for (size_t i = 0; i < sizeof slower / sizeof *slower; i++) {
        skv_stage_set_speed(stage, slower[i][0]);
        skv_control_shift_speed(stage, -1);
        assert_true(skv_stage_speed(stage) == slower[i][1]);
    }
    for (size_t i = 0; i < sizeof faster / sizeof *faster; i++) {
        skv_stage_set_speed(stage, faster[i][0]);
        skv_control_shift_speed(stage, 1);
        assert_true(skv_stage_speed(stage) == faster[i][1]);
    }
    skv_stage_destroy(stage);
}

static void test_going(void **state)
{
    (void)state;
    for (int i = 0; i < 6; i++)
        assert_non_null(skv_going_words(i));
    assert_null(skv_going_words(6));
    skv_stage *stage = open_pool(200);
    skv_stage_set_gravity(stage, 0, 1, 0); /* it moves */
    stage_look(stage, 0);
    assert_string_equal(skv_control_going(stage).words, "starting"); /* it may take long */
    pass_frames(stage, 5);
    assert_string_equal(skv_control_going(stage).words, "real time");
    skv_stage_set_speed(stage, 0.25);
    pass_frames(stage, 1);
    skv_going going = skv_control_going(stage);
    assert_string_equal(going.words, "%s× of real time");
    assert_true(going.times == 0.25 && !going.slow);
    skv_stage_set_paused(stage, true);
    stage_look(stage, 0);
    assert_string_equal(skv_control_going(stage).words, "paused");
    skv_stage_destroy(stage);
}

static void test_amounts(void **state)
{
    (void)state;
    int count = 0;
    int usual = skv_control_limits()->usual_amount, times_usual = 0;
    for (int amount, before = 0; (amount = skv_amount_at(count)) > 0; count++, before = amount) {
        assert_true(amount > before);
        times_usual += amount == usual;
    }
    assert_int_equal(times_usual, 1);
    assert_int_equal(skv_amount_of("fountain", usual), 1500);
    assert_int_equal(count, 7);
    assert_int_equal(skv_amount_at(-1), 0);
    assert_int_equal(skv_amount_of("pool", 0), 0);
    assert_int_equal(skv_amount_of("pool", 5000), 5000);
    assert_int_equal(skv_amount_of("fountain", 10000), 5000); /* it says 1500 */
    assert_int_equal(skv_amount_of("tank", 10000), 10000);    /* though it holds none */
    assert_int_equal(skv_amount_of("dir/a.json", 2000), 2000);
    assert_int_equal(skv_amount_of("dir/a.png", 2000), 2000);
    assert_int_equal(skv_amount_of("dir/a.skvr", 2000), 0);
    assert_int_equal(skv_amount_of("skvalp:1.abc", 2000), 0);
}

static void test_time(void **state)
{
    (void)state;
    const skv_limits *limits = skv_control_limits();
    assert_int_equal(limits->reach, 30 * 60); /* half a minute, as the bar's hint says */
    skv_stage *stage = open_pool(100);
    pass_frames(stage, 20);
    skv_control_seek(stage, 10);
    assert_int_equal(stage_moment(stage), 10);
    assert_true(skv_stage_paused(stage));
    skv_control_go(stage, -3);
    assert_int_equal(stage_moment(stage), 7);
    skv_control_seek(stage, -5);
    assert_int_equal(stage_moment(stage), 0);
    skv_control_seek(stage, 1000);
    assert_int_equal(stage_moment(stage), 20);
    for (int i = 0; i < limits->reach; i++)
        skv_stage_step_once(stage);
    stage_look(stage, 0);
    skv_control_seek(stage, 3);
    assert_int_equal(stage_moment(stage), 20);
    skv_stage_destroy(stage);
}

static void test_planets_and_tools(void **state)
{
    (void)state;
    skv_stage *stage = open_pool(100);
    const skv_limits *limits = skv_control_limits();
    const skv_named_number *planet;
    int count = 0;
    skv_stage_set(stage, 0, "gravity.x", "3");
    for (; (planet = skv_planet_at(count)); count++) {
        stage_look(stage, 0);
        skv_control_planet(stage, 0, planet);
        const skv_picture *picture = stage_look(stage, 0);
        assert_true(fabs(picture->parameters.gravity_y - planet->number) < 1e-6);
        assert_true(picture->parameters.gravity_x == 0);
        static const double wanted[] = {-1.62, -3.71, -9.81, -24.79};
        assert_true(planet->number == wanted[count]);
    }
    assert_int_equal(count, 4);
    skv_camera camera = skv_stage_camera(stage, 0);
    double size = fmax(camera.world_width, camera.world_height);
    skv_control_brush(stage, 0.05);
    stage_look(stage, 0);
    skv_control_scale_brush(stage, 2);
    assert_true(fabs(stage_look(stage, 0)->brush - 0.1) < 1e-9);
    skv_control_scale_brush(stage, 1e9);
    assert_true(fabs(stage_look(stage, 0)->brush - limits->largest_brush * size) < 1e-9);
    skv_control_brush(stage, -1);
    assert_true(fabs(stage_look(stage, 0)->brush - limits->least_brush * size) < 1e-9);
    skv_control_brush(stage, (double)NAN);
    assert_true(stage_look(stage, 0)->brush > 0);
    int dyes = 0, tool = 0;
    while (skv_dye_name(dyes))
        dyes++;
    while (!skv_tool_info(tool)->dyes)
        tool++;
    int first = skv_stage_dye(stage);
    skv_control_tool(stage, tool);
    assert_int_equal(skv_stage_dye(stage), first);
    for (int i = 1; i <= dyes; i++) {
        skv_control_tool(stage, tool);
        assert_int_equal(skv_stage_dye(stage), (first + i) % dyes);
    }
    assert_int_equal(skv_stage_tool(stage), tool);
    skv_stage_destroy(stage);
}

static bool is_inside(const skv_camera *camera, double x, double y)
{
    return x >= 0 && y >= 0 && x <= camera->world_width && y <= camera->world_height;
}

static void test_gauges(void **state)
{
    (void)state;
    skv_stage *stage = open_pool(200);
    const skv_gauge *gauge;
    int count = 0;
    for (; (gauge = skv_gauge_at(count)); count++) {
        assert_ptr_equal(skv_gauge_of(gauge->kind), gauge);
        assert_non_null(skv_instrument_channel(gauge->kind, gauge->channel));
        assert_true(gauge->line || !gauge->box);
        uint32_t id = skv_control_add_gauge(stage, gauge);
        stage_look(stage, 0);
        const skv_probe *probe = skv_stage_probe(stage, 0, id);
        skv_camera camera = skv_stage_camera(stage, 0);
        assert_non_null(probe);
        assert_string_equal(probe->def.name, skv_instrument_kind_name(gauge->kind));
        assert_true(is_inside(&camera, probe->def.x0, probe->def.y0));
        assert_true(is_inside(&camera, probe->def.x1, probe->def.y1));
        double length = hypot(probe->def.x1 - probe->def.x0, probe->def.y1 - probe->def.y0);
        assert_true(gauge->line ? length > 0.1 : length == 0);
        assert_true(!gauge->box || probe->def.y1 > probe->def.y0);
        /* The first end takes the second with it; the second goes alone. */
        double wide = probe->def.x1 - probe->def.x0, high = probe->def.y1 - probe->def.y0;
        skv_control_drag(stage, 0, id, 0, 0.3, 0.2);
        stage_look(stage, 0);
        probe = skv_stage_probe(stage, 0, id);
        assert_true(probe->def.x0 == 0.3 && probe->def.y0 == 0.2);
        assert_true(fabs(probe->def.x1 - 0.3 - wide) + fabs(probe->def.y1 - 0.2 - high) < 1e-9);
        skv_control_drag(stage, 0, id, 1, -1, 1e9);
        skv_control_drag(stage, 0, id, 1, (double)NAN, 0);
        stage_look(stage, 0);
        probe = skv_stage_probe(stage, 0, id);
        assert_true(probe->def.x0 == 0.3 && probe->def.x1 == 0);
        assert_true(fabs(probe->def.y1 - camera.world_height) < 1e-9);
        /* Out of what is seen from near it is kept at the edge. */
        skv_stage_zoom(stage, 0, 4, 800, 450);
        camera = skv_stage_camera(stage, 0);
        skv_control_drag(stage, 0, id, 0, 9, 9);
        stage_look(stage, 0);
        probe = skv_stage_probe(stage, 0, id);
        double px, py;
        skv_camera_to_view(&camera, probe->def.x0, probe->def.y0, &px, &py);
        assert_true(fabs(px - 1600) < 1e-6 && fabs(py) < 1e-6);
        skv_stage_show_all(stage);
    }
    assert_int_equal(count, 6);
    assert_null(skv_gauge_of(SKV_INSTRUMENT_ENERGY));
    skv_control_drag(stage, 0, 99, 0, 0, 0); /* there is none */
    skv_stage_destroy(stage);
}

static const skv_probe *add_gauge(skv_stage *stage, skv_instrument_kind kind)
{
    uint32_t id = skv_control_add_gauge(stage, skv_gauge_of(kind));
    stage_look(stage, 0);
    const skv_probe *probe = skv_stage_probe(stage, 0, id);
    assert_non_null(probe);
    return probe;
}

static void hover(skv_stage *stage, double x, double y)
{
    skv_camera camera = skv_stage_camera(stage, 0);
    double px, py;
    skv_camera_to_view(&camera, x, y, &px, &py);
    stage_touch(stage, SKV_PHASE_MOVE, SKV_DEVICE_MOUSE, 0, px, py, 1);
}

static bool is_at(const skv_probe *probe, double x, double y, double reach)
{
    return hypot(probe->def.x0 - x, probe->def.y0 - y) <= reach;
}

/* Instruments begin in the open, and apart from each other. */
static void expect_apart(skv_stage *stage)
{
    const skv_picture *picture = stage_look(stage, 0);
    for (int i = 0; i < picture->probe_count; i++) {
        const skv_instrument_def *one = &picture->probes[i].def;
        assert_true(skv_terrain_distance(picture->frame.terrain, (float)one->x0, (float)one->y0) >
                    0);
        for (int k = 0; k < i; k++)
            assert_false(is_at(&picture->probes[k], one->x0, one->y0, 0.03));
    }
}

/* Under the pointer while that is over the view, in the dry, too, but for a level. */
static void test_under_the_pointer(void **state)
{
    (void)state;
    skv_stage *stage = open_pool(300);
    skv_stage_set_paused(stage, true);
    hover(stage, 0.2, 0.1);
    assert_true(is_at(add_gauge(stage, SKV_INSTRUMENT_PRESSURE), 0.2, 0.1, 1e-9));
    hover(stage, 0.3, 0.8);
    assert_true(is_at(add_gauge(stage, SKV_INSTRUMENT_VELOCITY), 0.3, 0.8, 1e-9));
    hover(stage, 0.7, 0.8);
    const skv_probe *level = add_gauge(stage, SKV_INSTRUMENT_LEVEL);
    assert_true(fabs(level->def.x0 - 0.7) < 0.1 && !isnan(level->value[0]));
    /* On another, and in the floor's wall: close by. */
    hover(stage, 0.2, 0.1);
    const skv_probe *close = add_gauge(stage, SKV_INSTRUMENT_RULER);
    assert_true(is_at(close, 0.2, 0.1, 0.3) && !is_at(close, 0.2, 0.1, 0.05));
    hover(stage, 1.2, 0);
    assert_true(is_at(add_gauge(stage, SKV_INSTRUMENT_PRESSURE), 1.2, 0, 0.1));
    expect_apart(stage);
    /* Gone from the view: in the water, and in the middle, as far as there is room. */
    stage_touch(stage, SKV_PHASE_LEAVE, SKV_DEVICE_MOUSE, 0, 0, 0, 2);
    const skv_probe *middle = add_gauge(stage, SKV_INSTRUMENT_PRESSURE);
    assert_true(fabs(middle->def.x0 - 0.8) < 0.2 && middle->value[0] > 0);
    skv_stage_destroy(stage);
}

/* In every scene a new instrument reads, one after the other, and so do those of a part that is
 * seen from near. */
static void test_in_the_water(void **state)
{
    (void)state;
    const skv_scene_info *info;
    for (int i = 0; (info = skv_builtin_scene(i)); i++) {
        skv_stage *stage = stage_make(false, stage_still);
        skv_scene_options options = skv_default_scene_options();
        options.particles = 500;
        skv_stage_set_paused(stage, true);
        skv_stage_open(stage, info->name, &options);
        if (stage_look(stage, 0)->frame.particles.count < 100) /* it fills by and by */
            for (int frame = 0; frame < 120; frame++)
                skv_stage_step_once(stage);
        if (stage_look(stage, 0)->frame.particles.count == 0) { /* that begins empty */
            skv_stage_destroy(stage);
            continue;
        }
        for (int k = 0; k < 9; k++) {
            const skv_probe *probe =
                add_gauge(stage, k % 2 ? SKV_INSTRUMENT_LEVEL : SKV_INSTRUMENT_PRESSURE);
            if (isnan(probe->value[0]))
                fail_msg("%s: instrument %d reads nothing at (%g, %g)", info->name, k,
                         probe->def.x0, probe->def.y0);
        }
        expect_apart(stage);
        skv_stage_destroy(stage);
    }
    skv_stage *stage = open_pool(2000);
    skv_stage_set_paused(stage, true);
    skv_stage_zoom(stage, 0, 6, 100, 880);
    skv_camera camera = skv_stage_camera(stage, 0);
    const skv_probe *near = add_gauge(stage, SKV_INSTRUMENT_PRESSURE);
    assert_true(near->value[0] > 0);
    assert_true(is_at(near, camera.centre_x, camera.centre_y, 0.1));
    skv_stage_destroy(stage);
}

static void test_choices(void **state)
{
    (void)state;
    const skv_choice *choice;
    int count = 0;
    for (; (choice = skv_choice_at(count)); count++) {
        assert_ptr_equal(skv_choice_named(choice->name), choice);
        skv_stage *stage = open_pool(400);
        int before = stage_look(stage, 0)->frame.particles.count;
        skv_control_compare(stage, choice);
        assert_string_equal(stage_compared(stage).error.text, "");
        const skv_picture *other = stage_look(stage, 1);
        assert_int_equal(skv_stage_sides(stage), 2);
        double times = choice->particles > 0 ? choice->particles : 1;
        assert_true(fabs(other->frame.particles.count / (before * times) - 1) < 0.3);
        if (choice->path) {
            char text[64];
            skv_world_def_get(&other->parameters, choice->path, text, sizeof text, NULL);
            assert_string_equal(text, choice->value);
            assert_string_equal(choice->name, choice->value);
        }
        skv_stage_destroy(stage);
    }
    assert_int_equal(count, 8);
    assert_null(skv_choice_named("syrup"));
    assert_string_equal(skv_experiment_like("slosh"), "waves");
    assert_null(skv_experiment_like("nothing"));
}

/* A tank that begins empty takes water, and one four times as fine has it four times as often. */
static void test_an_empty_tank(void **state)
{
    (void)state;
    skv_stage *stage = stage_make(false, stage_still);
    skv_stage_set_view(stage, 0, 1600, 900);
    skv_scene_options options = skv_default_scene_options();
    options.particles = 1000;
    skv_stage_open(stage, "tank", &options);
    assert_int_equal(stage_look(stage, 0)->frame.particles.count, 0);
    skv_outcome opened;
    assert_int_equal(stage_report(stage, &opened), SKV_OK);
    skv_control_compare(stage, skv_choice_named("finer"));
    assert_string_equal(stage_compared(stage).error.text, "");
    for (int i = 0; skv_tool_info(i); i++)
        if (strcmp(skv_tool_info(i)->name, "water") == 0)
            skv_stage_set_tool(stage, i);
    skv_stage_set_brush(stage, 0.1);
    stage_point(stage, 0, SKV_PHASE_DOWN, 400, 450, 0);
    pass_frames(stage, 10);
    stage_point(stage, 0, SKV_PHASE_UP, 400, 450, 1);
    pass_frames(stage, 10);
    int coarse = stage_look(stage, 0)->frame.particles.count;
    int fine = stage_look(stage, 1)->frame.particles.count;
    assert_in_range(coarse, 20, 200);
    assert_in_range(fine, 3 * coarse, 5 * coarse);
    skv_stage_destroy(stage);
}

static void test_keys(void **state)
{
    (void)state;
    const skv_key *key, *before = NULL;
    const skv_tool *tool;
    int count = 0;
    for (; (key = skv_key_at(count)); before = key, count++) {
        assert_non_null(key->section);
        assert_true(key->title || key->action);
        for (int i = 0; i < count; i++) { /* each is there once, or is an arrow that is held */
            const skv_key *other = skv_key_at(i);
            assert_true(strcmp(other->key, key->key) != 0);
            /* Sections and rows are not torn apart. */
            assert_true(strcmp(other->section, key->section) != 0 || !before ||
                        strcmp(before->section, key->section) == 0);
            assert_true(!other->title || !key->title || strcmp(other->title, key->title) != 0 ||
                        (before->title && strcmp(before->title, key->title) == 0) ||
                        strcmp(other->section, key->section) != 0);
        }
        for (int i = 0; (tool = skv_tool_info(i)); i++)
            assert_true(key->key[0] != tool->key || key->key[1]);
    }
    assert_true(count > 40);
    assert_null(skv_key_at(-1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_refusals),      cmocka_unit_test(test_speeds),
        cmocka_unit_test(test_going),         cmocka_unit_test(test_amounts),
        cmocka_unit_test(test_time),          cmocka_unit_test(test_planets_and_tools),
        cmocka_unit_test(test_gauges),        cmocka_unit_test(test_under_the_pointer),
        cmocka_unit_test(test_in_the_water),  cmocka_unit_test(test_choices),
        cmocka_unit_test(test_an_empty_tank), cmocka_unit_test(test_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
