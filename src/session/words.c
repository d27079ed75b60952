/* What a picture shows, and what a reading is, in words. */
#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "skvalp/session.h"

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

/* ---- Readings -------------------------------------------------------------------------------- */

/* What people measure a unit of an instrument in. */
static const struct unit {
    const char *from;
    double per; /* of the unit, one of those that people know */
    const char *to;
    int decimals;
} units[] = {
    {"Pa m", 1000 * 9.81 / 100, "cm of water", 1}, {"m", 0.01, "cm", 1}, {"m/s", 1, "m/s", 2},
    {"m^2/s", 0.001, "L/s per metre", 2},          {"s", 1, "s", 2},
};

static const struct unit *find_unit(const char *from)
{
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(from, units[i].from) == 0)
            return &units[i];
    return NULL;
}

const char *skv_reading_unit(const char *unit, bool plain, double *size)
{
    SKV_ASSERT_OR(unit, "");
    const struct unit *known = plain ? find_unit(unit) : NULL;
    if (size)
        *size = known ? known->per : 1;
    return known ? known->to : unit;
}

void skv_format_reading(double value, const char *unit, bool plain, char *text, size_t size)
{
    SKV_ASSERT(unit && text && size > 0);
    const struct unit *known = plain ? find_unit(unit) : NULL;
    if (!isfinite(value)) {
        skv_format(text, size, "\u2013");
    } else if (known) {
        /* No minus before zeros. */
        double shown = value / known->per, least = 0.5 * (known->decimals == 1 ? 0.1 : 0.01);
        skv_format(text, size, "%.*f %s", known->decimals, fabs(shown) < least ? 0 : shown,
                   known->to);
    } else {
        skv_format(text, size, "%.4g%s%s", value, *unit ? " " : "", unit);
    }
}
