/* Fluid that rests as it is drawn has the level that is drawn, within 0.5 % of the depth or a
 * quarter of a spacing, in vessels of any shape, of many particles and few. What misses is named:
 * it may come nearer, and then it is to be struck out here. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "skvalp/skvalp.h"
#include "support/fixture.h"
#include "support/long.h"
#include "world/world_internal.h"

#define SHARE   0.005 /* of the depth */
#define SPACING 0.25

typedef struct vessel {
    const char *name, *walls, *water;
    double floor, level, x, y; /* m; and where the gauge begins */
} vessel;

#define ALL_BUT "{\"shape\": \"box\"}, "
#define CARVED  "{\"carve\": true, \"shape\": "
#define TUBE(right)                                                                                \
    ALL_BUT CARVED "\"box\", \"x0\": 0.7, \"x1\": " right ", \"y0\": 0.1}",                        \
        "{\"shape\": \"box\", \"y1\": 0.7}", 0.1, 0.7

/* Tubes are 3.2, 5 and 10 spacings of 300 particles wide. */
static const vessel vessels[] = {
    {"tank", "", "{\"shape\": \"box\", \"y1\": 0.45}", 0, 0.45, 0.8, 0.2},
    {"flask",
     ALL_BUT CARVED "\"box\", \"x0\": 0.55, \"x1\": 1.05, \"y0\": 0.1, \"y1\": 0.4}, " CARVED
                    "\"box\", \"x0\": 0.75, \"x1\": 0.85, \"y0\": 0.3}",
     "{\"shape\": \"box\", \"y1\": 0.7}", 0.1, 0.7, 0.8, 0.3},
    {"funnel",
     ALL_BUT CARVED "\"polygon\", \"points\": [[0.7, 0.1], [0.9, 0.1], [1.3, 0.9], [0.3, 0.9]]}",
     "{\"shape\": \"box\", \"y1\": 0.7}", 0.1, 0.7, 0.8, 0.3},
    {"slanted vessel",
     ALL_BUT CARVED "\"polygon\", \"points\": [[0.2, 0.1], [0.5, 0.1], [1.3, 0.9], [1.0, 0.9]]}",
     "{\"shape\": \"box\", \"y1\": 0.7}", 0.1, 0.7, 0.95, 0.6},
    {"bowl", ALL_BUT CARVED "\"circle\", \"x\": 0.8, \"y\": 0.6, \"radius\": 0.5}",
     "{\"shape\": \"box\", \"y1\": 0.45}", 0.1, 0.45, 0.8, 0.25},
    {"narrow tube", TUBE("0.72"), 0.71, 0.3},
    {"tube", TUBE("0.75"), 0.725, 0.3},
    {"wide tube", TUBE("0.9"), 0.8, 0.3},
};
enum { VESSELS = sizeof vessels / sizeof *vessels, NARROW = 5 };

/* What misses, and by how many spacings at most. A row of particles more or less between walls 3 or
 * 4 spacings apart takes another room than its share. */
static const struct {
    const char *name;
    int particles;
    double most;
} misses[] = {{"flask", 300, 0.6}, {"slanted vessel", 300, 0.3}, {"narrow tube", 300, 1.2}};

static double miss_of(const vessel *v, int particles)
{
    for (size_t i = 0; i < sizeof misses / sizeof *misses; i++)
        if (strcmp(misses[i].name, v->name) == 0 && misses[i].particles == particles)
            return misses[i].most;
    return 0;
}

/* The mean level of a second, after `wait` more, m. */
static double level_of(skv_world *world, const vessel *v, double wait)
{
    skv_lab *lab;
    skv_instrument gauge;
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_LEVEL);
    def.x0 = def.x1 = v->x;
    def.y0 = v->y;
    def.y1 = 0.89;
    assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
    assert_int_equal(skv_lab_add(lab, &def, &gauge, NULL), SKV_OK);
    fixture_run(world, (int)(60 * wait));
    double sum = 0;
    for (int frame = 0; frame < 60; frame++) {
        fixture_run(world, 1);
        assert_int_equal(skv_lab_sample(lab, world, NULL), SKV_OK);
        sum += skv_lab_reading(lab, gauge, 2);
    }
    skv_lab_destroy(lab);
    return sum / 60;
}

static skv_world *open(const vessel *v, int particles)
{
    char text[1000];
    snprintf(text, sizeof text, "{\"particles\": %d, \"solid\": [%s], \"water\": [%s]}", particles,
             v->walls, v->water);
    return open_text(text);
}

static void expect_level(const vessel *v, int particles)
{
    skv_world *world = open(v, particles);
    double s = (double)skv_world_spacing(world), off = level_of(world, v, 3) - v->level;
    double most = fmax(SHARE * (v->level - v->floor), SPACING * s), named = miss_of(v, particles);
    skv_world_destroy(world);
    if (named > 0 && fabs(off) <= most)
        fail_msg("%s, %d particles: no longer misses", v->name, particles);
    most = fmax(most, named * s);
    if (!(fabs(off) <= most))
        fail_msg("%s, %d particles: %.4f m off, %.2f spacings", v->name, particles, off, off / s);
}

static void levels_are_as_drawn(void **unused)
{
    (void)unused;
    static const int numbers[] = {300, 1000, 3000, 10000};
    for (int i = 0; i < VESSELS; i++)
        for (int k = 0; k < (i >= NARROW ? 1 : long_tests() ? 4 : 2); k++)
            expect_level(&vessels[i], numbers[k]);
}

/* One world has one compression, and vessels of other mean depths are off by the difference: what
 * holds for each of them alone does not hold for the flask among others. */
static void other_depths_in_one_world_miss(void **unused)
{
    (void)unused;
    const vessel v = {"flask beside a tank",
                      ALL_BUT CARVED
                      "\"box\", \"x0\": 0.05, \"x1\": 0.45, \"y0\": 0.1, \"y1\": 0.4}, " CARVED
                      "\"box\", \"x0\": 0.2, \"x1\": 0.3, \"y0\": 0.3}, " CARVED
                      "\"box\", \"x0\": 0.6, \"x1\": 1.5, \"y0\": 0.4}",
                      "{\"shape\": \"box\", \"y1\": 0.7}",
                      0.1,
                      0.7,
                      0.25,
                      0.3};
    skv_world *world = open(&v, 1000);
    double off = (level_of(world, &v, 3) - v.level) / (v.level - v.floor);
    skv_world_destroy(world);
    if (!(off < -SHARE && off > -0.06))
        fail_msg("%.4f of the depth", off);
}

/* Where water stands at its level, and for good: what is asleep does not sink. */
static void levels_stay(void **unused)
{
    (void)unused;
    skv_world *world = open(&vessels[0], 1000);
    double s = (double)skv_world_spacing(world), before = level_of(world, &vessels[0], 0);
    double after = level_of(world, &vessels[0], long_tests() ? 60 : 10);
    assert_near(after, before, 0.1 * s);
    skv_world_destroy(world);
}

/* Without weight there is nothing to make up for, and what falls keeps its size. */
static void what_has_no_level_is_left_alone(void **unused)
{
    (void)unused;
    static const char *const scenes[] = {
        "{\"particles\": 300, \"gravity\": {\"y\": 0}, \"water\": [{\"shape\": \"box\", \"y1\": "
        "0.4}]}",
        "{\"particles\": 300, \"water\": [{\"shape\": \"box\", \"x1\": 0.5, \"y1\": 0.6}]}",
        "{\"particles\": 300, \"water\": [{\"shape\": \"circle\", \"x\": 0.8, \"y\": 0.5, "
        "\"radius\": 0.2}]}",
        "{\"particles\": 300, \"settle\": false, \"water\": [{\"shape\": \"box\", \"y1\": 0.4}]}",
    };
    for (int i = 0; i < 4; i++) {
        skv_world *world = open_text(scenes[i]);
        assert_true(world->compression == 0);
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels_are_as_drawn),
        cmocka_unit_test(other_depths_in_one_world_miss),
        cmocka_unit_test(levels_stay),
        cmocka_unit_test(what_has_no_level_is_left_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
