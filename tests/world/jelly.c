/* Worlds of jelly, clay and goo. Invariant: they depend on their arguments alone. */
#include "world/jelly.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

const float jelly_numbers[3] = {4000, 0.1f, 0};
const float clay_numbers[3] = {10000, 0.03f, 50};
const float goo_numbers[3] = {2000, 0.02f, 20};

skv_world_def jelly_def(const float *numbers, skv_solver_kind solver, float spacing)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, spacing, 1);
    fixture_add_liquids(&def, 1);
    def.liquids[0].shear_modulus = numbers[0];
    def.liquids[0].yield = numbers[1];
    def.liquids[0].plasticity = numbers[2];
    return def;
}

skv_world *jelly_block(const skv_world_def *def, float y)
{
    skv_world *world;
    skv_error error;
    if (skv_world_create(def, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    fixture_fill_with(world, 0.8f - JELLY_SIDE / 2, y, 0.8f + JELLY_SIDE / 2, y + JELLY_SIDE, 1);
    return world;
}

skv_world *jelly_medley(skv_solver_kind solver, int threads, skv_instruction_set set)
{
    skv_world_def def = jelly_def(jelly_numbers, solver, 0.02f);
    fixture_add_liquids(&def, 2);
    def.threads = threads;
    def.instruction_set = set;
    def.liquids[0].density = 900;
    const float *const numbers[] = {clay_numbers, goo_numbers};
    for (int i = 0; i < 2; i++) {
        skv_liquid *liquid = &def.liquids[1 + i];
        liquid->shear_modulus = numbers[i][0];
        liquid->yield = numbers[i][1];
        liquid->plasticity = numbers[i][2];
    }
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    for (int i = 0; i < 3; i++)
        fixture_fill_with(world, 0.1f + 0.5f * (float)i, 0.4f, 0.3f + 0.5f * (float)i, 0.6f, 1 + i);
    fixture_fill_with(world, 0, 0, 1.6f, 0.2f, 0);
    skv_drain drain = {.area = skv_box(0, 0, 0.05f, 0.05f), .rate = 0.05f};
    assert_int_equal(skv_world_set_drains(world, &drain, 1, NULL), SKV_OK);
    return world;
}
