/* Any bytes as a replay: the answer is a player whose log can be played, or one line. The checksum
 * is made right first, or nothing behind it would ever be reached. */
#include "fuzz.h"

#include "base/envelope.h"

#include <skvalp/player.h>

#include <stdlib.h>
#include <string.h>

enum { MOST_FRAMES = 8, MOST_BYTES = 4 << 20 };

/* A replay's scene may ask for more particles than a fuzzer has time for: it gets no memory. */
static void *allocate(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    size_t room = (bytes + alignment - 1) / alignment * alignment;
    return bytes <= MOST_BYTES ? aligned_alloc(alignment, room) : NULL;
}

static void release(void *memory, void *user)
{
    (void)user;
    free(memory);
}

/* What a hostile file may ask for, but a fuzzer has no time for. */
static bool is_small(const skv_player *player)
{
    const skv_world *world = skv_player_world(player);
    return skv_world_substeps_per_frame(world) <= 50 && skv_world_particle_count(world) <= 20000;
}

static void play(skv_player *player)
{
    skv_error error = {0};
    skv_result result = SKV_OK;
    for (int i = 0; i < MOST_FRAMES && result == SKV_OK && is_small(player); i++) {
        result = skv_player_step(player, &error);
        fuzz_expect_answer(result, &error);
    }
    if (result != SKV_OK || !is_small(player))
        return;
    fuzz_expect_answer(skv_player_undo(player, &error), &error);
    for (int i = 0; i < MOST_FRAMES && skv_player_seeking(player) && result == SKV_OK; i++)
        result = skv_player_step(player, &error);
    fuzz_expect_answer(result, &error);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    skv_set_allocator(&(skv_allocator){allocate, release, NULL});
    uint8_t *bytes = malloc(size > 0 ? size : 1);
    memcpy(bytes, data, size);
    if (size > 0 && data[size - 1] % 8 != 0)
        skv_envelope_seal(bytes, size);
    skv_player *player = NULL;
    skv_player_def def = skv_default_player_def();
    skv_error error = {0};
    def.threads = 1;
    def.history = 1 << 20;
    skv_demands demands;
    skv_result asked = skv_player_ask(bytes, size, &demands, &error);
    fuzz_expect_answer(asked, &error);
    if (asked == SKV_OK)
        fuzz_expect_answer(skv_demands_check(&demands, &error), &error);
    skv_result result = skv_player_load(bytes, size, &def, &player, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(result != SKV_OK || asked == SKV_OK || asked == SKV_ERROR_MEMORY,
                "what can be opened can be asked");
    fuzz_expect((result == SKV_OK) == (player != NULL), "a player exactly if SKV_OK");
    if (player != NULL)
        play(player);
    skv_player_destroy(player);
    free(bytes);
    return 0;
}
