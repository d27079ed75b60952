/* Names the machine, and reads its clocks. Invariant: the names hold no quotes, commas or line
 * ends, so they fit into CSV and Markdown as they are. */
#include "machine.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

double bench_seconds(bench_clock clock)
{
    static const clockid_t clocks[] = {CLOCK_MONOTONIC, CLOCK_PROCESS_CPUTIME_ID,
                                       CLOCK_THREAD_CPUTIME_ID};
    struct timespec now;
    clock_gettime(clocks[clock], &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void make_plain(char *text)
{
    for (char *at = text; *at; at++)
        if (strchr("\",|<>&\t\r\n", *at))
            *at = ' ';
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == ' ')
        text[--length] = '\0';
}

void bench_name_cpu(char *text, size_t size)
{
    char line[256];
    snprintf(text, size, "unknown");
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (colon && (strncmp(line, "model name", 10) == 0 || strncmp(line, "Hardware", 8) == 0)) {
            snprintf(text, size, "%s", colon + 1 + strspn(colon + 1, " "));
            break;
        }
    }
    if (file)
        fclose(file);
    make_plain(text);
}

void bench_name_compiler(char *text, size_t size)
{
#if defined(__clang__)
    snprintf(text, size, "clang %d.%d.%d", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    snprintf(text, size, "gcc %d.%d.%d", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    snprintf(text, size, "unknown");
#endif
    make_plain(text);
}

double bench_load(void)
{
    char line[64] = "";
    FILE *file = fopen("/proc/loadavg", "r");
    bool known = file && fgets(line, sizeof line, file);
    if (file)
        fclose(file);
    return known ? strtod(line, NULL) : NAN;
}
