/* Takes key frames that a first module has handed out (key_out.c) for the replay that is open, so
 * that going back there takes no longer than it did here. Invariant: as skv_player_take_key. */
#include "session/stage.h"

__attribute__((export_name("skv_wasm_take_key"))) bool
skv_wasm_take_key(const skv_stage *stage, int side, const uint8_t *written);

bool skv_wasm_take_key(const skv_stage *stage, int side, const uint8_t *written)
{
    return skv_player_take_key(stage->worlds[side]->worker.player, written);
}
