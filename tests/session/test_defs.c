/* Definitions as other languages and older programs have them: filled in where they lie, as far as
 * their program knows them; and refused where nobody has. Memory is given to the byte, so that a
 * sanitizer notices what is read or written beyond it. */
#include "support/misuse.h"

#include <skvalp/skvalp.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "skvalp/player.h"
#include "skvalp/stage.h"

/* ---- What is written ------------------------------------------------------------------------- */

static void init_fluid(void *def, size_t size)
{
    skv_fluid_def_init(def, size, SKV_LAW_CLAVET);
}

static void init_instrument(void *def, size_t size)
{
    skv_instrument_def_init(def, size, SKV_INSTRUMENT_LEVEL);
}

#define INIT(name)                                                                                 \
    static void init_##name(void *def, size_t size)                                                \
    {                                                                                              \
        skv_##name##_init(def, size);                                                              \
    }
INIT(world_def)
INIT(fill_def)
INIT(liquid)
INIT(terrain_def)
INIT(surface_def)
INIT(player_def)
INIT(stage_def)
INIT(scene_options)

static const struct {
    const char *name;
    void (*init)(void *def, size_t size);
    size_t size;
} defs[] = {
    {"fluid_def", init_fluid, sizeof(skv_fluid_def)},
    {"instrument_def", init_instrument, sizeof(skv_instrument_def)},
    {"world_def", init_world_def, sizeof(skv_world_def)},
    {"fill_def", init_fill_def, sizeof(skv_fill_def)},
    {"liquid", init_liquid, sizeof(skv_liquid)},
    {"terrain_def", init_terrain_def, sizeof(skv_terrain_def)},
    {"surface_def", init_surface_def, sizeof(skv_surface_def)},
    {"player_def", init_player_def, sizeof(skv_player_def)},
    {"stage_def", init_stage_def, sizeof(skv_stage_def)},
    {"scene_options", init_scene_options, sizeof(skv_scene_options)},
};

static void nothing_is_written_beyond_the_size(void **unused)
{
    (void)unused;
    for (size_t d = 0; d < sizeof defs / sizeof *defs; d++) {
        uint32_t seen = 0;
        for (size_t size = sizeof(uint32_t); size <= defs[d].size; size += 4) {
            uint8_t *bytes = malloc(size);
            assert_non_null(bytes);
            defs[d].init(bytes, size);
            uint32_t cookie;
            memcpy(&cookie, bytes, sizeof cookie);
            assert_true(cookie != 0 && cookie != seen); /* it tells how many bytes are known */
            seen = cookie;
            free(bytes);
        }
        assert_int_equal(misuses, 0);
        /* More than this library has, or less than a cookie: nothing is written. */
        uint8_t *bytes = calloc(1, defs[d].size + 4);
        const size_t wrong[] = {defs[d].size + 4, 3, 0};
        for (int w = 0; w < 3; w++) {
            misuses = 0;
            defs[d].init(bytes, wrong[w]);
            assert_int_equal(misuses, 1);
            for (size_t i = 0; i < defs[d].size + 4; i++)
                assert_int_equal(bytes[i], 0);
        }
        misuses = 0;
        free(bytes);
    }
}

static void init_gives_what_the_default_is(void **unused)
{
    (void)unused;
    skv_world_def world, standard = skv_default_world_def();
    skv_world_def_init(&world, sizeof world);
    for (int i = 0; skv_world_field(i); i++) {
        char text[2][32];
        const char *path = skv_world_field(i)->path;
        assert_int_equal(skv_world_def_get(&world, path, text[0], 32, NULL), SKV_OK);
        assert_int_equal(skv_world_def_get(&standard, path, text[1], 32, NULL), SKV_OK);
        assert_string_equal(text[0], text[1]);
    }
    skv_fluid_def_init(&world.fluid, sizeof world.fluid, SKV_LAW_CLAVET);
    assert_int_equal(world.fluid.law, SKV_LAW_CLAVET);
    assert_int_equal(world.fluid.iterations, skv_default_fluid_def(SKV_LAW_CLAVET).iterations);
    skv_liquid liquid;
    skv_liquid_init(&liquid, sizeof liquid);
    assert_true(liquid.density == 1000 && liquid.color == -1 && liquid.name[0] == '\0');
    skv_instrument_def gauge;
    skv_instrument_def_init(&gauge, sizeof gauge, SKV_INSTRUMENT_LEVEL);
    assert_int_equal(gauge.kind, SKV_INSTRUMENT_LEVEL);
    assert_int_equal(misuses, 0);
}

/* ---- Programs that know less ----------------------------------------------------------------- */

/* A def as a program has it that knows of its members up to one; freed by the caller. */
#define OLDER(type, init, member) older(init, offsetof(type, member) + sizeof(((type *)0)->member))
static void *older(void (*init)(void *def, size_t size), size_t size)
{
    volatile size_t known = size; /* a compiler that followed it would warn of just this */
    void *def = malloc(known);
    assert_non_null(def);
    init(def, known);
    return def;
}

static void an_older_program_makes_a_world(void **unused)
{
    (void)unused;
    skv_terrain_def *tank = OLDER(skv_terrain_def, init_terrain_def, coverage);
    skv_world_def *def = OLDER(skv_world_def, init_world_def, gravity_y);
    skv_fill_def *fill = OLDER(skv_fill_def, init_fill_def, y1);
    tank->width = 320;
    fill->y1 = 0.2f;
    assert_int_equal(skv_terrain_create(tank, &def->terrain, NULL), SKV_OK);
    assert_true(skv_terrain_width(def->terrain) == 320 * 0.0025f); /* the pixels of the default */
    skv_fill_def whole = skv_default_fill_def();
    whole.y1 = 0.2f;
    int places = skv_fill_count(def->terrain, 0.02f, &whole);
    assert_true(places > 300);
    assert_int_equal(skv_fill_count(def->terrain, 0.02f, fill), places);
    def->gravity_y = -5;
    assert_int_equal(skv_world_def_set(def, "fluid.spacing", "0.02", NULL), SKV_OK);
    skv_error error;
    assert_int_equal(skv_world_def_set(def, "capacity", "5", &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "capacity: this program was compiled before"));
    char text[32];
    assert_int_equal(skv_world_def_get(def, "sleep", text, sizeof text, NULL), SKV_OK);
    assert_string_equal(text, "true");
    skv_world *world;
    skv_placed placed;
    float x, y;
    assert_int_equal(skv_world_create(def, &world, NULL), SKV_OK);
    assert_int_equal(skv_world_fill(world, fill, &placed, NULL), SKV_OK);
    assert_int_equal(placed.added, places);
    skv_world_gravity(world, &x, &y);
    assert_true(y == -5);
    assert_int_equal(skv_world_get(world, "emission.limit", text, sizeof text, NULL), SKV_OK);
    assert_string_equal(text, "20000");
    assert_int_equal(misuses, 0);
    skv_world_destroy(world);
    free(fill);
    free(def);
    free(tank);
}

static void an_older_program_measures_and_plays(void **unused)
{
    (void)unused;
    skv_instrument_def *def = OLDER(skv_instrument_def, init_instrument, y1);
    skv_lab *lab;
    skv_instrument gauge;
    def->x0 = def->x1 = 0.5;
    def->y0 = 0, def->y1 = 0.5;
    assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
    assert_int_equal(skv_lab_add(lab, def, &gauge, NULL), SKV_OK);
    assert_int_equal(skv_lab_def(lab, gauge)->capacity, 1200);
    skv_lab_destroy(lab);

    skv_player_def *playing = OLDER(skv_player_def, init_player_def, threads);
    skv_scene_options *options = OLDER(skv_scene_options, init_scene_options, particles);
    playing->threads = 1;
    options->particles = 200;
    skv_scene *scene;
    skv_player *player;
    assert_int_equal(skv_scene_load("pool", options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_player_create(scene, playing, &player, NULL), SKV_OK);
    skv_player_destroy(player);

    skv_stage_def *stage_def = OLDER(skv_stage_def, init_stage_def, threads);
    skv_stage *stage;
    stage_def->threads = 1;
    assert_int_equal(skv_stage_create(stage_def, &stage, NULL), SKV_OK);
    skv_stage_open(stage, "pool", options);
    skv_stage_wait(stage);
    skv_stage_destroy(stage);
    assert_int_equal(misuses, 0);
    free(stage_def);
    free(options);
    free(playing);
    free(def);
}

/* ---- Programs that have forgotten ------------------------------------------------------------ */

static void who_initialised_nothing_is_told(void **unused)
{
    (void)unused;
    static const skv_world_def no_world;
    static const skv_fill_def no_fill;
    static const skv_terrain_def no_terrain;
    static const skv_instrument_def no_instrument;
    static const skv_surface_def no_surface;
    static const skv_player_def no_player;
    static const skv_stage_def no_stage;
    static const skv_scene_options no_options;
    skv_world *world, *none;
    skv_world_def def = skv_default_world_def();
    def.threads = 1;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    int expected = 0;
    assert_int_equal(skv_world_create(&no_world, &none, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    def.liquid_count = 1;
    memset(&def.liquids[0], 0, sizeof def.liquids[0]);
    assert_int_equal(skv_world_create(&def, &none, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    def.liquid_count = 0;
    memset(&def.fluid, 0, sizeof def.fluid);
    assert_int_equal(skv_world_create(&def, &none, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    /* A definition of another kind is none. */
    skv_fill_def fill = skv_default_fill_def();
    skv_terrain_def tank = skv_default_terrain_def();
    fill.cookie = tank.cookie;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    assert_int_equal(skv_world_fill(world, &no_fill, NULL, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    assert_int_equal(skv_fill_count(skv_world_terrain(world), 0.02f, &no_fill), 0);
    assert_int_equal(misuses, ++expected);
    skv_terrain *terrain;
    assert_int_equal(skv_terrain_create(&no_terrain, &terrain, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    skv_lab *lab;
    skv_instrument id;
    assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
    assert_int_equal(skv_lab_add(lab, &no_instrument, &id, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    skv_lab_destroy(lab);
    skv_surface *surface;
    skv_survey *survey;
    assert_int_equal(skv_surface_create(&surface, NULL), SKV_OK);
    assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
    assert_int_equal(skv_surface_find(surface, survey, &no_surface, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    skv_survey_destroy(survey);
    skv_surface_destroy(surface);
    skv_scene *scene;
    assert_int_equal(skv_scene_load("pool", &no_options, &scene, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    assert_int_equal(skv_scene_load("pool", NULL, &scene, NULL), SKV_OK);
    skv_player *player;
    assert_int_equal(skv_player_create(scene, &no_player, &player, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    assert_int_equal(skv_player_load("x", 1, &no_player, &player, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    skv_scene_destroy(scene);
    skv_stage *stage;
    assert_int_equal(skv_stage_create(&no_stage, &stage, NULL), SKV_ERROR_VALUE);
    assert_int_equal(misuses, ++expected);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(nothing_is_written_beyond_the_size, misuse_begin,
                                        misuse_end),
        cmocka_unit_test_setup_teardown(init_gives_what_the_default_is, misuse_begin, misuse_end),
        cmocka_unit_test_setup_teardown(an_older_program_makes_a_world, misuse_begin, misuse_end),
        cmocka_unit_test_setup_teardown(an_older_program_measures_and_plays, misuse_begin,
                                        misuse_end),
        cmocka_unit_test_setup_teardown(who_initialised_nothing_is_told, misuse_begin, misuse_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
