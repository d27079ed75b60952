/* A world's state in a file, a snapshot with terrain (docs/snapshot.md), and a replay (docs/
 * stage.md), in a file or in a link (docs/share.md), as they are.
 *
 * Invariant: what is no regular file is not opened, and no more is read than its size.
 */
#include "state_file.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "skvalp/link.h"
#include "skvalp/snapshot.h"

/* Bytes: 2 million particles and the largest picture fit several times. */
#define LARGEST_STATE (1 << 29)

bool is_state_file(const char *name)
{
    return ends_with(name, ".skv");
}

bool is_replay_file(const char *name)
{
    return ends_with(name, ".skvr") || skv_link_is(name);
}

const char *name_of_input(const char *name)
{
    static char plain[PATH_MAX];
    if (skv_link_is(name))
        return "link";
    skv_format(plain, sizeof plain, "%s", name);
    skv_make_plain(plain);
    return plain;
}

static skv_result read_bytes(const char *name, uint8_t **bytes, size_t *size, skv_error *error)
{
    struct stat status;
    bool there = stat(name, &status) == 0;
    /* A pipe or a device may never open. */
    if (there && !S_ISREG(status.st_mode))
        return skv_fail(
            error, SKV_ERROR_FILE,
            "%.200s: is not a regular file; name a file that --snapshot or the window has written",
            name);
    FILE *file = there ? fopen(name, "rb") : NULL;
    if (!file)
        return skv_fail(
            error, SKV_ERROR_FILE,
            "%.200s: cannot be opened: %s; name a file that --snapshot or the window has written",
            name, strerror(errno));
    *size = (size_t)status.st_size;
    *bytes = status.st_size <= LARGEST_STATE ? malloc(*size + 1) : NULL;
    skv_result result = SKV_OK;
    if (!*bytes)
        result = skv_fail(error, SKV_ERROR_LIMIT, "%.200s: has %zu bytes, too many for a state",
                          name, *size);
    else if (fread(*bytes, 1, *size, file) != *size)
        result = skv_fail(error, SKV_ERROR_FILE, "%.200s: cannot be read; try again", name);
    fclose(file);
    return result;
}

/* What is to be made of a file's bytes or a link's: a world, or else a player. */
typedef struct loading {
    const cli_options *options;
    skv_world **world;
    skv_player **player;
    skv_result result;
    skv_error cause;
} loading;

/* Fails for what a stranger may have made to keep one waiting. What is damaged the loader names. */
static skv_result check_demands(const void *bytes, size_t size, skv_error *error)
{
    skv_demands demands;
    skv_error much;
    if (skv_player_ask(bytes, size, &demands, NULL) || !skv_demands_check(&demands, &much))
        return SKV_OK;
    return skv_fail(error, much.code, "%s; add --anyway if that is wanted", much.text);
}

static bool load_bytes(const char *bytes, size_t size, void *user)
{
    loading *load = user;
    skv_player_def def = skv_default_player_def();
    skv_world_def host = skv_default_world_def();
    def.threads = host.threads = load->options->threads;
    load->result = load->options->anyway ? SKV_OK : check_demands(bytes, size, &load->cause);
    if (!load->result && load->world)
        load->result = skv_world_load(bytes, size, &host, load->world, &load->cause);
    else if (!load->result)
        load->result = skv_player_load(bytes, size, &def, load->player, &load->cause);
    return true;
}

static skv_result load_file(loading *load, skv_error *error)
{
    uint8_t *bytes = NULL;
    size_t size = 0;
    const char *name = load->options->scene;
    skv_result result = read_bytes(name, &bytes, &size, error);
    if (!result && load_bytes((const char *)bytes, size, load) && load->result)
        result = skv_fail(error, load->result, "%.200s: %s", name, load->cause.text);
    free(bytes);
    return result;
}

skv_result state_file_read(const cli_options *options, skv_world **world, skv_error *error)
{
    loading load = {.options = options, .world = world};
    return load_file(&load, error);
}

skv_result replay_file_read(const cli_options *options, skv_player **player, skv_error *error)
{
    loading load = {.options = options, .player = player};
    if (!skv_link_is(options->scene))
        return load_file(&load, error);
    skv_result result = skv_link_read(options->scene, load_bytes, &load, error);
    if (!result && load.result)
        result = skv_fail(error, load.result, "link: %s", load.cause.text);
    return result;
}

skv_result state_file_write(output_file *file, const skv_world *world, skv_error *error)
{
    size_t size = skv_world_snapshot_size(world, true);
    uint8_t *bytes = malloc(size);
    if (!bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "--snapshot: no memory for %zu bytes", size);
    skv_result result = skv_world_save(world, true, bytes, size, error);
    if (!result) {
        fwrite(bytes, 1, size, file->stream);
        result = output_file_check(file, error);
    }
    free(bytes);
    return result;
}
