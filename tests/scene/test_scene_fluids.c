/* Fluids in a scene: a list, which water and emitters name; and what is no list is refused with its
 * place and a remedy. */
#include "skvalp/skvalp.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A scene of two fluids beside water, with room for another element and a place for one more key
 * of the oil. */
#define SCENE(oil, more)                                                                           \
    "{\n\"particles\": 300,\n"                                                                     \
    "\"fluids\": [{\"name\": \"oil\", \"density\": 1000" oil "},\n{\"name\": \"red "               \
    "\xc3\xb6l\", \"color\": \"#fF8000\", \"cohesion\": 0.5}],\n"                                  \
    "\"water\": [{\"shape\": \"box\", \"y1\": 0.2},\n"                                             \
    "{\"shape\": \"box\", \"y0\": 0.2, \"y1\": 0.3, \"fluid\": \"oil\", \"dye\": \"rose\"},\n"     \
    "{\"shape\": \"circle\", \"x\": 0.8, \"y\": 0.6, \"radius\": 0.1, \"fluid\": \"red "           \
    "\xc3\xb6l\", \"vx\": 1}],\n"                                                                  \
    "\"emitters\": [{\"x\": 0.2, \"y\": 0.8, \"vy\": -1, \"fluid\": \"oil\"},\n"                   \
    "{\"x\": 1.2, \"y\": 0.8, \"vy\": -1, \"fluid\": \"water\", \"dye\": \"green\"}]" more "}"

static void fluids_arrive(void **unused)
{
    (void)unused;
    skv_scene *scene;
    skv_world *world;
    skv_error error = {0};
    if (load_text(SCENE("", ""), NULL, &scene, &error) != SKV_OK ||
        skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_null(skv_scene_notice(scene, 0));
    assert_string_equal(skv_world_liquid(world, 0)->name, "water");
    assert_string_equal(skv_world_liquid(world, 1)->name, "oil");
    assert_int_equal(skv_world_liquid(world, 1)->color, -1);
    assert_true(skv_world_liquid(world, 1)->cohesion == -1);
    assert_true(skv_world_liquid(world, 2)->cohesion == 0.5f);
    assert_string_equal(skv_world_liquid(world, 2)->name, "red \xc3\xb6l");
    assert_int_equal(skv_world_liquid(world, 2)->color, 0xff8000);
    assert_true(skv_world_liquid(world, 2)->density == 1000);
    assert_null(skv_world_liquid(world, 3));
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++) {
        int fluid = p.y[i] > 0.45f ? 2 : p.y[i] > 0.2f ? 1 : 0;
        /* Settled fluid has sunk a little. */
        if (p.y[i] < 0.15f || p.y[i] > 0.21f) {
            assert_int_equal(p.fluid[i], fluid);
            assert_int_equal(p.dye[i], fluid == 1);
        }
    }
    for (int i = 0; i < 3; i++)
        assert_in_range(skv_world_fluid_stats(world, i).particles, i == 2 ? 10 : 80, 200);
    int count;
    const skv_emitter *emitters = skv_world_emitters(world, &count);
    assert_int_equal(count, 2);
    assert_true(emitters[0].fluid == 1 && emitters[0].dye == 0);
    assert_true(emitters[1].fluid == 0 && emitters[1].dye == 3);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

/* Jelly begins with the corners that are drawn, where water's tension rounds them. */
static void jelly_keeps_its_corners(void **unused)
{
    (void)unused;
    for (int i = 0; i < 2; i++) {
        skv_scene *scene;
        skv_world *world;
        skv_error error = {0};
        const char *text =
            i ? "{\"particles\": 400, \"fluids\": [{\"name\": \"jelly\", \"shear_modulus\": 4000}],"
                "\"water\": [{\"shape\": \"box\", \"x0\": 0.6, \"x1\": 0.8, \"y0\": 0.4,"
                "\"y1\": 0.6, \"fluid\": \"jelly\"}]}"
              : "{\"particles\": 400, \"water\": [{\"shape\": \"box\", \"x0\": 0.6, \"x1\": 0.8,"
                "\"y0\": 0.4, \"y1\": 0.6}]}";
        if (load_text(text, NULL, &scene, &error) != SKV_OK ||
            skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
            fail_msg("%s", error.text);
        skv_particles p = skv_world_particles(world);
        float farthest = 0;
        for (int k = 0; k < p.count; k++)
            farthest = fmaxf(farthest, fabsf(p.x[k] - 0.7f) + fabsf(p.y[k] - 0.5f));
        /* The outermost particle of a drawn corner is half a spacing inside, both ways. */
        assert_true((farthest > 0.18f) == (i == 1));
        skv_world_destroy(world);
        skv_scene_destroy(scene);
    }
}

/* Loads a text with one setting, null for none, and expects to be told that. */
static void expect_refused(const char *text, const char *path, const char *value,
                           const char *message)
{
    const char *const settings[] = {path, value, NULL};
    skv_scene *scene;
    skv_error error = {0};
    skv_result result = load_text(text, path ? settings : NULL, &scene, &error);
    assert_true(result == SKV_ERROR_VALUE || result == SKV_ERROR_LIMIT);
    assert_string_equal(error.text, message);
    assert_null(scene);
}

/* Which of them is told of the name, not of what was set. */
enum { MISSING_NAME = 22 };

static void what_is_wrong_is_told(void **unused)
{
    (void)unused;
    static const struct {
        const char *path, *value, *message;
    } wrong[] = {
        {"water[1].fluid", "oli",
         "\"oli\" is no fluid of this scene; allowed is one of water, oil, red \xc3\xb6l"},
        {"water[0].fluid", "",
         "\"\" is no fluid of this scene; allowed is one of water, oil, red \xc3\xb6l"},
        {"emitters[1].fluid", "Oil",
         "\"Oil\" is no fluid of this scene; allowed is one of water, oil, red \xc3\xb6l"},
        {"fluids[1].name", "oil", "is another fluid's, too; choose another"},
        {"fluids[0].name", "water", "is that of the first fluid; choose another"},
        {"fluids[0].name", "", "is empty; each fluid needs a name of its own"},
        {"fluids[0].name", "a name that is longer than it may be",
         "\"a name that is longer than it may be\" is too long; allowed is text of at most 31 "
         "bytes"},
        {"fluids[1].color", "red", "is no color; allowed is \"#rrggbb\""},
        {"fluids[1].color", "#ff80g0", "is no color; allowed is \"#rrggbb\""},
        {"fluids[1].color", "#ff800", "is no color; allowed is \"#rrggbb\""},
        {"fluids[1].material", "gold",
         "\"gold\" is not known; allowed is water, oil, honey or mercury"},
        {"fluids[0].density", "0.001",
         "0.001 is out of range; allowed is a number from 0.01 to 400000 kg/m^2"},
        {"fluids[0].density", "400001",
         "400001 is out of range; allowed is a number from 0.01 to 400000 kg/m^2"},
        {"fluids[0].shear_modulus", "20001",
         "20001 is out of range; allowed is a number from 0 to 20000 Pa"},
        {"fluids[0].shear_modulus", "stiff",
         "\"stiff\" is not a number; allowed is a number from 0 to 20000 Pa"},
        {"fluids[1].yield", "-0.1", "-0.1 is out of range; allowed is a number from 0 to 1"},
        {"fluids[0].plasticity", "1e9",
         "1e+09 is out of range; allowed is a number from 0 to 100 1/s"},
        {"fluids[1].interface_push", "401",
         "401 is out of range; allowed is a number from 0 to 400 m/s^2"},
        {"fluids[0].cohesion", "500.5",
         "500.5 is out of range; allowed is a number from 0 to 500 m/s^2"},
        {"fluids[0].cohesion", "-1", "-1 is out of range; allowed is a number from 0 to 500 m/s^2"},
        {"fluids[1].plasticity", "2", "needs springs that give way; add a shear_modulus, Pa"},
        {"fluids[0].density", "9",
         "is 9 kg/m^2; allowed is 0.01 to 20 times that of the first fluid, 10..20000 kg/m^2"},
        {"fluids[2].density", "1000", "is missing; water and emitters need it"},
        {"fluids[3].name", "x", "there is no fluids[3]; the next free one is fluids[2]"},
    };
    for (int i = 0; i < (int)(sizeof wrong / sizeof *wrong); i++) {
        char message[300];
        const char *path = i == MISSING_NAME ? "fluids[2].name" : wrong[i].path;
        snprintf(message, sizeof message, "--set %s: %s", path, wrong[i].message);
        expect_refused(SCENE("", ""), wrong[i].path, wrong[i].value, message);
    }
    expect_refused("{\"water\": [{\"shape\": \"box\"},\n{\"shape\": \"box\", \"fluid\": \"oil\"}]}",
                   NULL, NULL,
                   "a.json:2: water[1].fluid: \"oil\" is no fluid of this scene; allowed is one of "
                   "water");
    expect_refused("{\"fluids\": [\n{\"density\": 1000}], \"water\": [{\"shape\": \"box\"}]}", NULL,
                   NULL, "a.json:2: fluids[0].name: is missing; water and emitters need it");
    expect_refused("{\"fluids\": {\"oil\": 1}}", NULL, NULL,
                   "a.json:1: fluids: an object is not a list; allowed is [ ... ]");
    expect_refused("{\"fluids\": [{\"name\": 1}]}", NULL, NULL,
                   "a.json:1: fluids[0].name: 1 is not text; allowed is text of at most 31 bytes");
    expect_refused(
        "{\"fluids\": [{\"name\": \"a\\nb\"}], \"water\": []}", NULL, NULL,
        "a.json:1: fluids[0].name: \"a?b\" holds a control character; allowed is text of "
        "at most 31 bytes");
}

static void eight_are_all(void **unused)
{
    (void)unused;
    char text[1000] =
        "{\"particles\": 100, \"water\": [{\"shape\": \"box\", \"y1\": 0.3, \"fluid\": "
        "\"7\"}], \"fluids\": [";
    for (int i = 1; i <= 8; i++) {
        char one[40];
        snprintf(one, sizeof one, "%s\n{\"name\": \"%d\"}", i > 1 ? "," : "", i);
        strcat(text, one);
        size_t end = strlen(text);
        strcat(text, "]}");
        skv_scene *scene;
        skv_error error = {0};
        skv_result result = load_text(text, NULL, &scene, &error);
        if (i == 8)
            assert_string_equal(error.text, "a.json:9: fluids[7]: too many; allowed are 7");
        else if (i < 7)
            assert_non_null(strstr(error.text, "\"7\" is no fluid of this scene"));
        else
            assert_int_equal(result, SKV_OK);
        skv_scene_destroy(scene);
        text[end] = '\0';
    }
}

/* A material's density and viscosity, or the fluid's own. */
static void materials_are_as_they_are(void **unused)
{
    (void)unused;
    skv_scene *scene;
    skv_error error = {0};
    const char *const heavy[] = {"fluids[1].material", "mercury", NULL};
    assert_int_equal(load_text(SCENE("", ""), heavy, &scene, &error), SKV_OK);
    skv_world_def def = skv_scene_world_def(scene);
    assert_int_equal(def.liquid_count, 2);
    assert_true(def.liquids[0].density == 1000 && def.liquids[1].density == 13546);
    assert_true(def.liquids[1].viscosity == 1.15e-7f);
    skv_terrain_destroy(def.terrain);
    skv_scene_destroy(scene);
    const char *const thick[] = {"fluids[0].material", "honey", "fluids[1].viscosity", "0.05",
                                 NULL};
    assert_int_equal(load_text(SCENE("", ""), thick, &scene, &error), SKV_OK);
    assert_null(skv_scene_notice(scene, 0));
    def = skv_scene_world_def(scene);
    assert_true(def.liquids[0].viscosity == 7e-3f && def.liquids[1].viscosity == 0.05f);
    skv_terrain_destroy(def.terrain);
    skv_scene_destroy(scene);
    const char *const wrong[] = {"fluids[0].viscosity", "0.06", NULL};
    assert_int_equal(load_text(SCENE("", ""), wrong, &scene, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "--set fluids[0].viscosity: 0.06 is out of range; allowed is a "
                                    "number from 0 to 0.05 m^2/s");
}

/* A fluid of which a scene says its name alone is the one that a program gets. */
static void defaults_are_those_of_programs(void **unused)
{
    (void)unused;
    skv_scene *scene;
    skv_error error = {0};
    skv_liquid standard = skv_default_liquid();
    memcpy(standard.name, "other", sizeof "other");
    if (load_text("{\"fluids\": [{\"name\": \"other\"}], \"water\": [{\"shape\": \"box\"}]}", NULL,
                  &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_world_def def = skv_scene_world_def(scene);
    assert_memory_equal(&def.liquids[0], &standard, sizeof standard);
    assert_true(standard.yield == 0.1f && standard.cohesion == -1);
    memset(standard.name, 0, sizeof standard.name);
    skv_world_def own = skv_default_world_def();
    assert_memory_equal(&own.liquids[SKV_MAX_FLUIDS - 2], &standard, sizeof standard);
    skv_terrain_destroy(def.terrain);
    skv_scene_destroy(scene);
}

/* Blue up to a third, yellow above it, green over both. */
static rgb paint_layers(int x, int y, void *user)
{
    (void)user;
    if (y < 10 && x > 40 && x < 60)
        return (rgb){0, 255, 0};
    return y > 80 ? (rgb){0, 0, 255} : y > 60 ? (rgb){255, 255, 0} : (rgb){0, 0, 0};
}

static skv_result load_layers(const skv_setting *settings, int count, skv_scene **scene,
                              skv_error *error)
{
    buffer picture = write_rgb(120, 120, paint_layers, NULL);
    skv_scene_options options = skv_default_scene_options();
    options.particles = 300;
    options.settings = settings;
    options.setting_count = count;
    skv_result result =
        skv_scene_load_memory(picture.data, picture.size, "png", "p.png", &options, scene, error);
    buffer_free(&picture);
    return result;
}

/* Yellow pixels are the fluid named oil, which is there without being listed. */
static void yellow_is_painted_oil(void **unused)
{
    (void)unused;
    const skv_setting own[] = {
        {"fluids[0].name", "milk"}, {"fluids[1].name", "oil"}, {"fluids[1].density", "700"}};
    for (int listed = 0; listed < 2; listed++) {
        skv_scene *scene;
        skv_world *world = NULL;
        skv_error error;
        if (load_layers(own, listed ? 3 : 0, &scene, &error) != SKV_OK ||
            skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
            fail_msg("%s", error.text);
        int oil = listed ? 2 : 1;
        assert_string_equal(skv_world_liquid(world, oil)->name, "oil");
        assert_true(skv_world_liquid(world, oil)->density == (listed ? 700 : 911));
        assert_null(skv_world_liquid(world, oil + 1));
        skv_stats water = skv_world_fluid_stats(world, 0), top = skv_world_fluid_stats(world, oil);
        /* 39 rows of pixels of water, 20 of oil. */
        assert_in_range(water.particles, 180, 215);
        assert_int_equal(water.particles + top.particles, 300);
        assert_true(top.centre_y > 1.6 * 45 / 120 && water.centre_y < 1.6 * 25 / 120);
        skv_world_destroy(world);
        skv_scene_destroy(scene);
    }
    skv_setting seven[7];
    const char *const paths[] = {"fluids[0].name", "fluids[1].name", "fluids[2].name",
                                 "fluids[3].name", "fluids[4].name", "fluids[5].name",
                                 "fluids[6].name"};
    for (int i = 0; i < 7; i++)
        seven[i] = (skv_setting){paths[i], paths[i]};
    skv_scene *scene;
    skv_error error;
    assert_int_equal(load_layers(seven, 7, &scene, &error), SKV_ERROR_LIMIT);
    assert_string_equal(error.text,
                        "p.png: its yellow pixels are oil, one fluid too many; name one "
                        "of the scene's 7 fluids \"oil\"");
    const skv_setting light = {"fluid.density", "20"};
    assert_int_equal(load_layers(&light, 1, &scene, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "p.png: fluids[0].density: is 911 kg/m^2; allowed is 0.01 to 20 "
                        "times that of the first fluid, 0.2..400 kg/m^2");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jelly_keeps_its_corners),
        cmocka_unit_test(fluids_arrive),
        cmocka_unit_test(what_is_wrong_is_told),
        cmocka_unit_test(eight_are_all),
        cmocka_unit_test(materials_are_as_they_are),
        cmocka_unit_test(defaults_are_those_of_programs),
        cmocka_unit_test(yellow_is_painted_oil),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
