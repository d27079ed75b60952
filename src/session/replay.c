/* Replays (docs/stage.md): writing them, and reading them whoever wrote them. A saved one holds
 * the state that it began with; one to be shared only the scene, from which that is made again.
 *
 * Invariant: a log that skv_player_load has let through consists of whole records in order; what
 * they ask of the world the world checks when they are played.
 */
#include "base/assert.h"
#include "base/defs.h"
#include "base/envelope.h"
#include "base/memory.h"
#include "scene/recipe.h"
#include "session/packed_log.h"
#include "session/player.h"
#include "skvalp/query.h"
#include "skvalp/snapshot.h"
#include "world/crowding.h"

#include <limits.h>
#include <string.h>

/* Version 2 has nothing to say but the world and its log; so what says no more is still written. */
enum { OLDEST = 2, NEWEST = 3 };
static const skv_envelope kind = {"replay", 'R', NEWEST, OLDEST, 0};
static const skv_envelope old_kind = {"replay", 'R', OLDEST, OLDEST, 0};

/* ---- Writing --------------------------------------------------------------------------------- */

/* What a replay consists of, beside the recipe. */
typedef struct parts {
    const skv_player *player;
    int64_t end;
    uint8_t *start; /* a snapshot with terrain; null: none */
    size_t start_size;
    uint8_t *log; /* packed */
    size_t log_size;
} parts;

static void put_part(skv_writer *w, const uint8_t *bytes, size_t size)
{
    skv_put(w, size, 8);
    if (w->bytes && size)
        memcpy(w->bytes + w->used, bytes, size);
    w->used += size;
}

static void put_showing(skv_writer *w, const skv_player *player)
{
    skv_writer counter = {NULL, 0};
    skv_showing_put(&counter, &player->showing);
    skv_put(w, counter.used, 8);
    skv_showing_put(w, &player->showing);
    put_part(w, player->second, player->second_size);
}

static size_t put_all(const parts *p, uint8_t *bytes)
{
    skv_writer writer = {bytes, 0}, *w = &writer;
    bool plain = skv_showing_is_plain(&p->player->showing) && p->player->second_size == 0;
    skv_envelope_put(w, plain ? &old_kind : &kind, 0);
    skv_put_text(w, skv_version());
    skv_put(w, (uint64_t)p->end, 4);
    put_part(w, p->player->recipe, p->player->recipe_size);
    put_part(w, p->start, p->start_size);
    put_part(w, p->log, p->log_size);
    if (!plain)
        put_showing(w, p->player);
    if (bytes)
        skv_envelope_seal(bytes, writer.used);
    return writer.used;
}

static skv_result write_all(const parts *p, skv_write *write, void *user, skv_error *error)
{
    size_t size = put_all(p, NULL);
    uint8_t *bytes = skv_calloc(size, 1);
    if (!bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a replay");
    put_all(p, bytes);
    bool written = write((const char *)bytes, size, user);
    skv_free(bytes);
    return written ? SKV_OK : skv_fail(error, SKV_ERROR_FILE, "the replay could not be written");
}

static skv_result save_start(parts *p, const skv_world *start, skv_error *error)
{
    p->start_size = skv_world_snapshot_size(start, true);
    p->start = skv_calloc(p->start_size, 1);
    return p->start ? skv_world_save(start, true, p->start, p->start_size, error)
                    : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a replay");
}

/* Copies the log up to a position, with or without its checks, and ends it with one if the world is
 * there. */
static skv_result copy_log(const skv_player *player, skv_position until, bool checks, skv_log *log,
                           skv_error *error)
{
    skv_result result = SKV_OK;
    for (size_t at = 0; at < until.at && result == SKV_OK;) {
        skv_command command;
        size_t next = skv_log_read(&player->log, at, &command);
        if (checks || command.kind != SKV_COMMAND_CHECK)
            result = skv_log_append_bytes(log, player->log.bytes + at, next - at, error);
        at = next;
    }
    if (result == SKV_OK && player->now.frame == until.frame && player->now.at == until.at) {
        skv_command check = {.kind = SKV_COMMAND_CHECK, .hash = skv_world_hash(player->world)};
        result = skv_log_append(log, until.frame, &check, error);
    }
    return result;
}

static skv_result pack_log(parts *p, skv_position until, bool checks, const skv_world *start,
                           skv_error *error)
{
    skv_log log = {0};
    skv_steps steps = skv_steps_of(start);
    skv_result result = copy_log(p->player, until, checks, &log, error);
    if (result == SKV_OK) {
        p->log = skv_log_pack(&log, &steps, &p->log_size);
        if (!p->log)
            result = skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a replay");
    }
    skv_free(log.bytes);
    return result;
}

static skv_result write_replay(const skv_player *player, skv_position until, bool with_start,
                               bool checks, skv_write *write, void *user, skv_error *error)
{
    /* The start is the first key frame, whose terrain need not be the present one. */
    skv_world *start = NULL;
    parts p = {.player = player, .end = until.frame};
    skv_result result = skv_player_make_start(player, &start, error);
    if (result != SKV_OK)
        return result;
    if (with_start)
        result = save_start(&p, start, error);
    if (result == SKV_OK)
        result = pack_log(&p, until, checks, start, error);
    if (result == SKV_OK)
        result = write_all(&p, write, user, error);
    skv_world_destroy(start);
    skv_free(p.start);
    skv_free(p.log);
    return result;
}

skv_result skv_player_save(const skv_player *player, skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(player && write && !player->seeking, SKV_ERROR_VALUE);
    skv_position end = {player->end, player->log.size};
    return write_replay(player, end, true, true, write, user, error);
}

static skv_result pack_none(parts *p, const skv_world *start, skv_error *error)
{
    const skv_log none = {0};
    skv_steps steps = skv_steps_of(start);
    p->log = skv_log_pack(&none, &steps, &p->log_size);
    return p->log ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a replay");
}

skv_result skv_player_save_moment(const skv_player *player, skv_write *write, void *user,
                                  skv_error *error)
{
    SKV_ASSERT_OR(player && write, SKV_ERROR_VALUE);
    parts p = {.player = player};
    skv_result result = save_start(&p, player->world, error);
    if (result == SKV_OK)
        result = pack_none(&p, player->world, error);
    if (result == SKV_OK)
        result = write_all(&p, write, user, error);
    skv_free(p.start);
    skv_free(p.log);
    return result;
}

/* Whether this library makes the start of a saved replay from its scene. */
static bool makes_start(const skv_player *player)
{
    skv_scene *scene = NULL;
    skv_world *made = NULL, *start = NULL;
    bool same =
        skv_recipe_load(player->recipe, player->recipe_size, NULL, &scene, NULL) == SKV_OK &&
        skv_scene_create_world(scene, 1, &made, NULL) == SKV_OK &&
        skv_player_make_start(player, &start, NULL) == SKV_OK &&
        skv_world_hash(made) == skv_world_hash(start);
    skv_world_destroy(made);
    skv_world_destroy(start);
    skv_scene_destroy(scene);
    return same;
}

static skv_result share_until(const skv_player *player, skv_position until, bool checks,
                              skv_write *write, void *user, skv_error *error)
{
    if (!player->recipe)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "it began with a state, or with too large a picture, which no link can "
                        "hold; save it as a file");
    if (player->saved_start && !makes_start(player))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "it does not begin as its scene does in this version of skvalp; share it "
                        "as a file");
    return write_replay(player, until, false, checks, write, user, error);
}

skv_result skv_player_share(const skv_player *player, skv_write *write, void *user,
                            skv_error *error)
{
    SKV_ASSERT_OR(player && write && !player->seeking, SKV_ERROR_VALUE);
    return share_until(player, player->now, false, write, user, error);
}

skv_result skv_player_share_whole(const skv_player *player, skv_write *write, void *user,
                                  skv_error *error)
{
    return share_until(player, (skv_position){player->end, player->log.size}, true, write, user,
                       error);
}

/* ---- Reading --------------------------------------------------------------------------------- */

/* A part of the file, null if it is longer than what is left. */
static const uint8_t *get_part(skv_reader *r, size_t *size)
{
    uint64_t length = skv_get(r, 8);
    if (r->failed || length > r->size - r->at)
        return NULL;
    const uint8_t *bytes = r->bytes + r->at;
    r->at += (size_t)length;
    *size = (size_t)length;
    return bytes;
}

/* Makes a player from a snapshot. */
static skv_result begin(const uint8_t *data, size_t size, const skv_player_def *def,
                        skv_player **player, skv_error *error)
{
    skv_world *world = NULL;
    skv_world_def host = skv_default_world_def();
    host.threads = def->threads;
    host.pool = def->pool;
    skv_result result = skv_world_load(data, size, &host, &world, error);
    if (result != SKV_OK)
        return result;
    result = skv_player_begin(world, NULL, def, player, error);
    if (result != SKV_OK)
        skv_world_destroy(world);
    else
        (*player)->saved_start = true;
    return result;
}

/* Makes a player at a replay's start: from the state, if it is there, and else from the scene. A
 * scene that this library does not have is missed only for its title. */
static skv_result begin_replay(const uint8_t *recipe, size_t recipe_size, const uint8_t *start,
                               size_t start_size, const skv_player_def *def, skv_player **player,
                               skv_error *error)
{
    skv_scene *scene = NULL;
    skv_result result = SKV_OK;
    bool saved = start_size && !def->changed, taken = false;
    if (recipe_size)
        result = skv_recipe_load(recipe, recipe_size, def->changed, &scene, error);
    if (saved) {
        result = begin(start, start_size, def, player, error);
        if (result == SKV_OK && scene)
            result = skv_player_take_scene(*player, scene, error);
        taken = result == SKV_OK;
    } else if (result == SKV_OK && scene) {
        result = skv_player_create(scene, def, player, error);
        taken = result == SKV_OK;
    } else if (result == SKV_OK) {
        result = SKV_ERROR_FORMAT;
        skv_fail(error, result, "it is missing; take another copy");
    }
    if (!taken)
        skv_scene_destroy(scene);
    return result;
}

static skv_result take_log(skv_player *player, const uint8_t *log, size_t size, int64_t end,
                           bool checks, skv_error *error)
{
    skv_error cause;
    skv_result result = skv_log_unpack(&player->log, log, size, end, checks, &cause);
    if (result != SKV_OK)
        return skv_fail(error, result, "replay: %s", cause.text);
    player->end = end;
    return skv_player_find_marks(player, 0, error);
}

/* What a file consists of, where it lies in it. */
typedef struct contents {
    int64_t end;
    const uint8_t *recipe, *start, *log, *second;
    size_t recipe_size, start_size, log_size, second_size;
    skv_showing showing;
} contents;

/* A second world's replay has none beside it. */
static bool find_showing(skv_reader *r, contents *c)
{
    size_t size = 0;
    const uint8_t *bytes = get_part(r, &size);
    skv_reader showing = {.bytes = bytes, .size = size};
    if (!bytes || !skv_showing_get(&showing, &c->showing) || showing.at != size)
        return false;
    c->second = get_part(r, &c->second_size);
    return c->second &&
           (c->second_size == 0 || (skv_envelope_is(&kind, c->second, c->second_size) &&
                                    skv_envelope_version(c->second, c->second_size) == OLDEST));
}

static skv_result find_contents(skv_reader *r, contents *c, skv_error *error)
{
    char version[256];
    unsigned flags;
    *c = (contents){0};
    skv_result result = skv_envelope_open(r, &kind, &flags, error);
    if (result != SKV_OK)
        return result;
    skv_get_text(r, version);
    c->end = (int64_t)skv_get(r, 4);
    c->recipe = get_part(r, &c->recipe_size);
    c->start = c->recipe ? get_part(r, &c->start_size) : NULL;
    c->log = c->start ? get_part(r, &c->log_size) : NULL;
    bool whole =
        c->log && (skv_envelope_version(r->bytes, r->size) == OLDEST || find_showing(r, c));
    return whole && r->at == r->size
               ? SKV_OK
               : skv_fail(error, SKV_ERROR_FORMAT, "replay: it is damaged; take another copy");
}

static skv_result fail_start(skv_result result, const skv_error *cause, skv_error *error)
{
    return skv_fail(error, result, "replay: its start: %s", cause->text);
}

skv_result skv_player_show(skv_player *player, const skv_showing *showing, const uint8_t *second,
                           size_t size, skv_error *error)
{
    uint8_t *copy = size ? skv_calloc(size, 1) : NULL;
    if (size && !copy)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a second world");
    if (size)
        memcpy(copy, second, size);
    skv_free(player->second);
    player->showing = *showing;
    player->second = copy;
    player->second_size = size;
    return SKV_OK;
}

static skv_result ask_second(const contents *c, skv_demands *demands, skv_error *error);

static skv_result read_replay(skv_reader *r, const skv_player_def *def, skv_player **player,
                              skv_error *error)
{
    contents c;
    skv_demands unused = {0};
    skv_error cause;
    skv_result result = find_contents(r, &c, error);
    if (result == SKV_OK) /* what is damaged there is said before anything is opened */
        result = ask_second(&c, &unused, error);
    if (result != SKV_OK)
        return result;
    result = begin_replay(c.recipe, c.recipe_size, c.start, c.start_size, def, player, &cause);
    if (result != SKV_OK)
        return fail_start(result, &cause, error);
    result = skv_player_show(*player, &c.showing, c.second, c.second_size, error);
    if (result != SKV_OK)
        return result;
    return take_log(*player, c.log, c.log_size, c.end, !def->changed, error);
}

skv_result skv_player_load(const void *data, size_t size, const skv_player_def *def,
                           skv_player **player, skv_error *error)
{
    SKV_ASSERT_OR(player, SKV_ERROR_VALUE);
    *player = NULL;
    SKV_ASSERT_OR(data, SKV_ERROR_VALUE);
    skv_player_def plain = skv_default_player_def();
    def = def ? def : &plain;
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &plain, sizeof plain), SKV_ERROR_VALUE);
    skv_reader reader = {.bytes = data, .size = size};
    bool replay = skv_envelope_is(&kind, data, size);
    skv_result result =
        replay ? read_replay(&reader, def, player, error) : begin(data, size, def, player, error);
    if (result != SKV_OK) {
        skv_player_destroy(*player);
        *player = NULL;
    }
    return result;
}

/* ---- What it asks for ------------------------------------------------------------------------ */

static skv_result ask_recipe(const contents *c, skv_demands *demands, skv_error *error)
{
    skv_scene *scene = NULL;
    skv_result result = skv_recipe_load(c->recipe, c->recipe_size, NULL, &scene, error);
    if (result == SKV_OK)
        demands->particles = skv_scene_particles(scene);
    skv_scene_destroy(scene);
    return result;
}

static skv_result ask_log(const contents *c, skv_demands *demands, skv_error *error)
{
    skv_log log = {0};
    skv_error cause;
    skv_result result = skv_log_unpack(&log, c->log, c->log_size, c->end, false, &cause);
    if (result != SKV_OK)
        skv_fail(error, result, "replay: %s", cause.text);
    int64_t before = -1;
    int given = 0;
    for (size_t at = 0; result == SKV_OK && at < log.size;) {
        skv_command command;
        int64_t frame = skv_log_frame(&log, at);
        given = frame == before ? given + 1 : 1;
        demands->at_once = given > demands->at_once ? given : demands->at_once;
        before = frame;
        at = skv_log_read(&log, at, &command);
    }
    skv_free(log.bytes);
    return result;
}

/* Of one world. */
static skv_result ask_one(const contents *c, skv_demands *demands, skv_error *error)
{
    skv_error cause;
    skv_result result = SKV_OK;
    demands->frames = c->end;
    if (c->start_size)
        result = skv_snapshot_ask(c->start, c->start_size, &demands->particles, &demands->crowding,
                                  &cause);
    else
        result = ask_recipe(c, demands, &cause);
    return result == SKV_OK ? ask_log(c, demands, error) : fail_start(result, &cause, error);
}

static skv_result ask_second(const contents *c, skv_demands *demands, skv_error *error)
{
    contents second;
    skv_reader reader = {.bytes = c->second, .size = c->second_size};
    if (c->second_size == 0)
        return SKV_OK;
    skv_result result = find_contents(&reader, &second, error);
    return result == SKV_OK ? ask_one(&second, demands, error) : result;
}

/* Both worlds are there at once. */
static skv_result ask_replay(skv_reader *r, skv_demands *demands, skv_error *error)
{
    contents c;
    skv_demands more = {0};
    skv_result result = find_contents(r, &c, error);
    if (result == SKV_OK)
        result = ask_one(&c, demands, error);
    if (result == SKV_OK)
        result = ask_second(&c, &more, error);
    demands->frames = more.frames > demands->frames ? more.frames : demands->frames;
    demands->at_once = more.at_once > demands->at_once ? more.at_once : demands->at_once;
    demands->crowding = more.crowding > demands->crowding ? more.crowding : demands->crowding;
    int room = INT_MAX - demands->particles;
    demands->particles += more.particles < room ? more.particles : room;
    return result;
}

skv_result skv_player_ask(const void *data, size_t size, skv_demands *demands, skv_error *error)
{
    SKV_ASSERT_OR(data && demands, SKV_ERROR_VALUE);
    *demands = (skv_demands){0};
    skv_reader reader = {.bytes = data, .size = size};
    return skv_envelope_is(&kind, data, size)
               ? ask_replay(&reader, demands, error)
               : skv_snapshot_ask(data, size, &demands->particles, &demands->crowding, error);
}

skv_result skv_demands_check(const skv_demands *demands, skv_error *error)
{
    SKV_ASSERT_OR(demands, SKV_ERROR_VALUE);
    if (demands->frames > SKV_MODEST_FRAMES)
        return skv_fail(error, SKV_ERROR_LIMIT, "it plays for %.0f minutes, %lld frames",
                        (double)demands->frames / 3600, (long long)demands->frames);
    if (demands->particles > SKV_MODEST_PARTICLES)
        return skv_fail(error, SKV_ERROR_LIMIT, "it begins with %d particles", demands->particles);
    if (demands->at_once > SKV_MODEST_AT_ONCE)
        return skv_fail(error, SKV_ERROR_LIMIT, "it does %d things within a frame",
                        demands->at_once);
    if (demands->crowding > SKV_MODEST_CROWDING)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "its fluid is pressed to %.0f times what it is at "
                        "rest, and takes as much longer to step",
                        demands->crowding);
    return SKV_OK;
}
