/* Hands out key frames and what was undone to the page's larger module (key_in.c), which goes on
 * with what a first one plays. Invariant: as skv_player_write_key and skv_player_write_branch. */
#include "session/stage.h"

__attribute__((export_name("skv_wasm_write_key"))) void
skv_wasm_write_key(const skv_stage *stage, int side, int i, skv_write *write, void *user);

void skv_wasm_write_key(const skv_stage *stage, int side, int i, skv_write *write, void *user)
{
    skv_player_write_key(stage->worlds[side]->worker.player, i, write, user);
}

__attribute__((export_name("skv_wasm_write_branch"))) void
skv_wasm_write_branch(const skv_stage *stage, int side, int i, skv_write *write, void *user);

void skv_wasm_write_branch(const skv_stage *stage, int side, int i, skv_write *write, void *user)
{
    skv_player_write_branch(stage->worlds[side]->worker.player, i, write, user);
}
