/* Readings: what each kind of instrument sees in a survey.
 *
 * Invariant: a particle's way between two samples crosses a gate's line exactly when its two ends
 * lie on different sides, a point on the line being on the left; so nobody is counted twice, and
 * who goes back is counted back.
 */
#include "measure/instruments.h"

#include <math.h>

static const struct {
    const char *name;
    skv_channel channels[SKV_MAX_CHANNELS];
} kinds[SKV_INSTRUMENT_KINDS] = {
    [SKV_INSTRUMENT_PRESSURE] = {"pressure probe", {{"pressure", "Pa m"}}},
    [SKV_INSTRUMENT_VELOCITY] = {"velocity probe",
                                 {{"vx", "m/s"}, {"vy", "m/s"}, {"speed", "m/s"}}},
    [SKV_INSTRUMENT_LEVEL] = {"level gauge", {{"distance", "m"}, {"x", "m"}, {"y", "m"}}},
    [SKV_INSTRUMENT_GATE] = {"flow gate",
                             {{"flow", "m^2/s"},
                              {"forward", "m^2/s"},
                              {"back", "m^2/s"},
                              {"particles forward", "1/s"},
                              {"particles back", "1/s"}}},
    [SKV_INSTRUMENT_FORCE] = {"force meter", {{"fx", "N"}, {"fy", "N"}, {"torque", "N m"}}},
    [SKV_INSTRUMENT_ENERGY] = {"energy meter",
                               {{"kinetic", "J"}, {"potential", "J"}, {"rms speed", "m/s"}}},
    [SKV_INSTRUMENT_REGION] = {"region",
                               {{"particles", ""},
                                {"area", "m^2"},
                                {"mean x", "m"},
                                {"mean y", "m"},
                                {"mean vx", "m/s"},
                                {"mean vy", "m/s"},
                                {"mean pressure", "Pa m"},
                                {"rms speed", "m/s"}}},
    [SKV_INSTRUMENT_RULER] = {"ruler",
                              {{"length", "m"}, {"dx", "m"}, {"dy", "m"}, {"angle", "rad"}}},
    [SKV_INSTRUMENT_STOPWATCH] = {"stopwatch", {{"time", "s"}}},
};

const skv_channel *skv_instrument_channel(skv_instrument_kind kind, int channel)
{
    if ((unsigned)kind >= SKV_INSTRUMENT_KINDS || channel < 0 || channel >= SKV_MAX_CHANNELS)
        return NULL;
    const skv_channel *found = &kinds[kind].channels[channel];
    return found->name ? found : NULL;
}

const char *skv_instrument_kind_name(skv_instrument_kind kind)
{
    return (unsigned)kind < SKV_INSTRUMENT_KINDS ? kinds[kind].name : "";
}

int skv_channel_count(skv_instrument_kind kind)
{
    int count = 0;
    while (skv_instrument_channel(kind, count))
        count++;
    return count;
}

static double speed_squared(const skv_survey *s, int i)
{
    double vx = (double)s->vx[i], vy = (double)s->vy[i];
    return vx * vx + vy * vy;
}

static void read_probe(const skv_instrument_def *def, const skv_survey *s, double *values)
{
    skv_local local = skv_survey_at(s, def->x0, def->y0);
    if (!local.wet)
        return;
    if (def->kind == SKV_INSTRUMENT_PRESSURE) {
        values[0] = local.pressure;
        return;
    }
    values[0] = local.vx;
    values[1] = local.vy;
    values[2] = sqrt(local.vx * local.vx + local.vy * local.vy);
}

static void read_level(const skv_instrument_def *def, const skv_survey *s, double *values)
{
    double distance;
    if (!skv_survey_surface(s, def->x0, def->y0, def->x1, def->y1, &distance))
        return;
    double dx = def->x1 - def->x0, dy = def->y1 - def->y0, length = sqrt(dx * dx + dy * dy);
    values[0] = distance;
    values[1] = def->x0 + dx * distance / length;
    values[2] = def->y0 + dy * distance / length;
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
    cell_range cells =
        skv_survey_cells(s, fmin(def->x0, def->x1) - s->travel, fmin(def->y0, def->y1) - s->travel,
                         fmax(def->x0, def->x1) + s->travel, fmax(def->y0, def->y1) + s->travel);
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

static void read_gate(const skv_instrument_def *def, const skv_survey *s, double *values)
{
    double interval = s->time - s->time_before;
    if (s->time_before < 0 || !(interval > 0))
        return;
    crossing c = {def->x0, def->y0, def->x1 - def->x0, def->y1 - def->y0, 0, 0};
    count_crossings(s, def, &c);
    double area = s->spacing * s->spacing;
    values[0] = (c.forward - c.back) * area / interval;
    values[1] = c.forward * area / interval;
    values[2] = c.back * area / interval;
    values[3] = c.forward / interval;
    values[4] = c.back / interval;
}

static skv_result read_force(instrument *it, const skv_world *world, double *values,
                             skv_error *error)
{
    skv_wall_force force;
    const skv_instrument_def *def = &it->def;
    skv_result result =
        skv_force_measure(&it->meter, world, def->x0, def->y0, def->x1, def->y1, &force, error);
    if (result == SKV_OK) {
        values[0] = force.fx;
        values[1] = force.fy;
        values[2] = force.torque;
    }
    return result;
}

static void read_energy(const skv_survey *s, double *values)
{
    double mass = s->density * s->spacing * s->spacing, speeds = 0, height = 0;
    for (int i = 0; i < s->count; i++) {
        speeds += speed_squared(s, i);
        height -= s->gravity_x * (double)s->x[i] + s->gravity_y * (double)s->y[i];
    }
    values[0] = mass * speeds / 2;
    values[1] = mass * height;
    values[2] = s->count ? sqrt(speeds / s->count) : 0;
}

static void read_region(const skv_instrument_def *def, const skv_survey *s, double *values)
{
    double x0 = fmin(def->x0, def->x1), x1 = fmax(def->x0, def->x1);
    double y0 = fmin(def->y0, def->y1), y1 = fmax(def->y0, def->y1);
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
        return;
    for (int k = 0; k < 5; k++)
        values[2 + k] = sums[k] / count;
    values[7] = sqrt(speeds / count);
}

static void read_ruler(const skv_instrument_def *def, double *values)
{
    double dx = def->x1 - def->x0, dy = def->y1 - def->y0;
    values[0] = sqrt(dx * dx + dy * dy);
    values[1] = dx;
    values[2] = dy;
    values[3] = atan2(dy, dx);
}

skv_result skv_instrument_read(instrument *it, const skv_survey *survey, const skv_world *world,
                               double *values, skv_error *error)
{
    for (int i = 0; i < SKV_MAX_CHANNELS; i++)
        values[i] = (double)NAN;
    switch (it->def.kind) {
    case SKV_INSTRUMENT_PRESSURE:
    case SKV_INSTRUMENT_VELOCITY:
        read_probe(&it->def, survey, values);
        break;
    case SKV_INSTRUMENT_LEVEL:
        read_level(&it->def, survey, values);
        break;
    case SKV_INSTRUMENT_GATE:
        read_gate(&it->def, survey, values);
        break;
    case SKV_INSTRUMENT_FORCE:
        return read_force(it, world, values, error);
    case SKV_INSTRUMENT_ENERGY:
        read_energy(survey, values);
        break;
    case SKV_INSTRUMENT_REGION:
        read_region(&it->def, survey, values);
        break;
    case SKV_INSTRUMENT_RULER:
        read_ruler(&it->def, values);
        break;
    case SKV_INSTRUMENT_STOPWATCH:
    case SKV_INSTRUMENT_KINDS:
        break;
    }
    return SKV_OK;
}
