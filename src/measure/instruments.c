/* The kinds of instruments: what each sees in a survey, and the table of them all.
 *
 * A kind is a function sample_... and a row of the table. Invariant: a particle's way between two
 * samples crosses a gate's line exactly when its two ends lie on different sides, a point on the
 * line being on the left; so no particle is counted twice, and one that goes back is counted back.
 */
#include "measure/instruments.h"

#include "base/exact.h"

#include <math.h>

static double speed_squared(const skv_survey *s, int i)
{
    double vx = (double)s->vx[i], vy = (double)s->vy[i];
    return vx * vx + vy * vy;
}

/* How far the surface is from a wet point, against gravity: the first place where fluid ends. NaN
 * if a wall is before it or keeps it, within a spacing, or for want of gravity. */
static double depth_below_surface(const skv_survey *s, double x, double y)
{
    double gravity = sqrt(s->gravity_x * s->gravity_x + s->gravity_y * s->gravity_y);
    if (!(gravity > 0))
        return (double)NAN;
    double up_x = -s->gravity_x / gravity, up_y = -s->gravity_y / gravity;
    double wet = 0, dry = s->spacing;
    while (skv_survey_fill(s, x + up_x * dry, y + up_y * dry) >= 0.5) {
        wet = dry;
        dry += s->spacing;
    }
    for (int i = 0; i < 24; i++) {
        double middle = (wet + dry) / 2;
        if (skv_survey_fill(s, x + up_x * middle, y + up_y * middle) >= 0.5)
            wet = middle;
        else
            dry = middle;
    }
    double free = wet + s->spacing;
    float share = skv_terrain_sweep(s->terrain, (float)x, (float)y, (float)(x + up_x * free),
                                    (float)(y + up_y * free), 0);
    return share < 1 ? (double)NAN : wet;
}

/* The way of `depth` m straight up from a point, each piece of it as long as its fluid is heavy,
 * over the first one. */
static double mass_above(const skv_survey *s, double x, double y, double depth)
{
    if (!s->mixed || !(depth > 0))
        return depth;
    double gravity = sqrt(s->gravity_x * s->gravity_x + s->gravity_y * s->gravity_y);
    double up_x = -s->gravity_x / gravity, up_y = -s->gravity_y / gravity, sum = 0;
    int pieces = (int)(depth / s->spacing) + 1;
    for (int i = 0; i < pieces; i++) {
        double way = depth * (i + 0.5) / pieces;
        sum += skv_survey_mean_mass(s, x + up_x * way, y + up_y * way);
    }
    return depth * sum / pieces;
}

static skv_result sample_pressure(instrument *it, const look *seen, double *values)
{
    const skv_survey *s = seen->survey;
    skv_local local = skv_survey_at(s, it->def.x0, it->def.y0);
    if (!local.wet)
        return SKV_OK;
    values[0] = local.pressure;
    double depth = depth_below_surface(s, it->def.x0, it->def.y0);
    values[1] = s->density * sqrt(s->gravity_x * s->gravity_x + s->gravity_y * s->gravity_y) *
                mass_above(s, it->def.x0, it->def.y0, depth);
    return SKV_OK;
}

static skv_result sample_velocity(instrument *it, const look *seen, double *values)
{
    skv_local local = skv_survey_at(seen->survey, it->def.x0, it->def.y0);
    if (!local.wet)
        return SKV_OK;
    values[0] = local.vx;
    values[1] = local.vy;
    values[2] = sqrt(local.vx * local.vx + local.vy * local.vy);
    return SKV_OK;
}

static skv_result sample_level(instrument *it, const look *seen, double *values)
{
    const skv_instrument_def *def = &it->def;
    const skv_survey *s = seen->survey;
    double distance;
    if (!skv_survey_surface(s, def->x0, def->y0, def->x1, def->y1, &distance))
        return SKV_OK;
    double dx = def->x1 - def->x0, dy = def->y1 - def->y0, length = sqrt(dx * dx + dy * dy);
    values[0] = distance;
    values[1] = def->x0 + dx * distance / length;
    values[2] = def->y0 + dy * distance / length;
    return SKV_OK;
}

typedef struct crossing {
    double x0, y0, dx, dy; /* the gate: its first end and the way to the other */
    int forward, back;
} crossing;

/* Which side of the gate's line: above 0 is left, as seen from the first end. */
static double side_of(const crossing *c, double x, double y)
{
    return c->dx * (y - c->y0) - c->dy * (x - c->x0);
}

static void count_way(crossing *c, double x0, double y0, double x1, double y1)
{
    double from = side_of(c, x0, y0), to = side_of(c, x1, y1);
    if ((from >= 0) == (to >= 0))
        return;
    double share = from / (from - to);
    double x = x0 + share * (x1 - x0) - c->x0, y = y0 + share * (y1 - y0) - c->y0;
    double along = (x * c->dx + y * c->dy) / (c->dx * c->dx + c->dy * c->dy);
    if (!(along >= 0 && along < 1))
        return;
    if (from >= 0)
        c->forward++;
    else
        c->back++;
}

/* Looks at those only who have not travelled too far to have come from the gate. */
static void count_crossings(const skv_survey *s, const skv_instrument_def *def, crossing *c)
{
    cell_range cells = skv_survey_cells(
        s, skv_min(def->x0, def->x1) - s->travel, skv_min(def->y0, def->y1) - s->travel,
        skv_max(def->x0, def->x1) + s->travel, skv_max(def->y0, def->y1) + s->travel);
    for (int row = cells.row0; row <= cells.row1; row++) {
        int begin = s->cell_start[row * s->columns + cells.column0];
        int end = s->cell_start[row * s->columns + cells.column1 + 1];
        for (int i = begin; i < end; i++) {
            if (!isnan(s->from_x[i]))
                count_way(c, (double)s->from_x[i], (double)s->from_y[i], (double)s->x[i],
                          (double)s->y[i]);
        }
    }
}

static skv_result sample_gate(instrument *it, const look *seen, double *values)
{
    const skv_instrument_def *def = &it->def;
    const skv_survey *s = seen->survey;
    double interval = s->time - s->time_before;
    if (s->time_before < 0 || !(interval > 0))
        return SKV_OK;
    crossing c = {def->x0, def->y0, def->x1 - def->x0, def->y1 - def->y0, 0, 0};
    count_crossings(s, def, &c);
    double area = s->spacing * s->spacing;
    values[0] = (c.forward - c.back) * area / interval;
    values[1] = c.forward * area / interval;
    values[2] = c.back * area / interval;
    values[3] = c.forward / interval;
    values[4] = c.back / interval;
    return SKV_OK;
}

static skv_result sample_force(instrument *it, const look *seen, double *values)
{
    skv_wall_force force;
    const skv_instrument_def *def = &it->def;
    skv_result result = skv_force_measure(&it->meter, seen->world, def->x0, def->y0, def->x1,
                                          def->y1, &force, seen->error);
    if (result == SKV_OK) {
        values[0] = force.fx;
        values[1] = force.fy;
        values[2] = force.torque;
        values[3] = sqrt(force.fx * force.fx + force.fy * force.fy);
    }
    return result;
}

static skv_result sample_energy(instrument *it, const look *seen, double *values)
{
    (void)it;
    const skv_survey *s = seen->survey;
    double mass = s->density * s->spacing * s->spacing, speeds = 0, energies = 0, height = 0;
    for (int i = 0; i < s->count; i++) {
        double squared = speed_squared(s, i), weight = (double)s->mass[i];
        speeds += squared;
        energies += weight * squared;
        height -= weight * (s->gravity_x * (double)s->x[i] + s->gravity_y * (double)s->y[i]);
    }
    values[0] = mass * energies / 2;
    values[1] = mass * height;
    values[2] = s->count ? sqrt(speeds / s->count) : 0;
    return SKV_OK;
}

static skv_result sample_region(instrument *it, const look *seen, double *values)
{
    const skv_instrument_def *def = &it->def;
    const skv_survey *s = seen->survey;
    double x0 = skv_min(def->x0, def->x1), x1 = skv_max(def->x0, def->x1);
    double y0 = skv_min(def->y0, def->y1), y1 = skv_max(def->y0, def->y1);
    double sums[5] = {0}, speeds = 0;
    int count = 0;
    cell_range cells = skv_survey_cells(s, x0, y0, x1, y1);
    for (int row = cells.row0; row <= cells.row1; row++) {
        int begin = s->cell_start[row * s->columns + cells.column0];
        int end = s->cell_start[row * s->columns + cells.column1 + 1];
        for (int i = begin; i < end; i++) {
            double x = (double)s->x[i], y = (double)s->y[i];
            if (x < x0 || x >= x1 || y < y0 || y >= y1)
                continue;
            sums[0] += x;
            sums[1] += y;
            sums[2] += (double)s->vx[i];
            sums[3] += (double)s->vy[i];
            sums[4] += (double)s->pressure[i];
            speeds += speed_squared(s, i);
            count++;
        }
    }
    values[0] = count;
    values[1] = count * s->spacing * s->spacing;
    if (count == 0)
        return SKV_OK;
    for (int k = 0; k < 5; k++)
        values[2 + k] = sums[k] / count;
    values[7] = sqrt(speeds / count);
    return SKV_OK;
}

static skv_result sample_ruler(instrument *it, const look *seen, double *values)
{
    const skv_instrument_def *def = &it->def;
    (void)seen;
    double dx = def->x1 - def->x0, dy = def->y1 - def->y0;
    values[0] = sqrt(dx * dx + dy * dy);
    values[1] = dx;
    values[2] = dy;
    values[3] = skv_atan2(dy, dx);
    return SKV_OK;
}

/* ---- Waves ----------------------------------------------------------------------------------- */

enum { LEVEL, SLOPE, HEIGHT, PERIOD, STEEPNESS };

/* What a train of waves adds up to, from one rise through the mean level to the last. */
typedef struct wave_sums {
    double lowest, highest;  /* since the last rise */
    double heights, periods; /* of complete waves */
    double levels, slopes, since_l,
        since_s; /* squares: of complete waves, and since the last rise */
    int waves;
    double crossed, rise; /* when the level last crossed its mean upwards; the last rise, or NaN */
    bool low;             /* has been below the mean far enough for a rise to follow */
    double before, time_before;
} wave_sums;

/* The next sample, its level and slope against their means. A rise counts when the level has gone
 * from `noise` below the mean to `noise` above it. */
static void add_to_waves(wave_sums *w, double time, double level, double slope, double noise)
{
    if (w->before < 0 && level >= 0)
        w->crossed = w->time_before + (time - w->time_before) * w->before / (w->before - level);
    w->before = level;
    w->time_before = time;
    w->low = w->low || level < -noise;
    if (w->low && level > noise) {
        if (!isnan(w->rise)) {
            w->waves++;
            w->periods += w->crossed - w->rise;
            w->heights += w->highest - w->lowest;
            w->levels += w->since_l;
            w->slopes += w->since_s;
        }
        w->rise = w->crossed;
        w->low = false;
        w->lowest = w->highest = level;
        w->since_l = w->since_s = 0;
    }
    w->lowest = skv_min(w->lowest, level);
    w->highest = skv_max(w->highest, level);
    w->since_l += level * level;
    w->since_s += slope * slope;
}

/* Writes the waves of the remembered levels and slopes. The length follows from both: in a wave of
 * wave number k the slope swings k times as far as the level. */
static void read_waves(const instrument *it, double spacing, double *values)
{
    const double *levels = it->values + LEVEL * it->def.capacity;
    const double *slopes = it->values + SLOPE * it->def.capacity;
    double level = 0, slope = 0, lowest = HUGE_VAL, highest = -HUGE_VAL;
    int count = 0;
    for (int i = 0; i < it->count; i++) {
        if (isnan(slopes[i]))
            continue;
        level += levels[i];
        slope += slopes[i];
        lowest = skv_min(lowest, levels[i]);
        highest = skv_max(highest, levels[i]);
        count++;
    }
    double noise = skv_max(spacing / 4, (highest - lowest) / 10);
    wave_sums w = {.rise = (double)NAN};
    for (int age = it->count - 1; age >= 0; age--) {
        int at = skv_instrument_slot(it, age);
        if (!isnan(slopes[at]))
            add_to_waves(&w, it->times[at], levels[at] - level / count, slopes[at] - slope / count,
                         noise);
    }
    if (w.waves == 0)
        return;
    values[HEIGHT] = w.heights / w.waves;
    values[PERIOD] = w.periods / w.waves;
    values[STEEPNESS] = values[HEIGHT] * sqrt(w.slopes / w.levels) / (2 * SKV_PI);
}

static skv_result sample_waves(instrument *it, const look *seen, double *values)
{
    const skv_survey *s = seen->survey;
    const skv_instrument_def *d = &it->def;
    double middle, left, right;
    if (skv_survey_surface(s, d->x0, d->y0, d->x0, d->y1, &middle))
        values[LEVEL] = d->y0 + (d->y1 > d->y0 ? middle : -middle);
    if (skv_survey_surface(s, d->x0 - s->h, d->y0, d->x0 - s->h, d->y1, &left) &&
        skv_survey_surface(s, d->x0 + s->h, d->y0, d->x0 + s->h, d->y1, &right) &&
        !isnan(values[LEVEL]))
        values[SLOPE] = (d->y1 > d->y0 ? right - left : left - right) / (2 * s->h);
    read_waves(it, s->spacing, values);
    return SKV_OK;
}

/* ---- The table ------------------------------------------------------------------------------- */

/* Sums of float frames must not decide at which sample a condition has held long enough. */
#define HALF_A_MILLISECOND 5e-4

static skv_result sample_stopwatch(instrument *it, const look *seen, double *values)
{
    double time = seen->survey->time;
    if (isnan(it->stopped_at)) {
        bool holds =
            it->def.above ? seen->watched > it->def.threshold : seen->watched < it->def.threshold;
        if (!holds)
            it->held_since = -1;
        else if (it->held_since < 0)
            it->held_since = time;
        if (holds && time - it->held_since >= it->def.hold - HALF_A_MILLISECOND)
            it->stopped_at = it->held_since;
    }
    values[0] = it->stopped_at;
    return SKV_OK;
}

static const instrument_kind kinds[] = {
    [SKV_INSTRUMENT_PRESSURE] = {.name = "pressure probe",
                                 .channels = {{"pressure", "Pa m", false},
                                              {"density g depth", "Pa m", true}},
                                 .sample = sample_pressure},
    [SKV_INSTRUMENT_VELOCITY] = {.name = "velocity probe",
                                 .channels = {{"vx", "m/s", false},
                                              {"vy", "m/s", false},
                                              {"speed", "m/s", false}},
                                 .sample = sample_velocity},
    [SKV_INSTRUMENT_LEVEL] = {.name = "level gauge",
                              .channels = {{"distance", "m", false},
                                           {"x", "m", false},
                                           {"level", "m", false}},
                              .is_line = true,
                              .sample = sample_level},
    [SKV_INSTRUMENT_GATE] = {.name = "flow gate",
                             .channels = {{"flow", "m^2/s", false},
                                          {"forward", "m^2/s", false},
                                          {"back", "m^2/s", false},
                                          {"particles forward", "1/s", false},
                                          {"particles back", "1/s", false}},
                             .is_line = true,
                             .window = 0.25,
                             .sample = sample_gate},
    [SKV_INSTRUMENT_FORCE] = {.name = "force meter",
                              .channels = {{"fx", "N", false},
                                           {"fy", "N", false},
                                           {"torque", "N m", false},
                                           {"force", "N", false}},
                              .sample = sample_force},
    [SKV_INSTRUMENT_ENERGY] = {.name = "energy meter",
                               .channels = {{"kinetic", "J", false},
                                            {"potential", "J", false},
                                            {"rms speed", "m/s", false}},
                               .sample = sample_energy},
    [SKV_INSTRUMENT_REGION] = {.name = "region",
                               .channels = {{"particles", "", false},
                                            {"area", "m^2", false},
                                            {"mean x", "m", false},
                                            {"mean y", "m", false},
                                            {"mean vx", "m/s", false},
                                            {"mean vy", "m/s", false},
                                            {"mean pressure", "Pa m", false},
                                            {"rms speed", "m/s", false}},
                               .sample = sample_region},
    [SKV_INSTRUMENT_RULER] = {.name = "ruler",
                              .channels = {{"length", "m", false},
                                           {"dx", "m", false},
                                           {"dy", "m", false},
                                           {"angle", "rad", false}},
                              .sample = sample_ruler},
    [SKV_INSTRUMENT_WAVES] = {.name = "wave gauge",
                              .channels = {[LEVEL] = {"level", "m", false},
                                           [SLOPE] = {"slope", "", false},
                                           [HEIGHT] = {"wave height", "m", false},
                                           [PERIOD] = {"wave period", "s", false},
                                           [STEEPNESS] = {"steepness", "", false}},
                              .is_line = true,
                              .sample = sample_waves},
    [SKV_INSTRUMENT_STOPWATCH] = {.name = "stopwatch",
                                  .channels = {{"time", "s", false}},
                                  .holds = true,
                                  .sample = sample_stopwatch},
};

const instrument_kind *skv_instrument_kind_info(skv_instrument_kind kind)
{
    return (unsigned)kind < sizeof kinds / sizeof *kinds ? &kinds[kind] : NULL;
}

const skv_channel *skv_instrument_channel(skv_instrument_kind kind, int channel)
{
    const instrument_kind *info = skv_instrument_kind_info(kind);
    if (!info || channel < 0 || channel >= SKV_MAX_CHANNELS)
        return NULL;
    const skv_channel *found = &info->channels[channel];
    return found->name ? found : NULL;
}

const char *skv_instrument_kind_name(skv_instrument_kind kind)
{
    const instrument_kind *info = skv_instrument_kind_info(kind);
    return info ? info->name : NULL;
}

int skv_channel_count(skv_instrument_kind kind)
{
    int count = 0;
    while (skv_instrument_channel(kind, count))
        count++;
    return count;
}

void skv_instrument_reset(instrument *it)
{
    it->next = it->count = 0;
    it->held_since = -1;
    it->stopped_at = (double)NAN;
}

int skv_instrument_slot(const instrument *it, int age)
{
    return (it->next - 1 - age + 2 * it->def.capacity) % it->def.capacity;
}
