/* Whatever the registry accepts stays bounded: each parameter of a world at its ends and at places
 * between, in a dam that breaks and in a pool, by both laws, from the start or set while it runs.
 *
 * What a fall allows is the speed sqrt(2 g H) of what falls from the water's highest place through
 * all of the tank. A dam's front may be faster: sqrt(2) of it on a dry floor (Ritter 1892), less
 * with a pressure that is not hydrostatic. So half as much again is allowed. What hits a wall is
 * left out, for a jet beside a wall is faster than any fall: the tank is longer than the front
 * gets, and it is turned with gravity.
 *
 * Gravity that turns while the world runs is left out, too: it throws water at walls. Where a
 * surface meets a wall flat there is no bound, for the jet is as much faster than the fall as the
 * angle between them is small (Wagner 1932). */
#include "scene/support.h"

#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/* In spacings: a dam of 375 particles, a pool of 400, and what is above either. */
enum {
    DAM_WIDTH = 14,
    DAM_HEIGHT = 24,
    DAM_TANK = 160,
    LIVE_TANK = 400, /* in which a dam's front runs for 1.8 s */
    POOL_WIDTH = 40,
    POOL_HEIGHT = 10,
    TOP = 36
};
enum { PLACES = 12 };
/* Frames: a dam's front runs 1.3 times as far as it is high at Earth's gravity. */
enum { WATCHED = 36 };
/* Frames until a parameter is set, when a dam's water falls, and its way to a new number. */
enum { FALLEN = 12, WAY = 60 };

typedef struct run {
    const skv_field *field;
    double value;
    bool clavet, pool, live;
} run;

/* The tank and its water, turned so that gravity, which is mostly along one side, presses the water
 * to the floor. */
static void write_scene(const run *r, char *text, size_t size)
{
    double s = strcmp(r->field->path, "fluid.spacing") == 0 ? r->value : 0.02;
    bool aside = strcmp(r->field->path, "gravity.x") == 0;
    bool turned = (aside || strcmp(r->field->path, "gravity.y") == 0) && r->value > 0;
    double tank = r->live ? LIVE_TANK : DAM_TANK;
    double across = (r->pool ? POOL_WIDTH : tank) * s, up = TOP * s;
    double width = (r->pool ? POOL_WIDTH : DAM_WIDTH) * s;
    double high = (r->pool ? POOL_HEIGHT : DAM_HEIGHT) * s, from = turned ? up - high : 0;
    snprintf(text, size,
             "{\"world\":{\"width\":%.9g,\"height\":%.9g,\"pixel\":%.9g},"
             "\"fluid\":{\"spacing\":%.9g,\"law\":\"%s\"},"
             "\"water\":[{\"shape\":\"box\",\"%c0\":0,\"%c1\":%.9g,\"%c0\":%.9g,\"%c1\":%.9g}]}",
             aside ? up : across, aside ? across : up, s / 2, s,
             r->clavet ? "clavet" : "calibrated", aside ? 'y' : 'x', aside ? 'y' : 'x', width,
             aside ? 'x' : 'y', from, aside ? 'x' : 'y', from + high);
}

static skv_scene *open(const run *r)
{
    char text[600], value[32];
    write_scene(r, text, sizeof text);
    snprintf(value, sizeof value, "%.9g", r->value);
    if (r->field->type == SKV_FIELD_BOOLEAN)
        snprintf(value, sizeof value, "%s", r->value == 0 ? "false" : "true");
    const char *const setting[] = {r->field->path, value, NULL};
    bool later = r->live || strcmp(r->field->path, "fluid.spacing") == 0;
    skv_scene *scene;
    skv_error error;
    if (load_text(text, later ? NULL : setting, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return scene;
}

/* sqrt(2 g H), in m/s. */
static double fall(const skv_world *world)
{
    const skv_terrain *terrain = skv_world_terrain(world);
    float gx, gy, width = skv_terrain_width(terrain), height = skv_terrain_height(terrain);
    skv_world_gravity(world, &gx, &gy);
    double deepest = fmax(gx, 0) * (double)width + fmax(gy, 0) * (double)height, most = 0;
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++)
        most = fmax(most, deepest - (double)(gx * p.x[i]) - (double)(gy * p.y[i]));
    return sqrt(2 * most);
}

/* What hits a wall is left out. */
static bool has_come_across(const skv_world *world, const run *r)
{
    skv_particles p = skv_world_particles(world);
    float end = skv_terrain_width(skv_world_terrain(world)) - skv_world_spacing(world);
    bool come = false;
    for (int i = 0; i < p.count; i++)
        come |= p.x[i] > end;
    return come && r->live && !r->pool;
}

/* The greatest speed, as a share of the fall. */
static double greatest(const run *r, const skv_scene *scene)
{
    skv_world *world;
    skv_error error;
    if (skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    double allowed = fall(world), most = 0;
    int count = skv_world_particle_count(world);
    if (r->live) {
        int parameter = skv_world_parameter(r->field->path);
        fixture_run(world, FALLEN);
        assert_int_equal(skv_world_set_number(world, parameter, r->value, NULL), SKV_OK);
        allowed = fmax(allowed, fall(world));
    }
    int frames = r->live ? WAY + WATCHED : WATCHED;
    for (int frame = 0; frame < frames && !has_come_across(world, r); frame++) {
        fixture_run(world, 1);
        skv_stats stats = skv_world_stats(world);
        most = fmax(most, stats.max_speed);
        if (stats.not_finite || stats.escaped || stats.particles != count)
            fail_msg("%s %g: lost particles", r->field->path, r->value);
    }
    skv_world_destroy(world);
    return most / allowed;
}

static void expect_bounded(const run *r)
{
    skv_scene *scene = open(r);
    double most = greatest(r, scene);
    const char *note = skv_scene_notice(scene, 0);
    /* Or a note names the parameter and says what can be had instead. */
    bool noted = note && strstr(note, r->field->path) && strstr(note, "can be had");
    if (!(most < 1.5) && !noted)
        fail_msg("%s %g, %s, %s%s: %.2f of what the fall allows", r->field->path, r->value,
                 r->clavet ? "clavet" : "calibrated", r->pool ? "pool" : "dam",
                 r->live ? ", while it runs" : "", most);
    skv_scene_destroy(scene);
}

/* Whether a law has a parameter. */
static bool has(bool clavet, const char *path)
{
    static const char *const calibrated[] = {"fluid.near_stiffness", "fluid.cohesion",
                                             "fluid.relaxation", "fluid.wall_images",
                                             "fluid.adhesion"};
    bool is_calibrated = false;
    for (size_t i = 0; i < sizeof calibrated / sizeof *calibrated; i++)
        is_calibrated |= strcmp(path, calibrated[i]) == 0;
    return clavet ? !is_calibrated : strncmp(path, "fluid.clavet", 12) != 0;
}

/* Whether a parameter turns gravity. */
static bool turns(const skv_field *field, double value)
{
    bool upwards = strcmp(field->path, "gravity.y") == 0 && value > 0;
    return upwards || strcmp(field->path, "gravity.x") == 0;
}

/* The ends in a dam; in the long form, the places between, too, and a pool at the ends and two
 * places. */
static void try_all(const skv_field *field, bool clavet, bool live)
{
    int places = field->type == SKV_FIELD_BOOLEAN ? 2 : PLACES;
    int step = places == 2 || long_tests() ? 1 : PLACES - 1;
    for (int i = 0; i < places; i += step) {
        double value = field->minimum + (field->maximum - field->minimum) * i / (places - 1);
        if (field->type == SKV_FIELD_INTEGER)
            value = floor(value + 0.5);
        if (live && turns(field, value))
            continue;
        expect_bounded(&(run){field, value, clavet, false, live});
        if (long_tests() && (i % 4 == 0 || i == places - 1))
            expect_bounded(&(run){field, value, clavet, true, live});
    }
}

/* The short form sets none while the calibrated law's fluid runs, whose numbers may jump. */
static void try_fields(bool live)
{
    const skv_field *field;
    for (int i = 0; (field = skv_world_field(i)); i++) {
        bool hosts = strcmp(field->path, "threads") == 0 || strcmp(field->path, "capacity") == 0;
        if (hosts || field->type == SKV_FIELD_CHOICE ||
            (live && !skv_world_can_change(field->path)))
            continue;
        for (int law = live && !long_tests() ? 1 : 0; law < 2; law++)
            if (has(law == 1, field->path))
                try_all(field, law == 1, live);
    }
}

static void all_that_is_accepted_stays_bounded(void **unused)
{
    (void)unused;
    try_fields(false);
}

static void all_that_is_set_while_it_runs_stays_bounded(void **unused)
{
    (void)unused;
    try_fields(true);
}

/* A note's range can be had: with its ends there is no note. */
static void what_a_note_offers_can_be_had(void **unused)
{
    (void)unused;
    static const struct {
        const char *path;
        double value;
    } bursting[] = {{"fluid.clavet_near_stiffness", 0.2},
                    {"fluid.clavet_near_stiffness", 0},
                    {"fluid.clavet_stiffness", 0},
                    {"fluid.clavet_rest_density", 40},
                    {"fluid.radius_ratio", 4}};
    for (size_t i = 0; i < sizeof bursting / sizeof *bursting; i++) {
        run r = {skv_world_field(skv_world_parameter(bursting[i].path)), bursting[i].value, true,
                 false, false};
        skv_scene *scene = open(&r);
        const char *note = skv_scene_notice(scene, 0);
        const char *offer = note ? strrchr(note, ';') : NULL;
        double ends[2];
        assert_non_null(offer);
        assert_int_equal(sscanf(offer, "; %lf to %lf can be had", &ends[0], &ends[1]), 2);
        skv_scene_destroy(scene);
        for (int k = 0; k < 2; k++) {
            r.value = ends[k];
            scene = open(&r);
            assert_null(skv_scene_notice(scene, 0));
            assert_true(greatest(&r, scene) < 1.5);
            skv_scene_destroy(scene);
        }
    }
}

/* Of two numbers that no third one mends, the note says both, and the two that can be had. */
static void a_note_names_all_that_is_bad_together(void **unused)
{
    (void)unused;
    static const struct {
        skv_setting given[2];
        const char *note;
    } cases[] = {
        {{{"fluid.clavet_stiffness", "0"}, {"fluid.clavet_rest_density", "1"}},
         "with fluid.clavet_stiffness 0, fluid.clavet_rest_density 1 the clavet fluid swells and "
         "bursts; the defaults 0.004, 10 can be had"},
        {{{"fluid.clavet_near_stiffness", "0"}, {"fluid.clavet_stiffness", "0"}},
         "with fluid.clavet_near_stiffness 0, fluid.clavet_stiffness 0 the clavet fluid collapses; "
         "the defaults 0.04, 0.004 can be had"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        skv_setting settings[] = {{"fluid.law", "clavet"}, cases[i].given[0], cases[i].given[1]};
        skv_scene_options options = skv_default_scene_options();
        options.settings = settings;
        options.setting_count = 3;
        skv_scene *scene;
        skv_error error;
        assert_int_equal(skv_scene_load("pool", &options, &scene, &error), SKV_OK);
        assert_non_null(skv_scene_notice(scene, 0));
        assert_string_equal(skv_scene_notice(scene, 0), cases[i].note);
        assert_null(skv_scene_notice(scene, 1));
        skv_scene_destroy(scene);
    }
}

/* Opens the pool with 3000 particles and so many substeps. */
static skv_scene *open_pool(const char *substeps)
{
    const skv_setting settings[] = {{"substeps", substeps}, {"particles", "3000"}};
    skv_scene_options options = skv_default_scene_options();
    options.settings = settings;
    options.setting_count = 2;
    skv_scene *scene;
    skv_error error;
    if (skv_scene_load("pool", &options, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return scene;
}

/* m/s, in a fifth of a second: still water that a scene may have so. */
static double stirred(const skv_scene *scene)
{
    skv_world *world;
    assert_int_equal(skv_scene_create_world(scene, 1, &world, NULL), SKV_OK);
    double most = 0;
    for (int frame = 0; frame < 12; frame++) {
        fixture_run(world, 1);
        most = fmax(most, skv_world_stats(world).max_speed);
    }
    skv_world_destroy(world);
    return most;
}

/* Still water bursts with fewer substeps than the note offers, and with these it is calm. */
static void a_note_names_too_few_substeps(void **unused)
{
    (void)unused;
    skv_scene *scene = open_pool("1");
    const char *note = skv_scene_notice(scene, 0);
    assert_non_null(note);
    assert_string_equal(note, "with substeps 1 the fluid may burst; 0, or 2 and more can be had");
    assert_true(stirred(scene) > 10);
    skv_scene_destroy(scene);
    scene = open_pool("2");
    assert_null(skv_scene_notice(scene, 0));
    assert_true(stirred(scene) < 0.1);
    skv_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_note_offers_can_be_had),
        cmocka_unit_test(a_note_names_all_that_is_bad_together),
        cmocka_unit_test(a_note_names_too_few_substeps),
        cmocka_unit_test(all_that_is_accepted_stays_bounded),
        cmocka_unit_test(all_that_is_set_while_it_runs_stays_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
