/* Several fluids in one world: their list, which particles are of which, and what is told of each.
 */
#include "support/fixture.h"
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

static skv_liquid liquid(const char *name)
{
    skv_liquid l = skv_default_liquid();
    snprintf(l.name, sizeof l.name, "%s", name);
    return l;
}

static skv_world_def make_def(skv_solver_kind solver, int liquids)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, 0.03f, 1);
    fixture_add_liquids(&def, liquids);
    return def;
}

static skv_world *make(const skv_world_def *def)
{
    skv_world *world;
    assert_int_equal(skv_world_create(def, &world, NULL), SKV_OK);
    return world;
}

static int count_of(const skv_world *world, int fluid)
{
    return skv_world_fluid_stats(world, fluid).particles;
}

static void a_world_lists_its_fluids(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 7);
    def.liquids[1].color = 0xff8000;
    def.fluid.viscosity = 0.001f;
    skv_world *world = make(&def);
    assert_string_equal(skv_world_liquid(world, 0)->name, "water");
    assert_true(skv_world_liquid(world, 0)->density == 1000);
    assert_true(skv_world_liquid(world, 0)->viscosity == 0.001f);
    assert_int_equal(skv_world_liquid(world, 0)->color, -1);
    assert_string_equal(skv_world_liquid(world, 1)->name, "the 2.");
    assert_int_equal(skv_world_liquid(world, 2)->color, 0xff8000);
    assert_string_equal(skv_world_liquid(world, 7)->name, "the 8.");
    assert_null(skv_world_liquid(world, 8));
    assert_null(skv_world_liquid(world, -1));
    skv_frame frame = skv_world_frame(world);
    assert_int_equal(frame.fluid_count, 8);
    assert_string_equal(frame.fluids[7].name, "the 8.");
    assert_int_equal(skv_world_set(world, "fluid.viscosity", "0.002", NULL), SKV_OK);
    assert_true(skv_world_liquid(world, 0)->viscosity == 0.002f);
    skv_world_destroy(world);
    def = make_def(SKV_SOLVER_FAST, 0);
    world = make(&def);
    fixture_fill_with(world, 0, 0, 0.4f, 0.6f, 0);
    assert_int_equal(skv_world_frame(world).fluid_count, 1);
    assert_null(skv_world_particles(world).fluid);
    assert_int_equal(count_of(world, 0), skv_world_particle_count(world));
    assert_int_equal(count_of(world, 1), 0);
    skv_world_destroy(world);
}

static void expect_no_world(const skv_world_def *def, skv_result code, const char *message)
{
    skv_error error;
    skv_world *world;
    assert_int_equal(skv_world_create(def, &world, &error), code);
    assert_string_equal(error.text, message);
    assert_null(world);
}

static void what_is_no_list_is_refused(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 2);
    def.liquid_count = 8;
    expect_no_world(&def, SKV_ERROR_LIMIT, "fluids: 8 beside the first; allowed is 0..7");
    def.liquid_count = -1;
    expect_no_world(&def, SKV_ERROR_LIMIT, "fluids: -1 beside the first; allowed is 0..7");
    static const struct {
        const char *name, *message;
    } wrong[] = {
        {"", "fluids[1].name: is empty; each fluid needs a name of its own"},
        {"water", "fluids[1].name: is that of the first fluid; choose another"},
        {"the 2.", "fluids[1].name: is another fluid's, too; choose another"},
        {"a\nb", "fluids[1].name: holds a control character"},
    };
    for (int i = 0; i < 4; i++) {
        def = make_def(SKV_SOLVER_FAST, 2);
        def.liquids[1] = liquid(wrong[i].name);
        expect_no_world(&def, SKV_ERROR_VALUE, wrong[i].message);
    }
    def = make_def(SKV_SOLVER_FAST, 2);
    memset(def.liquids[0].name, 'x', sizeof def.liquids[0].name);
    expect_no_world(&def, SKV_ERROR_VALUE, "fluids[0].name: is too long; allowed are 31 bytes");
    def = make_def(SKV_SOLVER_FAST, 2);
    def.liquids[0].viscosity = NAN;
    expect_no_world(&def, SKV_ERROR_VALUE,
                    "fluids[0].viscosity: is out of range; allowed is 0..0.05 m^2/s");
    def = make_def(SKV_SOLVER_FAST, 2);
    def.liquids[0].color = 0x1000000;
    expect_no_world(&def, SKV_ERROR_VALUE,
                    "fluids[0].color: is out of range; allowed is 0..0xffffff, and -1 for none");
}

/* Densities lie in a range about that of the first fluid, which moves with it. */
static void densities_have_a_range(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 2);
    const char *const message = "fluids[1].density: is %s kg/m^2; allowed is 0.01 to 20 times that "
                                "of the first fluid, 10..20000 kg/m^2";
    static const struct {
        float density;
        const char *text;
    } wrong[] = {{9.9f, "9.9"}, {20001, "20001"}, {NAN, "nan"}, {-1000, "-1000"}};
    for (int i = 0; i < 4; i++) {
        char text[200];
        snprintf(text, sizeof text, message, wrong[i].text);
        def.liquids[1].density = wrong[i].density;
        expect_no_world(&def, SKV_ERROR_VALUE, text);
    }
    def.liquids[0].density = 10;
    def.liquids[1].density = 20000;
    skv_world *world = make(&def);
    skv_error error;
    assert_int_equal(skv_world_set(world, "fluid.density", "900", &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "fluids[1].density: is 20000 kg/m^2; allowed is 0.01 to 20 "
                                    "times that of the first fluid, 9..18000 kg/m^2");
    assert_int_equal(skv_world_set(world, "fluid.material", "honey", NULL), SKV_ERROR_VALUE);
    assert_true(skv_world_fluid(world)->density == 1000);
    skv_world_destroy(world);
}

/* What is told weighs each particle by its fluid, also once the first one's density is another. */
static void sums_are_weighed(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 1);
    def.liquids[0].density = 4000;
    skv_world *world = make(&def);
    fixture_fill_with(world, 0, 0, 0.4f, 0.6f, 0);
    int light = skv_world_particle_count(world);
    fixture_fill_with(world, 0.8f, 0, 1.2f, 0.6f, 1);
    int heavy = skv_world_particle_count(world) - light;
    assert_int_equal(skv_world_add_velocity(world, 0, light, 1, 0, NULL), SKV_OK);
    assert_int_equal(skv_world_add_velocity(world, light, heavy, 0, -2, NULL), SKV_OK);
    const float densities[] = {1000, 2000};
    for (int k = 0; k < 2; k++) {
        double s = (double)skv_world_spacing(world), area = s * s, first = (double)densities[k];
        skv_world_set_number(world, skv_world_parameter("fluid.density"), first, NULL);
        skv_stats all = skv_world_stats(world),
                  own[2] = {skv_world_fluid_stats(world, 0), skv_world_fluid_stats(world, 1)};
        double mass[2] = {light * first * area, heavy * 4000 * area};
        assert_near(own[0].kinetic_energy, mass[0] / 2, 1e-6 * mass[0]);
        assert_near(own[1].kinetic_energy, 2 * mass[1], 1e-6 * mass[1]);
        assert_near(all.kinetic_energy, mass[0] / 2 + 2 * mass[1], 1e-6 * mass[1]);
        assert_near(all.momentum_x, mass[0], 1e-6 * mass[0]);
        assert_near(all.momentum_y, -2 * mass[1], 1e-6 * mass[1]);
        assert_near(all.centre_x,
                    (mass[0] * own[0].centre_x + mass[1] * own[1].centre_x) / (mass[0] + mass[1]),
                    1e-6);
        assert_near(all.potential_energy,
                    9.81 * (mass[0] * own[0].centre_y + mass[1] * own[1].centre_y),
                    1e-5 * all.potential_energy);
    }
    skv_world_destroy(world);
}

/* Every way to the fluids of a definition leads to the same state: by filling, by changing fluids,
 * by a parameter that is set in a world that began as `other`, and from a snapshot. */
static void reach_by_all_ways(skv_world *worlds[4], const skv_world_def *def,
                              const skv_world_def *other, const char *path, const char *value)
{
    for (int i = 0; i < 4; i++) {
        worlds[i] = make(i == 2 ? other : def);
        fixture_fill_with(worlds[i], 0, 0, 0.3f, 0.6f, i == 1 ? 0 : 2);
        fixture_fill_with(worlds[i], 0.3f, 0, 0.5f, 0.6f, 1);
        fixture_fill_with(worlds[i], 0.5f, 0, 0.8f, 0.6f, 0);
    }
    skv_particles p = skv_world_particles(worlds[0]);
    assert_int_equal(skv_world_set_fluids(worlds[1], 0, p.count, p.fluid, NULL), SKV_OK);
    assert_int_equal(skv_world_set(worlds[2], path, value, NULL), SKV_OK);
    fixture_saved b = fixture_save(worlds[0], false);
    skv_world_destroy(worlds[3]);
    skv_world_def plain = make_def(def->solver, 0);
    worlds[3] = make(&plain);
    assert_int_equal(skv_world_restore(worlds[3], b.bytes, b.size, NULL), SKV_OK);
    free(b.bytes);
    for (int i = 0; i < 4; i++)
        fixture_run(worlds[i], 10);
    for (int i = 1; i < 4; i++)
        assert_true(skv_world_hash(worlds[i]) == skv_world_hash(worlds[0]));
}

static void destroy_all(skv_world *worlds[4])
{
    for (int i = 0; i < 4; i++)
        skv_world_destroy(worlds[i]);
}

static void masses_follow(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world_def def = make_def((skv_solver_kind)solver, 2);
        def.fluid.density = 1000;
        def.liquids[0].density = 800;
        def.liquids[1].density = 500;
        def.substeps = 8; /* which else know where a world comes from */
        skv_world_def other = def;
        other.fluid.density = 1500;
        skv_world *worlds[4];
        reach_by_all_ways(worlds, &def, &other, "fluid.density", "1000");
        destroy_all(worlds);
    }
}

/* The first fluid's viscosity alone may change while it runs. */
static void viscosities_follow(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world_def def = make_def((skv_solver_kind)solver, 2);
        def.fluid.viscosity = 0.01f;
        def.liquids[0].viscosity = 0.02f;
        def.liquids[1].viscosity = 0.003f;
        def.substeps = 8;
        skv_world_def other = def;
        other.fluid.viscosity = 0;
        skv_world *worlds[4];
        reach_by_all_ways(worlds, &def, &other, "fluid.viscosity", "0.01");
        assert_int_equal(skv_world_set(worlds[1], "fluid.viscosity", "0", NULL), SKV_OK);
        fixture_run(worlds[0], 5);
        fixture_run(worlds[1], 5);
        assert_true(skv_world_hash(worlds[1]) != skv_world_hash(worlds[0]));
        destroy_all(worlds);
    }
}

/* As many as the most viscous of all fluids wants, whether there is any of it or not. */
static void substeps_go_by_the_most_viscous(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 2);
    def.fluid.spacing = 0.01f;
    skv_world *thin = make(&def);
    def.liquids[1].viscosity = 0.05f;
    skv_world *thick = make(&def);
    def.liquids[1].viscosity = 0;
    def.fluid.viscosity = 0.05f;
    skv_world *all = make(&def);
    int substeps = skv_world_substeps_per_frame(thick);
    assert_true(substeps > skv_world_substeps_per_frame(thin) + 5);
    assert_int_equal(substeps, skv_world_substeps_per_frame(all));
    for (int i = 0; i < 2; i++) {
        skv_world *world = i ? all : thick;
        fixture_fill_with(world, 0, 0, 0.1f, 0.2f, 0);
        fixture_run(world, 60); /* it is still, and takes no fewer than that */
        assert_true(skv_world_substeps_per_frame(world) >= substeps - 1);
        skv_world_destroy(world);
    }
    skv_world_destroy(thin);
}

/* Where all particles have one density the solver is told of no mass, nor of a viscosity where they
 * have one. */
static void one_density_needs_no_masses(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 2);
    def.liquids[0].density = 800;
    skv_world *world = make(&def);
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    skv_constants constants = skv_world_make_constants(world);
    fixture_fill_with(world, 0, 0, 0.4f, 0.6f, 2);
    assert_null(skv_world_describe_step(world, &constants, forces).particles.mass);
    fixture_fill_with(world, 0.4f, 0, 0.5f, 0.6f, 1);
    const float *mass = skv_world_describe_step(world, &constants, forces).particles.mass;
    assert_true(mass[0] == 1 && mass[skv_world_particle_count(world) - 1] == 0.8f);
    assert_null(skv_world_describe_step(world, &constants, forces).particles.drag);
    skv_world_destroy(world);
    def.liquids[0].density = 1000;
    def.liquids[1].viscosity = 0.02f;
    world = make(&def);
    fixture_fill_with(world, 0, 0, 0.4f, 0.6f, 1);
    assert_null(skv_world_describe_step(world, &constants, forces).particles.drag);
    fixture_fill_with(world, 0.4f, 0, 0.5f, 0.6f, 2);
    mass = skv_world_describe_step(world, &constants, forces).particles.mass;
    const float *drag = skv_world_describe_step(world, &constants, forces).particles.drag;
    assert_true(mass[0] == 1 && drag[0] == 0 && drag[skv_world_particle_count(world) - 1] > 0);
    skv_world_destroy(world);
}

static void particles_are_of_a_fluid(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 2);
    skv_world *world = make(&def);
    fixture_fill_with(world, 0, 0, 0.4f, 0.6f, 2);
    int first = skv_world_particle_count(world);
    assert_int_equal(skv_world_add_particle(world, 1.2f, 0.8f, 0, 0, NULL), SKV_OK);
    fixture_fill_with(world, 0.8f, 0, 1, 0.6f, 1);
    int all = skv_world_particle_count(world);
    assert_int_equal(count_of(world, 2), first);
    assert_int_equal(count_of(world, 0), 1);
    assert_int_equal(count_of(world, 1), all - first - 1);
    const uint8_t two[] = {1, 0};
    assert_int_equal(skv_world_set_fluids(world, first - 1, 2, two, NULL), SKV_OK);
    skv_particles p = skv_world_particles(world);
    assert_true(p.fluid[first - 2] == 2 && p.fluid[first - 1] == 1 && p.fluid[first] == 0);

    /* What is wrong changes nothing. */
    uint64_t hash = skv_world_hash(world);
    skv_error error;
    const uint8_t wrong[] = {0, 3};
    assert_int_equal(skv_world_set_fluids(world, 0, 2, wrong, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "there is no fluid 3; allowed is 0..2");
    assert_int_equal(skv_world_set_fluids(world, all - 1, 2, two, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_set_fluids(world, -1, 1, two, NULL), SKV_ERROR_VALUE);
    skv_fill_def more = skv_default_fill_def();
    more.fluid = 3;
    assert_int_equal(skv_world_fill(world, &more, NULL, NULL), SKV_ERROR_VALUE);
    skv_emitter tap = {.vx = 1, .width = 0.1f, .fluid = -1};
    assert_int_equal(skv_world_set_emitters(world, &tap, 1, NULL), SKV_ERROR_VALUE);
    tap.fluid = 3;
    assert_int_equal(skv_world_add_emitter(world, &tap, NULL, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "there is no fluid 3; allowed is 0..2");
    assert_true(skv_world_hash(world) == hash);
    skv_world_destroy(world);
}

/* Fluids that are alike in all but their names move as one. */
static void a_name_moves_nothing(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world_def one = make_def((skv_solver_kind)solver, 0);
        skv_world_def several = make_def((skv_solver_kind)solver, 2);
        skv_world *plain = make(&one), *mixed = make(&several);
        fixture_fill_with(plain, 0, 0, 0.4f, 0.6f, 0);
        fixture_fill_with(mixed, 0, 0, 0.4f, 0.6f, 2);
        assert_true(skv_world_hash(plain) != skv_world_hash(mixed));
        fixture_run(plain, 20);
        fixture_run(mixed, 20);
        skv_particles a = skv_world_particles(plain), b = skv_world_particles(mixed);
        assert_true(a.count == b.count);
        assert_memory_equal(a.x, b.x, (size_t)a.count * sizeof *a.x);
        assert_memory_equal(a.vy, b.vy, (size_t)a.count * sizeof *a.vy);
        uint8_t *none = calloc((size_t)a.count, 1);
        assert_int_equal(skv_world_set_fluids(mixed, 0, a.count, none, NULL), SKV_OK);
        assert_true(skv_world_hash(plain) == skv_world_hash(mixed));
        free(none);
        skv_world_destroy(plain);
        skv_world_destroy(mixed);
    }
}

/* From emitters, over removal and growth, each particle keeps its fluid. */
static void a_fluid_goes_with_its_particle(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 4);
    skv_world *world = make(&def);
    fixture_fill_with(world, 0, 0, 0.4f, 0.6f, 0);
    int all = skv_world_particle_count(world);
    uint8_t *fluids = malloc((size_t)all);
    for (int i = 0; i < all; i++)
        fluids[i] = (uint8_t)(i % 4);
    assert_int_equal(skv_world_set_fluids(world, 0, all, fluids, NULL), SKV_OK);
    free(fluids);
    skv_emitter tap = {.x = 1, .y = 0.5f, .vx = 1, .width = 0.1f, .dye = 3, .fluid = 4};
    assert_int_equal(skv_world_set_emitters(world, &tap, 1, NULL), SKV_OK);
    fixture_run(world, 30);
    skv_area corner = skv_box(0, 0, 0.2f, 0.2f);
    int removed;
    assert_int_equal(skv_world_remove_area(world, &corner, &removed, NULL), SKV_OK);
    assert_true(removed > 10 && count_of(world, 4) > 10);
    fixture_run(world, 10);
    skv_world *copy;
    assert_int_equal(skv_world_copy(world, fixture_host(1), &copy, NULL), SKV_OK);
    fixture_run(world, 10);
    fixture_run(copy, 10);
    assert_true(skv_world_hash(world) == skv_world_hash(copy));
    assert_string_equal(skv_world_liquid(copy, 4)->name, "the 5.");
    int emitters;
    assert_int_equal(skv_world_emitters(copy, &emitters)->fluid, 4);
    assert_int_equal(skv_world_emitters(copy, &emitters)->dye, 3);
    skv_particles p = skv_world_particles(copy);
    for (int i = 0; i < p.count; i++)
        assert_int_equal(p.fluid[i], (int)p.id[i] < all ? (int)p.id[i] % 4 : 4);
    skv_world_destroy(world);
    skv_world_destroy(copy);
}

/* Who is made to be of another fluid is awake; who is of it already sleeps on. */
static void a_change_wakes(void **unused)
{
    (void)unused;
    skv_world_def def = make_def(SKV_SOLVER_FAST, 1);
    def.sleep = true;
    def.fluid.viscosity_linear = 30;
    def.fluid.spacing = 0.06f;
    skv_world *world = make(&def);
    fixture_fill_with(world, 0, 0, 1.6f, 0.6f, 1);
    for (int i = 0; i < 3600 && skv_world_awake_count(world) > 0; i++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    const uint8_t same = 1, other = 0;
    assert_int_equal(skv_world_set_fluids(world, 5, 1, &same, NULL), SKV_OK);
    assert_int_equal(skv_world_awake_count(world), 0);
    assert_int_equal(skv_world_set_fluids(world, 5, 1, &other, NULL), SKV_OK);
    assert_true(skv_world_awake_count(world) > 0);
    skv_world_destroy(world);
}

static void expect_refused(const skv_world *from, skv_world *into, const char *message)
{
    fixture_saved b = fixture_save(from, false);
    skv_error error;
    uint64_t before = skv_world_hash(into);
    assert_int_equal(skv_world_restore(into, b.bytes, b.size, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, message);
    assert_true(skv_world_hash(into) == before);
    free(b.bytes);
}

/* What acts and who is of which fluid, in a world of three. */
static void fluids_that_no_world_has_are_refused(void **unused)
{
    (void)unused;
    skv_world_def several = make_def(SKV_SOLVER_FAST, 2), single = make_def(SKV_SOLVER_FAST, 0);
    skv_world *world = make(&several), *other = make(&single);
    fixture_fill_with(world, 0, 0, 0.4f, 0.6f, 0);
    fixture_fill_with(other, 0, 0, 0.2f, 0.6f, 0);
    fixture_mix_fluids(world);
    const skv_emitter emitter = {.x = 0.3f, .y = 0.4f, .vy = -1, .width = 0.1f, .fluid = 2};
    assert_int_equal(skv_world_set_emitters(world, &emitter, 1, NULL), SKV_OK);
    world->acting.emitters[0].fluid = 3;
    expect_refused(world, other, "there is no fluid 3; allowed is 0..2");
    world->acting.emitters[0].fluid = 2;
    world->state.fluid[7] = 3;
    expect_refused(world, other, "snapshot: a particle has values that none can have");
    world->state.fluid[7] = 2;
    const skv_liquid good = world->liquids[2];
    for (int i = 0; i < 5; i++) {
        skv_liquid *liquid = &world->liquids[2];
        if (i == 0)
            liquid->name[0] = '\0';
        else if (i == 1)
            memcpy(liquid->name, world->liquids[1].name, sizeof liquid->name);
        else if (i == 2)
            liquid->density = NAN;
        else if (i == 3)
            liquid->viscosity = -1;
        else
            liquid->color = 0x1000000;
        expect_refused(world, other, "snapshot: it holds values that no world has");
        *liquid = good;
    }
    /* With them comes what they are, to a world that had none, and goes with one that has none. */
    fixture_saved three = fixture_save(world, false), one = fixture_save(other, false);
    assert_null(skv_world_particles(other).fluid);
    assert_int_equal(skv_world_restore(other, three.bytes, three.size, NULL), SKV_OK);
    assert_true(skv_world_hash(other) == skv_world_hash(world));
    assert_string_equal(skv_world_liquid(other, 2)->name, "the 3.");
    fixture_run(world, 5);
    fixture_run(other, 5);
    assert_true(skv_world_hash(other) == skv_world_hash(world));
    assert_int_equal(skv_world_restore(other, one.bytes, one.size, NULL), SKV_OK);
    assert_null(skv_world_liquid(other, 1));
    assert_int_equal(skv_world_fluid_stats(other, 0).particles, skv_world_particle_count(other));
    fixture_saved again = fixture_save(other, false);
    assert_int_equal(again.size, one.size);
    assert_memory_equal(again.bytes, one.bytes, one.size);
    free(again.bytes);
    free(three.bytes);
    free(one.bytes);
    skv_world_destroy(world);
    skv_world_destroy(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_world_lists_its_fluids),
        cmocka_unit_test(what_is_no_list_is_refused),
        cmocka_unit_test(densities_have_a_range),
        cmocka_unit_test(sums_are_weighed),
        cmocka_unit_test(masses_follow),
        cmocka_unit_test(viscosities_follow),
        cmocka_unit_test(substeps_go_by_the_most_viscous),
        cmocka_unit_test(one_density_needs_no_masses),
        cmocka_unit_test(particles_are_of_a_fluid),
        cmocka_unit_test(a_name_moves_nothing),
        cmocka_unit_test(a_fluid_goes_with_its_particle),
        cmocka_unit_test(a_change_wakes),
        cmocka_unit_test(fluids_that_no_world_has_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
