/* Scenes that mix all: walls, up to four fluids of which some are jelly or clay, bodies of any
 * shape and density, air, thrown together by chance. For some seconds no number is lost, nothing
 * escapes, and the energy of all together never grows.
 *
 * Scenes are named by their seed. Five of them by default, which once burst or grew, and the first
 * 60 with SKV_LONG_TESTS=1; SKV_SCENE=N runs scene N alone and prints it. */
#include "scene/support.h"

#include "skvalp/skvalp.h"
#include "support/long.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MANY_SCENES = 60, SECONDS = 2, MANY_SECONDS = 10 };
static const int bursting[] = {14, 43, 50, 114, 243};

typedef struct text {
    char bytes[6000];
    int used;
} text;

#define SAY(t, ...)                                                                                \
    ((t)->used +=                                                                                  \
     snprintf((t)->bytes + (t)->used, sizeof(t)->bytes - (size_t)(t)->used, __VA_ARGS__))

static int whole(uint32_t *state, int from, int to)
{
    return from + (int)(dice(state) % (uint32_t)(to - from + 1));
}

static double number(uint32_t *state, double from, double to)
{
    return from + (to - from) * (dice(state) % 10001) / 10000;
}

/* One of the kinds of shape, about so large, somewhere in a box. */
static void say_shape(text *t, uint32_t *state, double size, double width, double height)
{
    double x = number(state, 0.1 * width, 0.9 * width);
    double y = number(state, 0.1 * height, 0.9 * height);
    double a = number(state, 0.5, 1) * size / 2, b = number(state, 0.5, 1) * size / 2;
    switch (whole(state, 0, 3)) {
    case 0:
        SAY(t, "\"shape\": \"box\", \"x0\": %.3f, \"x1\": %.3f, \"y0\": %.3f, \"y1\": %.3f", x - a,
            x + a, y - b, y + b);
        break;
    case 1:
        SAY(t, "\"shape\": \"circle\", \"x\": %.3f, \"y\": %.3f, \"radius\": %.3f", x, y, a);
        break;
    case 2:
        SAY(t, "\"shape\": \"line\", \"points\": [[%.3f, %.3f], [%.3f, %.3f]], \"thickness\": %.3f",
            x - a, y - b, x + a, y + b, 0.3 * size);
        break;
    default:
        SAY(t, "\"shape\": \"polygon\", \"points\": [[%.3f, %.3f], [%.3f, %.3f], [%.3f, %.3f]]",
            x - a, y - b, x + a, y - 0.5 * b, x + 0.3 * a, y + b);
    }
}

static int say_fluids(text *t, uint32_t *state)
{
    int fluids = whole(state, 0, 3);
    SAY(t, "\"fluids\": [");
    for (int i = 0; i < fluids; i++) {
        SAY(t, "%s\n {\"name\": \"f%d\", \"density\": %.0f", i ? "," : "", i,
            1000 * pow(10, number(state, -0.7, 1)));
        if (whole(state, 0, 2) == 0)
            SAY(t, ", \"shear_modulus\": %.0f, \"plasticity\": %d", number(state, 500, 5000),
                whole(state, 0, 1));
        SAY(t, ", \"interface_push\": %d}", 20 * whole(state, 0, 3));
    }
    SAY(t, "],\n");
    return fluids;
}

static void say_water(text *t, uint32_t *state, int fluids, double width, double height)
{
    double low = number(state, 0.2, 0.5) * height;
    SAY(t, "\"water\": [{\"shape\": \"box\", \"y1\": %.3f}", low);
    for (int i = 0; i < fluids; i++) {
        SAY(t, ",\n {\"fluid\": \"f%d\", ", i);
        say_shape(t, state, number(state, 0.15, 0.5), width, height);
        SAY(t, "}");
    }
    SAY(t, "],\n");
}

static void write_scene(text *t, uint32_t *state)
{
    double width = number(state, 0.8, 2), height = number(state, 0.6, 1.2);
    SAY(t, "{\"particles\": %d, \"settle\": %s, \"world\": {\"width\": %.2f, \"height\": %.2f},\n",
        whole(state, 400, 1500), whole(state, 0, 1) ? "true" : "false", width, height);
    if (whole(state, 0, 2) == 0)
        SAY(t, "\"air\": {\"pressure\": %d},\n", whole(state, 1, 50));
    int fluids = say_fluids(t, state);
    say_water(t, state, fluids, width, height);
    SAY(t, "\"solid\": [");
    for (int i = 0, walls = whole(state, 0, 3); i < walls; i++) {
        SAY(t, "%s\n {", i ? "," : "");
        say_shape(t, state, 0.4, width, 0.5 * height);
        SAY(t, "}");
    }
    SAY(t, "],\n\"bodies\": [");
    for (int i = 0, bodies = whole(state, 0, 8); i < bodies; i++) {
        SAY(t, "%s\n {\"density\": %.0f, \"friction\": %.1f, \"restitution\": %.1f, ", i ? "," : "",
            1000 * pow(10, number(state, -1, 0.9)), number(state, 0, 1), number(state, 0, 0.9));
        say_shape(t, state, 0.25, width, height);
        SAY(t, "}");
    }
    SAY(t, "]}\n");
}

/* Of air that is pressed or drawn, J/m: what it takes at a constant temperature. */
static double energy_of_air(const skv_world *world)
{
    skv_pocket pockets[20];
    double sum = 0, pressure = (double)skv_world_air(world);
    int count = pressure > 0 ? skv_world_pockets(world, pockets, 20) : 0;
    for (int i = 0; i < count && i < 20; i++) {
        double now = (double)pockets[i].volume;
        double then = now * (1 + (double)pockets[i].pressure / pressure);
        sum += pressure * (then * log(then / now) - then + now);
    }
    return sum;
}

/* Of motion, height and air, J/m; and what it would take to lift all to the world's top. */
static double energy_of(const skv_world *world, double *most)
{
    skv_stats stats = skv_world_stats(world);
    double sum = stats.kinetic_energy + stats.potential_energy + energy_of_air(world);
    double mass = stats.potential_energy / (9.81 * stats.centre_y);
    skv_body b;
    for (int i = 0; skv_world_body_at(world, i, &b); i++) {
        double square = (double)b.vx * (double)b.vx + (double)b.vy * (double)b.vy;
        sum += ((double)b.mass * square + (double)b.inertia * (double)b.spin * (double)b.spin) / 2;
        sum += 9.81 * (double)b.mass * (double)b.y;
        mass += (double)b.mass;
    }
    *most = 9.81 * mass * (double)skv_terrain_height(skv_world_terrain(world));
    return sum;
}

/* What overlaps at the start has a second to part. Then energy grows no more; where springs or air
 * store some, it does not become more than it was. */
static bool watch(skv_world *world, char failure[600], bool talk)
{
    int particles = skv_world_particle_count(world), bodies = skv_world_body_count(world);
    bool stores = skv_world_spring_count(world) > 0 || skv_world_air(world) > 0;
    double all;
    energy_of(world, &all);
    double least = 2 * all;
    const int frames = 60 * (long_tests() ? MANY_SECONDS : SECONDS);
    for (int frame = 1; frame <= frames; frame++) {
        skv_error error;
        if (skv_world_step(world, 1.0f / 60, &error) != SKV_OK)
            return snprintf(failure, 600, "frame %d: %s", frame, error.text), false;
        if (frame % 30)
            continue;
        skv_stats stats = skv_world_stats(world);
        double now = energy_of(world, &all);
        if (talk)
            print_message("frame %3d: %.4f of the most, %.2f m/s at most\n", frame, now / all,
                          stats.max_speed);
        if (stats.not_finite || stats.escaped || stats.particles != particles ||
            skv_world_body_count(world) != bodies || !isfinite(now))
            return snprintf(failure, 600, "frame %d: %d of %d particles, %d not finite, %d escaped",
                            frame, stats.particles, particles, stats.not_finite, stats.escaped),
                   false;
        if (now > least + 0.01 * all)
            return snprintf(failure, 600, "frame %d: energy grew from %g to %g of the most", frame,
                            least / all, now / all),
                   false;
        if (frame >= 60 && (!stores || frame == 60))
            least = now < least ? now : least;
    }
    return true;
}

static bool run_scene(uint32_t seed, bool talk)
{
    text *t = calloc(1, sizeof *t);
    assert_non_null(t);
    uint32_t state = seed;
    write_scene(t, &state);
    if (talk)
        puts(t->bytes); /* a message may not be as long */
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error = {0};
    char failure[600] = "";
    bool good = load_text(t->bytes, NULL, &scene, &error) == SKV_OK &&
                skv_scene_create_world(scene, 1, &world, &error) == SKV_OK;
    if (!good)
        snprintf(failure, sizeof failure, "%s", error.text);
    good = good && watch(world, failure, talk);
    if (!good)
        print_message("scene %u: %s\n", seed, failure);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    free(t);
    return good;
}

static void mixtures_stay_bounded(void **unused)
{
    (void)unused;
    const char *one = getenv("SKV_SCENE");
    int count = one ? 1 : long_tests() ? MANY_SCENES : (int)(sizeof bursting / sizeof *bursting);
    int bad = 0;
    for (int i = 0; i < count; i++) {
        int seed = one ? atoi(one) : long_tests() ? i + 1 : bursting[i];
        bad += !run_scene((uint32_t)seed, one != NULL);
    }
    if (bad)
        fail_msg("something went wrong in %d of %d scenes; SKV_SCENE=N runs one", bad, count);
}

/* From the depth, of which each is a hundredth to a quarter as heavy as water: no more of them than
 * a fall from there to the surface would give, though the water that lies on them weighs up to a
 * hundred times as much. */
static void light_bodies_rise(void **unused)
{
    (void)unused;
    static const char *const shapes[] = {
        "\"polygon\", \"points\": [[0.42, 0.1], [0.58, 0.13], [0.52, 0.25]]",
        "\"circle\", \"x\": 0.5, \"y\": 0.15, \"radius\": 0.04",
        "\"line\", \"points\": [[0.3, 0.1], [0.6, 0.2]], \"thickness\": 0.03",
    };
    static const int densities[] = {10, 50, 240};
    for (int k = 0; k < 9; k++) {
        char scene[500];
        snprintf(scene, sizeof scene,
                 "{\"particles\": 500, \"world\": {\"width\": 1, \"height\": 0.7}, "
                 "\"water\": [{\"shape\": \"box\", \"y1\": 0.4}], "
                 "\"bodies\": [{\"density\": %d, \"shape\": %s}]}",
                 densities[k / 3], shapes[k % 3]);
        skv_world *world = open_text(scene);
        double most = sqrt(2 * 9.81 * 0.4);
        skv_body body;
        for (int frame = 0; frame < 60; frame++) {
            assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
            assert_true(skv_world_body_at(world, 0, &body));
            if (!(hypot((double)body.vx, (double)body.vy) < most))
                fail_msg("%s\nframe %d: %g, %g m/s", scene, frame, (double)body.vx,
                         (double)body.vy);
        }
        assert_true(body.y > 0.25f);
        skv_world_destroy(world);
    }
}

/* Bodies that begin in each other, beside, within, around the same middle and in the very same
 * place, as where a list has one twice, are apart in a second, and lie still then: points of the
 * rim of one that lies deep in another are nearest to all of its sides, and who asks them out by
 * these asks for all ways at once, holds the two, and lifts them. */
static void what_lies_in_each_other_parts(void **unused)
{
    (void)unused;
    static const struct {
        double x, y, radius;
    } second[] = {{0.52, 0.23, 0.09}, {0.52, 0.18, 0.04}, {0.5, 0.2, 0.06}, {0.5, 0.2, 0.1}};
    static const int densities[][2] = {{500, 5000}, {5000, 500}, {4000, 4000}};
    for (int k = 0; k < 12; k++) {
        char scene[500];
        snprintf(
            scene, sizeof scene,
            "{\"particles\": 500, \"world\": {\"width\": 1, \"height\": 0.7}, "
            "\"water\": [{\"shape\": \"box\", \"y1\": 0.2}], \"bodies\": ["
            "{\"density\": %d, \"shape\": \"circle\", \"x\": 0.5, \"y\": 0.2, \"radius\": 0.1},"
            "{\"density\": %d, \"shape\": \"circle\", \"x\": %g, \"y\": %g, "
            "\"radius\": %g}]}",
            densities[k % 3][0], densities[k % 3][1], second[k / 3].x, second[k / 3].y,
            second[k / 3].radius);
        skv_world *world = open_text(scene);
        skv_body a, b;
        for (int frame = 0; frame < 60; frame++)
            assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
        assert_true(skv_world_body_at(world, 0, &a) && skv_world_body_at(world, 1, &b));
        double apart = hypot((double)a.x - (double)b.x, (double)a.y - (double)b.y);
        if (!(apart > 0.1 + second[k / 3].radius - 0.002))
            fail_msg("%s\ntheir centres are %g m apart", scene, apart);
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mixtures_stay_bounded),
        cmocka_unit_test(what_lies_in_each_other_parts),
        cmocka_unit_test(light_bodies_rise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
