/* Recorder: plays the log again on a thread of its own and hands pictures to ffmpeg. Invariant: the
 * video appears under its name when it is complete, or not at all. */
#include "recorder.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <math.h>
#include <skvalp/player.h>
#include <stdio.h>
#include <string.h>

#include "workers.h"

#define FRAMES_A_SECOND 60
#define EVERY           2 /* frames a picture: 30 pictures a second */
#define WIDTH           1280

typedef struct job {
    char *replay, *path;
    gint64 moment;
    double seconds;
    skv_render_style style;
    GCancellable *stop;
    PlayRecorded *told;
    gpointer user;
    bool done;
    char error[256];
} job;

typedef struct news {
    PlayRecorded *told;
    gpointer user;
    double share;
} news;

static gboolean on_news(gpointer data)
{
    news *n = data;
    n->told(n->share, false, NULL, n->user);
    g_free(n);
    return G_SOURCE_REMOVE;
}

static void tell(const job *work, double share)
{
    news *n = g_new(news, 1);
    *n = (news){work->told, work->user, share};
    g_idle_add_full(G_PRIORITY_DEFAULT, on_news, n, NULL); /* as the end: it comes last */
}

/* Height of a picture for a width: even, as videos want it. */
static int height_for(const skv_frame *frame, int width)
{
    double ratio = skv_terrain_height(frame->terrain) / skv_terrain_width(frame->terrain);
    return CLAMP((int)lround(width * ratio / 2) * 2, 16, 4 * width);
}

static bool fail(job *work, const char *text)
{
    if (!work->error[0])
        g_strlcpy(work->error, text, sizeof work->error);
    return false;
}

static skv_player *load(job *work)
{
    char *data;
    gsize size;
    GError *problem = NULL;
    skv_player *player = NULL;
    skv_error error;
    if (!g_file_get_contents(work->replay, &data, &size, &problem)) {
        fail(work, problem->message);
        g_error_free(problem);
        return NULL;
    }
    if (skv_player_load(data, size, NULL, &player, &error) != SKV_OK)
        fail(work, error.text);
    g_free(data);
    return player;
}

static bool go_to(job *work, skv_player *player, gint64 frame)
{
    skv_error error;
    if (skv_player_seek(player, frame, &error) != SKV_OK)
        return fail(work, error.text);
    while (skv_player_seeking(player) && !g_cancellable_is_cancelled(work->stop))
        if (skv_player_step(player, &error) != SKV_OK)
            return fail(work, error.text);
    return true;
}

static GSubprocess *start_ffmpeg(job *work, int width, int height, const char *output)
{
    char size[32];
    g_snprintf(size, sizeof size, "%dx%d", width, height);
    GError *problem = NULL;
    /* A set of flags is no member of their enumeration, as the analyser sees it.
     * NOLINTBEGIN(clang-analyzer-optin.core.EnumCastOutOfRange) */
    const GSubprocessFlags flags = G_SUBPROCESS_FLAGS_STDIN_PIPE |
                                   G_SUBPROCESS_FLAGS_STDOUT_SILENCE |
                                   G_SUBPROCESS_FLAGS_STDERR_SILENCE;
    /* NOLINTEND(clang-analyzer-optin.core.EnumCastOutOfRange) */
    GSubprocess *process =
        g_subprocess_new(flags, &problem, "ffmpeg", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24",
                         "-s", size, "-r", "30", "-i", "-", "-pix_fmt", "yuv420p", "-movflags",
                         "+faststart", "-f", "mp4", output, NULL);
    if (!process) {
        fail(work, problem->message);
        g_clear_error(&problem);
    }
    return process;
}

static bool write_pictures(job *work, skv_player *player, skv_offscreen *offscreen, guint8 *rgb,
                           gsize size, GOutputStream *to)
{
    gint64 from = skv_player_frame(player), count = MAX(work->moment - from, 1);
    for (gint64 i = 0; i <= count; i++) {
        skv_error error;
        if (g_cancellable_is_cancelled(work->stop))
            return false;
        skv_frame frame = skv_world_frame(skv_player_world(player));
        if (i % EVERY == 0) {
            if (skv_offscreen_render(offscreen, &frame, &work->style, rgb, &error) != SKV_OK)
                return fail(work, error.text);
            if (!g_output_stream_write_all(to, rgb, size, NULL, NULL, NULL))
                return fail(work, _("ffmpeg ended early, as on a full disk"));
            tell(work, (double)i / (double)count);
        }
        if (i < count && skv_player_step(player, &error) != SKV_OK)
            return fail(work, error.text);
    }
    return true;
}

/* What keeps a file from being made is the system's to say: of ffmpeg nobody hears it. */
static bool can_write(job *work, const char *output)
{
    FILE *file = g_fopen(output, "wb");
    if (!file)
        return fail(work, g_strerror(errno));
    fclose(file);
    return true;
}

/* The video under a name beside its own. */
static bool make_video(job *work, skv_player *player, const char *output)
{
    skv_frame frame = skv_world_frame(skv_player_world(player));
    int height = height_for(&frame, WIDTH);
    gsize size = (gsize)WIDTH * (gsize)height * 3;
    skv_offscreen *offscreen;
    skv_error error;
    if (skv_offscreen_create(WIDTH, height, &offscreen, &error) != SKV_OK)
        return fail(work, error.text);
    GSubprocess *ffmpeg = start_ffmpeg(work, WIDTH, height, output);
    bool done = false;
    if (ffmpeg) {
        guint8 *rgb = g_malloc(size);
        GOutputStream *to = g_subprocess_get_stdin_pipe(ffmpeg);
        done = write_pictures(work, player, offscreen, rgb, size, to);
        g_output_stream_close(to, NULL, NULL);
        if (!g_subprocess_wait_check(ffmpeg, NULL, NULL) && done)
            done = fail(work, _("ffmpeg ended early, as on a full disk"));
        g_free(rgb);
        g_object_unref(ffmpeg);
    }
    skv_offscreen_destroy(offscreen);
    return done;
}

static gboolean on_ended(gpointer data)
{
    job *work = data;
    work->told(1, true, work->done ? NULL : work->error, work->user);
    g_free(work->replay);
    g_free(work->path);
    g_object_unref(work->stop);
    g_free(work);
    return G_SOURCE_REMOVE;
}

static gpointer run(gpointer data)
{
    job *work = data;
    char *output = g_strconcat(work->path, ".part", NULL);
    skv_player *player = load(work);
    gint64 from = MAX(0, work->moment - (gint64)(work->seconds * FRAMES_A_SECOND));
    work->done = player && can_write(work, output) && go_to(work, player, from) &&
                 make_video(work, player, output);
    if (work->done && g_rename(output, work->path) != 0)
        work->done = fail(work, g_strerror(errno));
    if (!work->done)
        g_remove(output);
    skv_player_destroy(player);
    g_free(output);
    g_idle_add_full(G_PRIORITY_DEFAULT, on_ended, work, NULL);
    return NULL;
}

void play_record(const char *replay, const char *path, gint64 moment, double seconds,
                 const skv_render_style *style, GCancellable *stop, PlayRecorded *told,
                 gpointer user)
{
    job *work = g_new0(job, 1);
    *work = (job){.replay = g_strdup(replay),
                  .path = g_strdup(path),
                  .moment = moment,
                  .seconds = seconds,
                  .style = *style,
                  .stop = g_object_ref(stop),
                  .told = told,
                  .user = user};
    play_workers_start("video", run, work);
}
