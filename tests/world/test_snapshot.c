/* Snapshots: a world that goes on from one gives the bits of one that was never interrupted; what
 * is no snapshot, or that of another world, is refused and changes nothing. */
#include "base/bytes.h"
#include "support/failing_memory.h"
#include "support/fixture.h"
#include "support/long.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { CHECKSUM_AT = 24 };

/* The kinds of world that go on in different ways. */
typedef struct kind {
    const char *name;
    skv_law law;
    skv_solver_kind solver;
    float viscosity;
    unsigned open_sides;
    bool stirred, calm, images;
    float compression;
    int liquids; /* beside the first fluid */
} kind;

static const kind kinds[] = {
    {.name = "fast", .stirred = true},
    {.name = "fast, clavet, viscous", .law = SKV_LAW_CLAVET, .viscosity = 3, .stirred = true},
    {.name = "fast, open", .viscosity = 3, .open_sides = SKV_SIDE_RIGHT, .stirred = true},
    {.name = "fast, asleep", .viscosity = 2, .calm = true},
    {.name = "reference", .solver = SKV_SOLVER_REFERENCE, .stirred = true},
    {.name = "reference, viscous",
     .solver = SKV_SOLVER_REFERENCE,
     .viscosity = 3,
     .open_sides = SKV_SIDE_RIGHT,
     .stirred = true},
    {.name = "fast, three fluids", .stirred = true, .liquids = 2},
    {.name = "reference, eight fluids",
     .solver = SKV_SOLVER_REFERENCE,
     .open_sides = SKV_SIDE_RIGHT,
     .stirred = true,
     .liquids = 7},
    {.name = "fast, compressed", .stirred = true, .compression = 0.02f},
    {.name = "fast, images", .stirred = true, .images = true},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static skv_world *make_world(const kind *k, int threads)
{
    skv_world_def def = skv_default_world_def();
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = 160;
    terrain.height = 90;
    terrain.pixel_size = 0.01f;
    terrain.open_sides = k->open_sides;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    def.fluid = skv_default_fluid_def(k->law);
    def.fluid.spacing = k->calm ? 0.02f : 0.025f;
    def.fluid.viscosity_linear = def.fluid.viscosity_quadratic = k->viscosity;
    def.fluid.wall_images = k->images;
    def.solver = k->solver;
    def.threads = threads;
    fixture_add_liquids(&def, k->liquids);
    for (int i = 0; i < k->liquids; i++)
        def.liquids[i].density = 700 + 150 * (float)i;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

static skv_world *make_filled(const kind *k)
{
    skv_world *world = make_world(k, 1);
    fixture_fill(world, 0, 0, k->calm ? 1.6f : 0.6f, k->calm ? 0.3f : 0.7f);
    fixture_mix_fluids(world);
    world->compression = k->compression; /* as settling a scene sets it */
    /* A pool that is falling asleep, and no longer turns over now and then. */
    for (int f = 0; k->calm && f < 3600; f++) {
        fixture_run(world, 1);
        if (skv_world_awake_count(world) < skv_world_particle_count(world) / 2)
            break;
    }
    return world;
}

/* One step of a history that depends on its number alone. */
static void live(skv_world *world, const kind *k, int step)
{
    if (k->stirred && step % 7 == 3) {
        skv_hand hand = skv_default_hand();
        hand.x = 0.1f * (float)(step % 12);
        hand.y = 0.2f;
        hand.vx = 1;
        assert_int_equal(skv_world_set_hands(world, &hand, step % 2, NULL), SKV_OK);
    }
    if (k->calm && (step == 30 || step == 35)) {
        skv_hand hand = skv_default_hand();
        hand.y = 0.1f;
        assert_int_equal(skv_world_set_hands(world, &hand, step == 30, NULL), SKV_OK);
    }
    if (k->stirred && step == 20)
        assert_int_equal(skv_world_set_gravity(world, 3, -9, NULL), SKV_OK);
    if (k->stirred && step == 24)
        assert_int_equal(skv_world_set(world, "fluid.viscosity", "0.001", NULL), SKV_OK);
    if (k->stirred && step == 26)
        assert_int_equal(skv_world_set(world, "fluid.contact_distance", "0.4", NULL), SKV_OK);
    if (k->stirred && step == 27) /* by Clavet's law they go there by and by */
        assert_int_equal(skv_world_set(world, "fluid.clavet_rest_density", "8", NULL), SKV_OK);
    /* Of different lengths: a part of a substep is owed at most moments. */
    float dt = k->stirred ? 0.001f * (float)(5 + step % 17) : 1.0f / 60;
    assert_int_equal(skv_world_step(world, dt, NULL), SKV_OK);
}

static void assert_same(const char *name, const skv_world *a, const skv_world *b)
{
    skv_particles p = skv_world_particles(a), q = skv_world_particles(b);
    bool same = p.count == q.count && skv_world_hash(a) == skv_world_hash(b) &&
                memcmp(p.pressure, q.pressure, (size_t)p.count * sizeof(float)) == 0 &&
                memcmp(p.id, q.id, (size_t)p.count * sizeof *p.id) == 0;
    if (!same)
        fail_msg("%s: it goes on differently", name);
    assert_true(skv_world_time(a) == skv_world_time(b));
    assert_int_equal(skv_world_substep_count(a), skv_world_substep_count(b));
    assert_int_equal(skv_world_awake_count(a), skv_world_awake_count(b));
    assert_int_equal(skv_world_substeps_per_frame(a), skv_world_substeps_per_frame(b));
}

static void going_on_gives_the_same_bits(void **unused)
{
    (void)unused;
    int after = long_tests() ? 10 : 4;
    for (int i = 0; i < KINDS; i++) {
        const kind *k = &kinds[i];
        skv_world *world = make_filled(k), *other = make_world(k, 2);
        int moments = k->calm ? 120 : 30, asleep = 0;
        for (int step = 0; step < moments; step++) {
            live(world, k, step);
            asleep += skv_world_awake_count(world) < skv_world_particle_count(world);
            if (step % (k->calm ? 9 : 5) != 2)
                continue;
            fixture_saved b = fixture_save(world, false);
            skv_world *loaded;
            fixture_saved whole = fixture_save(world, true);
            assert_int_equal(
                skv_world_load(whole.bytes, whole.size, fixture_host(1), &loaded, NULL), SKV_OK);
            assert_int_equal(skv_world_restore(other, b.bytes, b.size, NULL), SKV_OK);
            assert_same(k->name, world, other);
            for (int later = 1; later <= after; later++) {
                live(world, k, step + later);
                live(other, k, step + later);
                live(loaded, k, step + later);
            }
            assert_same(k->name, world, other);
            assert_same(k->name, world, loaded);
            /* Back, and forth again in the world itself. */
            assert_int_equal(skv_world_restore(world, b.bytes, b.size, NULL), SKV_OK);
            for (int later = 1; later <= after; later++)
                live(world, k, step + later);
            assert_same(k->name, world, other);
            assert_int_equal(skv_world_restore(world, b.bytes, b.size, NULL), SKV_OK);
            skv_world_destroy(loaded);
            free(whole.bytes);
            free(b.bytes);
        }
        assert_true(!k->calm || asleep > 50);
        skv_world_destroy(world);
        skv_world_destroy(other);
    }
}

static void a_copy_is_a_world_of_its_own(void **unused)
{
    (void)unused;
    skv_world *world = make_filled(&kinds[0]), *copy;
    live(world, &kinds[0], 3);
    assert_int_equal(skv_world_copy(world, fixture_host(2), &copy, NULL), SKV_OK);
    assert_ptr_equal(skv_world_terrain(world), skv_world_terrain(copy));
    assert_int_equal(skv_world_threads(copy), 2);
    assert_same("copy", world, copy);
    uint64_t before = skv_world_hash(world);
    live(copy, &kinds[0], 4);
    assert_true(skv_world_hash(world) == before);
    live(world, &kinds[0], 4);
    assert_same("copy", world, copy);
    skv_world_destroy(world);
    live(copy, &kinds[0], 5);
    skv_world_destroy(copy);
}

/* What a host lends: its threads, counted, and where it hears what is worth knowing. */
typedef struct lent {
    int runs, lines;
} lent;

static void run_alone(void *user, int count, void (*member)(void *team), void *team)
{
    lent *l = user;
    l->runs++;
    for (int i = 0; i < count; i++)
        member(team);
}

static void note_line(const char *text, void *user)
{
    lent *l = user;
    assert_non_null(text);
    l->lines++;
}

static void loading_and_copying_take_what_creating_takes(void **unused)
{
    (void)unused;
    skv_world *world = make_filled(&kinds[0]), *made[4];
    live(world, &kinds[0], 3);
    fixture_saved whole = fixture_save(world, true);
    lent l = {0};
    skv_pool *pool;
    assert_int_equal(skv_pool_create(3, &pool, NULL), SKV_OK);
    skv_world_def shares = skv_default_world_def(), lends = shares;
    shares.pool = pool;
    shares.gravity_y = 5; /* not the host's: the snapshot's counts */
    shares.instruction_set = SKV_ISA_SCALAR;
    lends.tasks = (skv_task_system){2, run_alone, &l};
    lends.log = note_line;
    lends.log_user = &l;
    lends.capacity = 10;
    assert_int_equal(skv_world_load(whole.bytes, whole.size, &shares, &made[0], NULL), SKV_OK);
    assert_int_equal(skv_world_load(whole.bytes, whole.size, &lends, &made[1], NULL), SKV_OK);
    assert_int_equal(skv_world_copy(world, &shares, &made[2], NULL), SKV_OK);
    assert_int_equal(skv_world_copy(world, NULL, &made[3], NULL), SKV_OK);
    assert_int_equal(skv_world_threads(made[0]), 3);
    assert_int_equal(skv_world_threads(made[2]), 3);
    assert_int_equal(skv_world_threads(made[1]), 2);
    assert_int_equal(l.lines, 1); /* there was room for 10 */
    live(world, &kinds[0], 4);
    for (int i = 0; i < 4; i++) {
        live(made[i], &kinds[0], 4);
        assert_same("host", world, made[i]);
        skv_world_destroy(made[i]);
    }
    assert_true(l.runs > 0);
    skv_pool_destroy(pool);
    /* What create refuses is refused, and says so. */
    skv_error error;
    shares = skv_default_world_def();
    shares.threads = SKV_MAX_THREADS + 1;
    assert_int_equal(skv_world_load(whole.bytes, whole.size, &shares, made, &error),
                     SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "threads"));
    assert_null(made[0]);
    free(whole.bytes);
    skv_world_destroy(world);
}

/* A world of some sixty particles, for many tries. */
static skv_world *make_small_of(skv_solver_kind solver, int liquids)
{
    skv_world_def def = skv_default_world_def();
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = 32;
    terrain.height = 24;
    terrain.pixel_size = 0.02f;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    def.fluid.spacing = 0.05f;
    def.fluid.viscosity_linear = 1;
    def.solver = solver;
    def.threads = 1;
    fixture_add_liquids(&def, liquids);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 0.64f, 0.25f);
    fixture_mix_fluids(world);
    skv_hand hand = skv_default_hand();
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    fixture_run(world, 3);
    return world;
}

static skv_world *make_small(skv_solver_kind solver)
{
    return make_small_of(solver, 0);
}

/* Gives bytes to the loader: it refuses them, or the world steps on. */
static void try_to_load(fixture_saved b)
{
    skv_world *loaded = NULL;
    if (skv_world_load(b.bytes, b.size, fixture_host(1), &loaded, NULL) == SKV_OK)
        skv_world_step(loaded, 1.0f / 60, NULL);
    else
        assert_null(loaded);
    skv_world_destroy(loaded);
}

/* Gives them to a world: it refuses with a message and nothing changes, or steps on. Returns
 * whether they were refused. */
static bool try_bytes(skv_world *world, fixture_saved b, fixture_saved good)
{
    skv_error error = {0};
    uint64_t before = skv_world_hash(world);
    double time = skv_world_time(world);
    skv_result result = skv_world_restore(world, b.bytes, b.size, &error);
    if (result != SKV_OK) {
        assert_true(error.text[0] && !strchr(error.text, '\n'));
        assert_true(skv_world_hash(world) == before && skv_world_time(world) == time);
        return true;
    }
    skv_world_step(world, 1.0f / 60, NULL);
    skv_world_stats(world);
    assert_int_equal(skv_world_restore(world, good.bytes, good.size, NULL), SKV_OK);
    assert_true(skv_world_hash(world) == before);
    return false;
}

static void every_byte_may_be_wrong(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world *world = make_small_of((skv_solver_kind)solver, solver);
        fixture_saved good = fixture_save(world, true), bad = {malloc(good.size), good.size};
        static const uint8_t flips[] = {0x01, 0x80, 0xff};
        int refused = 0;
        /* All that stands before the particles, and of these one byte in seven. */
        size_t sparse = long_tests() ? 1 : 11;
        for (size_t at = 0; at < good.size; at += at < good.size / 2 ? ONE_OF : sparse) {
            memcpy(bad.bytes, good.bytes, good.size);
            bad.bytes[at] ^= flips[at / sparse % 3];
            assert_true(try_bytes(world, bad, good));
            fixture_seal(bad);
            refused += try_bytes(world, bad, good);
            /* The particles, which begin behind the terrain, are the same to both. */
            if (at < good.size / 2 || at % 16 == 0)
                try_to_load(bad);
        }
        /* Most bytes are digits of numbers, which may be others. */
        assert_true(refused * ONE_OF > (int)good.size / 8);
        free(bad.bytes);
        free(good.bytes);
        skv_world_destroy(world);
    }
}

static void a_part_of_a_snapshot_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_small_of(SKV_SOLVER_FAST, 1);
    fixture_saved good = fixture_save(world, true), bad = {malloc(good.size + 8), 0};
    for (; bad.size < good.size; bad.size++) {
        /* Of its own memory: a reader that goes too far is seen. */
        uint8_t *exact = malloc(bad.size + !bad.size);
        memcpy(exact, good.bytes, bad.size);
        assert_true(try_bytes(world, (fixture_saved){exact, bad.size}, good));
        /* The same with a size and a checksum that fit. */
        if (bad.size > CHECKSUM_AT + 8) {
            skv_writer w = {exact, 16};
            skv_put(&w, bad.size, 8);
            fixture_seal((fixture_saved){exact, bad.size});
            assert_true(try_bytes(world, (fixture_saved){exact, bad.size}, good));
            try_to_load((fixture_saved){exact, bad.size});
        }
        free(exact);
    }
    memset(bad.bytes, 0, good.size + 8);
    memcpy(bad.bytes, good.bytes, good.size);
    bad.size = good.size + 8;
    assert_true(try_bytes(world, bad, good));
    free(bad.bytes);
    free(good.bytes);
    skv_world_destroy(world);
}

/* The reference solver once had two arrays of its own at the end: they are passed over. */
static void arrays_of_an_old_reference_are_passed_over(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world *world = make_small((skv_solver_kind)solver);
        size_t count = (size_t)skv_world_particle_count(world);
        fixture_saved now = fixture_save(world, true), old = {calloc(now.size + 12 * count, 1), 0};
        for (unsigned arrays = 0; arrays < 4; arrays++) {
            old.size = now.size + arrays * count * 4;
            memcpy(old.bytes, now.bytes, now.size);
            old.bytes[now.size - 38 * count - 4] = (uint8_t)arrays;
            skv_writer w = {old.bytes, 16};
            skv_put(&w, old.size, 8);
            fixture_seal(old);
            bool refused = try_bytes(world, old, now);
            assert_int_equal(refused, arrays != 0 && (arrays != 2 || solver == SKV_SOLVER_FAST));
        }
        free(old.bytes);
        free(now.bytes);
        skv_world_destroy(world);
    }
}

static void expect_refused(const skv_world *from, skv_world *into, const char *named)
{
    fixture_saved b = fixture_save(from, false);
    skv_error error = {0};
    assert_int_equal(skv_world_restore(into, b.bytes, b.size, &error), SKV_ERROR_VALUE);
    if (!strstr(error.text, named))
        fail_msg("\"%s\" does not name %s", error.text, named);
    free(b.bytes);
}

static void another_kind_of_world_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_filled(&kinds[0]);
    skv_world *const others[] = {make_world(&kinds[1], 1), make_world(&kinds[2], 1),
                                 make_world(&kinds[3], 1), make_world(&kinds[4], 1),
                                 make_world(&kinds[KINDS - 1], 1)};
    const char *const named[] = {"fluid.law", "terrain", "fluid.spacing", "solver",
                                 "fluid.wall_images"};
    for (int i = 0; i < 5; i++) {
        expect_refused(world, others[i], named[i]);
        assert_int_equal(skv_world_particle_count(others[i]), 0);
        skv_world_destroy(others[i]);
    }
    /* What can change while a world runs need not be the same. */
    skv_world *thick = make_world(&kinds[0], 1);
    assert_int_equal(skv_world_set(thick, "fluid.viscosity", "0.01", NULL), SKV_OK);
    fixture_saved b = fixture_save(world, false);
    assert_int_equal(skv_world_restore(thick, b.bytes, b.size, NULL), SKV_OK);
    live(world, &kinds[0], 1);
    live(thick, &kinds[0], 1);
    assert_same("thick", world, thick);
    skv_world_destroy(thick);
    skv_world *none;
    skv_error error = {0};
    assert_int_equal(skv_world_load(b.bytes, b.size, fixture_host(1), &none, &error),
                     SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "terrain"));
    assert_int_equal(skv_world_save(world, false, b.bytes, b.size - 1, &error), SKV_ERROR_LIMIT);
    b.bytes[8] = 9;
    assert_int_equal(skv_world_restore(world, b.bytes, b.size, &error), SKV_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "version is 9"));
    free(b.bytes);
    skv_world_destroy(world);
}

/* How far an emitter's next row and a drain's due particles are: what no world reaches is refused.
 */
static void emitters_and_drains_that_no_world_has_are_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_small(SKV_SOLVER_FAST), *other = make_small(SKV_SOLVER_FAST);
    const skv_emitter emitter = {.x = 0.3f, .y = 0.4f, .vy = -1, .width = 0.1f};
    const skv_drain drain = {.area = skv_circle(0.3f, 0.1f, 0.05f), .rate = 0.1f};
    assert_int_equal(skv_world_set_emitters(world, &emitter, 1, NULL), SKV_OK);
    assert_int_equal(skv_world_set_drains(world, &drain, 1, NULL), SKV_OK);
    double *const numbers[] = {&world->acting.streams[0].way, &world->acting.streams[0].travelled,
                               &world->acting.drainable[0]};
    for (int i = 0; i < 3; i++) {
        const double before = *numbers[i], wrong[] = {-1, 1e13, (double)NAN, (double)INFINITY};
        for (int k = 0; k < 4; k++) {
            *numbers[i] = wrong[k];
            expect_refused(world, other, "emitters or drains that no world has");
        }
        *numbers[i] = before;
    }
    fixture_saved good = fixture_save(world, false);
    assert_int_equal(skv_world_restore(other, good.bytes, good.size, NULL), SKV_OK);
    free(good.bytes);
    skv_world_destroy(world);
    skv_world_destroy(other);
}

/* The way to new numbers of Clavet's law, and what acts on it. */
static void ways_that_no_world_goes_are_refused(void **unused)
{
    (void)unused;
    const kind *clavet = &kinds[1];
    skv_world *world = make_filled(clavet), *other = make_filled(clavet);
    assert_int_equal(skv_world_set(world, "fluid.clavet_stiffness", "0.01", NULL), SKV_OK);
    const skv_ramp good = world->ramp;
    const double wrong[] = {1.01, (double)INFINITY};
    for (int i = 0; i < 2; i++) {
        world->ramp.left = wrong[i];
        expect_refused(world, other, "values that no world has");
    }
    for (int i = 0; i < SKV_RAMP_NUMBERS; i++) {
        world->ramp = good;
        world->ramp.now[i] = i % 2 ? -0.01f : NAN;
        expect_refused(world, other, "values that no world has");
    }
    world->ramp = good;
    fixture_saved b = fixture_save(world, false);
    assert_int_equal(skv_world_restore(other, b.bytes, b.size, NULL), SKV_OK);
    free(b.bytes);
    skv_world_destroy(world);
    skv_world_destroy(other);
}

/* No pushes add up to a speed that a snapshot could not hold, and none is faster. */
static void speeds_have_an_end(void **unused)
{
    (void)unused;
    skv_world *world = make_small(SKV_SOLVER_FAST), *other = make_small(SKV_SOLVER_FAST);
    int count = skv_world_particle_count(world);
    for (int i = 0; i < 1200; i++)
        assert_int_equal(skv_world_add_velocity(world, 0, count, 1000, -1000, NULL), SKV_OK);
    skv_particles p = skv_world_particles(world);
    assert_true(p.vx[0] == 1e6f && p.vy[0] == -1e6f);
    fixture_saved b = fixture_save(world, false);
    assert_int_equal(skv_world_restore(other, b.bytes, b.size, NULL), SKV_OK);
    free(b.bytes);
    world->state.vx[count / 2] = 1e30f;
    expect_refused(world, other, "a particle has values that none can have");
    skv_world_destroy(world);
    skv_world_destroy(other);
}

static void running_out_of_memory_changes_nothing(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        kind k = {.solver = (skv_solver_kind)solver, .viscosity = 3, .liquids = 2};
        skv_world *world = make_filled(&k);
        k.liquids = 0; /* of those that take it up */
        live(world, &k, 0);
        fixture_saved b = fixture_save(world, true);
        skv_result result = SKV_ERROR_MEMORY;
        for (int fail_at = 0; result != SKV_OK; fail_at++) {
            skv_world *small = make_world(&k, 1), *made;
            assert_int_equal(skv_world_add_particle(small, 0.5f, 0.5f, 0, 0, NULL), SKV_OK);
            uint64_t before = skv_world_hash(small);
            failing_memory memory;
            failing_memory_start(&memory, fail_at);
            result = skv_world_restore(small, b.bytes, b.size, NULL);
            if (result != SKV_OK)
                assert_true(result == SKV_ERROR_MEMORY && skv_world_hash(small) == before);
            failing_memory_start(&memory, fail_at);
            skv_result loading = skv_world_load(b.bytes, b.size, fixture_host(1), &made, NULL);
            assert_true(loading == SKV_OK || loading == SKV_ERROR_MEMORY);
            skv_world_destroy(made);
            assert_int_equal(memory.live, 0);
            failing_memory_start(&memory, fail_at);
            loading = skv_world_copy(world, fixture_host(1), &made, NULL);
            assert_true(loading == SKV_OK || loading == SKV_ERROR_MEMORY);
            skv_world_destroy(made);
            failing_memory_stop();
            skv_world_destroy(small);
        }
        free(b.bytes);
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(going_on_gives_the_same_bits),
        cmocka_unit_test(a_copy_is_a_world_of_its_own),
        cmocka_unit_test(loading_and_copying_take_what_creating_takes),
        cmocka_unit_test(every_byte_may_be_wrong),
        cmocka_unit_test(a_part_of_a_snapshot_is_refused),
        cmocka_unit_test(arrays_of_an_old_reference_are_passed_over),
        cmocka_unit_test(another_kind_of_world_is_refused),
        cmocka_unit_test(emitters_and_drains_that_no_world_has_are_refused),
        cmocka_unit_test(ways_that_no_world_goes_are_refused),
        cmocka_unit_test(speeds_have_an_end),
        cmocka_unit_test(running_out_of_memory_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
