/* Opening and saving. Invariants: what cannot be opened leaves what is open untouched; a file that
 * is saved appears when it is complete. */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "base/bytes.h"
#include "base/memory.h"
#include "scene/read/file.h"
#include "session/save.h"
#include "session/worker.h"
#include "skvalp/snapshot.h"

/* Bytes: 2 million particles and the largest picture fit several times. */
#define LARGEST_FILE (1 << 29)

/* ---- Saving ---------------------------------------------------------------------------------- */

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* What a name ends in, without the dot. */
static const char *ending(const char *path)
{
    const char *dot = strrchr(base_name(path), '.');
    return dot ? dot + 1 : "";
}

static bool is_format(const char *format, const char *name)
{
    return strcasecmp(format, name) == 0;
}

bool skv_names_replay(const char *path)
{
    return is_format(ending(path), "skvr");
}

static skv_result write_state(const skv_world *world, const char *path, skv_error *error)
{
    size_t size = skv_world_snapshot_size(world, true);
    uint8_t *bytes = skv_calloc(size, 1);
    if (!bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "no memory for %zu bytes", size);
    skv_result result = skv_world_save(world, true, bytes, size, error);
    if (result == SKV_OK)
        result = skv_file_write(path, bytes, size, error);
    skv_free(bytes);
    return result;
}

/* Where a replay goes. */
typedef struct target {
    const char *path;
    skv_result result;
    skv_error *error;
} target;

/* A player writes all of it at once. */
static bool write_replay(const char *bytes, size_t size, void *user)
{
    target *to = user;
    to->result = skv_file_write(to->path, bytes, size, to->error);
    return true;
}

static skv_result save(skv_worker *worker, const char *path, bool moment, skv_error *error)
{
    if (!worker->player)
        return skv_fail(error, SKV_ERROR_VALUE, "nothing is open");
    if (!moment && is_format(ending(path), "skv"))
        return write_state(skv_player_world(worker->player), path, error);
    if (!moment && !skv_names_replay(path))
        return skv_fail(error, SKV_ERROR_VALUE, "name it .skv, for the state, or .skvr, a replay");
    target to = {.path = path, .error = error};
    skv_result result = skv_worker_tell_shown(worker, false, error);
    if (result == SKV_OK)
        result = (moment ? skv_player_save_moment : skv_player_save)(worker->player, write_replay,
                                                                     &to, error);
    return result == SKV_OK ? to.result : result;
}

void skv_worker_save(skv_worker *worker, const skv_request *request)
{
    skv_error error = {0};
    save(worker, request->name, request->text != NULL, &error);
    skv_worker_report(worker, SKV_OUTCOME_SAVE, &error);
}

static bool keep_shared(const char *bytes, size_t size, void *place)
{
    skv_shared *shared = skv_calloc(sizeof *shared + size, 1);
    if (!shared)
        return false;
    shared->size = size;
    memcpy(shared->bytes, bytes, size);
    skv_free(atomic_exchange((_Atomic(skv_shared *) *)place, shared));
    return true;
}

static skv_result share_as(skv_worker *worker, skv_share share, void *place, skv_error *error)
{
    if (!worker->player)
        return skv_fail(error, SKV_ERROR_VALUE, "nothing is open");
    skv_result result = skv_worker_tell_shown(worker, share != SKV_SHARE_LINK, error);
    if (result == SKV_OK && share == SKV_SHARE_BESIDE_WHOLE)
        result = skv_player_share_whole(worker->player, keep_shared, place, error);
    else if (result == SKV_OK && share == SKV_SHARE_BESIDE_MOMENT)
        result = skv_player_save_moment(worker->player, keep_shared, place, error);
    else if (result == SKV_OK)
        result = skv_player_share(worker->player, keep_shared, place, error);
    if (result == SKV_OK && share == SKV_SHARE_OFFER)
        worker->player->shared = worker->player->now;
    return result;
}

/* Who waits for a part of a link looks where it is to lie, and finds there why it could not be
 * made.
 */
static void keep_failure(void *place, const skv_error *error)
{
    skv_shared *failed = skv_calloc(sizeof *failed, 1);
    if (failed) {
        failed->result = error->code;
        failed->error = *error;
    }
    skv_free(atomic_exchange((_Atomic(skv_shared *) *)place, failed));
}

void skv_worker_share(skv_worker *worker, skv_share share)
{
    skv_error error = {0};
    int kept = share < SKV_SHARE_BESIDE ? (int)share : SKV_SHARE_BESIDE;
    skv_result result = share_as(worker, share, &worker->shared[kept], &error);
    if (share < SKV_SHARE_BESIDE)
        skv_worker_report(
            worker, share == SKV_SHARE_OFFER ? SKV_OUTCOME_COMPARE : SKV_OUTCOME_SHARE, &error);
    else if (result != SKV_OK)
        keep_failure(&worker->shared[kept], &error);
}

/* ---- Opening --------------------------------------------------------------------------------- */

static skv_result open_scene(const skv_request *request, const skv_player_def *def,
                             skv_player **player, skv_error *error)
{
    skv_scene *scene = NULL;
    skv_result result = request->data
                            ? skv_scene_load_memory(request->data, request->size, request->text,
                                                    request->name, &request->options, &scene, error)
                            : skv_scene_load(request->name, &request->options, &scene, error);
    if (result != SKV_OK)
        return result;
    result = skv_player_create(scene, def, player, error);
    if (result != SKV_OK)
        skv_scene_destroy(scene);
    return result;
}

/* Fails for what asks for much, unless it was the last to do so. What is damaged the player names.
 */
static skv_result be_cautious(skv_worker *worker, const void *bytes, size_t size, skv_error *error)
{
    skv_demands demands;
    skv_error much;
    uint64_t hash = skv_hash_bytes(SKV_HASH_BEGIN, bytes, size);
    if (hash == worker->wary || skv_player_ask(bytes, size, &demands, NULL) != SKV_OK ||
        skv_demands_check(&demands, &much) == SKV_OK)
        return SKV_OK;
    worker->wary = hash;
    return skv_fail(error, much.code, "%s; open it once more if that is wanted", much.text);
}

static skv_result open_bytes(skv_worker *worker, const skv_request *request,
                             const skv_player_def *def, skv_player **player, skv_error *error)
{
    uint8_t *read = NULL;
    size_t size = request->size;
    skv_error cause;
    skv_result result =
        request->data ? SKV_OK : skv_file_read(request->name, LARGEST_FILE, &read, &size, error);
    if (result != SKV_OK)
        return result;
    const void *bytes = request->data ? request->data : read;
    if (!request->data || request->options.cautious)
        result = be_cautious(worker, bytes, size, &cause);
    if (result == SKV_OK)
        result = skv_player_load(bytes, size, def, player, &cause);
    if (result != SKV_OK)
        skv_fail(error, result, "%s: %s", request->name, cause.text);
    skv_free(read);
    return result;
}

/* Puts what was opened in place of what is. Its scene goes to the pictures, which may outlive the
 * player. */
static void take_over(skv_worker *worker, skv_player *player, const skv_player_def *def,
                      skv_opened *opened)
{
    skv_player_destroy(worker->player);
    skv_opened_leave(worker->opened);
    skv_probes_destroy(&worker->probes);
    skv_tools_cancel(&worker->tools);
    worker->player = player;
    worker->opened = opened;
    player->scene = NULL;
    const skv_world *world = skv_player_world(player);
    const skv_terrain *terrain = skv_world_terrain(world);
    worker->tools.world_size =
        fmax((double)skv_terrain_width(terrain), (double)skv_terrain_height(terrain));
    worker->tools.fluids = skv_world_frame(world).fluid_count;
    worker->tools.steps = skv_steps_of(world);
    float x, y;
    skv_world_gravity(world, &x, &y);
    worker->tilt_x = (double)x / worker->tools.steps.strength;
    worker->tilt_y = (double)y / worker->tools.steps.strength;
    worker->tilt_pending = false;
    worker->unread = true;
    worker->unbalanced = skv_player_unbalanced(player);
    worker->forecast.known = false;
    worker->following = skv_player_end(player) > 0;
    if (!worker->following) /* what stands in a log without a frame */
        skv_player_seek(player, 0, NULL);
    worker->watching = worker->following;
    worker->followed = false;
    worker->again = def->changed != NULL;
    worker->halted = false;
    worker->hand_count = 0;
    worker->hands_known = false;
    double speed = worker->pace.speed;
    worker->pace = skv_pace_start();
    worker->pace.speed = speed;
    if (worker->def.own_thread) /* what has passed beside it is not the new world's */
        atomic_store(&worker->elapsed, 0);
    skv_worker_show(worker, def->changed != NULL);
}

void skv_worker_open(skv_worker *worker, const skv_request *request)
{
    skv_error error = {0};
    skv_player *player = NULL;
    skv_player_def def = skv_default_player_def();
    def.pool = worker->pool;
    def.history = worker->def.history;
    bool changed = request->options.particles > 0 || request->options.setting_count > 0;
    def.changed = changed ? &request->options : NULL;
    const char *format = request->data ? request->text : ending(request->name);
    bool bytes = is_format(format, "skv") || is_format(format, "skvr");
    skv_result result = bytes ? open_bytes(worker, request, &def, &player, &error)
                              : open_scene(request, &def, &player, &error);
    if (result == SKV_OK) {
        uint32_t number = worker->opened ? worker->opened->number + 1 : 1;
        skv_opened *opened = skv_opened_create(player->scene, base_name(request->name), number);
        if (opened) {
            take_over(worker, player, &def, opened);
        } else {
            skv_player_destroy(player);
            skv_fail(&error, SKV_ERROR_MEMORY, "out of memory for what is to be opened");
        }
    }
    if (result != SKV_STOPPED) /* for another one, which tells */
        skv_worker_report(worker, SKV_OUTCOME_OPEN, &error);
}
