/* Drives ffmpeg without a shell: one run that lists the encoders, one that encodes.
 *
 * Invariants: ffmpeg reads from a socket, so that writing to a dead one is an error to be reported
 * instead of a SIGPIPE; it lives in a process group of its own, so that Ctrl-C reaches only this
 * program, which then kills it before the half-written file is removed.
 */
#include "output_video.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cleanup.h"

extern char **environ;

static const char no_ffmpeg[] = "install the package ffmpeg, or omit --video";

/* Starts ffmpeg with the given standard streams; -1 is /dev/null. A signal finds it either not
 * begun, or known to cleanup.h. */
static skv_result spawn_ffmpeg(const char *const *arguments, int in, int out, int err, pid_t *pid,
                               skv_error *error)
{
    const int streams[] = {in, out, err};
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t none, all, before;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    for (int i = 0; i < 3; i++)
        if (streams[i] == -1)
            posix_spawn_file_actions_addopen(&actions, i, "/dev/null", O_RDWR, 0);
        else
            posix_spawn_file_actions_adddup2(&actions, streams[i], i);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF |
                                              POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setsigmask(&attributes, &none);
    sigprocmask(SIG_BLOCK, &all, &before);
    int reason =
        posix_spawnp(pid, arguments[0], &actions, &attributes, (char *const *)arguments, environ);
    if (!reason)
        cleanup_set_child(*pid);
    sigprocmask(SIG_SETMASK, &before, NULL);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (reason == ENOENT) {
        return skv_fail(error, SKV_ERROR_DEVICE, "--video: the program ffmpeg is not installed; %s",
                        no_ffmpeg);
    }
    return reason ? skv_fail(error, SKV_ERROR_DEVICE, "--video: ffmpeg does not start: %s; %s",
                             strerror(reason), no_ffmpeg)
                  : SKV_OK;
}

/* Waits for a child's end; true if it went well. The child stays a zombie until cleanup.h has
 * forgotten it, so that a signal never kills a process that happens to have got its number. */
static bool wait_for(pid_t pid)
{
    siginfo_t ended;
    int status;
    while (waitid(P_PID, (id_t)pid, &ended, WEXITED | WNOWAIT) == -1 && errno == EINTR) {
    }
    cleanup_set_child(0);
    while (waitpid(pid, &status, 0) == -1)
        if (errno != EINTR)
            return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* The best encoder that this ffmpeg was built with. */
static skv_result choose_encoder(const char **encoder, skv_error *error)
{
    static const char *const wanted[] = {"libx264", "libopenh264", "mpeg4"};
    enum { WANTED = (int)(sizeof wanted / sizeof wanted[0]) };
    static const char *const arguments[] = {"ffmpeg", "-hide_banner", "-encoders", NULL};
    FILE *list = tmpfile();
    if (!list) {
        return skv_fail(error, SKV_ERROR_FILE, "--video: no temporary file: %s; make room in /tmp",
                        strerror(errno));
    }
    pid_t pid;
    skv_result result = spawn_ffmpeg(arguments, -1, fileno(list), -1, &pid, error);
    if (result) {
        fclose(list);
        return result;
    }
    int best = WANTED;
    char line[256], name[64];
    if (wait_for(pid) && fseek(list, 0, SEEK_SET) == 0) {
        while (fgets(line, sizeof line, list)) {
            /* " V....D libx264   description" */
            for (int i = 0; i < best && sscanf(line, " V%*s %63s", name) == 1; i++)
                best = strcmp(name, wanted[i]) == 0 ? i : best;
        }
    }
    fclose(list);
    if (best == WANTED) {
        return skv_fail(
            error, SKV_ERROR_DEVICE,
            "--video: this ffmpeg has no encoder for mp4 (libx264, libopenh264, mpeg4); "
            "%s",
            no_ffmpeg);
    }
    *encoder = wanted[best];
    return SKV_OK;
}

skv_result video_open(output_video *video, const char *name, skv_error *error)
{
    *video = (output_video){0};
    skv_result result = choose_encoder(&video->encoder, error);
    if (!result)
        result = output_file_open(&video->file, name, error);
    if (!result && !video->file.target) {
        video_discard(video);
        result = skv_fail(error, SKV_ERROR_FILE,
                          "%s: it is no regular file, which an mp4 needs; name another", name);
    }
    return result;
}

skv_result video_start(output_video *video, int width, int height, skv_error *error)
{
    /* "file:" keeps a colon in the name from reading as a protocol. */
    char size[32], path[PATH_MAX + 8];
    snprintf(size, sizeof size, "%dx%d", width, height);
    snprintf(path, sizeof path, "file:%s", cleanup_path(video->file.slot));
    /* The quality is a constant rate for x264 and a quantiser for the others. Colours are converted
     * to BT.709 and marked as such; players guess otherwise. */
    bool x264 = strcmp(video->encoder, "libx264") == 0;
    /* clang-format off */
    const char *const arguments[] = {
        "ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-y",
        "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", size, "-framerate", "60",
        "-i", "pipe:0", "-an",
        "-vf", "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
        "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
        "-color_range", "tv",
        "-c:v", video->encoder, x264 ? "-crf" : "-q:v", x264 ? "18" : "3",
        "-movflags", "+faststart", "-f", "mp4", path, NULL,
    };
    /* clang-format on */
    int ends[2];
    video->frame_bytes = (size_t)width * (size_t)height * 3;
    video->messages = tmpfile();
    if (!video->messages || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        return skv_fail(error, SKV_ERROR_DEVICE,
                        "--video: no way to talk to ffmpeg: %s; omit --video", strerror(errno));
    }
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    skv_result result =
        spawn_ffmpeg(arguments, ends[0], -1, fileno(video->messages), &video->process, error);
    close(ends[0]);
    if (result) {
        video->process = 0;
        close(ends[1]);
        return result;
    }
    video->frames = ends[1];
    return SKV_OK;
}

/* Lets go of ffmpeg; true if it ended well. */
static bool end_encoder(output_video *video)
{
    if (video->process == 0)
        return false;
    close(video->frames);
    bool good = wait_for(video->process);
    video->process = 0;
    return good;
}

/* The first line that ffmpeg complained with. */
static skv_result report(output_video *video, skv_error *error)
{
    char line[256] = "it ended early";
    end_encoder(video);
    if (fseek(video->messages, 0, SEEK_SET) == 0 && fgets(line, sizeof line, video->messages))
        line[strcspn(line, "\n")] = '\0';
    return skv_fail(error, SKV_ERROR_DEVICE, "%s: ffmpeg failed: %s; check room and rights there",
                    video->file.name, line);
}

skv_result video_add(output_video *video, const uint8_t *rgb, skv_error *error)
{
    for (size_t sent = 0; sent < video->frame_bytes;) {
        ssize_t part = send(video->frames, rgb + sent, video->frame_bytes - sent, MSG_NOSIGNAL);
        if (part == -1 && errno != EINTR)
            return report(video, error);
        sent += part > 0 ? (size_t)part : 0;
    }
    return SKV_OK;
}

skv_result video_commit(output_video *video, skv_error *error)
{
    skv_result result = SKV_OK;
    if (video->process) {
        result =
            end_encoder(video) ? output_file_commit(&video->file, error) : report(video, error);
    }
    video_discard(video);
    return result;
}

void video_discard(output_video *video)
{
    if (video->process) {
        kill(video->process, SIGKILL);
        end_encoder(video);
    }
    if (video->messages)
        fclose(video->messages);
    output_file_discard(&video->file);
    *video = (output_video){0};
}
