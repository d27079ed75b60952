/* The player: a world, the log of what was done to it, and moving about in that log.
 *
 * Invariants: the world is the one that start and log give at `now`, whatever way was gone to
 * there; an operation that fails leaves the player at a moment of its log. Key frames and checks
 * are made as memory allows: without them it only takes longer to go back.
 */
#include "session/player.h"

#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "scene/recipe.h"
#include "skvalp/query.h"

#include <string.h>

/* Frames between key frames, and between checks of the log. */
enum { KEY_EVERY = 15, CHECK_EVERY = 60 };

/* Commands that are given at once. A frame of somebody's play has a dozen; one of a hostile file
 * may have as many as fit into it, and is not to keep whoever steps. */
enum { AT_ONCE = 256 };

enum { PLAYER_COOKIE = 0x504c };

#define FRAME (1.0f / 60)

skv_player_def skv_default_player_def(void)
{
    return (skv_player_def){.history = (size_t)64 << 20,
                            .cookie = SKV_COOKIE(PLAYER_COOKIE, skv_player_def)};
}

void skv_player_def_init(skv_player_def *def, size_t size)
{
    const skv_player_def standard = skv_default_player_def();
    skv_def_init(def, size, &standard, sizeof standard);
}

/* ---- Making ---------------------------------------------------------------------------------- */

skv_result skv_player_take_scene(skv_player *player, skv_scene *scene, skv_error *error)
{
    size_t size;
    const uint8_t *recipe = skv_scene_recipe(scene, &size);
    uint8_t *copy = recipe ? skv_calloc(size, 1) : NULL;
    if (recipe && !copy)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a scene of %zu bytes", size);
    if (recipe)
        memcpy(copy, recipe, size);
    player->scene = scene;
    player->recipe = copy;
    player->recipe_size = size;
    return SKV_OK;
}

skv_result skv_player_begin(skv_world *world, skv_scene *scene, const skv_player_def *def,
                            skv_player **out, skv_error *error)
{
    skv_player *player = skv_calloc(1, sizeof *player);
    if (!player)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a player");
    player->def = *def;
    player->def.changed = NULL; /* the caller's */
    player->mismatch = player->shared.frame = -1;
    skv_result result = skv_history_add(&player->keys, world, player->now, error);
    if (result == SKV_OK && scene)
        result = skv_player_take_scene(player, scene, error);
    if (result != SKV_OK) {
        skv_history_free(&player->keys);
        skv_free(player);
        return result;
    }
    player->world = world;
    player->terrain = skv_terrain_share(skv_world_terrain(world));
    *out = player;
    return SKV_OK;
}

skv_result skv_player_create(skv_scene *scene, const skv_player_def *def, skv_player **player,
                             skv_error *error)
{
    SKV_ASSERT_OR(player, SKV_ERROR_VALUE);
    *player = NULL;
    skv_player_def plain = skv_default_player_def();
    def = def ? def : &plain;
    SKV_ASSERT_OR(scene, SKV_ERROR_VALUE);
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &plain, sizeof plain), SKV_ERROR_VALUE);
    skv_world_def made = skv_scene_world_def(scene);
    made.pool = def->pool;
    made.threads = def->threads;
    skv_world *world = NULL;
    skv_result result = skv_world_create(&made, &world, error);
    if (result != SKV_OK) {
        skv_terrain_destroy(made.terrain);
        return result;
    }
    result = skv_scene_fill(scene, world, error);
    if (result == SKV_OK)
        result = skv_player_begin(world, scene, def, player, error);
    if (result != SKV_OK)
        skv_world_destroy(world);
    return result;
}

void skv_player_destroy(skv_player *player)
{
    if (!player)
        return;
    for (int i = 0; i < player->branch_count; i++)
        skv_branch_free(&player->branches[i]);
    skv_history_free(&player->keys);
    skv_free(player->log.bytes);
    skv_free(player->marks);
    skv_world_destroy(player->world);
    skv_terrain_destroy(player->terrain);
    skv_scene_destroy(player->scene);
    skv_free(player->recipe);
    skv_free(player->second);
    skv_free(player);
}

/* ---- Facts ----------------------------------------------------------------------------------- */

const skv_world *skv_player_world(const skv_player *player)
{
    SKV_ASSERT_OR(player, NULL);
    return player->world;
}

const skv_scene *skv_player_scene(const skv_player *player)
{
    SKV_ASSERT_OR(player, NULL);
    return player->scene;
}

int64_t skv_player_frame(const skv_player *player)
{
    SKV_ASSERT_OR(player, 0);
    return player->now.frame;
}

int64_t skv_player_end(const skv_player *player)
{
    SKV_ASSERT_OR(player, 0);
    return player->end;
}

bool skv_player_seeking(const skv_player *player)
{
    SKV_ASSERT_OR(player, false);
    return player->seeking;
}

int64_t skv_player_mismatch(const skv_player *player)
{
    SKV_ASSERT_OR(player, -1);
    return player->mismatch;
}

bool skv_player_unbalanced(const skv_player *player)
{
    const skv_position *now = &player->now;
    const skv_key *before = skv_history_find(&player->keys, (skv_position){now->frame, 0});
    size_t at = before ? before->position.at : 0;
    bool changed = skv_world_substep_count(player->world) == 0;
    while (at < now->at && !changed) {
        skv_command command;
        bool recent = skv_log_frame(&player->log, at) == now->frame;
        at = skv_log_read(&player->log, at, &command);
        changed = recent && skv_command_changes_balance(command.kind);
    }
    return changed;
}

/* ---- Going on -------------------------------------------------------------------------------- */

/* Whether the log has commands of this frame before `until`. */
static bool has_more(const skv_player *player, size_t until)
{
    return player->now.at < until &&
           skv_log_frame(&player->log, player->now.at) == player->now.frame;
}

/* Gives the log's commands of this frame, those before `until`, or AT_ONCE of them. */
static skv_result follow(skv_player *player, size_t until, skv_error *error)
{
    skv_position *now = &player->now;
    for (int given = 0; given < AT_ONCE && has_more(player, until); given++) {
        skv_command command;
        size_t next = skv_log_read(&player->log, now->at, &command);
        bool check = command.kind == SKV_COMMAND_CHECK;
        if (check && player->mismatch < 0 && skv_world_hash(player->world) != command.hash)
            player->mismatch = now->frame;
        skv_error cause;
        skv_result result = skv_command_apply(&command, player->world, &cause);
        if (result != SKV_OK)
            return skv_fail(error, result, "frame %lld: %s", (long long)now->frame, cause.text);
        now->at = next;
    }
    return SKV_OK;
}

static skv_result step_frame(skv_player *player, skv_error *error)
{
    skv_result result = follow(player, player->log.size, error);
    if (result == SKV_OK && has_more(player, player->log.size))
        return SKV_OK;
    if (result == SKV_OK)
        result = skv_world_step(player->world, FRAME, error);
    player->adrift = result == SKV_STOPPED;
    if (result == SKV_OK)
        player->now.frame++;
    return result;
}

static bool at_end(const skv_player *player)
{
    return player->now.frame == player->end && player->now.at == player->log.size;
}

/* What a log at its end gets by itself: now and then the hash that the world has to have. */
static void add_check(skv_player *player)
{
    skv_command check = {.kind = SKV_COMMAND_CHECK, .hash = skv_world_hash(player->world)};
    if (skv_log_append(&player->log, player->now.frame, &check, NULL) == SKV_OK)
        player->now.at = player->log.size;
}

/* A piece of the way to the moment sought. Close before it every frame becomes a key frame, so that
 * going back frame by frame costs no more than going on. */
static skv_result seek_on(skv_player *player, skv_error *error)
{
    const skv_position *goal = &player->goal;
    skv_result result = SKV_OK;
    if (player->now.frame < goal->frame) {
        result = step_frame(player, error);
        int64_t left = goal->frame - player->now.frame;
        if (result == SKV_OK && (left < KEY_EVERY || player->now.frame % KEY_EVERY == 0))
            skv_player_keep(player);
    }
    if (result == SKV_OK && player->now.frame == goal->frame)
        result = follow(player, goal->at, error);
    player->seeking =
        result == SKV_OK && (player->now.frame < goal->frame || player->now.at < goal->at);
    return result;
}

skv_result skv_player_step(skv_player *player, skv_error *error)
{
    SKV_ASSERT_OR(player, SKV_ERROR_VALUE);
    /* A key frame could not be taken up, for want of memory, or a step was stopped: again. */
    if (player->adrift)
        return skv_player_seek_to(player, player->seeking ? player->goal : player->now, false,
                                  error);
    if (player->seeking)
        return seek_on(player, error);
    skv_result result = step_frame(player, error);
    if (result != SKV_OK)
        return result;
    bool new = player->now.frame > player->end;
    player->end = new ? player->now.frame : player->end;
    if (player->now.frame % KEY_EVERY == 0)
        skv_player_keep(player);
    if (new && player->now.frame % CHECK_EVERY == 0)
        add_check(player);
    return SKV_OK;
}

/* Does a command and logs it, with a mark before it or as one. */
static skv_result apply(skv_player *player, const skv_command *command, bool edits,
                        skv_error *error)
{
    const skv_command begin = {.kind = SKV_COMMAND_MARK};
    bool mark = edits || command->kind == SKV_COMMAND_MARK;
    if (player->adrift)
        return skv_fail(error, SKV_ERROR_MEMORY, "a moment could not be reached; seek it again");
    skv_result result = at_end(player) ? SKV_OK : skv_player_cut(player, error);
    if (result == SKV_OK && mark)
        result = skv_player_reserve_mark(player, error);
    /* The log first: it can be taken back. */
    size_t size = player->log.size;
    if (result == SKV_OK && edits)
        result = skv_log_append(&player->log, player->now.frame, &begin, error);
    if (result == SKV_OK)
        result = skv_log_append(&player->log, player->now.frame, command, error);
    if (result == SKV_OK)
        result = skv_command_apply(command, player->world, error);
    if (result != SKV_OK) {
        player->log.size = size;
        return result;
    }
    if (mark)
        skv_player_add_mark(player);
    player->now.at = player->log.size;
    return SKV_OK;
}

skv_result skv_player_apply(skv_player *player, const skv_command *command, skv_error *error)
{
    SKV_ASSERT_OR(player && command && !player->seeking, SKV_ERROR_VALUE);
    return apply(player, command, false, error);
}

skv_result skv_player_edit(skv_player *player, const skv_command *command, skv_error *error)
{
    SKV_ASSERT_OR(player && command && !player->seeking, SKV_ERROR_VALUE);
    SKV_ASSERT_OR(command->kind != SKV_COMMAND_MARK, SKV_ERROR_VALUE);
    return apply(player, command, true, error);
}

/* ---- Seeking --------------------------------------------------------------------------------- */

skv_result skv_player_seek(skv_player *player, int64_t frame, skv_error *error)
{
    SKV_ASSERT_OR(player, SKV_ERROR_VALUE);
    if (at_end(player))
        skv_player_keep(player);
    if (frame >= player->end)
        return skv_player_seek_to(player, (skv_position){player->end, player->log.size}, true,
                                  error);
    skv_position goal = {frame < 0 ? 0 : frame, 0};
    /* The first record of that frame or a later one. */
    const skv_key *before = skv_history_find(&player->keys, goal);
    goal.at = before ? before->position.at : 0;
    skv_command skipped;
    while (goal.at < player->log.size && skv_log_frame(&player->log, goal.at) < goal.frame)
        goal.at = skv_log_read(&player->log, goal.at, &skipped);
    return skv_player_seek_to(player, goal, true, error);
}

skv_result skv_player_cut_to_shared(skv_player *player, skv_error *error)
{
    skv_position cut = player->shared;
    if (cut.frame < 0 || (cut.frame == player->end && cut.at == player->log.size))
        return SKV_OK;
    skv_player_keep(player);
    skv_result result = skv_player_seek_to(player, cut, true, error);
    return result == SKV_OK ? skv_player_cut_at(player, cut, error) : result;
}

skv_result skv_player_go_back(skv_player *player, int64_t frame, skv_error *error)
{
    if (skv_player_undo_frame(player) == frame)
        return skv_player_undo(player, error);
    skv_player_keep(player);
    skv_result result = skv_player_seek(player, frame, error);
    return result == SKV_OK ? skv_player_cut_at(player, player->goal, error) : result;
}
