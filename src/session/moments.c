/* Where a player's world is put back to: key frames, and the way to a moment from the nearest.
 *
 * Invariant: a key frame's state and position belong together, so that the world is the one that
 * start and log give at `now`, whichever was taken up.
 */
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "session/player.h"
#include "skvalp/snapshot.h"
#include "terrain/terrain.h"
#include "world/parameters.h"

size_t skv_player_history(const skv_player *player)
{
    SKV_ASSERT_OR(player, 0);
    size_t bytes = player->keys.bytes;
    for (int i = 0; i < player->branch_count; i++)
        bytes += player->branches[i].keys.bytes;
    return bytes;
}

/* First the ways not taken forget how they came about, then the past thins out. */
static void keep_limit(skv_player *player)
{
    for (int i = 0; i < player->branch_count; i++)
        while (skv_player_history(player) > player->def.history &&
               skv_history_thin(&player->branches[i].keys))
            continue;
    while (skv_player_history(player) > player->def.history && skv_history_thin(&player->keys))
        continue;
}

void skv_player_keep(skv_player *player)
{
    if (skv_history_add(&player->keys, player->world, player->now, NULL) == SKV_OK)
        keep_limit(player);
}

void skv_player_write_key(skv_player *player, int i, skv_write *write, void *user)
{
    skv_player_keep(player);
    if (i < player->keys.count)
        skv_key_write(&player->keys.list[i], write, user);
}

bool skv_player_take_key(skv_player *player, const uint8_t *written)
{
    const skv_position end = {player->end, player->log.size};
    skv_key key;
    memcpy(&key, written, sizeof key);
    if (key.position.frame > end.frame || key.position.at > end.at ||
        skv_history_has(&player->keys, key.position))
        return false;
    return skv_history_take(&player->keys, &written, NULL) == SKV_OK;
}

skv_result skv_player_make_start(const skv_player *player, skv_world **world, skv_error *error)
{
    const skv_key *start = &player->keys.list[0];
    skv_world_def def = skv_world_describe(player->world);
    def.terrain = skv_terrain_share(player->terrain);
    def.pool = player->def.pool;
    def.threads = player->def.threads;
    skv_result result = skv_world_create(&def, world, error);
    if (result != SKV_OK) {
        skv_terrain_destroy(def.terrain);
        return result;
    }
    result = skv_world_restore(*world, start->bytes, start->size, error);
    if (result != SKV_OK)
        skv_world_destroy(*world);
    return result;
}

/* Paints on a terrain, which is given up, what the log says up to a position. */
static skv_result paint_until(const skv_log *log, size_t until, skv_terrain **terrain,
                              skv_error *error)
{
    skv_result result = SKV_OK;
    for (size_t at = 0; at < until && result == SKV_OK;) {
        skv_command command;
        skv_terrain *painted = NULL;
        at = skv_log_read(log, at, &command);
        if (command.kind != SKV_COMMAND_PAINT)
            continue;
        result =
            skv_terrain_paint(*terrain, command.paint.list, command.paint.count, &painted, error);
        if (result == SKV_OK) {
            skv_terrain_destroy(*terrain);
            *terrain = painted;
        }
    }
    return result;
}

/* Puts the terrain of a key frame under the world, which may lose particles to its walls. */
static skv_result take_up_terrain(skv_player *player, const skv_key *key, skv_error *error)
{
    if (skv_world_terrain(player->world)->hash == key->terrain)
        return SKV_OK;
    skv_terrain *terrain = skv_terrain_share(player->terrain);
    skv_result result = SKV_OK;
    if (terrain->hash != key->terrain)
        result = paint_until(&player->log, key->position.at, &terrain, error);
    if (result == SKV_OK) {
        player->adrift = true;
        result = skv_world_set_terrain(player->world, terrain, NULL, error);
    }
    if (result != SKV_OK)
        skv_terrain_destroy(terrain);
    return result;
}

static skv_result take_up(skv_player *player, const skv_key *key, skv_error *error)
{
    skv_result result = take_up_terrain(player, key, error);
    if (result == SKV_OK)
        result = skv_world_restore(player->world, key->bytes, key->size, error);
    if (result == SKV_OK) {
        player->now = key->position;
        player->adrift = false;
    }
    return result;
}

skv_result skv_player_seek_to(skv_player *player, skv_position goal, bool from_here,
                              skv_error *error)
{
    const skv_key *key = skv_history_find(&player->keys, goal);
    skv_result result = SKV_OK;
    if (!from_here || player->adrift || skv_before(goal, player->now) ||
        skv_before(player->now, key->position))
        result = take_up(player, key, error);
    if (result == SKV_OK) {
        player->goal = goal;
        player->seeking = skv_before(player->now, goal);
    }
    return result;
}
