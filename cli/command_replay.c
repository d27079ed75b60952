/* skvalp replay: plays a replay and compares every hash that was written down with it. skvalp
 * share: does so, and then makes a link of it; or of a scene, where there is nothing to play. */
#include "commands.h"

#include <inttypes.h>

#include "output_json.h"
#include "progress.h"
#include "skvalp/link.h"
#include "skvalp/query.h"
#include "state_file.h"

static skv_result play(skv_player *player, const char *name, bool quiet, skv_error *error)
{
    int64_t end = skv_player_end(player);
    progress_line progress = progress_start(name, (double)end / 60, quiet);
    skv_result result = SKV_OK;
    skv_error cause;
    /* Seeking also comes to what stands in the log after the last frame. */
    for (int64_t frame = 0; frame < end && !result; frame++) {
        result = skv_player_step(player, &cause);
        progress_update(&progress, (double)frame / 60);
    }
    if (!result)
        result = skv_player_seek(player, end, &cause);
    while (!result && skv_player_seeking(player))
        result = skv_player_step(player, &cause);
    progress_end(&progress);
    if (result)
        skv_fail(error, result, "%.200s: %s", name, cause.text);
    return result;
}

static skv_result report(const skv_player *player, const cli_options *options, skv_error *error)
{
    const skv_world *world = skv_player_world(player);
    int64_t frames = skv_player_end(player), mismatch = skv_player_mismatch(player);
    int particles = skv_world_particle_count(world);
    uint64_t hash = skv_world_hash(world);
    if (options->json) {
        char text[17];
        snprintf(text, sizeof text, "%016" PRIx64, hash);
        return output_json(json_pack("{ss si sI ss sb}", "replay", name_of_input(options->scene),
                                     "particles", particles, "frames", (json_int_t)frames, "hash",
                                     text, "same", mismatch < 0),
                           error);
    }
    if (!options->quiet && mismatch < 0)
        printf("%s: %" PRId64 " frames, %.4g s, %d particles, as recorded; hash %016" PRIx64 "\n",
               name_of_input(options->scene), frames, (double)frames / 60, particles, hash);
    return SKV_OK;
}

static int fail_mismatch(const char *name, int64_t frame, skv_error *error)
{
    skv_fail(error, SKV_ERROR_VALUE,
             "%s: at %.4g s, frame %" PRId64 ", the world is not the one that was recorded; use "
             "the version of skvalp that recorded it",
             name, (double)frame / 60, frame);
    return STATUS_FAILED;
}

int replay_command(const cli_options *options, skv_error *error)
{
    skv_player *player = NULL;
    const char *name = name_of_input(options->scene);
    skv_result result = replay_file_read(options, &player, error);
    if (!result)
        result = play(player, name, options->quiet, error);
    if (!result)
        result = report(player, options, error);
    int64_t mismatch = player ? skv_player_mismatch(player) : -1;
    skv_player_destroy(player);
    if (result)
        return STATUS_BAD;
    return mismatch < 0 ? STATUS_DONE : fail_mismatch(name, mismatch, error);
}

/* ---- Sharing --------------------------------------------------------------------------------- */

/* A player at what is to be shared: the end of a replay, or the start of a scene. */
static skv_result open_shared(const cli_options *options, skv_player **player, skv_error *error)
{
    const char *name = name_of_input(options->scene);
    skv_result result;
    if (is_replay_file(options->scene)) {
        if (options->particles || options->setting_count)
            return skv_fail(error, SKV_ERROR_VALUE,
                            "%.200s: a replay is what it is; leave out --particles, --law and "
                            "--set",
                            name);
        result = replay_file_read(options, player, error);
        return result ? result : play(*player, name, options->quiet, error);
    }
    skv_scene *scene = NULL;
    skv_scene_options wanted = options_for_scene(options);
    skv_player_def def = skv_default_player_def();
    def.threads = options->threads;
    result = skv_scene_load(options->scene, &wanted, &scene, error);
    if (result)
        return result;
    result = skv_player_create(scene, &def, player, error);
    if (result)
        skv_scene_destroy(scene);
    return result;
}

static bool print_text(const char *text, size_t length, void *user)
{
    (void)user;
    return fwrite(text, 1, length, stdout) == length && putchar('\n') != EOF;
}

/* From the replay's bytes to the link. */
typedef struct sharing {
    const char *page;
    skv_result result;
    skv_error *error;
} sharing;

static bool print_link(const char *bytes, size_t size, void *user)
{
    sharing *share = user;
    share->result = skv_link_write(bytes, size, share->page, print_text, NULL, share->error);
    return true;
}

int share_command(const cli_options *options, skv_error *error)
{
    skv_player *player = NULL;
    skv_error cause;
    const char *name = name_of_input(options->scene);
    sharing share = {.page = options->page, .error = error};
    skv_result result = open_shared(options, &player, error);
    int64_t mismatch = result ? -1 : skv_player_mismatch(player);
    if (!result && mismatch < 0) {
        result = skv_player_share(player, print_link, &share, &cause);
        if (result)
            skv_fail(error, result, "%.200s: %s", name, cause.text);
        else
            result = share.result;
    }
    skv_player_destroy(player);
    if (result)
        return STATUS_BAD;
    return mismatch < 0 ? STATUS_DONE : fail_mismatch(name, mismatch, error);
}
