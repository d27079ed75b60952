/* What run leaves on disk: pictures and videos that are what they claim, complete files or none,
 * also when it is stopped or the disk is full; and what it shows on a terminal. */
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>
#include <png.h>

#include "program.h"

#define SHORT "--particles", "200", "--seconds", "0.1", "--threads", "1"

/* Decodes a PNG, checks its size, and returns the number of different colours (at most 100). */
static int check_picture(const char *folder, const char *name, unsigned width, unsigned height)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, path));
    assert_int_equal(image.width, width);
    assert_int_equal(image.height, height);
    image.format = PNG_FORMAT_RGB;
    unsigned char *pixels = malloc(PNG_IMAGE_SIZE(image));
    assert_true(png_image_finish_read(&image, NULL, pixels, 0, NULL));
    unsigned seen[100];
    int colours = 0;
    for (size_t i = 0; i < (size_t)width * height && colours < 100; i++) {
        unsigned colour =
            (unsigned)pixels[3 * i] << 16 | (unsigned)pixels[3 * i + 1] << 8 | pixels[3 * i + 2];
        int k = 0;
        while (k < colours && seen[k] != colour)
            k++;
        if (k == colours)
            seen[colours++] = colour;
    }
    free(pixels);
    return colours;
}

static void test_picture(void **state)
{
    program_result result =
        SKVALP(*state, "run", "pool", SHORT, "--png", "a.png", "--size", "321x123", "--tracers");
    assert_string_equal(result.err, "");
    assert_int_equal(result.status, 0);
    assert_true(check_picture(*state, "a.png", 321, 123) > 2);
    program_free(&result);
    /* Without a size: the world's shape, 16:9. */
    result = SKVALP(*state, "run", "pool", SHORT, "--png=b.png");
    assert_int_equal(result.status, 0);
    check_picture(*state, "b.png", 1280, 720);
    program_free(&result);
    assert_int_equal(folder_entries(*state), 2);
}

/* One line of what ffprobe says about a video. */
static void probe(const char *folder, const char *name, const char *entries, char *text)
{
    program_result result = program_run(
        folder, (const char *const[]){"ffprobe", "-v", "error", "-select_streams", "v",
                                      "-show_entries", entries, "-of", "csv=p=0", name, NULL});
    assert_int_equal(result.status, 0);
    snprintf(text, 256, "%s", result.out);
    text[strcspn(text, "\n")] = '\0';
    program_free(&result);
}

static void test_video(void **state)
{
    char text[256];
    program_result result = SKVALP(*state, "run", "dam-break", "--particles", "200", "--seconds",
                                   "0.5", "--video", "a: b.mp4", "--size", "160x90");
    assert_string_equal(result.err, "");
    assert_int_equal(result.status, 0);
    program_free(&result);
    probe(*state, "file:a: b.mp4", "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_frames",
          text);
    assert_string_equal(text, "h264,160,90,yuv420p,60/1,30");
    probe(*state, "file:a: b.mp4", "format=duration", text);
    assert_true(fabs(atof(text) - 0.5) < 1e-3);
    assert_int_equal(folder_entries(*state), 1);
}

/* A program under the name ffmpeg, found before any other; returns the old PATH. */
static char *fake_ffmpeg(const char *folder, const char *script, bool keep_path)
{
    char path[8192], name[4096];
    const char *before = getenv("PATH");
    char *old = strdup(before);
    snprintf(path, sizeof path, "%s/bin%s%s", folder, keep_path ? ":" : "",
             keep_path ? before : "");
    snprintf(name, sizeof name, "%s/bin", folder);
    mkdir(name, 0777);
    if (script) {
        file_write(folder, "bin/ffmpeg", script);
        snprintf(name, sizeof name, "%s/bin/ffmpeg", folder);
        assert_int_equal(chmod(name, 0777), 0);
    }
    setenv("PATH", path, 1);
    return old;
}

static void restore_path(char *old)
{
    setenv("PATH", old, 1);
    free(old);
}

static void expect_video_failure(const char *folder, const char *says)
{
    program_result result = SKVALP(folder, "run", "pool", SHORT, "--video", "a.mp4", "--csv",
                                   "a.csv", "--size", "640x360");
    assert_int_equal(result.status, 2);
    assert_int_equal(count_lines(result.err), 1);
    assert_non_null(strstr(result.err, says));
    assert_string_equal(result.out, "");
    program_free(&result);
    assert_int_equal(folder_entries(folder), 1); /* bin */
}

static void test_ffmpeg_is_missing(void **state)
{
    char *old = fake_ffmpeg(*state, NULL, false);
    expect_video_failure(*state, "ffmpeg is not installed; install the package ffmpeg");
    restore_path(old);
}

static void test_ffmpeg_without_encoders(void **state)
{
    char *old = fake_ffmpeg(*state, "#!/bin/sh\necho ' V..... gif    GIF'\n", true);
    expect_video_failure(*state, "no encoder for mp4");
    restore_path(old);
}

/* ffmpeg dies in the middle: its first complaint is passed on, no SIGPIPE, no file. */
static void test_ffmpeg_dies(void **state)
{
    static const char script[] = "#!/bin/sh\n"
                                 "case \"$*\" in\n"
                                 "*-encoders*) echo ' V..... libx264  H.264';;\n"
                                 "*) head -c 1000 >/dev/null; echo 'disk on fire' >&2\n"
                                 "   echo 'second line' >&2; exit 1;;\n"
                                 "esac\n";
    char *old = fake_ffmpeg(*state, script, true);
    expect_video_failure(*state, "a.mp4: ffmpeg failed: disk on fire;");
    restore_path(old);
}

/* No libx264: the same ffmpeg with what it has. */
static void test_encoder_fallback(void **state)
{
    char text[256], script[8192];
    snprintf(script, sizeof script,
             "#!/bin/sh\n"
             "PATH='%s'\n"
             "case \"$*\" in\n"
             "*-encoders*) echo ' V.S... mpeg4   MPEG-4 part 2';;\n"
             "*) exec ffmpeg \"$@\";;\n"
             "esac\n",
             getenv("PATH"));
    char *old = fake_ffmpeg(*state, script, true);
    program_result result =
        SKVALP(*state, "run", "pool", SHORT, "--video", "a.mp4", "--size", "160x90");
    restore_path(old);
    assert_string_equal(result.err, "");
    assert_int_equal(result.status, 0);
    program_free(&result);
    probe(*state, "a.mp4", "stream=codec_name,pix_fmt,nb_frames", text);
    assert_string_equal(text, "mpeg4,yuv420p,6");
}

/* Stops a long run while it writes everything; nothing may be left, not even ffmpeg. */
static void expect_clean_stop(const char *folder, int signal_number, const char *seconds)
{
    const struct timespec pause = {.tv_nsec = 20000000};
    pid_t pid = program_start(
        folder,
        (const char *const[]){"skvalp",    "run",           "dam-break", "--particles", "500",
                              "--seconds", seconds,         "--csv",     "a.csv",       "--trace",
                              "t.csv",     "--trace-every", "0.1",       "--png",       "a.png",
                              "--video",   "a.mp4",         "--size",    "320x180",     NULL});
    /* Four temporary files; then let it get into the run. */
    folder_await(folder, 4);
    for (int i = 0; i < 25; i++)
        nanosleep(&pause, NULL);
    assert_false(file_exists(folder, "a.csv"));
    /* A terminal sends its Ctrl-C to the whole group. */
    assert_int_equal(kill(signal_number == SIGINT ? -pid : pid, signal_number), 0);
    assert_int_equal(program_wait(pid), 128 + signal_number);
    assert_int_equal(folder_entries(folder), 0);
    /* Nobody brings the video back. */
    for (int i = 0; i < 10; i++)
        nanosleep(&pause, NULL);
    assert_int_equal(folder_entries(folder), 0);
}

static void test_interrupted(void **state)
{
    expect_clean_stop(*state, SIGINT, "3000");
    expect_clean_stop(*state, SIGTERM, "3000");
}

/* What a program that was killed has left goes when the next one writes there; what another one
 * that lives still writes stays. */
static void test_killed(void **state)
{
    const char *run[] = {"skvalp",  "run",       "dam-break", "--particles", "500",
                         "--quiet", "--seconds", "3000",      "--csv",       "a.csv",
                         NULL,      "t.csv",     "--png",     "a.png",       NULL};
    pid_t pid = program_start(*state, run);
    folder_await(*state, 1);
    assert_int_equal(kill(pid, SIGKILL), 0);
    assert_int_equal(program_wait(pid), -SIGKILL);
    assert_int_equal(folder_entries(*state), 1);
    /* No file of ours, though it is called so. */
    file_write(*state, ".skvalp-notes", "mine");
    /* Three files more than that are only there once what was left is gone. */
    run[10] = "--trace";
    pid = program_start(*state, run);
    folder_await(*state, 4);
    program_result result = SKVALP(*state, "run", "pool", SHORT, "--csv", "b.csv");
    assert_int_equal(result.status, 0);
    program_free(&result);
    assert_true(file_exists(*state, "b.csv"));
    assert_true(file_exists(*state, ".skvalp-notes"));
    assert_int_equal(folder_entries(*state), 5);
    assert_int_equal(kill(pid, SIGTERM), 0);
    assert_int_equal(program_wait(pid), 128 + SIGTERM);
    assert_int_equal(folder_entries(*state), 2);
}

static void expect_lost(const program_result *result, const char *says)
{
    assert_int_equal(result->status, 2);
    assert_int_equal(count_lines(result->err), 1);
    assert_non_null(strstr(result->err, says));
}

static void test_full_disk(void **state)
{
    program_result result =
        SKVALP(*state, "run", "pool", SHORT, "--csv", "/dev/full", "--trace", "t.csv");
    expect_lost(&result,
                "skvalp: /dev/full: cannot be written: No space left on device; make room");
    assert_string_equal(result.out, "");
    program_free(&result);
    result = SKVALP(*state, "run", "pool", SHORT, "--png", "/dev/full", "--json", "--csv", "a.csv");
    expect_lost(&result,
                "skvalp: /dev/full: cannot be written: No space left on device; make room");
    assert_string_equal(result.out, "");
    program_free(&result);
    assert_int_equal(folder_entries(*state), 0);
    result = program_run(*state, (const char *const[]){"sh", "-c", "exec \"$0\" scenes >/dev/full",
                                                       SKV_BINARY_DIR "/skvalp", NULL});
    expect_lost(&result, "skvalp: standard output: No space left on device;");
    program_free(&result);
}

/* A failure keeps what was there before; success replaces it, through a link, with its mode. */
static void test_replaces_whole_files(void **state)
{
    char path[4096];
    struct stat status;
    file_write(*state, "old.csv", "precious\n");
    snprintf(path, sizeof path, "%s/link.csv", (char *)*state);
    assert_int_equal(symlink("old.csv", path), 0);
    program_result result =
        SKVALP(*state, "run", "pool", SHORT, "--csv", "link.csv", "--png", "/dev/full");
    assert_int_equal(result.status, 2);
    program_free(&result);
    char *text = file_read(*state, "old.csv");
    assert_string_equal(text, "precious\n");
    free(text);

    result = SKVALP(*state, "run", "pool", SHORT, "--csv", "link.csv");
    assert_int_equal(result.status, 0);
    program_free(&result);
    assert_int_equal(lstat(path, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    text = file_read(*state, "old.csv");
    assert_memory_equal(text, "t,particles", 11);
    free(text);
    mode_t mask = umask(0);
    umask(mask);
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(status.st_mode & 0777, 0666 & ~mask);
    assert_int_equal(folder_entries(*state), 2);
}

/* A reader that leaves ends the run quietly. */
static void test_reader_leaves(void **state)
{
    program_result result =
        program_run(*state, (const char *const[]){"sh", "-c",
                                                  "\"$0\" run pool --particles 500 --seconds 3000 "
                                                  "--trace - --csv a.csv | head -n 1",
                                                  SKV_BINARY_DIR "/skvalp", NULL});
    assert_string_equal(result.out, "t,id,x,y,vx,vy,pressure,fluid\n");
    assert_string_equal(result.err, "");
    program_free(&result);
    assert_int_equal(folder_entries(*state), 0);
}

enum { COLUMNS = 62 };

/* `script` gives the program a terminal and records what it shows. */
static program_result on_terminal(const char *folder, const char *command)
{
    char line[4096];
    snprintf(line, sizeof line, "stty cols %d; %s/skvalp %s", COLUMNS, SKV_BINARY_DIR, command);
    return program_run(folder, (const char *const[]){"script", "-qec", line, "/dev/null", NULL});
}

static void test_progress(void **state)
{
    static const char command[] = "run dam-break --particles 2500 --seconds 3";
    struct timespec before, after;
    clock_gettime(CLOCK_MONOTONIC, &before);
    program_result result = on_terminal(*state, command);
    clock_gettime(CLOCK_MONOTONIC, &after);
    assert_int_equal(result.status, 0);
    assert_non_null(strstr(result.out, "dam-break"));
    assert_non_null(strstr(result.out, " / 3.00 s"));
    assert_non_null(strstr(result.out, " left"));
    /* Cleared: after the last line only blanks come before the summary. */
    char *last = result.out, *at;
    int updates = 0;
    for (; (at = strstr(last + 1, " / 3.00 s")); updates++)
        last = at;
    assert_in_range(updates, 1, 10 * (after.tv_sec - before.tv_sec + 1));
    at = strchr(last, '\r');
    assert_non_null(at);
    at += 1 + strspn(at + 1, " ");
    assert_int_equal(*at, '\r');
    /* A line that reaches the last column would wrap. */
    assert_int_equal(at - strchr(last, '\r'), COLUMNS);
    assert_int_equal(at[1] >= 'A' && at[1] <= 'Z', 1);
    program_free(&result);

    /* Not in a pipe, not when quiet. */
    result = SKVALP(*state, "run", "dam-break", "--particles", "1500", "--seconds", "1");
    assert_string_equal(result.err, "");
    program_free(&result);
    char quiet[128];
    snprintf(quiet, sizeof quiet, "%s --quiet", command);
    result = on_terminal(*state, quiet);
    assert_string_equal(result.out, "");
    program_free(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_picture, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_video, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_ffmpeg_is_missing, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_ffmpeg_without_encoders, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_ffmpeg_dies, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_encoder_fallback, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_interrupted, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_killed, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_full_disk, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_replaces_whole_files, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_reader_leaves, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_progress, folder_setup, folder_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
