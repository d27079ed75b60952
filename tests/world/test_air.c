/* Air: a bell keeps its own and obeys Boyle's law, a bubble rises, a siphon runs, a body with a
 * pocket floats, what is light is not thrown, and what has none is as without; the same bits on any
 * threads and instruction sets, and from snapshots; and what hosts ask of it. */
#include "base/bytes.h"
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define PRESSURE 10000.0f /* Pa m: a metre of water */
#define WEIGHT   9810.0   /* of water, N/m^3 */

/* A closed tank with walls painted into it, one stroke from each point to the next. */
static skv_world *make_tank(skv_world_def def, float width, float height, const float *points,
                            int count, float radius)
{
    skv_terrain_def shape = skv_default_terrain_def();
    shape.width = (int)(width / shape.pixel_size + 0.5f);
    shape.height = (int)(height / shape.pixel_size + 0.5f);
    skv_terrain *blank;
    assert_int_equal(skv_terrain_create(&shape, &blank, NULL), SKV_OK);
    skv_brush_stroke strokes[8];
    for (int i = 0; i + 1 < count; i++)
        strokes[i] = (skv_brush_stroke){
            points[2 * i], points[2 * i + 1], points[2 * i + 2], points[2 * i + 3], radius, false};
    assert_int_equal(skv_terrain_paint(blank, strokes, count - 1, &def.terrain, NULL), SKV_OK);
    skv_terrain_destroy(blank);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

/* Of the fluid's grain in all tanks but one. */
static skv_world_def make_def(skv_solver_kind solver, int threads, skv_instruction_set set,
                              float depth)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, 0.0155f, threads);
    def.instruction_set = set;
    def.depth = depth;
    return def;
}

/* A glass turned upside down in 0.5 m of water, with walls of 40 mm. */
static skv_world *make_bell(skv_solver_kind solver, int threads, skv_instruction_set set,
                            float pressure)
{
    static const float points[] = {0.25f, 0.14f, 0.25f, 0.36f, 0.55f, 0.36f, 0.55f, 0.14f};
    skv_world *world =
        make_tank(make_def(solver, threads, set, 0.5f), 0.8f, 0.7f, points, 4, 0.02f);
    fixture_fill(world, 0, 0, 0.8f, 0.12f);
    fixture_fill(world, 0, 0.12f, 0.23f, 0.5f);
    fixture_fill(world, 0.57f, 0.12f, 0.8f, 0.5f);
    fixture_fill(world, 0.23f, 0.38f, 0.57f, 0.5f);
    assert_int_equal(skv_world_set_air(world, pressure, NULL), SKV_OK);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    return world;
}

/* The height of the water between two uprights, at most `below`: half a spacing above the mean of
 * the highest particle in each of ten parts. */
static double level(const skv_world *world, float x0, float x1, float below)
{
    enum { PARTS = 10 };
    double highest[PARTS] = {0}, sum = 0;
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++) {
        int part = (int)((p.x[i] - x0) / (x1 - x0) * PARTS);
        if (p.x[i] > x0 && p.x[i] < x1 && p.y[i] < below && part < PARTS)
            highest[part] = fmax(highest[part], (double)p.y[i]);
    }
    for (int i = 0; i < PARTS; i++)
        sum += highest[i] / PARTS;
    return sum + 0.5 * (double)skv_world_spacing(world);
}

/* What all pockets hold, as the volume at the atmosphere's pressure; the largest one is written. */
static double amount(const skv_world *world, skv_pocket *largest)
{
    skv_pocket pockets[64];
    int count = skv_world_pockets(world, pockets, 64);
    double sum = 0, most = 0;
    for (int i = 0; i < count && i < 64; i++) {
        sum += (double)(pockets[i].volume * (1 + pockets[i].pressure / skv_world_air(world)));
        if ((double)pockets[i].volume > most)
            *largest = pockets[i];
        most = fmax(most, (double)pockets[i].volume);
    }
    return sum;
}

static void a_bell_keeps_its_air(void **unused)
{
    (void)unused;
    skv_pocket air = {0};
    skv_world *world = make_bell(SKV_SOLVER_FAST, 1, SKV_ISA_BEST, PRESSURE);
    fixture_run(world, 1);
    double held = amount(world, &air);
    assert_near(held, 0.26 * 0.22, 0.1 * 0.26 * 0.22);
    fixture_run(world, 600);
    assert_near(amount(world, &air) / held, 1, 0.02);
    double outside = level(world, 0.02f, 0.2f, 1), inside = level(world, 0.3f, 0.5f, 0.34f);
    double depth = WEIGHT * (outside - inside);
    assert_true(depth > 2500);
    /* p0 V0 = (p0 + rho g d) V, by the pocket's own volume and by the water's level. */
    double absolute = (double)PRESSURE + depth;
    assert_near(absolute * (double)air.volume / ((double)PRESSURE * held), 1, 0.03);
    assert_near(((double)PRESSURE + (double)air.pressure) / absolute, 1, 0.03);
    assert_true(skv_world_stats(world).rms_speed < 0.02);
    skv_world_destroy(world);
}

/* The bell with its air is lifted by what it displaces: the meter counts what the air presses on
 * its roof, or it would read nothing. By the grain of water that it reads 1.03 at a spacing of 10
 * mm and 1.06 at this one. */
static void meters_count_what_air_pushes(void **unused)
{
    (void)unused;
    skv_world *world = make_bell(SKV_SOLVER_FAST, 1, SKV_ISA_BEST, PRESSURE);
    skv_lab *lab;
    assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
    fixture_run(world, 480);
    skv_instrument meter = fixture_instrument(lab, SKV_INSTRUMENT_FORCE, 2, 0.2, 0.08, 0.6, 0.42);
    for (int f = 0; f < 120; f++) {
        fixture_run(world, 1);
        assert_int_equal(skv_lab_sample(lab, world, NULL), SKV_OK);
    }
    skv_pocket air = {0};
    amount(world, &air);
    /* Three strokes of 40 mm with round ends, which meet at right angles. */
    double walls = 0.74 * 0.04 + (3.14159265 * 1.5 - 2) * 0.0004;
    double lift = WEIGHT * (walls + (double)air.volume);
    assert_near(skv_lab_reading(lab, meter, 1) / lift, 1, 0.08);
    assert_near(skv_lab_reading(lab, meter, 0) / lift, 0, 0.03);
    assert_near(skv_lab_reading(lab, meter, 2) / lift, 0, 0.02);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* Without air it fills. */
static void without_air_it_fills(void **unused)
{
    (void)unused;
    skv_world *world = make_bell(SKV_SOLVER_FAST, 1, SKV_ISA_BEST, 0);
    fixture_run(world, 120);
    assert_true(level(world, 0.3f, 0.5f, 0.34f) > 0.3);
    assert_int_equal(skv_world_pockets(world, NULL, 0), 0);
    skv_world_destroy(world);
}

static void the_reference_keeps_it_too(void **unused)
{
    (void)unused;
    skv_pocket air = {0};
    skv_world *world = make_bell(SKV_SOLVER_REFERENCE, 1, SKV_ISA_BEST, PRESSURE);
    fixture_run(world, 1);
    double held = amount(world, &air);
    fixture_run(world, long_tests() ? 60 : 20);
    assert_near(amount(world, &air) / held, 1, 0.02);
    assert_true(level(world, 0.3f, 0.5f, 0.34f) < 0.25);
    skv_world_destroy(world);
}

/* A cavity in the water. */
static skv_world *make_bubble(int threads, skv_instruction_set set)
{
    skv_world *world =
        make_tank(make_def(SKV_SOLVER_FAST, threads, set, 0.6f), 0.8f, 0.8f, NULL, 1, 0);
    fixture_fill(world, 0, 0, 0.8f, 0.15f);
    fixture_fill(world, 0, 0.15f, 0.32f, 0.6f);
    fixture_fill(world, 0.48f, 0.15f, 0.8f, 0.6f);
    fixture_fill(world, 0.32f, 0.31f, 0.48f, 0.6f);
    assert_int_equal(skv_world_set_air(world, PRESSURE, NULL), SKV_OK);
    return world;
}

static void a_bubble_rises(void **unused)
{
    (void)unused;
    skv_pocket before = {0}, after = {0};
    skv_world *world = make_bubble(1, SKV_ISA_BEST);
    fixture_run(world, 1);
    double held = amount(world, &before);
    assert_near((double)before.y, 0.23, 0.01);
    fixture_run(world, 20);
    assert_near(amount(world, &after) / held, 1, 0.05);
    assert_true(after.y > before.y + 0.03f);
    /* At last it is gone, and the water is still. */
    fixture_run(world, 300);
    assert_true(amount(world, &after) < 0.1 * held);
    assert_true(skv_world_stats(world).rms_speed < 0.15);
    skv_world_destroy(world);
}

/* Two basins, parted by a wall, and an upturned U full of water that joins them. */
static skv_world *make_siphon(float pressure)
{
    static const float points[] = {0.2f, 0.12f, 0.2f, 0.8f, 0.8f, 0.8f, 0.8f, 0.12f};
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.02f, 1);
    skv_world *world = make_tank(def, 1, 1, points, 4, 0.1f);
    skv_terrain *carved, *parted;
    skv_brush_stroke strokes[3];
    for (int i = 0; i < 3; i++)
        strokes[i] = (skv_brush_stroke){
            points[2 * i], points[2 * i + 1], points[2 * i + 2], points[2 * i + 3], 0.06f, true};
    strokes[0].y0 = strokes[2].y1 = 0;
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), strokes, 3, &carved, NULL),
                     SKV_OK);
    const skv_brush_stroke wall = {0.5f, 0, 0.5f, 0.6f, 0.03f, false};
    assert_int_equal(skv_terrain_paint(carved, &wall, 1, &parted, NULL), SKV_OK);
    skv_terrain_destroy(carved);
    assert_int_equal(skv_world_set_terrain(world, parted, NULL, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 0.47f, 0.5f);
    fixture_fill(world, 0.14f, 0.5f, 0.26f, 0.74f);
    fixture_fill(world, 0.14f, 0.74f, 0.86f, 0.86f);
    fixture_fill(world, 0.74f, 0.2f, 0.86f, 0.74f);
    fixture_fill(world, 0.53f, 0, 1, 0.2f);
    assert_int_equal(skv_world_set_air(world, pressure, NULL), SKV_OK);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    return world;
}

static void a_siphon_runs(void **unused)
{
    (void)unused;
    for (int with_air = 0; with_air < 2; with_air++) {
        skv_world *world = make_siphon(with_air ? PRESSURE : 0);
        fixture_run(world, 300);
        double left = level(world, 0.31f, 0.46f, 0.6f), right = level(world, 0.54f, 0.69f, 0.6f);
        if (with_air)
            assert_near(left, right, 0.06);
        else
            assert_true(left > right + 0.1);
        skv_world_destroy(world);
    }
}

/* An upturned cup, heavier than water and heaviest at its rim: with its air it floats. */
static void a_diver_floats(void **unused)
{
    (void)unused;
    static const float outline[] = {-0.14f,  -0.125f, -0.04f, -0.125f, -0.04f, -0.065f, -0.11f,
                                    -0.025f, -0.11f,  0.105f, 0.11f,   0.105f, 0.11f,   -0.025f,
                                    0.04f,   -0.065f, 0.04f,  -0.125f, 0.14f,  -0.125f, 0.14f,
                                    -0.065f, 0.13f,   0.125f, -0.13f,  0.125f, -0.14f,  -0.065f};
    for (int with_air = 0; with_air < 2; with_air++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.0155f, 1);
        skv_world *world = make_tank(def, 0.6f, 0.8f, NULL, 1, 0);
        fixture_fill(world, 0, 0, 0.6f, 0.4f);
        skv_body_def cup = skv_default_body_def();
        cup.shape = skv_polygon(outline, 14);
        cup.x = 0.3f;
        cup.y = 0.55f;
        cup.density = 1700;
        skv_body_id id;
        skv_body body;
        assert_int_equal(skv_world_add_body(world, &cup, &id, NULL, NULL), SKV_OK);
        assert_int_equal(skv_world_set_air(world, with_air ? 50000.0f : 0, NULL), SKV_OK);
        fixture_run(world, 240);
        assert_true(skv_world_body(world, id, &body));
        if (with_air)
            assert_true(body.y > 0.25f);
        else
            assert_true(body.y < 0.2f);
        skv_world_destroy(world);
    }
}

/* A tank 0.31 m wide, of whole cells of the grid, with 0.1 m of water, over which a body lies as a
 * lid, 30 mm thick and from that height on. */
static skv_world *make_lid(float low, float density, float pressure, bool fixed)
{
    skv_world *world =
        make_tank(make_def(SKV_SOLVER_FAST, 1, SKV_ISA_BEST, 0.1f), 0.31f, 1, NULL, 1, 0);
    fixture_fill(world, 0, 0, 0.31f, 0.1f);
    skv_body_def lid = skv_default_body_def();
    lid.shape = skv_box(-0.151f, -0.015f, 0.151f, 0.015f);
    lid.x = 0.155f;
    lid.y = low + 0.015f;
    lid.density = density;
    lid.friction = 0;
    lid.fixed = fixed;
    assert_int_equal(skv_world_add_body(world, &lid, NULL, NULL, NULL), SKV_OK);
    assert_int_equal(skv_world_set_air(world, pressure, NULL), SKV_OK);
    return world;
}

/* What is so light that the air below it would throw it back in less than a substep: it swings out
 * within a second. */
static void air_throws_nothing_light(void **unused)
{
    (void)unused;
    static const float cases[][2] = {{10, 50000}, {50, 50000}, {10, 10000}};
    for (int k = 0; k < 3; k++) {
        skv_world *world = make_lid(0.15f, cases[k][0], cases[k][1], false);
        skv_body body;
        for (int frame = 0; frame < 90; frame++) {
            fixture_run(world, 1);
            assert_true(skv_world_body_at(world, 0, &body));
            if (!(fabsf(body.vy) < (frame < 60 ? 0.5f : 0.03f)))
                fail_msg("%g kg/m^2 at %g Pa m, frame %d: %g m/s", (double)cases[k][0],
                         (double)cases[k][1], frame, (double)body.vy);
        }
        assert_near((double)body.y, 0.165, 0.01);
        skv_world_destroy(world);
    }
}

/* Wherever a body lies in the cells of the grid: the pocket below it grows evenly as it rises. */
static void bodies_leave_pockets_their_room(void **unused)
{
    (void)unused;
    double before = 0;
    for (int mm = 150; mm <= 166; mm++) {
        skv_world *world = make_lid((float)mm / 1000, 1000, PRESSURE, true);
        fixture_run(world, 1);
        skv_pocket pockets[4], largest = {0};
        int count = skv_world_pockets(world, pockets, 4);
        for (int k = 0; k < count && k < 4; k++)
            largest = pockets[k].volume > largest.volume ? pockets[k] : largest;
        double more = ((double)largest.volume - before) / (0.001 * 0.31);
        if (mm > 150 && !(more > 0.5 && more < 1.6))
            fail_msg("%d mm up: %g times as much more as there is", mm, more);
        before = (double)largest.volume;
        skv_world_destroy(world);
    }
}

static skv_world *run_bell(int threads, skv_instruction_set set)
{
    skv_world *world = make_bell(SKV_SOLVER_FAST, threads, set, PRESSURE);
    fixture_run(world, 10);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_bell);
}

static void snapshots_keep_air(void **unused)
{
    (void)unused;
    skv_world *world = make_bubble(1, SKV_ISA_BEST), *copy;
    fixture_run(world, 25);
    fixture_saved b = fixture_save(world, false), bad = {malloc(b.size), b.size};
    assert_int_equal(skv_world_copy(world, fixture_host(2), &copy, NULL), SKV_OK);
    assert_true(skv_world_air(copy) == PRESSURE);
    fixture_expect_goes_on(world, 20);
    /* Also to a world that has none by now. */
    uint64_t hash = skv_world_hash(world);
    assert_int_equal(skv_world_set_air(world, 0, NULL), SKV_OK);
    fixture_run(world, 3);
    assert_int_equal(skv_world_restore(world, b.bytes, b.size, NULL), SKV_OK);
    fixture_run(world, 20);
    assert_true(skv_world_hash(world) == hash);
    /* Whatever byte of its air is another, it is refused, or a world goes on. */
    uint8_t pressure[5];
    skv_writer w = {pressure, 0};
    skv_put_float(&w, PRESSURE);
    skv_put(&w, 1, 1);
    size_t at = 0;
    while (memcmp(b.bytes + at, pressure, 5) != 0)
        at++;
    for (size_t k = at; k < at + 60; k++) {
        memcpy(bad.bytes, b.bytes, b.size);
        bad.bytes[k] ^= 0xff;
        fixture_seal(bad);
        if (skv_world_restore(copy, bad.bytes, bad.size, NULL) == SKV_OK)
            fixture_run(copy, 1);
    }
    free(b.bytes);
    free(bad.bytes);
    skv_world_destroy(world);
    skv_world_destroy(copy);
}

/* Bytes of air that cannot be. */
static void air_that_cannot_be_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_bubble(1, SKV_ISA_BEST);
    fixture_run(world, 1);
    fixture_saved b = fixture_save(world, false), bad = {malloc(b.size), b.size};
    uint8_t pressure[5];
    skv_writer w = {pressure, 0};
    skv_put_float(&w, PRESSURE);
    skv_put(&w, 1, 1);
    size_t at = 0;
    while (memcmp(b.bytes + at, pressure, 5) != 0)
        at++;
    static const struct {
        int offset, bytes;
        uint64_t value;
    } sins[] = {
        {0, 4, 0},                   /* no pressure */
        {0, 4, 0x7fc00000},          /* none that is a number */
        {0, 4, 0x49742400},          /* 1e6 Pa m */
        {4, 1, 2},                   /* begun twice */
        {5, 8, 0x40f0000000000000u}, /* lifted by more than there is */
        {21, 4, 7},                  /* of another world's cells */
        {25, 2, 60000},              /* a label that no pocket has */
        {27, 2, 0},                  /* a run of nothing */
    };
    for (size_t i = 0; i < sizeof sins / sizeof *sins; i++) {
        memcpy(bad.bytes, b.bytes, b.size);
        skv_put(&(skv_writer){bad.bytes, at + (size_t)sins[i].offset}, sins[i].value,
                sins[i].bytes);
        fixture_seal(bad);
        uint64_t hash = skv_world_hash(world);
        assert_int_not_equal(skv_world_restore(world, bad.bytes, bad.size, NULL), SKV_OK);
        assert_true(skv_world_hash(world) == hash);
    }
    free(b.bytes);
    free(bad.bytes);
    skv_world_destroy(world);
}

static void hosts_are_told(void **unused)
{
    (void)unused;
    skv_error error;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    assert_true(skv_world_air(world) == 0);
    static const float wrong[] = {-1, 100001, NAN, INFINITY};
    for (int i = 0; i < 4; i++)
        assert_int_equal(skv_world_set_air(world, wrong[i], &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "air: a pressure of inf Pa m is out of range; allowed is "
                                    "0..100000 Pa m");
    assert_int_equal(skv_world_set_air(world, 5000, NULL), SKV_OK);
    assert_true(skv_world_air(world) == 5000);
    fixture_run(world, 1);
    assert_int_equal(skv_world_pockets(world, NULL, 0), 0);
    skv_world_destroy(world);
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.0004f * 2, 1);
    def.terrain = NULL;
    def.fluid.spacing = 0.0005f;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    assert_int_equal(skv_world_set_air(world, 5000, &error), SKV_ERROR_LIMIT);
    assert_true(skv_world_air(world) == 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bell_keeps_its_air),
        cmocka_unit_test(meters_count_what_air_pushes),
        cmocka_unit_test(without_air_it_fills),
        cmocka_unit_test(the_reference_keeps_it_too),
        cmocka_unit_test(a_bubble_rises),
        cmocka_unit_test(a_siphon_runs),
        cmocka_unit_test(a_diver_floats),
        cmocka_unit_test(air_throws_nothing_light),
        cmocka_unit_test(bodies_leave_pockets_their_room),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(snapshots_keep_air),
        cmocka_unit_test(air_that_cannot_be_is_refused),
        cmocka_unit_test(hosts_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
