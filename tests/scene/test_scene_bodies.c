/* Bodies in a scene: each kind of shape arrives in its worlds, and what is no body is refused with
 * its place and a remedy; how much of a body is under water; and how bodies look. */
#include "skvalp/skvalp.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SCENE                                                                                      \
    "{\n\"particles\": 800, \"world\": {\"height\": 0.6},\n"                                       \
    "\"water\": [{\"shape\": \"box\", \"y1\": 0.3}],\n"                                            \
    "\"bodies\": [{\"name\": \"box\", \"shape\": \"box\", \"x0\": 0.2, \"y0\": 0.26, \"x1\": "     \
    "0.5, "                                                                                        \
    "\"y1\": 0.36, \"angle\": 0.1},\n"                                                             \
    "{\"shape\": \"circle\", \"x\": 0.8, \"y\": 0.5, \"radius\": 0.06, \"material\": \"cork\", "   \
    "\"vy\": -1, \"spin\": 2},\n"                                                                  \
    "{\"name\": \"w\xc3\xa4gg\", \"shape\": \"polygon\", \"points\": [[1.0, 0.1], [1.2, 0.1], "    \
    "[1.1, "                                                                                       \
    "0.2]], \"density\": 3000, \"fixed\": true},\n"                                                \
    "{\"shape\": \"line\", \"points\": [[1.3, 0.4], [1.5, 0.4]], \"thickness\": 0.08, "            \
    "\"friction\": 1, \"restitution\": 0}]}"

static skv_scene *load(void)
{
    skv_scene *scene;
    skv_error error = {0};
    if (load_text(SCENE, NULL, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return scene;
}

static skv_world *create(const skv_scene *scene)
{
    skv_world *world;
    skv_error error = {0};
    if (skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return world;
}

static void bodies_arrive(void **unused)
{
    (void)unused;
    skv_scene *scene = load();
    skv_world *world = create(scene);
    assert_int_equal(skv_scene_body_count(scene), 4);
    assert_string_equal(skv_scene_body_name(scene, 0), "box");
    assert_string_equal(skv_scene_body_name(scene, 1), "body 2");
    assert_string_equal(skv_scene_body_name(scene, 2), "w\xc3\xa4gg");
    assert_null(skv_scene_body_name(scene, 4));
    skv_body b[4];
    for (int i = 0; i < 4; i++) {
        assert_true(skv_world_body_at(world, i, &b[i]));
        assert_int_equal(b[i].id, i + 1);
    }
    skv_body none;
    assert_false(skv_world_body_at(world, 4, &none));
    assert_true(fabsf(b[0].x - 0.35f) < 1e-6f && fabsf(b[0].y - 0.31f) < 1e-6f);
    assert_true(b[0].angle == 0.1f && b[0].density == 500 && !b[0].fixed);
    assert_true(fabsf(b[1].y - 0.5f) < 1e-6f && b[1].vy == -1 && b[1].spin == 2);
    assert_true(b[1].density == 240);
    assert_true(b[2].fixed && b[2].density == 3000 && fabsf(b[2].area - 0.01f) < 1e-6f);
    assert_true(fabsf(b[3].area - (0.2f * 0.08f + 3.14159265f * 0.0016f)) < 1e-4f);
    assert_true(b[3].friction == 1 && b[3].restitution == 0);
    /* No water is left inside. */
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++)
        assert_false(p.y[i] > 0.11f && p.y[i] < 0.19f &&
                     fabsf(p.x[i] - 1.1f) < 0.95f * (0.2f - p.y[i]));
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

static skv_body pinned(const char *const *settings)
{
    skv_scene *scene;
    skv_error error = {0};
    if (load_text(SCENE, settings, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_world *world = create(scene);
    skv_body body;
    assert_true(skv_world_body_at(world, 0, &body));
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    return body;
}

/* A pin stays where it is said, and the body is turned about it. */
static void pins_and_motors_arrive(void **unused)
{
    (void)unused;
    skv_body body = pinned((const char *[]){"bodies[0].pin[0]", "0.5", "bodies[0].pin[1]", "0.31",
                                            "bodies[0].motor.speed", "-3", "bodies[0].motor.torque",
                                            "20", NULL});
    assert_true(body.pinned && body.pin_x == 0.5f && body.pin_y == 0.31f);
    assert_true(body.motor_speed == -3 && body.motor_torque == 20 && body.angle == 0.1f);
    assert_true(fabsf(body.x - (0.5f - 0.15f * cosf(0.1f))) < 1e-6f);
    assert_true(fabsf(body.y - (0.31f - 0.15f * sinf(0.1f))) < 1e-6f);
    body = pinned((const char *[]){"bodies[0].motor.torque", "0", NULL});
    assert_true(!body.pinned && body.motor_torque == 0);

    /* And as a file has them. */
    skv_scene *scene;
    skv_error error = {0};
    const char *text = "{\"water\": [], \"bodies\": [{\"shape\": \"circle\", \"x\": 0.4, \"y\": "
                       "0.4, \"radius\": 0.1, \"pin\": [0.4, 0.45], \"motor\": {\"speed\": 2, "
                       "\"torque\": 1}}]}";
    if (load_text(text, NULL, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_world *world = create(scene);
    assert_true(skv_world_body_at(world, 0, &body));
    assert_true(body.pin_x == 0.4f && body.pin_y == 0.45f && body.motor_torque == 1);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

/* The box floats half under water, the fixed one lies below, and the line is in the air. */
static void what_is_under_water_is_told(void **unused)
{
    (void)unused;
    skv_scene *scene = load();
    skv_world *world = create(scene);
    skv_survey *survey;
    skv_body body;
    assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
    assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
    assert_true(skv_world_body_at(world, 2, &body));
    assert_true(skv_survey_submerged(survey, &body) == 1);
    assert_true(skv_world_body_at(world, 3, &body));
    assert_true(skv_survey_submerged(survey, &body) == 0);
    for (int f = 0; f < 240; f++)
        assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
    assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
    assert_true(skv_world_body_at(world, 0, &body));
    assert_true(fabs(skv_survey_submerged(survey, &body) - 0.5) < 0.15);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

/* ---- Painted --------------------------------------------------------------------------------- */

/* 200 x 120 pixels of 8 mm: a disc in the air, a slanting plank, a ring, a box in the water at its
 * surface, and a speck. `user`: how far apart brown boxes lie over all of it instead; or a spiral.
 */
static rgb paint_wood(int x, int y, void *user)
{
    const rgb brown = {139, 69, 19}, orange = {255, 140, 0}, water = {0, 0, 255};
    int apart = *(const int *)user;
    if (apart > 0)
        return x % apart < 8 && y % apart < 8 ? brown : (rgb){0, 0, 0};
    double ring = hypot(x - 149.5, y - 29.5), along = (x - 89.5) + (y - 29.5),
           across = x - 89.5 - (y - 29.5);
    if (hypot(x - 29.5, y - 29.5) < 20 || (fabs(along) < 40 && fabs(across) < 8))
        return brown;
    if ((ring > 8 && ring < 20) || (x >= 30 && x < 70 && y >= 70 && y < 90))
        return orange;
    if (x >= 120 && x < 123 && y >= 100 && y < 103)
        return brown;
    return y >= 80 ? water : (rgb){0, 0, 0};
}

static skv_result load_wood(int apart, int particles, skv_scene **scene, skv_error *error)
{
    buffer picture = write_rgb(200, 120, paint_wood, &apart);
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_result result = skv_scene_load_memory(picture.data, picture.size, "png", "wood.png",
                                              &options, scene, error);
    buffer_free(&picture);
    return result;
}

/* Each area is a body of wood where it is painted, and as large; what is smaller than a particle is
 * left out. */
static void brown_areas_are_bodies(void **unused)
{
    (void)unused;
    const struct {
        double x, y, area; /* pixels */
        int most;          /* corners */
    } areas[] = {{90, 90, 593, 12}, {30, 90, 1257, 40}, {150, 90, 1257, 40}, {50, 40, 800, 4}};
    skv_scene *scene;
    skv_error error = {0};
    if (load_wood(0, 200, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_world *world = create(scene);
    assert_int_equal(skv_scene_body_count(scene), 4);
    assert_int_equal(skv_world_body_count(world), 4);
    for (int i = 0; i < 4; i++) {
        skv_body body;
        assert_true(skv_world_body_at(world, i, &body));
        assert_true(body.density == 500 && !body.fixed && !body.pinned && body.angle == 0);
        assert_true(fabs((double)body.x / 0.008 - areas[i].x) < 0.5);
        assert_true(fabs((double)body.y / 0.008 - areas[i].y) < 0.5);
        assert_true(fabs((double)body.area / 0.008 / 0.008 - areas[i].area) < 0.01 * areas[i].area);
        assert_in_range(body.corners, 4, areas[i].most);
    }
    assert_string_equal(skv_scene_body_name(scene, 3), "body 4");
    assert_string_equal(skv_scene_notice(scene, 0),
                        "the brown area at pixel (146, 10) has holes, which its body fills");
    assert_string_equal(skv_scene_notice(scene, 1),
                        "brown areas smaller than a particle are left out: 1");
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

static void too_many_brown_areas_are_refused(void **unused)
{
    (void)unused;
    skv_scene *scene;
    skv_error error = {0};
    assert_int_equal(load_wood(12, 200, &scene, &error), SKV_ERROR_LIMIT);
    assert_string_equal(error.text,
                        "wood.png: there are more than 64 brown areas and other bodies; "
                        "paint fewer, or join some");
    assert_null(scene);
    assert_int_equal(load_wood(12, 100, &scene, &error), SKV_OK);
    assert_int_equal(skv_scene_body_count(scene), 0);
    assert_string_equal(skv_scene_notice(scene, 1),
                        "brown areas smaller than a particle are left out: 170");
    skv_scene_destroy(scene);
}

static void expect_refused(const char *path, const char *value, const char *message)
{
    const char *const settings[] = {path, value, NULL};
    skv_scene *scene;
    skv_error error = {0};
    skv_result result = load_text(SCENE, settings, &scene, &error);
    assert_true(result == SKV_ERROR_VALUE || result == SKV_ERROR_LIMIT);
    assert_string_equal(error.text, message);
    assert_null(scene);
}

static void what_is_no_body_is_refused(void **unused)
{
    (void)unused;
    expect_refused(
        "bodies[0].density", "9",
        "--set bodies[0].density: 9 is out of range; allowed is a number from 10 to 50000 "
        "kg/m^2");
    expect_refused(
        "bodies[1].material", "gold",
        "--set bodies[1].material: \"gold\" is not known; allowed is cork, wood, ice, brick "
        "or steel");
    expect_refused("bodies[1].radius", "0.001",
                   "a.json:5: bodies[1]: its shape has 3.14159e-06 m^2; the least is a particle's, "
                   "0.000599996 m^2");
    expect_refused("bodies[3].points[2][0]", "1",
                   "--set bodies[3].points: a point lacks a value; a point is a pair [x, y]");
    expect_refused("bodies[0].x1", "0.1",
                   "--set bodies[0].x1: the box is empty; x0 must be smaller than x1");
    expect_refused("bodies[5].name", "x",
                   "--set bodies[5].name: there is no bodies[5]; the next free one is bodies[4]");
    expect_refused("bodies[0].pin[0]", "0.4",
                   "a.json:4: bodies[0].pin: lacks a value; a pin is a pair [x, y]");
    expect_refused("bodies[0].pin[2]", "0.4",
                   "--set bodies[0].pin[2]: one value too many; a pin is a pair [x, y]");
    expect_refused("bodies[0].pin[0]", "101",
                   "--set bodies[0].pin[0]: 101 is out of range; allowed is a number from -100 to "
                   "100 m");
    expect_refused("bodies[0].pin", "1",
                   "--set bodies[0].pin: holds several values; set one of them");
    expect_refused("bodies[0].motor.speed", "2",
                   "a.json:4: bodies[0].motor: lacks its torque; a motor has speed and torque");
    expect_refused("bodies[0].motor.torque", "2",
                   "a.json:4: bodies[0].motor: turns nothing; it takes a pin, and a body that is "
                   "not fixed");
    expect_refused("bodies[0].motor.power", "2",
                   "--set bodies[0].motor.power: unknown field; allowed are speed, torque");
}

/* A hollow counts neither as body nor as what is under water: a bell full of air and a boat, up to
 * their middle in water, and a wall as deep in it as they; a ball at the wall. */
static void a_hollow_is_no_body(void **unused)
{
    (void)unused;
    static const struct {
        const char *shape;
        double share;
    } cases[] = {
        /* Walls of 0.1 m, 0.5 m high, and a roof; the water stands outside as high as 0.4 m. */
        {"{\"shape\":\"polygon\",\"points\":[[0.5,0.15],[0.6,0.15],[0.6,0.55],[1,0.55],[1,0.15],[1."
         "1,"
         "0.15],[1.1,0.65],[0.5,0.65]]}",
         2 * 0.1 * 0.25 / (2 * 0.1 * 0.5 + 0.4 * 0.1)},
        /* The same the other way up: a floor, and no water in it. */
        {"{\"shape\":\"polygon\",\"points\":[[0.5,0.65],[0.5,0.15],[1.1,0.15],[1.1,0.65],[1,0.65],["
         "1,"
         "0.25],[0.6,0.25],[0.6,0.65]]}",
         (2 * 0.1 * 0.25 + 0.4 * 0.1) / (2 * 0.1 * 0.5 + 0.4 * 0.1)},
        {"{\"shape\":\"box\",\"x0\":0.75,\"x1\":0.85,\"y0\":0.15,\"y1\":0.65}", 0.5},
        /* At a wall, on the floor. */
        {"{\"shape\":\"circle\",\"x\":1.54,\"y\":0.06,\"radius\":0.06}", 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "{\"particles\":3000,\"settle\":false,\"water\":[{\"shape\":\"box\",\"x1\":0.6,"
                 "\"y1\":0.4},"
                 "{\"shape\":\"box\",\"x0\":1,\"y1\":0.4},{\"shape\":\"box\",\"x0\":0.6,\"x1\":1,"
                 "\"y1\":%s}],\"bodies\":[%s]}",
                 i >= 2 ? "0.4" : "0.15", cases[i].shape);
        skv_world *world = open_text(text);
        skv_survey *survey;
        skv_body body;
        assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
        assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
        assert_true(skv_world_body_at(world, 0, &body));
        double share = skv_survey_submerged(survey, &body);
        if (fabs(share - cases[i].share) > 0.05)
            fail_msg("%zu: %.3f instead of %.3f", i, share, cases[i].share);
        skv_survey_destroy(survey);
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_arrive),
        cmocka_unit_test(pins_and_motors_arrive),
        cmocka_unit_test(what_is_under_water_is_told),
        cmocka_unit_test(a_hollow_is_no_body),
        cmocka_unit_test(brown_areas_are_bodies),
        cmocka_unit_test(too_many_brown_areas_are_refused),
        cmocka_unit_test(what_is_no_body_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
