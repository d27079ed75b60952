/* Undo and redo: what comes after a moment is cut off and kept, and put back.
 *
 * Invariant: the log up to a branch's cut is the one that it was cut from, for what would change
 * it, a new mark, drops all branches, and what was cut off before a later cut lies below it.
 */
#include "base/assert.h"
#include "base/memory.h"
#include "session/player.h"

#include <string.h>

void skv_branch_free(skv_branch *branch)
{
    skv_free(branch->tail);
    skv_history_free(&branch->keys);
    *branch = (skv_branch){0};
}

/* ---- Marks ----------------------------------------------------------------------------------- */

skv_result skv_player_reserve_mark(skv_player *player, skv_error *error)
{
    if (player->mark_count < player->mark_capacity)
        return SKV_OK;
    int capacity = player->mark_capacity ? 2 * player->mark_capacity : 64;
    skv_position *marks = skv_calloc((size_t)capacity, sizeof *marks);
    if (!marks)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d edits", capacity);
    if (player->mark_count)
        memcpy(marks, player->marks, (size_t)player->mark_count * sizeof *marks);
    skv_free(player->marks);
    player->marks = marks;
    player->mark_capacity = capacity;
    return SKV_OK;
}

void skv_player_add_mark(skv_player *player)
{
    player->marks[player->mark_count++] = player->now;
    while (player->branch_count > 0)
        skv_branch_free(&player->branches[--player->branch_count]);
}

skv_result skv_player_find_marks(skv_player *player, size_t at, skv_error *error)
{
    while (at < player->log.size) {
        skv_command command;
        skv_position position = {skv_log_frame(&player->log, at), at};
        at = skv_log_read(&player->log, at, &command);
        if (command.kind != SKV_COMMAND_MARK)
            continue;
        skv_result result = skv_player_reserve_mark(player, error);
        if (result != SKV_OK)
            return result;
        player->marks[player->mark_count++] = position;
    }
    return SKV_OK;
}

/* ---- Cutting --------------------------------------------------------------------------------- */

/* Makes room for one more branch; the oldest goes. */
static void make_room(skv_player *player)
{
    if (player->branch_count < SKV_MOST_BRANCHES)
        return;
    skv_branch_free(&player->branches[0]);
    memmove(&player->branches[0], &player->branches[1],
            (SKV_MOST_BRANCHES - 1) * sizeof *player->branches);
    player->branch_count--;
}

/* The log ends here, and so does what of it is known elsewhere. */
static void shorten(skv_player *player, skv_position end)
{
    player->log.size = end.at;
    player->end = end.frame;
    if (skv_before(end, player->shared))
        player->shared = end;
}

skv_result skv_player_cut_at(skv_player *player, skv_position cut, skv_error *error)
{
    skv_branch branch = {.cut = cut, .size = player->log.size - cut.at, .end = player->end};
    branch.tail = skv_calloc(branch.size + 1, 1);
    if (!branch.tail)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for what is cut off");
    skv_result result = skv_history_split(&player->keys, cut, &branch.keys, error);
    if (result != SKV_OK) {
        skv_free(branch.tail);
        return result;
    }
    if (branch.size)
        memcpy(branch.tail, player->log.bytes + cut.at, branch.size);
    make_room(player);
    player->branches[player->branch_count++] = branch;
    shorten(player, cut);
    while (player->mark_count > 0 && player->marks[player->mark_count - 1].at >= cut.at)
        player->mark_count--;
    return SKV_OK;
}

skv_result skv_player_cut(skv_player *player, skv_error *error)
{
    SKV_ASSERT_OR(player && !player->seeking, SKV_ERROR_VALUE);
    if (player->now.frame == player->end && player->now.at == player->log.size)
        return SKV_OK;
    return skv_player_cut_at(player, player->now, error);
}

/* ---- Handing over ---------------------------------------------------------------------------- */

void skv_player_write_branch(const skv_player *player, int i, skv_write *write, void *user)
{
    if (i >= player->branch_count)
        return;
    const skv_branch *branch = &player->branches[i];
    write((const char *)branch, sizeof *branch, user);
    write((const char *)branch->tail, branch->size, user);
    for (int k = 0; k < branch->keys.count; k++)
        skv_key_write(&branch->keys.list[k], write, user);
}

bool skv_player_take_branch(skv_player *player, const uint8_t *written)
{
    skv_branch branch;
    memcpy(&branch, written, sizeof branch);
    written += sizeof branch;
    if (player->branch_count == SKV_MOST_BRANCHES)
        return false;
    int keys = branch.keys.count;
    branch.keys = (skv_history){0};
    branch.tail = skv_calloc(branch.size + 1, 1);
    if (!branch.tail)
        return false;
    memcpy(branch.tail, written, branch.size);
    written += branch.size;
    for (int k = 0; k < keys; k++) {
        if (skv_history_take(&branch.keys, &written, NULL) != SKV_OK) {
            skv_branch_free(&branch);
            return false;
        }
    }
    player->branches[player->branch_count++] = branch;
    return true;
}

/* ---- Undo and redo --------------------------------------------------------------------------- */

/* The last mark before this moment; null if there is none. */
static const skv_position *last_mark(const skv_player *player)
{
    for (int i = player->mark_count - 1; i >= 0; i--)
        if (player->marks[i].at < player->now.at)
            return &player->marks[i];
    return NULL;
}

bool skv_player_can_undo(const skv_player *player)
{
    SKV_ASSERT_OR(player, false);
    return last_mark(player) != NULL;
}

bool skv_player_can_redo(const skv_player *player)
{
    SKV_ASSERT_OR(player, false);
    return player->branch_count > 0;
}

int64_t skv_player_undo_frame(const skv_player *player)
{
    const skv_position *mark = last_mark(player);
    return mark ? mark->frame : -1;
}

int64_t skv_player_redo_frame(const skv_player *player)
{
    return player->branch_count > 0 ? player->branches[player->branch_count - 1].end : -1;
}

skv_result skv_player_undo(skv_player *player, skv_error *error)
{
    SKV_ASSERT_OR(player && !player->seeking, SKV_ERROR_VALUE);
    const skv_position *mark = last_mark(player);
    if (!mark)
        return SKV_OK;
    skv_position cut = *mark;
    /* So that redo is there at once. */
    skv_player_keep(player);
    skv_result result = skv_player_seek_to(player, cut, true, error);
    return result == SKV_OK ? skv_player_cut_at(player, cut, error) : result;
}

skv_result skv_player_redo(skv_player *player, skv_error *error)
{
    SKV_ASSERT_OR(player && !player->seeking, SKV_ERROR_VALUE);
    if (player->branch_count == 0)
        return SKV_OK;
    skv_branch *branch = &player->branches[player->branch_count - 1];
    skv_position cut = branch->cut;
    /* What was played since goes, and the world to a moment that both ways share. */
    skv_result result = skv_player_seek_to(player, cut, true, error);
    if (result != SKV_OK)
        return result;
    skv_history_drop_after(&player->keys, cut);
    shorten(player, cut);
    result = skv_log_append_bytes(&player->log, branch->tail, branch->size, error);
    if (result == SKV_OK)
        result = skv_history_join(&player->keys, &branch->keys, error);
    if (result == SKV_OK)
        result = skv_player_find_marks(player, cut.at, error);
    if (result != SKV_OK) {
        player->log.size = cut.at;
        return result;
    }
    player->end = branch->end;
    skv_branch_free(branch);
    player->branch_count--;
    return skv_player_seek_to(player, (skv_position){player->end, player->log.size}, true, error);
}
