/* What a scene has beside its world's parameters stays bounded, too: each number of a second fluid,
 * of a body and of air, at its ends and at ten places between, in a dam that breaks and in a pool,
 * by both laws.
 *
 * Bounds are those of test_bounded.c: half as much again as the fall from the water's highest place
 * allows. The heavier of two fluids, or of fluid and body, lies below, for what sinks drives the
 * other faster than any fall. Numbers that are themselves speeds, places or forces (bodies[].vx,
 * pins, motors) are left out. */
#include "scene/support.h"

#include "skvalp/bodies.h"
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

/* As in test_bounded.c, in spacings; of a bubble in the pool, its side. */
enum {
    DAM_WIDTH = 14,
    DAM_HEIGHT = 24,
    DAM_TANK = 160,
    POOL_WIDTH = 40,
    POOL_HEIGHT = 10,
    TOP = 36,
    BUBBLE = 4
};
enum { PLACES = 12, WATCHED = 36 };
static const double spacing = 0.02, water = 1000;

/* A field, and what else the item of its list has. */
typedef struct tried {
    const char *path, *beside;
    double least,
        most; /* what the world's first fluid allows of it; 0, 0: what the registry does */
} tried;

static const tried rows[] = {
    {"fluids[].density", "", 10, 20000}, /* 0.01 and 20 times that of water */
    {"fluids[].viscosity", "", 0, 0},
    {"fluids[].shear_modulus", "", 0, 0},
    {"fluids[].yield", ",\"shear_modulus\":2000,\"plasticity\":10", 0, 0},
    {"fluids[].plasticity", ",\"shear_modulus\":2000", 0, 0},
    {"fluids[].interface_push", "", 0, 0},
    {"fluids[].cohesion", "", 0, 0},
    {"bodies[].density", "", 0, 0},
    {"bodies[].angle", "", 0, 0},
    {"bodies[].friction", "", 0, 0},
    {"bodies[].restitution", "", 0, 0},
    {"air.pressure", "", 0, 0},
};

typedef struct run {
    const tried *row;
    double value;
    bool clavet, pool;
} run;

static const char *member_of(const tried *row)
{
    return strrchr(row->path, '.') + 1;
}

/* Two fluids, one above the other. */
static void write_fluids(const run *r, double width, double height, char *text, size_t size)
{
    bool below = strcmp(member_of(r->row), "density") == 0 && r->value > water;
    snprintf(
        text, size,
        "\"fluids\":[{\"name\":\"other\",\"%s\":%.9g%s}],\"water\":[{\"shape\":\"box\","
        "\"x1\":%.9g,\"y1\":%.9g%s},{\"shape\":\"box\",\"x1\":%.9g,\"y0\":%.9g,\"y1\":%.9g%s}]",
        member_of(r->row), r->value, r->row->beside, width, height / 2,
        below ? ",\"fluid\":\"other\"" : "", width, height / 2, height,
        below ? "" : ",\"fluid\":\"other\"");
}

/* A box in the fluid, on the floor if it is heavier. */
static void write_body(const run *r, double width, double height, char *text, size_t size)
{
    double side = 5 * spacing, x = (width - side) / 2, y = (height - side) / 2;
    if (strcmp(member_of(r->row), "density") == 0 && r->value > water)
        y = 0;
    snprintf(text, size,
             "\"bodies\":[{\"shape\":\"box\",\"x0\":%.9g,\"x1\":%.9g,\"y0\":%.9g,\"y1\":%.9g,"
             "\"%s\":%.9g}],\"water\":[{\"shape\":\"box\",\"x1\":%.9g,\"y1\":%.9g}]",
             x, x + side, y, y + side, member_of(r->row), r->value, width, height);
}

/* Fluid around a bubble, in four boxes. */
static void write_air(const run *r, double width, double height, char *text, size_t size)
{
    double side = BUBBLE * spacing, x0 = (width - side) / 2, y0 = (height - side) / 2,
           x1 = x0 + side, y1 = y0 + side;
    snprintf(text, size,
             "\"air\":{\"pressure\":%.9g},\"water\":[{\"shape\":\"box\",\"x1\":%.9g,\"y1\":%.9g},"
             "{\"shape\":\"box\",\"x1\":%.9g,\"y0\":%.9g,\"y1\":%.9g},"
             "{\"shape\":\"box\",\"x0\":%.9g,\"x1\":%.9g,\"y0\":%.9g,\"y1\":%.9g},"
             "{\"shape\":\"box\",\"x1\":%.9g,\"y0\":%.9g,\"y1\":%.9g}]",
             r->value, width, y0, x0, y0, y1, x1, width, y0, y1, width, y1, height);
}

/* The world; null if a message says what is allowed instead, or a note what can be had. */
static skv_world *open(const run *r)
{
    double width = (r->pool ? POOL_WIDTH : DAM_WIDTH) * spacing;
    double height = (r->pool ? POOL_HEIGHT : DAM_HEIGHT) * spacing;
    char holds[700], text[1000];
    void (*const write)(const run *, double, double, char *, size_t) =
        r->row->path[0] == 'f'   ? write_fluids
        : r->row->path[0] == 'b' ? write_body
                                 : write_air;
    write(r, width, height, holds, sizeof holds);
    snprintf(text, sizeof text,
             "{\"world\":{\"width\":%.9g,\"height\":%.9g,\"pixel\":%.9g},"
             "\"fluid\":{\"spacing\":%.9g,\"law\":\"%s\"},%s}",
             (r->pool ? POOL_WIDTH : DAM_TANK) * spacing, TOP * spacing, spacing / 2, spacing,
             r->clavet ? "clavet" : "calibrated", holds);
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error;
    if (load_text(text, NULL, &scene, &error) != SKV_OK) {
        if (!strstr(error.text, "allowed is"))
            fail_msg("%s", error.text);
        return NULL;
    }
    const char *note = skv_scene_notice(scene, 0);
    bool noted = note && strstr(note, member_of(r->row)) && strstr(note, "can be had");
    if (!noted && skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_scene_destroy(scene);
    return world;
}

static double fastest(const skv_world *world)
{
    double most = skv_world_stats(world).max_speed;
    for (int i = 0; i < skv_world_body_count(world); i++) {
        skv_body body;
        skv_world_body_at(world, i, &body);
        most = fmax(most, hypot((double)body.vx, (double)body.vy));
    }
    return most;
}

static void expect_bounded(const run *r)
{
    skv_world *world = open(r);
    if (!world)
        return;
    double highest = 0, most = 0;
    skv_particles p = skv_world_particles(world);
    int count = p.count;
    for (int i = 0; i < count; i++)
        highest = fmax(highest, (double)p.y[i]);
    for (int frame = 0; frame < WATCHED; frame++) {
        fixture_run(world, 1);
        skv_stats stats = skv_world_stats(world);
        most = fmax(most, fastest(world));
        if (stats.not_finite || stats.escaped || stats.particles != count)
            fail_msg("%s %g: lost particles", r->row->path, r->value);
    }
    most /= sqrt(2 * 9.81 * highest);
    if (!(most < 1.5))
        fail_msg("%s %g, %s, %s: %.2f of what the fall allows", r->row->path, r->value,
                 r->clavet ? "clavet" : "calibrated", r->pool ? "pool" : "dam", most);
    skv_world_destroy(world);
}

static const skv_field *field_of(const tried *row)
{
    const skv_field *field = NULL;
    for (int i = 0; (field = skv_scene_field(i)) && strcmp(field->path, row->path) != 0; i++)
        ;
    assert_non_null(field);
    return field;
}

/* The ends in a dam; in the long form, the places between and a pool, too. */
static void all_that_is_accepted_stays_bounded(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const skv_field *field = field_of(&rows[k]);
        double least = rows[k].most > 0 ? rows[k].least : field->minimum;
        double most = rows[k].most > 0 ? rows[k].most : field->maximum;
        for (int i = 0; i < PLACES; i += long_tests() ? 1 : PLACES - 1)
            for (int form = 0; form < (long_tests() ? 4 : 2); form++)
                expect_bounded(&(run){&rows[k], least + (most - least) * i / (PLACES - 1),
                                      form % 2 == 1, form / 2 == 1});
    }
}

/* What the note offers of a light fluid can be had, whatever the heaviest one's density is. */
static void what_a_note_offers_can_be_had(void **unused)
{
    (void)unused;
    const run light = {&rows[0], 20, true, false}, had = {&rows[0], 50, true, false};
    assert_null(open(&light));
    expect_bounded(&had);
    skv_scene *scene;
    static const char *const three =
        "{\"fluid\":{\"law\":\"clavet\"},\"water\":[{\"shape\":\"box\",\"y1\":0.3}],\"fluids\":"
        "[{\"name\":\"a\",\"density\":2000},{\"name\":\"b\",\"density\":60}]}";
    assert_int_equal(load_text(three, NULL, &scene, NULL), SKV_OK);
    assert_string_equal(skv_scene_notice(scene, 0), "with fluids[1].density 60 the clavet fluid "
                                                    "bursts; 100 to 20000 can be had");
    skv_scene_destroy(scene);
    const char *const calibrated[] = {"fluid.law", "calibrated", NULL};
    assert_int_equal(load_text(three, calibrated, &scene, NULL), SKV_OK);
    assert_null(skv_scene_notice(scene, 0));
    skv_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_note_offers_can_be_had),
        cmocka_unit_test(all_that_is_accepted_stays_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
