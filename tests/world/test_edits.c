/* Walls that are drawn and erased while a world runs: bit for bit what a world has whose terrain
 * was made from the same picture. */
#include "support/failing_memory.h"
#include "support/fixture.h"
#include "support/long.h"
#include "terrain/terrain.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { COLUMNS = 240, ROWS = 150 };
static const float pixel = 0.004f;

/* Numbers from 0 to 1, the same everywhere. */
static float roll(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) / 16777216.0f;
}

static skv_terrain *make_terrain(unsigned open_sides)
{
    skv_terrain_def def = skv_default_terrain_def();
    def.width = COLUMNS;
    def.height = ROWS;
    def.pixel_size = pixel;
    def.open_sides = open_sides;
    skv_terrain *terrain;
    assert_int_equal(skv_terrain_create(&def, &terrain, NULL), SKV_OK);
    return terrain;
}

/* What a terrain of the same picture would be. */
static skv_terrain *made_anew(const skv_terrain *terrain)
{
    static uint8_t picture[COLUMNS * ROWS];
    for (int y = 0; y < ROWS; y++)
        memcpy(picture + (size_t)y * COLUMNS, skv_terrain_row(terrain, y), COLUMNS);
    skv_terrain_def def = skv_default_terrain_def();
    def.width = COLUMNS;
    def.height = ROWS;
    def.pixel_size = pixel;
    def.open_sides = skv_terrain_open_sides(terrain);
    def.coverage = picture;
    skv_terrain *made;
    assert_int_equal(skv_terrain_create(&def, &made, NULL), SKV_OK);
    return made;
}

/* The kinds of world whose walls are drawn. */
typedef struct kind {
    skv_solver_kind solver;
    bool images;
} kind;

static const kind usual = {SKV_SOLVER_FAST, false};

static skv_world *make_world(const kind *k, skv_terrain *terrain, float spacing, int threads,
                             skv_instruction_set set)
{
    skv_world_def def = skv_default_world_def();
    def.solver = k->solver;
    def.fluid.wall_images = k->images;
    def.terrain = terrain;
    def.fluid.spacing = spacing;
    def.threads = threads;
    def.instruction_set = set;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

/* Strokes from place to place; thin ones make thin walls. */
static skv_brush_stroke next_stroke(uint32_t *state, const skv_brush_stroke *last)
{
    skv_brush_stroke s = {.x0 = last->x1, .y0 = last->y1};
    s.x1 = s.x0 + 0.1f * (roll(state) - 0.5f);
    s.y1 = s.y0 + 0.1f * (roll(state) - 0.5f);
    if (!(s.x1 > -0.1f && s.x1 < 1.1f && s.y1 > -0.1f && s.y1 < 0.7f)) {
        s.x1 = roll(state) * 0.96f;
        s.y1 = roll(state) * 0.6f;
    }
    s.radius = roll(state) < 0.6f ? 0.6f * pixel : 8 * pixel * roll(state);
    s.erase = roll(state) < 0.3f;
    return s;
}

static void expect_same_terrains(const skv_terrain *a, const skv_terrain *b)
{
    size_t pixels = (size_t)a->columns * (size_t)a->rows;
    assert_memory_equal(a->coverage, b->coverage, pixels);
    assert_memory_equal(a->field, b->field, pixels * sizeof *a->field);
    assert_true(a->hash == b->hash && a->free_area == b->free_area);
    assert_true(a->lowest == b->lowest && a->highest == b->highest);
}

static void expect_same_walls(const skv_wall_map *a, const skv_wall_map *b)
{
    assert_int_equal(a->columns, b->columns);
    assert_int_equal(a->rows, b->rows);
    for (int k = 0; k < a->columns * a->rows; k++) {
        assert_int_equal(a->index[k] < 0 ? a->index[k] : 0, b->index[k] < 0 ? b->index[k] : 0);
        if (a->index[k] >= 0)
            assert_memory_equal(&a->blocks[a->index[k]], &b->blocks[b->index[k]],
                                sizeof *a->blocks);
    }
    assert_int_equal(a->thin != NULL, b->thin != NULL);
    size_t cells = (size_t)a->found->columns * (size_t)a->found->rows;
    assert_memory_equal(a->found->marks, b->found->marks, cells);
    assert_memory_equal(a->found->found, b->found->found, cells);
    if (a->thin)
        assert_memory_equal(a->flat, b->flat, sizeof a->flat);
}

/* Gives `other` the state of `world`, and both the same time. */
static void expect_same_future(skv_world *world, skv_world *other)
{
    size_t size = skv_world_snapshot_size(world, false);
    void *state = malloc(size);
    assert_int_equal(skv_world_save(world, false, state, size, NULL), SKV_OK);
    assert_int_equal(skv_world_restore(other, state, size, NULL), SKV_OK);
    free(state);
    fixture_run(world, 3);
    fixture_run(other, 3);
    assert_true(skv_world_hash(world) == skv_world_hash(other));
}

/* Paints for some frames, and compares with what is made anew. */
static void paint_and_compare(const kind *k, unsigned open_sides, float spacing, int threads,
                              uint32_t seed)
{
    skv_world *world = make_world(k, make_terrain(open_sides), spacing, threads, SKV_ISA_BEST);
    fixture_fill(world, 0, 0, 0.96f, 0.3f);
    skv_brush_stroke strokes[3] = {{.x1 = 0.3f, .y1 = 0.2f}};
    for (int frame = 0; frame < 28 / ONE_OF; frame++) {
        strokes[0] = next_stroke(&seed, &strokes[2]);
        strokes[1] = next_stroke(&seed, &strokes[0]);
        strokes[2] = next_stroke(&seed, &strokes[1]);
        skv_terrain *painted;
        assert_int_equal(skv_terrain_paint(skv_world_terrain(world), strokes, 3, &painted, NULL),
                         SKV_OK);
        int before = skv_world_particle_count(world), removed, left = 0, events;
        assert_int_equal(skv_world_set_terrain(world, painted, &removed, NULL), SKV_OK);
        assert_int_equal(skv_world_particle_count(world), before - removed);
        assert_ptr_equal(skv_world_terrain(world), painted);
        fixture_run(world, 1);
        const skv_event *event = skv_world_events(world, &events);
        for (int i = 0; i < events; i++)
            left += event[i].kind == SKV_EVENT_LEFT;
        assert_int_equal(events - left, removed);
        assert_int_equal(skv_world_particle_count(world), before - events);
        assert_int_equal(skv_world_stats(world).not_finite, 0);
        if (frame % 4 != 3)
            continue;
        skv_terrain *anew = made_anew(painted);
        expect_same_terrains(painted, anew);
        skv_world *other = make_world(k, anew, spacing, 3 - threads, SKV_ISA_SCALAR);
        expect_same_walls(world->walls, other->walls);
        expect_same_future(world, other);
        skv_world_destroy(other);
    }
    skv_world_destroy(world);
}

static void edits_equal_the_picture_loaded(void **state)
{
    (void)state;
    paint_and_compare(&usual, 0, 0.02f, 1, 1);
    paint_and_compare(&usual, 0, 0.012f, 2, 2);
    paint_and_compare(&usual, SKV_SIDE_TOP | SKV_SIDE_RIGHT, 0.016f, 1, 3);
    paint_and_compare(&usual, 0, 0.04f, 2, 4);
    const kind reference = {SKV_SOLVER_REFERENCE, false}, images = {SKV_SOLVER_FAST, true};
    paint_and_compare(&reference, 0, 0.012f, 1, 2);
    paint_and_compare(&images, 0, 0.012f, 2, 2);
}

/* A stroke's edge lies where it says, and the thinnest holds water. */
static void strokes_are_exact(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(0), *painted;
    const skv_brush_stroke slanted = {0.3f, 0.2f, 0.6f, 0.37f, 0.05f, false};
    assert_int_equal(skv_terrain_paint(tank, &slanted, 1, &painted, NULL), SKV_OK);
    double length = hypot(0.3, 0.17), nx = -0.17 / length, ny = 0.3 / length;
    for (int i = 0; i < 60; i++) {
        double along = i / 60.0, across = (i % 6 - 2.5) * 0.03;
        double x = 0.3 + along * 0.3 + across * nx, y = 0.2 + along * 0.17 + across * ny;
        assert_near((double)skv_terrain_distance(painted, (float)x, (float)y), fabs(across) - 0.05,
                    0.06 * (double)pixel);
    }
    skv_terrain_destroy(painted);

    const skv_brush_stroke line = {0.111f, 0.05f, 0.777f, 0.555f, 1e-6f, false};
    assert_int_equal(skv_terrain_paint(tank, &line, 1, &painted, NULL), SKV_OK);
    for (int i = 0; i < 200; i++) {
        float along = (float)i / 200, x = 0.111f + along * 0.666f, y = 0.05f + along * 0.505f;
        assert_true(skv_terrain_sweep(painted, x - 0.03f, y + 0.03f, x + 0.03f, y - 0.03f, 0) < 1);
    }
    /* And is gone again. */
    const skv_brush_stroke eraser = {0.111f, 0.05f, 0.777f, 0.555f, 3 * pixel, true};
    skv_terrain *erased;
    assert_int_equal(skv_terrain_paint(painted, &eraser, 1, &erased, NULL), SKV_OK);
    expect_same_terrains(erased, tank);
    skv_terrain_destroy(painted);
    skv_terrain_destroy(erased);
    /* Nothing to do: the same terrain. */
    assert_int_equal(skv_terrain_paint(tank, &eraser, 1, &painted, NULL), SKV_OK);
    assert_ptr_equal(painted, tank);
    skv_terrain_destroy(painted);
    skv_terrain_destroy(tank);
}

static void hostile_numbers_are_refused(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(0), *painted;
    for (int i = 0; i < 5; i++) {
        for (int k = 0; k < 5; k++) {
            const float bad[5] = {NAN, INFINITY, -INFINITY, 1001, -1001};
            skv_brush_stroke s = {0.1f, 0.1f, 0.2f, 0.2f, 0.01f, false};
            float *numbers[5] = {&s.x0, &s.y0, &s.x1, &s.y1, &s.radius};
            *numbers[i] = bad[k];
            skv_error error = {0};
            assert_int_equal(skv_terrain_paint(tank, &s, 1, &painted, &error), SKV_ERROR_VALUE);
            assert_null(painted);
            assert_non_null(strstr(error.text, "stroke 0"));
        }
    }
    /* Far outside, and huge: both allowed. */
    const skv_brush_stroke odd[2] = {{-1000, 1000, -999, 1000, 0.5f, false},
                                     {-1000, -1000, 1000, 1000, 100, false}};
    assert_int_equal(skv_terrain_paint(tank, odd, 2, &painted, NULL), SKV_OK);
    assert_true(skv_terrain_free_area(painted) == 0);
    skv_terrain_destroy(painted);

    skv_terrain_def def = skv_default_terrain_def();
    skv_terrain *larger;
    assert_int_equal(skv_terrain_create(&def, &larger, NULL), SKV_OK);
    skv_world *world = make_world(&usual, tank, 0.02f, 1, SKV_ISA_BEST);
    skv_error error = {0};
    assert_int_equal(skv_world_set_terrain(world, larger, NULL, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "640 x 360"));
    assert_ptr_equal(skv_world_terrain(world), tank);
    skv_terrain_destroy(larger);
    skv_world_destroy(world);
}

/* Whichever allocation fails, the world goes on as if nothing had been tried. */
static void failures_change_nothing(void **state)
{
    (void)state;
    skv_world *world = make_world(&usual, make_terrain(0), 0.03f, 1, SKV_ISA_BEST);
    fixture_fill(world, 0, 0, 0.96f, 0.3f);
    const skv_brush_stroke walls[2] = {{0.2f, 0, 0.2f, 0.5f, 0.002f, false},
                                       {0.6f, 0.1f, 0.7f, 0.5f, 0.03f, false}};
    const skv_terrain *before = skv_world_terrain(world);
    bool painted_all = false, set_all = false;
    for (int fail_at = 0; fail_at < 100 && !set_all; fail_at++) {
        skv_terrain *painted = NULL;
        failing_memory memory;
        skv_error error = {0};
        failing_memory_start(&memory, painted_all ? -1 : fail_at);
        skv_result result = skv_terrain_paint(before, walls, 2, &painted, &error);
        failing_memory_stop();
        if (result != SKV_OK) {
            assert_int_equal(result, SKV_ERROR_MEMORY);
            assert_null(painted);
            assert_int_equal(memory.live, 0);
            continue;
        }
        if (!painted_all)
            fail_at = 0;
        painted_all = true;
        uint64_t hash = skv_world_hash(world);
        failing_memory_start(&memory, fail_at);
        result = skv_world_set_terrain(world, painted, NULL, &error);
        failing_memory_stop();
        set_all = result == SKV_OK;
        if (set_all)
            break;
        assert_int_equal(result, SKV_ERROR_MEMORY);
        assert_ptr_equal(skv_world_terrain(world), before);
        assert_true(skv_world_hash(world) == hash);
        skv_world *other = make_world(&usual, made_anew(before), 0.03f, 1, SKV_ISA_BEST);
        expect_same_walls(world->walls, other->walls);
        expect_same_future(world, other);
        skv_world_destroy(other);
        skv_terrain_destroy(painted);
    }
    assert_true(set_all);
    skv_world_destroy(world);
}

/* A snapshot belongs to the terrain it was taken on; coming back to that brings it back. */
static void snapshots_know_their_terrain(void **state)
{
    (void)state;
    skv_world *world = make_world(&usual, make_terrain(0), 0.02f, 1, SKV_ISA_BEST);
    fixture_fill(world, 0, 0, 0.4f, 0.4f);
    fixture_run(world, 10);
    skv_terrain *first = skv_terrain_share(skv_world_terrain(world)), *second;
    size_t size = skv_world_snapshot_size(world, false);
    void *state_then = malloc(size);
    assert_int_equal(skv_world_save(world, false, state_then, size, NULL), SKV_OK);
    uint64_t hash = skv_world_hash(world);
    const skv_brush_stroke wall = {0.5f, 0, 0.5f, 0.3f, 0.01f, false};
    assert_int_equal(skv_terrain_paint(first, &wall, 1, &second, NULL), SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, second, NULL, NULL), SKV_OK);
    fixture_run(world, 10);
    assert_int_equal(skv_world_restore(world, state_then, size, NULL), SKV_ERROR_VALUE);

    /* With its terrain it makes the edited world. */
    size_t whole = skv_world_snapshot_size(world, true);
    void *all = malloc(whole);
    assert_int_equal(skv_world_save(world, true, all, whole, NULL), SKV_OK);
    skv_world *loaded;
    assert_int_equal(skv_world_load(all, whole, fixture_host(1), &loaded, NULL), SKV_OK);
    fixture_run(world, 5);
    fixture_run(loaded, 5);
    assert_true(skv_world_hash(world) == skv_world_hash(loaded));

    assert_int_equal(skv_world_set_terrain(world, first, NULL, NULL), SKV_OK);
    assert_int_equal(skv_world_restore(world, state_then, size, NULL), SKV_OK);
    assert_true(skv_world_hash(world) == hash);
    skv_world_destroy(loaded);
    skv_world_destroy(world);
    free(state_then);
    free(all);
}

/* Sleeping water behind a wall falls when it is erased; far from it, sleep goes on. */
static void erased_walls_let_go(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(0), *walled;
    const skv_brush_stroke wall = {0.3f, -0.1f, 0.3f, 0.7f, 0.012f, false};
    assert_int_equal(skv_terrain_paint(tank, &wall, 1, &walled, NULL), SKV_OK);
    skv_world *world = make_world(&usual, walled, 0.015f, 1, SKV_ISA_BEST);
    fixture_fill(world, 0, 0, 0.28f, 0.3f);
    int count = skv_world_particle_count(world);
    for (int i = 0; i < 3000 && skv_world_awake_count(world) > 0; i++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);

    /* Elsewhere: nobody wakes. */
    const skv_brush_stroke far = {0.8f, 0.1f, 0.8f, 0.3f, 0.012f, false};
    skv_terrain *painted;
    int removed = -1;
    assert_int_equal(skv_terrain_paint(walled, &far, 1, &painted, NULL), SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, painted, &removed, NULL), SKV_OK);
    fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    assert_int_equal(removed, 0);

    assert_int_equal(skv_world_set_terrain(world, tank, NULL, NULL), SKV_OK);
    fixture_run(world, 60);
    skv_area beyond = skv_box(0.4f, 0, 0.96f, 0.6f);
    assert_true(skv_world_query(world, &beyond, NULL, 0) > count / 5);
    assert_int_equal(skv_world_particle_count(world), count);
    skv_world_destroy(world);
}

static int count_inside(const skv_world *world, float deeper_than)
{
    skv_particles p = skv_world_particles(world);
    int inside = 0;
    for (int i = 0; i < p.count; i++)
        inside += skv_terrain_distance(skv_world_terrain(world), p.x[i], p.y[i]) < -deeper_than;
    return inside;
}

/* Deep inside a thick wall fluid is taken out; what is left is pushed out of it at once. */
static void new_walls_take_their_place(void **state)
{
    (void)state;
    skv_world *world = make_world(&usual, make_terrain(0), 0.01f, 1, SKV_ISA_BEST);
    fixture_fill(world, 0, 0, 0.96f, 0.3f);
    fixture_run(world, 30);
    const skv_brush_stroke block = {0.4f, 0.15f, 0.5f, 0.15f, 0.06f, false};
    skv_terrain *painted;
    int removed = 0, before = skv_world_particle_count(world);
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &block, 1, &painted, NULL),
                     SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, painted, &removed, NULL), SKV_OK);
    assert_true(removed > 20);
    assert_int_equal(count_inside(world, 0.1f * pixel), 0);
    fixture_run(world, 60);
    assert_int_equal(skv_world_particle_count(world), before - removed);
    assert_int_equal(count_inside(world, 0.2f * 0.01f), 0);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edits_equal_the_picture_loaded), cmocka_unit_test(strokes_are_exact),
        cmocka_unit_test(hostile_numbers_are_refused),    cmocka_unit_test(failures_change_nothing),
        cmocka_unit_test(snapshots_know_their_terrain),   cmocka_unit_test(erased_walls_let_go),
        cmocka_unit_test(new_walls_take_their_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
