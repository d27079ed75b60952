/* Takes what a first module has handed out (key_out.c) for the replay that is open: key frames, so
 * that going back there takes no longer than it did here, and what was undone, for redo. Invariant:
 * as skv_player_take_key and skv_player_take_branch. */
#include "session/stage.h"

__attribute__((export_name("skv_wasm_take_key"))) bool
skv_wasm_take_key(const skv_stage *stage, int side, const uint8_t *written);

bool skv_wasm_take_key(const skv_stage *stage, int side, const uint8_t *written)
{
    return skv_player_take_key(stage->worlds[side]->worker.player, written);
}

__attribute__((export_name("skv_wasm_take_branch"))) bool
skv_wasm_take_branch(const skv_stage *stage, int side, const uint8_t *written);

bool skv_wasm_take_branch(const skv_stage *stage, int side, const uint8_t *written)
{
    return skv_player_take_branch(stage->worlds[side]->worker.player, written);
}
