/* What a picture shows, in words. */
#include "base/assert.h"
#include "skvalp/stage.h"

/* "2 960": groups of three digits, with thin spaces that keep together. */
static void write_count(int count, char *text, size_t size)
{
    if (count >= 1000000)
        skv_format(text, size, "%d\u202f%03d\u202f%03d", count / 1000000, count / 1000 % 1000,
                   count % 1000);
    else if (count >= 1000)
        skv_format(text, size, "%d\u202f%03d", count / 1000, count % 1000);
    else
        skv_format(text, size, "%d", count);
}

static const char *state_of(const skv_picture *picture)
{
    if (picture->seeking)
        return "going back";
    return picture->paused ? "paused" : "playing";
}

void skv_picture_describe(const skv_picture *picture, char *text, size_t size)
{
    SKV_ASSERT(picture && text && size > 0);
    text[0] = '\0';
    if (picture->opened == 0)
        return;
    char count[32], extra[64] = "";
    write_count(picture->frame.particles.count, count, sizeof count);
    if (picture->at_rest)
        skv_format(extra, sizeof extra, ", at rest");
    else if (!picture->paused && picture->pace < 0.95)
        skv_format(extra, sizeof extra, ", %.2g\u00d7 of real time",
                   picture->pace * picture->speed);
    else if (picture->speed != 1)
        skv_format(extra, sizeof extra, ", speed %g\u00d7", picture->speed);
    skv_format(text, size, "%s, %s particles%s", state_of(picture), count, extra);
}
