/* Walls by images: what the walls read of a pool at rest in single layers, and that the clavet law
 * does not know them. */
#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static skv_world_def imaged_def(skv_law law, float spacing)
{
    skv_world_def def = fixture_def(law, SKV_SOLVER_FAST, 0, spacing, 1);
    def.fluid.wall_images = true;
    return def;
}

enum { LAYERS = 12, FRAMES = 180 };

/* Mean pressures of layers half a spacing thick, by what they should be. */
typedef struct layers {
    double read[LAYERS], due[LAYERS];
} layers;

static void add_to_layers(layers *l, double distance, double pressure, double due)
{
    int layer = (int)(2 * distance);
    if (layer >= LAYERS)
        return;
    l->read[layer] += pressure;
    l->due[layer] += due;
}

static void expect_true(const layers *l, double least, double most_off)
{
    for (int i = 0; i < LAYERS; i++)
        if (l->due[i] > least && !(fabs(l->read[i] / l->due[i] - 1) < most_off))
            fail_msg("layer %d reads %g of rho g z", i, l->read[i] / l->due[i]);
}

static void single_layers_read_their_depth(void **unused)
{
    (void)unused;
    skv_world_def def = imaged_def(SKV_LAW_CALIBRATED, 0.0155f);
    def.depth = 0.45f;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 1.6f, 0.45f);
    fixture_run(world, 6 * 60);
    layers floor = {{0}, {0}}, side = {{0}, {0}};
    double s = (double)skv_world_spacing(world), area = skv_world_particle_count(world) * s * s;
    const double surface = 0.985 * area / 1.6;
    for (int f = 0; f < FRAMES; f++) {
        fixture_run(world, 1);
        skv_particles p = skv_world_particles(world);
        for (int i = 0; i < p.count; i++) {
            double x = (double)p.x[i], y = (double)p.y[i], due = 9810 * (surface - y);
            if (x > 0.3 && x < 1.3)
                add_to_layers(&floor, y / s, (double)p.pressure[i], due);
            if (y > 0.1 && y < 0.3)
                add_to_layers(&side, x / s, (double)p.pressure[i], due);
        }
    }
    /* Where hardly a particle comes by there is no mean. Without images the floor's layers are up
     * to 21 % off, and the side's 30 %. */
    expect_true(&floor, 12000.0 * FRAMES, 0.05);
    expect_true(&side, 4000.0 * FRAMES, 0.05);
    skv_world_destroy(world);
}

/* In short substeps a pool begins at rest: what its corners press together does not shake it. One
 * pool is chance; where what images leave over was no crowd, with a push across walls that no
 * energy has, these had 0.043 m/s. */
static void corners_do_not_shake(void **unused)
{
    (void)unused;
    enum { POOLS = 8 };
    double mean = 0;
    for (int k = 0; k < POOLS; k++) {
        skv_world_def def = imaged_def(SKV_LAW_CALIBRATED, 0.03f + 0.002f * (float)k);
        def.substeps = 14;
        skv_world *world;
        assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
        fixture_fill(world, 0, 0, 1.6f, 0.45f);
        assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
        double worst = 0;
        for (int f = 0; f < 60; f++) {
            fixture_run(world, 1);
            worst = fmax(worst, skv_world_stats(world).rms_speed);
        }
        mean += worst / POOLS;
        skv_world_destroy(world);
    }
    if (!(mean < 0.02))
        fail_msg("pools begin with %g m/s", mean);
}

static void the_clavet_law_has_none(void **unused)
{
    (void)unused;
    uint64_t hash[2];
    for (int images = 0; images < 2; images++) {
        skv_world_def def = imaged_def(SKV_LAW_CLAVET, 0.02f);
        def.fluid.wall_images = images;
        skv_world *world = fixture_dam_of(&def);
        fixture_run(world, 60);
        skv_particles p = skv_world_particles(world);
        hash[images] = fixture_hash(&p);
        skv_world_destroy(world);
    }
    assert_true(hash[0] == hash[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(single_layers_read_their_depth),
        cmocka_unit_test(corners_do_not_shake),
        cmocka_unit_test(the_clavet_law_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
