/* The JSON reader and the builder: every mistake has its one line, every value its effect. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "support/comma_locale.h"
#include <skvalp/acting.h>
#include <skvalp/query.h>

#define WATER "\"water\": [{\"shape\": \"box\", \"y1\": 0.3}]"

typedef struct mistake {
    const char *text;
    skv_result code;
    const char *message;
} mistake;

static const mistake mistakes[] = {
    /* Not a scene at all. */
    {"", SKV_ERROR_FORMAT, "a.json: is empty; a scene is { \"water\": [ ... ] }"},
    {" \n ", SKV_ERROR_FORMAT,
     "a.json:2: is not JSON: it ends too early; is a \", } or ] missing?"},
    {"{\"name\": \"a\\u0000b\"}", SKV_ERROR_FORMAT,
     "a.json:1: name: holds the character \\u0000, which no text may have; take it out"},
    {"{\"na\\u0000me\": 1}", SKV_ERROR_FORMAT,
     "a.json:1: na\\u0000me: holds the character \\u0000, which no text may have; take it out"},
    {"hello", SKV_ERROR_FORMAT,
     "a.json:1: is not JSON: '[' or '{' expected near 'hello'; look for a missing quote, comma or "
     "bracket"},
    {"[1, 2]", SKV_ERROR_VALUE,
     "a.json:1: a list is not an object; allowed is { \"name\": value, ... }"},
    {"{" WATER, SKV_ERROR_FORMAT,
     "a.json:1: is not JSON: it ends too early; is a \", } or ] missing?"},
    {"{" WATER "}\nx", SKV_ERROR_FORMAT,
     "a.json:2: is not JSON: something follows the last }; take it out"},
    {"{\"title\": \"\xff\"}", SKV_ERROR_FORMAT,
     "a.json:1: is not UTF-8 text; save the file as UTF-8"},

    /* Unknown keys. */
    {"{\n\"fluid\": {\n\"spaceing\": 0.01}}", SKV_ERROR_VALUE,
     "a.json:3: fluid.spaceing: unknown field; did you mean fluid.spacing?"},
    {"{\"spacing\": 0.01}", SKV_ERROR_VALUE,
     "a.json:1: spacing: unknown field; did you mean fluid.spacing?"},
    {"{\"wordl\": {}}", SKV_ERROR_VALUE, "a.json:1: wordl: unknown field; did you mean world?"},
    {"{\"gravity\": {\"zebra\": 1}}", SKV_ERROR_VALUE,
     "a.json:1: gravity.zebra: unknown field; allowed are x, y"},
    {"{\"zebra\": 1}", SKV_ERROR_VALUE,
     "a.json:1: zebra: unknown field; allowed are name, title, description, seconds, world, "
     "settle, particles, substeps, sleep, depth, gravity, emission, fluid, fluids, solid, water, "
     "forces, emitters, drains, bodies, air"},
    {"{\"fluid.law\": \"clavet\"}", SKV_ERROR_VALUE,
     "a.json:1: \"fluid.law\": unknown field; a key is one word, a group is { ... }"},
    {"{\"water[0]\": {}}", SKV_ERROR_VALUE,
     "a.json:1: \"water[0]\": unknown field; a key is one word, a group is { ... }"},
    {"{\"\": 1}", SKV_ERROR_VALUE,
     "a.json:1: \"\": unknown field; a key is one word, a group is { ... }"},

    /* Wrong types. */
    {"{\"seconds\": \"long\"}", SKV_ERROR_VALUE,
     "a.json:1: seconds: \"long\" is not a number; allowed is a number from 0.1 to 3600 s"},
    {"{\"particles\": null}", SKV_ERROR_VALUE,
     "a.json:1: particles: null is not a number; allowed is a whole number from 1 to 2000000"},
    {"{\"particles\": 2.5}", SKV_ERROR_VALUE,
     "a.json:1: particles: 2.5 is not a whole number; allowed is a whole number from 1 to 2000000"},
    {"{\"particles\": [1]}", SKV_ERROR_VALUE,
     "a.json:1: particles: a list is not a number; allowed is a whole number from 1 to 2000000"},
    {"{\"title\": 3}", SKV_ERROR_VALUE,
     "a.json:1: title: 3 is not text; allowed is text of at most 100 bytes"},
    {"{\"title\": \"two\\nlines\"}", SKV_ERROR_VALUE,
     "a.json:1: title: \"two?lines\" holds a control character; allowed is text of at most 100 "
     "bytes"},
    {"{\"title\": \"rub\x7f out\"}", SKV_ERROR_VALUE,
     "a.json:1: title: \"rub? out\" holds a control character; allowed is text of at most 100 "
     "bytes"},
    {"{\"title\": \"\xc2\x9b\"}", SKV_ERROR_VALUE,
     "a.json:1: title: \"?\" holds a control character; allowed is text of at most 100 bytes"},
    {"{\"name\": \"\\u009b2J\"}", SKV_ERROR_VALUE,
     "a.json:1: name: \"?2J\" holds a control character; allowed is text of at most 64 bytes"},
    {"{\"description\": \"\\u202e\"}", SKV_ERROR_VALUE,
     "a.json:1: description: \"?\" holds a control character; allowed is text of at most 1000 "
     "bytes"},
    {"{\"\\u202e\": 1}", SKV_ERROR_VALUE,
     "a.json:1: ?: unknown field; allowed are name, title, description, seconds, world, "
     "settle, particles, substeps, sleep, depth, gravity, emission, fluid, fluids, solid, water, "
     "forces, emitters, drains, bodies, air"},
    {"{\"seconds\": \"\"}", SKV_ERROR_VALUE,
     "a.json:1: seconds: it is empty; allowed is a number from 0.1 to 3600 s"},
    {"{\"world\": {\"open\": {\"left\": 1}}}", SKV_ERROR_VALUE,
     "a.json:1: world.open.left: 1 is not true or false; allowed is true or false"},
    {"{\"fluid\": 3}", SKV_ERROR_VALUE,
     "a.json:1: fluid: 3 is not an object; allowed is { \"name\": value, ... }"},
    {"{\"water\": {\"shape\": \"box\"}}", SKV_ERROR_VALUE,
     "a.json:1: water: an object is not a list; allowed is [ ... ]"},
    {"{\"water\": [[1]]}", SKV_ERROR_VALUE,
     "a.json:1: water[0]: a list is not an object; allowed is { \"name\": value, ... }"},

    /* Out of range. */
    {"{\"fluid\": {\n\n\"spacing\": 0.5}}", SKV_ERROR_VALUE,
     "a.json:3: fluid.spacing: 0.5 is out of range; allowed is a number from 0.0005 to 0.1 m"},
    {"{\"air\": {\"pressure\": 101}}", SKV_ERROR_VALUE,
     "a.json:1: air.pressure: 101 is out of range; allowed is a number from 0 to 100 kPa m"},
    {"{\"air\": 10}", SKV_ERROR_VALUE,
     "a.json:1: air: 10 is not an object; allowed is { \"name\": value, ... }"},
    {"{\"gravity\": {\"y\": -1000.5}}", SKV_ERROR_VALUE,
     "a.json:1: gravity.y: -1000.5 is out of range; allowed is a number from -1000 to 1000 m/s^2"},
    {"{\"particles\": 2000001}", SKV_ERROR_LIMIT,
     "a.json:1: particles: 2000001 is out of range; allowed is a whole number from 1 to 2000000"},
    {"{\"particles\": 0}", SKV_ERROR_VALUE,
     "a.json:1: particles: 0 is out of range; allowed is a whole number from 1 to 2000000"},
    {"{\"fluid\": {\"law\": \"clavat\"}}", SKV_ERROR_VALUE,
     "a.json:1: fluid.law: \"clavat\" is not known; allowed is calibrated or clavet"},
    {"{\"name\": \"01234567890123456789012345678901234567890123456789012345678901234\"}",
     SKV_ERROR_VALUE,
     "a.json:1: name: \"0123456789012345678901234567890123456789...\" is too long; allowed is text "
     "of at most 64 bytes"},

    /* Numbers that are none. */
    {"{\"fluid\": {\"density\":\nNaN}}", SKV_ERROR_FORMAT,
     "a.json:2: fluid.density: is not a finite number; allowed is a number from 1 to 20000 kg/m^2"},
    {"{\"gravity\": {\"y\": -Infinity}}", SKV_ERROR_FORMAT,
     "a.json:1: gravity.y: is not a finite number; allowed is a number from -1000 to 1000 m/s^2"},
    {"{\"seconds\": Infinity}", SKV_ERROR_FORMAT,
     "a.json:1: seconds: is not a finite number; allowed is a number from 0.1 to 3600 s"},
    {"{\"seconds\": 1e999}", SKV_ERROR_VALUE,
     "a.json:1: seconds: the number is too large; allowed is a number from 0.1 to 3600 s"},
    {"{\"particles\": 99999999999999999999}", SKV_ERROR_VALUE,
     "a.json:1: particles: the number is too large; allowed is a whole number from 1 to 2000000"},
    {"{\"water\": [{\"shape\": \"box\", \"y1\": 0.2},\n{\"x0\": 1e400}]}", SKV_ERROR_VALUE,
     "a.json:2: water[1].x0: the number is too large; allowed is a number from -100 to 100 m"},

    /* Twice. */
    {"{\"seconds\": 1,\n\"seconds\": 2}", SKV_ERROR_FORMAT,
     "a.json:2: seconds: is given twice; allowed is once"},
    {"{\"fluid\": {\"density\": 1,\n\"density\": 2}}", SKV_ERROR_FORMAT,
     "a.json:2: fluid.density: is given twice; allowed is once"},

    /* Shapes. */
    {"{\"water\": [{\"shape\": \"bax\"}]}", SKV_ERROR_VALUE,
     "a.json:1: water[0].shape: \"bax\" is not known; allowed is box, circle, polygon or line"},
    {"{\"water\": [\n{\"y1\": 1}]}", SKV_ERROR_VALUE,
     "a.json:2: water[0].shape: is missing; allowed is box, circle, polygon or line"},
    {"{\"water\": [{\"shape\": \"circle\", \"x\": 1,\n\"y\": 1}]}", SKV_ERROR_VALUE,
     "a.json:1: water[0].radius: is missing; a circle needs it"},
    {"{\"water\": [{\"shape\": \"circle\",\n\"x0\": 1, \"x\": 1, \"y\": 1, \"radius\": 1}]}",
     SKV_ERROR_VALUE, "a.json:2: water[0].x0: does not belong to a circle; it has x, y and radius"},
    {"{\"solid\": [{\"shape\": \"box\", \"points\":\n[[1, 2]]}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:2: solid[0].points: does not belong to a box; it has x0, y0, x1 and y1"},
    {"{\"solid\": [{\"shape\": \"polygon\", \"points\": [[1, 2], [2, 3]]}], " WATER "}",
     SKV_ERROR_VALUE, "a.json:1: solid[0].points: a polygon needs at least 3 points"},
    {"{\"solid\": [{\"shape\": \"polygon\"}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:1: solid[0].points: is missing; a polygon needs it"},
    {"{\"solid\": [{\"shape\": \"line\", \"points\": [[1, 2]]}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:1: solid[0].points: a line needs at least 2 points"},
    {"{\"solid\": [{\"shape\": \"line\", \"points\": [[1, 2], [3]]}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:1: solid[0].points: a point lacks a value; a point is a pair [x, y]"},
    {"{\"solid\": [{\"shape\": \"line\", \"points\": [[1,\n2, 3]]}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:2: solid[0].points[0][2]: one value too many; a point is a pair [x, y]"},
    {"{\"solid\": [{\"shape\": \"line\", \"points\": [1, 2]}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:1: solid[0].points[0]: 1 is not a list; allowed is [ ... ]"},
    {"{\"water\": [{\"shape\": \"box\", \"x0\": 1,\n\"x1\": 0.5}]}", SKV_ERROR_VALUE,
     "a.json:2: water[0].x1: the box is empty; x0 must be smaller than x1"},
    {"{\"water\": [{\"shape\": \"box\", \"y0\": 2}]}", SKV_ERROR_VALUE,
     "a.json:1: water[0].y0: the box is empty; y0 must be smaller than y1"},
    {"{\"water\": [{\"shape\": \"box\", \"carve\": true}]}", SKV_ERROR_VALUE,
     "a.json:1: water[0].carve: unknown field; did you mean solid[].carve?"},

    /* What concerns the whole. */
    {"{}", SKV_ERROR_VALUE,
     "a.json: water: is missing; say where the fluid starts, such as [ { \"shape\": \"box\", "
     "\"y1\": 0.45 } ]"},
    {"{\"water\": [\n{\"shape\": \"box\", \"x0\": 2, \"x1\": 3}]}", SKV_ERROR_VALUE,
     "a.json:2: water[0]: lies outside the world; it reaches from 0, 0 to 1.6, 0.9 m"},
    {"{\"emitters\": [\n{\"x\": -0.01, \"y\": 0.5, \"vx\": 1}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:2: emitters[0]: lies outside the world; it reaches from 0, 0 to 1.6, 0.9 m"},
    {"{\"solid\": [\n{\"shape\": \"box\"}], " WATER "}", SKV_ERROR_VALUE,
     "a.json:2: solid: fills the whole world; leave some air"},
    {"{\"solid\": [{\"shape\": \"box\", \"y1\": 0.5}],\n" WATER "}", SKV_ERROR_VALUE,
     "a.json:2: water: has no room for a particle; it lies in solid or is too small"},
    {"{\"particles\": 100, \"fluid\": {\"spacing\": 0.01}, " WATER "}", SKV_ERROR_VALUE,
     "a.json:1: particles: follows from fluid.spacing; give only one of them"},
    {"{\"world\": {\"width\": 16, \"height\": 16,\n\"pixel\": 0.1}, \"fluid\": {\"spacing\": "
     "0.0005}, \"water\": [{\"shape\": \"box\", \"y1\": 1}]}",
     SKV_ERROR_LIMIT, NULL},
    {"{\"particles\": 3, \"world\": {\"width\": 16, \"height\": 9, \"pixel\": 0.1},\n" WATER "}",
     SKV_ERROR_VALUE, NULL},
    {"{\"world\": {\"pixel\": 0.0001}, " WATER "}", SKV_ERROR_VALUE,
     "a.json:1: world.pixel: makes the world 16000 x 9000 pixels; allowed are 16 to 8192 each way; "
     "0.000196 m would do"},
    {"{\"world\": {\"width\": 0.02}, " WATER "}", SKV_ERROR_VALUE,
     "a.json: world.pixel: makes the world 8 x 360 pixels; allowed are 16 to 8192 each way; "
     "0.00125 m would do"},
    {"{\"world\": {\"width\": 0.01, \"height\": 16}, " WATER "}", SKV_ERROR_VALUE,
     "a.json: world.pixel: makes the world 4 x 6400 pixels; allowed are 16 to 8192 each way; the "
     "sides are too unequal for any pixel"},
    {"{\"world\": {\"picture\": \"x.png\"}, " WATER "}", SKV_ERROR_VALUE,
     "a.json:1: world.picture: \"x.png\" needs a scene in a file; a picture is looked for in its "
     "folder"},
};

static void test_every_mistake_has_its_line(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof mistakes / sizeof mistakes[0]; i++) {
        const mistake *m = &mistakes[i];
        skv_error error = {0};
        skv_scene *scene = (skv_scene *)&error;
        skv_result result = load_text(m->text, NULL, &scene, &error);
        if (m->message != NULL)
            assert_string_equal(error.text, m->message);
        if (result != m->code)
            fail_msg("%s: %s", m->text, error.text);
        assert_int_equal(error.code, m->code);
        assert_null(scene);
    }
}

/* Whether a scene takes a number of particles; reads the range from the message if not. */
static bool takes(const char *format, int particles, int *fewest, int *most)
{
    char text[400];
    skv_scene *scene;
    skv_error error;
    snprintf(text, sizeof text, format, particles);
    if (load_text(text, NULL, &scene, &error) == SKV_OK) {
        assert_int_equal(skv_scene_particles(scene), particles);
        skv_scene_destroy(scene);
        return true;
    }
    const char *allowed = strstr(error.text, "allowed are ");
    assert_non_null(allowed);
    assert_int_equal(sscanf(allowed, "allowed are %d to %d", fewest, most), 2);
    return false;
}

/* The range that a message names is the whole truth: both ends are taken, and what lies beyond them
 * is refused with the same range. */
static void test_numbers_of_particles_name_what_fits(void **state)
{
    (void)state;
    const char *const scenes[] = {
        "{\"particles\": %d, \"water\": [{\"shape\": \"circle\", \"x\": 1, \"y\": 0.5, "
        "\"radius\": 0.004}]}",
        "{\"particles\": %d, \"world\": {\"width\": 0.4, \"height\": 0.3}, " WATER "}",
        "{\"particles\": %d, \"world\": {\"width\": 4, \"height\": 4, \"pixel\": 0.1}, " WATER "}",
    };
    for (int i = 0; i < 3; i++) {
        int fewest = 0, most = 0, again_fewest, again_most;
        assert_false(takes(scenes[i], i < 2 ? SKV_MAX_PARTICLES : 1, &fewest, &most));
        assert_true(fewest >= 1 && fewest < most && most <= SKV_MAX_PARTICLES);
        assert_true(takes(scenes[i], fewest, &again_fewest, &again_most));
        if (i < 2)
            assert_true(takes(scenes[i], most, &again_fewest, &again_most));
        if (fewest > 1) {
            assert_false(takes(scenes[i], fewest - 1, &again_fewest, &again_most));
            assert_true(again_fewest == fewest && again_most == most);
        }
        if (most < SKV_MAX_PARTICLES)
            assert_false(takes(scenes[i], most + 1, &again_fewest, &again_most));
    }
}

static void test_deep_nesting(void **state)
{
    (void)state;
    for (int open = 0; open < 2; open++) {
        char *text = calloc(60001, 1);
        for (int i = 0; i < 10000; i++)
            strcat(text + i * (open ? 1 : 5), open ? "[" : "{\"a\":");
        skv_scene *scene;
        skv_error error;
        assert_int_equal(load_text(text, NULL, &scene, &error), SKV_ERROR_FORMAT);
        assert_string_equal(error.text, "a.json:1: is nested too deeply for a scene");
        free(text);
    }
}

static void test_limits_of_lists(void **state)
{
    (void)state;
    char *text = calloc(1000000, 1);
    size_t at = (size_t)sprintf(text, "{" WATER ", \"solid\": [");
    for (int i = 0; i < 300; i++)
        at += (size_t)sprintf(text + at, "%s\n{\"shape\": \"box\", \"x1\": 0.1}", i ? "," : "");
    sprintf(text + at, "]}");
    skv_scene *scene;
    skv_error error;
    assert_int_equal(load_text(text, NULL, &scene, &error), SKV_ERROR_LIMIT);
    assert_string_equal(error.text, "a.json:258: solid[256]: too many; allowed are 256");

    at = (size_t)sprintf(text, "{" WATER ", \"solid\": [{\"shape\": \"line\", \"points\": [");
    for (int i = 0; i < 1100; i++)
        at += (size_t)sprintf(text + at, "%s\n[0.5, 0.5]", i ? "," : "");
    sprintf(text + at, "]}]}");
    assert_int_equal(load_text(text, NULL, &scene, &error), SKV_ERROR_LIMIT);
    assert_string_equal(error.text, "a.json:1002: solid[0].points[1000]: too many points; allowed "
                                    "are 1000 in a shape and 10000 in all");

    memset(text, ' ', 999999);
    char *large = malloc(5 << 20);
    memset(large, ' ', 5 << 20);
    assert_int_equal(skv_scene_load_memory(large, 5 << 20, "json", "a.json", NULL, &scene, &error),
                     SKV_ERROR_LIMIT);
    assert_string_equal(error.text, "a.json: 5242880 bytes are too many; allowed are 4194304");
    free(large);
    free(text);
}

static void test_settings(void **state)
{
    (void)state;
    const struct {
        const char *path, *value;
        skv_result code;
        const char *message;
    } cases[] = {
        {"fluid.law", "clavat", SKV_ERROR_VALUE,
         "--set fluid.law: \"clavat\" is not known; allowed is calibrated or clavet"},
        {"fluid.low", "clavet", SKV_ERROR_VALUE,
         "--set fluid.low: unknown field; did you mean fluid.law?"},
        {"fluid", "3", SKV_ERROR_VALUE, "--set fluid: holds several values; set one of them"},
        {"seconds", "1,5", SKV_ERROR_VALUE,
         "--set seconds: \"1,5\" is not a number; allowed is a number from 0.1 to 3600 s"},
        {"seconds", "", SKV_ERROR_VALUE,
         "--set seconds: it is empty; allowed is a number from 0.1 to 3600 s"},
        {"world.open.top", "", SKV_ERROR_VALUE,
         "--set world.open.top: it is empty; allowed is true or false"},
        {"title", "\x9b", SKV_ERROR_VALUE,
         "--set title: \"?\" is not UTF-8; allowed is text of at most 100 bytes"},
        {"seconds", "nan", SKV_ERROR_VALUE,
         "--set seconds: \"nan\" is not a number; allowed is a number from 0.1 to 3600 s"},
        {"particles", "3000000", SKV_ERROR_LIMIT,
         "--set particles: 3000000 is out of range; allowed is a whole number from 1 to 2000000"},
        {"world.open.top", "yes", SKV_ERROR_VALUE,
         "--set world.open.top: \"yes\" is not true or false; allowed is true or false"},
        {"water[2].x0", "1", SKV_ERROR_VALUE,
         "--set water[2].x0: there is no water[2]; the next free one is water[1]"},
        {"water[0].radius", "1", SKV_ERROR_VALUE,
         "--set water[0].radius: does not belong to a box; it has x0, y0, x1 and y1"},
        {"water[0].points[3][0]", "1", SKV_ERROR_VALUE,
         "--set water[0].points[3][0]: there is no point 3; the next free one is 0"},
        {"world.picture", "x.png", SKV_ERROR_VALUE,
         "--set world.picture: \"x.png\" needs a scene in a file; a picture is looked for in its "
         "folder"},
        {"world.pixel", "0.1", SKV_ERROR_VALUE,
         "--set world.pixel: makes the world 16 x 9 pixels; allowed are 16 to 8192 each way; "
         "0.0562 m would do"},
        {"particles", "1e3", SKV_OK, NULL},
        {"world.open.top", "true", SKV_OK, NULL},
        {"water[0].y1", "0.25", SKV_OK, NULL},
        {"fluid.spacing", "0.02", SKV_OK, NULL},
        {"title", "Any text = allowed", SKV_OK, NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *settings[] = {cases[i].path, cases[i].value, NULL};
        skv_scene *scene;
        skv_error error = {0};
        skv_result result = load_text("{" WATER "}", settings, &scene, &error);
        if (cases[i].message != NULL)
            assert_string_equal(error.text, cases[i].message);
        assert_int_equal(result, cases[i].code);
        skv_scene_destroy(scene);
    }
}

static void test_settings_override_in_order(void **state)
{
    (void)state;
    skv_scene *scene;
    skv_error error;
    const char *settings[] = {"particles",  "500", "particles",  "700", "water[1].shape",  "circle",
                              "water[1].x", "1",   "water[1].y", "0.7", "water[1].radius", "0.1",
                              NULL};
    assert_int_equal(
        load_text("{\"fluid\": {\"spacing\": 0.01}, " WATER "}", settings, &scene, &error), SKV_OK);
    assert_int_equal(skv_scene_particles(scene), 700);
    skv_world *world;
    assert_int_equal(skv_scene_create_world(scene, 1, &world, &error), SKV_OK);
    skv_area circle = skv_circle(1.0f, 0.7f, 0.1f);
    assert_true(skv_world_query(world, &circle, NULL, 0) > 20);
    skv_world_destroy(world);
    skv_scene_destroy(scene);

    /* --particles comes last, and too many is said with its own name. */
    skv_scene_options options = skv_default_scene_options();
    options.particles = 400;
    options.settings = &(skv_setting){"particles", "500"};
    options.setting_count = 1;
    const char *text = "{" WATER "}";
    assert_int_equal(
        skv_scene_load_memory(text, strlen(text), "json", "a.json", &options, &scene, &error),
        SKV_OK);
    assert_int_equal(skv_scene_particles(scene), 400);
    skv_scene_destroy(scene);
    options.particles = 3000000;
    assert_int_equal(
        skv_scene_load_memory(text, strlen(text), "json", "a.json", &options, &scene, &error),
        SKV_ERROR_LIMIT);
    assert_string_equal(error.text, "--particles: 3000000 is out of range; allowed is a whole "
                                    "number from 1 to 2000000");
    options.particles = 400;
    options.settings = &(skv_setting){"fluid.spacing", "0.02"};
    assert_int_equal(
        skv_scene_load_memory(text, strlen(text), "json", "a.json", &options, &scene, &error),
        SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "--particles: follows from fluid.spacing; give only one of them");
}

/* The spacing of what a file says about water, and of how many particles that is. */
static float spacing_of(const char *text, const char *const *settings, int particles, int amount)
{
    skv_scene *scene;
    skv_world *world;
    skv_error error = {0};
    if (load_text(text, settings, &scene, &error) != SKV_OK)
        fail_msg("%s: %s", text, error.text);
    assert_int_equal(skv_scene_particles(scene), particles);
    assert_int_equal(skv_scene_amount(scene), amount);
    assert_null(skv_scene_notice(scene, 0));
    assert_int_equal(skv_scene_create_world(scene, 1, &world, &error), SKV_OK);
    assert_int_equal(skv_world_particle_count(world), particles);
    assert_int_equal(skv_world_step(world, 1.0f / 60, &error), SKV_OK);
    float spacing = skv_world_fluid(world)->spacing;
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    return spacing;
}

/* A file may say that there is no water yet: it is as fine as if it were half full. */
static void test_an_empty_scene(void **state)
{
    (void)state;
    const char *empty = "{\"water\": []}";
    const char *half = "{\"water\": [{\"shape\": \"box\", \"y1\": 0.45}]}";
    const char *fewer[] = {"particles", "700", NULL};
    assert_float_equal(spacing_of(empty, NULL, 0, 3000), spacing_of(half, NULL, 3000, 3000), 1e-5);
    assert_float_equal(spacing_of(empty, fewer, 0, 700), spacing_of(half, fewer, 700, 700), 1e-5);
    const char *spaced[] = {"fluid.spacing", "0.05", NULL};
    assert_true(spacing_of(empty, spaced, 0, 288) == 0.05f);
    /* Half of what walls leave. */
    assert_true(spacing_of("{\"solid\": [{\"shape\": \"box\", \"y1\": 0.3}], \"water\": []}", NULL,
                           0, 3000) < spacing_of(empty, NULL, 0, 3000));
    /* A setting puts water in. */
    const char *filled[] = {"water[0].shape", "box", "water[0].y1", "0.45", NULL};
    assert_true(spacing_of(empty, filled, 3000, 3000) == spacing_of(half, NULL, 3000, 3000));
}

/* Every value ends where it belongs. */
static void test_values_arrive(void **state)
{
    (void)state;
    const char *text =
        "\xef\xbb\xbf{\"name\": \"n\", \"title\": \"T\", \"description\": \"D\", \"seconds\": 4,"
        "\"substeps\": 7, \"depth\": 0.2, \"particles\": 321,"
        "\"world\": {\"width\": 1.2, \"height\": 0.6, \"pixel\": 0.004, \"open\": {\"left\": true,"
        "\"top\": true}}, \"gravity\": {\"x\": 1, \"y\": -2},"
        "\"fluid\": {\"law\": \"clavet\", \"density\": 800, \"iterations\": 3, \"cohesion\": 5},"
        "\"water\": [{\"shape\": \"box\", \"y1\": 0.2, \"dye\": \"violet\"}, {\"shape\": "
        "\"circle\", "
        "\"x\": 0.6, \"y\": 0.4, \"radius\": 0.1, \"vx\": 1.5, \"vy\": -0.5}],"
        "\"emitters\": [{\"x\": 1, \"y\": 0.5, \"dye\": \"amber\"}],"
        "\"forces\": [{\"ax\": 2}, {\"shape\": \"polygon\", \"points\": [[0, 0], [0.5, 0], [0, "
        "0.7]], \"toward_x\": 0.3, \"toward_y\": 0.4, \"attraction\": -5, \"wind_x\": 6,"
        "\"wind_y\": 7, \"drag\": 8, \"ay\": 9, \"spin\": 10}]}";
    skv_scene *scene;
    skv_world *world;
    skv_error error = {0};
    assert_int_equal(load_text(text, NULL, &scene, &error), SKV_OK);
    assert_string_equal(skv_scene_name(scene), "n");
    assert_string_equal(skv_scene_title(scene), "T");
    assert_string_equal(skv_scene_description(scene), "D");
    assert_true(skv_scene_seconds(scene) == 4);
    assert_int_equal(skv_scene_particles(scene), 321);
    assert_null(skv_scene_notice(scene, 0));
    assert_int_equal(skv_scene_create_world(scene, 1, &world, &error), SKV_OK);
    assert_int_equal(skv_world_substeps_per_frame(world), 7);
    assert_int_equal(skv_world_particle_count(world), 321);
    const skv_fluid_def *fluid = skv_world_fluid(world);
    skv_fluid_def clavet = skv_default_fluid_def(SKV_LAW_CLAVET);
    assert_int_equal(fluid->law, SKV_LAW_CLAVET);
    assert_true(fluid->density == 800.0f && fluid->iterations == 3 && fluid->cohesion == 5.0f);
    assert_true(fluid->radius_ratio == clavet.radius_ratio);
    float gx, gy;
    skv_world_gravity(world, &gx, &gy);
    assert_true(gx == 1.0f && gy == -2.0f);
    const skv_terrain *terrain = skv_world_terrain(world);
    assert_int_equal(skv_terrain_pixels_x(terrain), 300);
    assert_int_equal(skv_terrain_pixels_y(terrain), 150);
    assert_int_equal(skv_terrain_open_sides(terrain), SKV_SIDE_LEFT | SKV_SIDE_TOP);

    /* What is in the circle moves, and nothing else. */
    skv_particles p = skv_world_particles(world);
    int moving = 0;
    for (int i = 0; i < p.count; i++) {
        bool high = p.y[i] > 0.25f;
        assert_true(p.vx[i] == (high ? 1.5f : 0.0f) && p.vy[i] == (high ? -0.5f : 0.0f));
        assert_string_equal(skv_dye_name(p.dye[i]), high ? "none" : "violet");
        moving += high;
    }
    assert_in_range(moving, 34, 40); /* the circle's share: no surplus is cut off its top */

    int emitters;
    assert_string_equal(skv_dye_name(skv_world_emitters(world, &emitters)->dye), "amber");

    int forces;
    const skv_force *f = skv_world_forces(world, &forces);
    assert_int_equal(forces, 2);
    assert_int_equal(f[0].area.kind, SKV_AREA_BOX);
    assert_true(f[0].area.x0 == 0 && f[0].area.x1 == 1.2f && f[0].area.y1 == 0.6f && f[0].ax == 2);
    assert_true(f[1].area.count == 3 && f[1].area.corners[5] == 0.7f && f[1].toward_x == 0.3f);
    assert_true(f[1].toward_y == 0.4f && f[1].attraction == -5 && f[1].wind_x == 6);
    assert_true(f[1].wind_y == 7 && f[1].drag == 8 && f[1].ay == 9 && f[1].ax == 0);
    assert_true(f[1].spin == 10 && f[0].spin == 0);

    /* In two halves it is the same world. */
    skv_world_def def = skv_scene_world_def(scene);
    skv_world *other;
    assert_int_equal(skv_world_create(&def, &other, &error), SKV_OK);
    assert_int_equal(skv_world_particle_count(other), 0);
    assert_int_equal(skv_scene_fill(scene, other, &error), SKV_OK);
    assert_true(skv_world_hash(other) == skv_world_hash(world));
    skv_world_destroy(other);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

/* A number reads the same where the decimal point is a comma. */
static void test_other_locale(void **state)
{
    (void)state;
    set_comma_locale();
    const char *settings[] = {"fluid.spacing", "0.02", NULL};
    skv_scene *scene;
    skv_error error = {0};
    assert_int_equal(load_text("{\"seconds\": 1.5, " WATER "}", settings, &scene, &error), SKV_OK);
    assert_true(skv_scene_seconds(scene) == 1.5);
    skv_scene_destroy(scene);
    assert_int_equal(load_text("{\"fluid\": {\"spacing\": 0.5}}", NULL, &scene, &error),
                     SKV_ERROR_VALUE);
    assert_string_equal(error.text, "a.json:1: fluid.spacing: 0.5 is out of range; allowed is a "
                                    "number from 0.0005 to 0.1 m");
    reset_locale();
}

/* Where gravity leans, fluid may pile up as deep as the world is long. */
static void test_depth_of_a_tilted_scene(void **state)
{
    (void)state;
    for (int tilted = 0; tilted < 2; tilted++) {
        const char *settings[] = {"gravity.x", tilted ? "1" : "0", NULL};
        skv_scene *scene;
        assert_int_equal(load_text("{" WATER "}", settings, &scene, NULL), SKV_OK);
        skv_world_def def = skv_scene_world_def(scene);
        float width = skv_terrain_width(def.terrain);
        assert_true(width > skv_terrain_height(def.terrain));
        bool whole = def.depth > 0.999f * width;
        if (whole != (tilted == 1))
            fail_msg("%g m deep in %g m", (double)def.depth, (double)width);
        skv_terrain_destroy(def.terrain);
        skv_scene_destroy(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_mistake_has_its_line),
        cmocka_unit_test(test_numbers_of_particles_name_what_fits),
        cmocka_unit_test(test_deep_nesting),
        cmocka_unit_test(test_limits_of_lists),
        cmocka_unit_test(test_settings),
        cmocka_unit_test(test_depth_of_a_tilted_scene),
        cmocka_unit_test(test_settings_override_in_order),
        cmocka_unit_test(test_an_empty_scene),
        cmocka_unit_test(test_values_arrive),
        cmocka_unit_test(test_other_locale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
