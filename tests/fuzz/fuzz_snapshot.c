/* Any bytes as a snapshot, loaded and restored: the answer is a world that can be stepped, or one
 * line and a world that stays as it was. The checksum is made right first, or nothing behind it
 * would ever be reached. */
#include "fuzz.h"

#include "base/envelope.h"

#include <skvalp/query.h>
#include <skvalp/snapshot.h>
#include <skvalp/world.h>

#include <stdlib.h>
#include <string.h>

static void step(skv_world *world)
{
    skv_error error = {0};
    /* What a hostile snapshot may ask for, but a fuzzer has no time for. */
    if (skv_world_substeps_per_frame(world) > 50)
        return;
    fuzz_expect_answer(skv_world_step(world, 1.0f / 60, &error), &error);
    fuzz_expect(skv_world_stats(world).not_finite == 0, "every position and velocity is finite");
}

static void try_load(const uint8_t *bytes, size_t size)
{
    skv_world *world = NULL;
    skv_error error = {0};
    skv_world_def host = skv_default_world_def();
    host.threads = 1;
    skv_result result = skv_world_load(bytes, size, &host, &world, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect((result == SKV_OK) == (world != NULL), "a world exactly if SKV_OK");
    if (world != NULL)
        step(world);
    skv_world_destroy(world);
}

static void try_restore(const uint8_t *bytes, size_t size)
{
    skv_world_def def = skv_default_world_def();
    skv_terrain_def box = skv_default_terrain_def();
    box.width = box.height = 24;
    box.pixel_size = 0.01f;
    def.fluid.spacing = 0.02f;
    def.threads = 1;
    fuzz_expect(skv_terrain_create(&box, &def.terrain, NULL) == SKV_OK, "a small terrain is made");
    skv_world *world = NULL;
    fuzz_expect(skv_world_create(&def, &world, NULL) == SKV_OK, "a small world is made");
    for (int i = 0; i < 5; i++)
        skv_world_add_particle(world, 0.05f + 0.02f * (float)i, 0.1f, 0, 0, NULL);
    uint64_t before = skv_world_hash(world);
    skv_error error = {0};
    skv_result result = skv_world_restore(world, bytes, size, &error);
    fuzz_expect_answer(result, &error);
    if (result != SKV_OK)
        fuzz_expect(skv_world_hash(world) == before, "a refused snapshot changes nothing");
    step(world);
    skv_world_destroy(world);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *bytes = malloc(size > 0 ? size : 1);
    memcpy(bytes, data, size);
    if (size > 0 && data[size - 1] % 8 != 0)
        skv_envelope_seal(bytes, size);
    try_load(bytes, size);
    try_restore(bytes, size);
    free(bytes);
    return 0;
}
