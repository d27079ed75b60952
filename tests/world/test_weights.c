/* Walls by weights: the weight against its definition, what they read of a pool at rest in single
 * layers, and that the clavet law does not know them. */
#include "solver/wall_weight.h"

#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { A_RADIUS = 50, CELLS = 4 * A_RADIUS };

static skv_world_def weighted_def(skv_law law, float spacing)
{
    skv_world_def def = fixture_def(law, SKV_SOLVER_FAST, 0, spacing, 2);
    def.fluid.wall_weights = true;
    return def;
}

/* The kernel's share at a distance across a line, in cells; normalised. */
static void line_kernel(double w[2 * A_RADIUS + 1])
{
    double sum = 0;
    for (int i = -A_RADIUS; i <= A_RADIUS; i++) {
        double x = (double)i / A_RADIUS, line = 0;
        for (int k = -200; k <= 200; k++)
            line += skv_kernel_density(SKV_KERNEL_SMOOTH, fmax(0, 1 - hypot(x, k / 200.0)));
        w[i + A_RADIUS] = line;
        sum += line;
    }
    for (int i = 0; i <= 2 * A_RADIUS; i++)
        w[i] /= sum;
}

/* Solves g (g * W) = 1 beside a flat wall, in the middles of cells. */
static void solve_weights(double g[CELLS])
{
    double w[2 * A_RADIUS + 1];
    line_kernel(w);
    for (int i = 0; i < CELLS; i++)
        g[i] = 1;
    for (int round = 0; round < 40; round++) {
        double smooth[CELLS];
        for (int i = 0; i < CELLS; i++) {
            smooth[i] = 0;
            for (int k = -A_RADIUS; k <= A_RADIUS; k++)
                if (i + k >= 0)
                    smooth[i] += w[k + A_RADIUS] * (i + k < CELLS ? g[i + k] : 1);
        }
        for (int i = 0; i < CELLS; i++)
            g[i] = sqrt(g[i] / smooth[i]);
    }
}

static void weights_solve_their_equation(void **unused)
{
    (void)unused;
    double g[CELLS];
    solve_weights(g);
    skv_world_def def = weighted_def(SKV_LAW_CALIBRATED, 0.0155f);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    const double h = (double)skv_world_smoothing_radius(world);
    double before = 0;
    for (int i = 0; i < A_RADIUS; i++) {
        double away = (i + 0.5) / A_RADIUS;
        skv_wall_sample wall;
        skv_boundary_sample(&world->boundary, 0.8f, (float)(away * h), &wall);
        skv_wall_weight found = skv_weigh(&world->boundary, &wall);
        assert_true(fabs((double)found.weight / g[i] - 1) < 0.01);
        /* Its slope, by differences: -(h/gain) dg/dy is slope F1. */
        double slope = -((double)found.weight - before) * A_RADIUS / 12;
        if (i > 2 && i < A_RADIUS - 5)
            assert_true(fabs((double)(found.slope * wall.f1y) - slope) < 0.03);
        before = (double)found.weight;
    }
    skv_world_destroy(world);
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
    skv_world_def def = weighted_def(SKV_LAW_CALIBRATED, 0.0155f);
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
    /* Where hardly a particle comes by there is no mean. Without weights the floor's layers are up
     * to 21 % off, and the side's 30 %. */
    expect_true(&floor, 12000.0 * FRAMES, 0.05);
    expect_true(&side, 4000.0 * FRAMES, 0.13);
    skv_world_destroy(world);
}

static void the_clavet_law_has_none(void **unused)
{
    (void)unused;
    uint64_t hash[2];
    for (int weighted = 0; weighted < 2; weighted++) {
        skv_world_def def = weighted_def(SKV_LAW_CLAVET, 0.02f);
        def.fluid.wall_weights = weighted;
        skv_world *world = fixture_dam_of(&def);
        fixture_run(world, 60);
        skv_particles p = skv_world_particles(world);
        hash[weighted] = fixture_hash(&p);
        skv_world_destroy(world);
    }
    assert_true(hash[0] == hash[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_solve_their_equation),
        cmocka_unit_test(single_layers_read_their_depth),
        cmocka_unit_test(the_clavet_law_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
