/* Draws the progress line on stderr.
 *
 * Invariant: nothing is written unless stderr is a terminal, and the line never reaches the last
 * column, so that it cannot wrap and overwriting it with spaces always takes it away.
 */
#include "progress.h"

#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "cleanup.h"
#include "skvalp/base.h"

double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int columns(void)
{
    struct winsize size;
    int width = CLEANUP_LINE;
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1)
        width = size.ws_col - 1;
    return width < CLEANUP_LINE ? width : CLEANUP_LINE;
}

progress_line progress_start(const char *label, double total, bool quiet)
{
    double now = clock_seconds();
    return (progress_line){.label = label,
                           .total = total,
                           .wanted = !quiet && isatty(STDERR_FILENO),
                           .started = now,
                           .updated = now};
}

static bool is_due(const progress_line *progress)
{
    return progress->wanted && clock_seconds() - progress->updated >= 0.1;
}

void progress_show(progress_line *progress, const char *text)
{
    if (!is_due(progress))
        return;
    int width = columns();
    cleanup_set_line(true);
    fprintf(stderr, "\r%-*.*s", width, width, text);
    fflush(stderr);
    progress->shown = true;
    progress->updated = clock_seconds();
}

void progress_update(progress_line *progress, double simulated)
{
    if (!is_due(progress))
        return;
    double speed = simulated / (clock_seconds() - progress->started);
    double left = speed > 0 ? (progress->total - simulated) / speed : 0;
    char line[256];
    snprintf(line, sizeof line, "%.24s  %.2f / %.2f s  %3.0f %%  %.2fx real time  %d:%02d left",
             progress->label, simulated, progress->total,
             progress->total > 0 ? 100 * simulated / progress->total : 100, speed, (int)(left / 60),
             (int)left % 60);
    skv_make_plain(line);
    progress_show(progress, line);
}

void progress_end(progress_line *progress)
{
    if (progress->shown) {
        fprintf(stderr, "\r%*s\r", columns(), "");
        fflush(stderr);
        cleanup_set_line(false);
        progress->shown = false;
    }
}
