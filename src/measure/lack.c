/* Why an instrument has no reading. Invariant: every reason is a row of one table, for translators.
 */
#include "measure/instruments.h"

enum { OUTSIDE, IN_WALL, NO_WATER, WALL_ABOVE, WEIGHTLESS, NO_WAVE, NOT_YET, REASONS };

static const char *const words[REASONS] = {
    [OUTSIDE] = "outside",       [IN_WALL] = "in the wall",   [NO_WATER] = "no water here",
    [WALL_ABOVE] = "wall above", [WEIGHTLESS] = "weightless", [NO_WAVE] = "no wave yet",
    [NOT_YET] = "not yet",
};

const char *skv_lack_words(int i)
{
    return i >= 0 && i < REASONS ? words[i] : NULL;
}

/* Why there is no water at a place. */
static int dryness(const skv_survey *s, double x, double y)
{
    if (x < 0 || y < 0 || x > (double)skv_terrain_width(s->terrain) ||
        y > (double)skv_terrain_height(s->terrain))
        return OUTSIDE;
    return skv_terrain_distance(s->terrain, (float)x, (float)y) > 0 ? NO_WATER : IN_WALL;
}

const char *skv_instrument_lack(const instrument *it, const skv_survey *s, int channel)
{
    const skv_instrument_def *def = &it->def;
    bool timed = def->kind == SKV_INSTRUMENT_GATE || def->kind == SKV_INSTRUMENT_STOPWATCH;
    int why = NO_WATER;
    if (it->count == 0 || !s->terrain || timed)
        why = NOT_YET;
    else if (skv_instrument_channel(def->kind, channel)->theory)
        why = s->gravity_x == 0 && s->gravity_y == 0 ? WEIGHTLESS : WALL_ABOVE;
    else if (def->kind == SKV_INSTRUMENT_WAVES && channel > 0)
        why = NO_WAVE;
    else if (def->kind != SKV_INSTRUMENT_REGION)
        why = dryness(s, def->x0, def->y0);
    return words[why];
}
