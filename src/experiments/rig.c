/* Runs the worlds of the experiments.
 *
 * Invariant: once something has failed, the world does not change any more and the message is that
 * of the first failure.
 */
#include "experiments/rig.h"

#include "base/memory.h"
#include "experiments/experiment.h"

#include <math.h>
#include <string.h>

#define FRAME (1.0f / 60)

enum { HISTORY = 4000, SIDE_BY_SIDE = 6 };

/* What theory said of the conditions when it was asked last. */
typedef struct foresight {
    bool known;
    double condition[MAX_CONDITIONS];
    skv_plot theory;
} foresight;

/* ---- Results --------------------------------------------------------------------------------- */

void skv_rig_open(rig *s, const experiment *e, const skv_lab_options *options, findings *found,
                  skv_error *error)
{
    *s = (rig){.experiment = e, .options = options, .found = found, .error = error};
    s->result = skv_settings_make(&s->settings, e, options, error);
}

skv_result skv_rig_close(rig *s)
{
    if (s->foresight)
        skv_plot_free(&s->foresight->theory);
    skv_free(s->foresight);
    skv_lab_destroy(s->lab);
    skv_world_destroy(s->world);
    s->foresight = NULL;
    s->lab = NULL;
    s->world = NULL;
    return s->result;
}

bool skv_rig_ok(const rig *s)
{
    return s->result == SKV_OK;
}

void skv_rig_keep(rig *s, skv_result result)
{
    if (skv_rig_ok(s))
        s->result = result;
}

void skv_rig_require(rig *s, bool condition, const char *message)
{
    if (skv_rig_ok(s) && !condition)
        s->result = skv_fail(s->error, SKV_ERROR_VALUE, "%s", message);
}

/* ---- Settings -------------------------------------------------------------------------------- */

double skv_rig_value(const rig *s, int own)
{
    return s->settings.own[own];
}

double skv_rig_length(const rig *s, int own)
{
    return s->settings.own[own] * s->settings.common[PARAM_SCALE];
}

double skv_rig_gravity(const rig *s)
{
    return s->settings.common[PARAM_GRAVITY];
}

double skv_rig_pace(const rig *s)
{
    /* What failed may have no settings, and counts frames all the same. */
    return skv_rig_ok(s) ? sqrt(s->settings.common[PARAM_SCALE] * 9.81 / skv_rig_gravity(s)) : 1;
}

double skv_rig_speed(const rig *s)
{
    return s->settings.common[PARAM_SCALE] / skv_rig_pace(s);
}

void skv_rig_set(rig *s, const char *path, double value)
{
    int i = 0;
    while (i < s->override_count && strcmp(s->overrides[i].path, path) != 0)
        i++;
    if (i == MAX_OVERRIDES) {
        skv_rig_require(s, false, "an experiment overrides too much of the fluid");
        return;
    }
    s->override_count = i == s->override_count ? i + 1 : s->override_count;
    s->overrides[i].path = path;
    skv_format(s->overrides[i].value, sizeof s->overrides[i].value, "%.9g", value);
}

/* ---- Worlds ---------------------------------------------------------------------------------- */

/* The scene of a plan: with this spacing; 0: with the wanted number of particles. */
static skv_scene *load(rig *s, const rig_plan *plan, double spacing)
{
    if (s->sketch)
        *s->sketch = *plan;
    skv_setting list[MAX_FLUID_SETTINGS + MAX_OVERRIDES + 1];
    int count = s->settings.fluid_count;
    for (int i = 0; i < count; i++)
        list[i] = s->settings.fluid[i];
    for (int i = 0; i < s->override_count; i++)
        list[count++] = (skv_setting){s->overrides[i].path, s->overrides[i].value};
    char particles[32];
    if (!(spacing > 0)) {
        double wanted = s->settings.common[PARAM_PARTICLES] * (plan->share > 0 ? plan->share : 1);
        skv_format(particles, sizeof particles, "%.9g", floor(wanted));
        list[count++] = (skv_setting){"particles", particles};
        spacing = sqrt(skv_plan_area(plan) / wanted);
    }
    skv_scene *scene = NULL;
    skv_rig_keep(
        s, skv_plan_scene(plan, s->experiment->info.name, spacing, list, count, &scene, s->error));
    return scene;
}

static skv_world *make_world(rig *s, const skv_scene *scene)
{
    if (!skv_rig_ok(s))
        return NULL;
    skv_world_def def = skv_scene_world_def(scene);
    skv_world *world = NULL;
    def.threads = s->options ? s->options->threads : 0;
    skv_rig_keep(s, skv_world_create(&def, &world, s->error));
    if (!skv_rig_ok(s))
        skv_terrain_destroy(def.terrain);
    return world;
}

static void take_over(rig *s, skv_world *world)
{
    skv_world_destroy(s->world);
    s->world = world;
    s->particles = skv_world_particle_count(world);
    s->spacing = (double)skv_world_spacing(world);
    s->h = (double)skv_world_smoothing_radius(world);
    if (!s->lab)
        skv_rig_keep(s, skv_lab_create(&s->lab, s->error));
}

skv_result skv_rig_write(const rig *s, skv_write *write, void *user, skv_error *error)
{
    const rig_plan *plan = s->sketch;
    skv_setting list[MAX_OVERRIDES];
    int count = 0;
    for (int i = 0; i < s->override_count; i++)
        list[count++] = (skv_setting){s->overrides[i].path, s->overrides[i].value};
    double particles = s->settings.common[PARAM_PARTICLES] * (plan->share > 0 ? plan->share : 1);
    return skv_plan_write(plan, &s->experiment->info, floor(particles), list, count, write, user,
                          error);
}

/* The spacing of a plan whose water fills its shapes, but for what walls cover. */
static void draw_outline(rig *s, const rig_plan *plan)
{
    double share = plan->share > 0 ? plan->share : 1;
    double particles = s->settings.common[PARAM_PARTICLES] * share;
    *s->sketch = *plan;
    s->spacing =
        s->settings.spacing > 0 ? s->settings.spacing : sqrt(skv_plan_area(plan) / particles);
    s->result = SKV_STOPPED;
}

void skv_rig_build(rig *s, const rig_plan *plan)
{
    if (!skv_rig_ok(s))
        return;
    if (s->outline) {
        draw_outline(s, plan);
        return;
    }
    skv_scene *scene = load(s, plan, s->settings.spacing);
    skv_world *world = scene ? make_world(s, scene) : NULL;
    if (world) {
        /* No plan depends on the fluid, which would take a second to come to rest. */
        if (!s->sketch)
            skv_rig_keep(s, skv_scene_fill(scene, world, s->error));
        take_over(s, world);
    }
    skv_scene_destroy(scene);
}

void skv_rig_rebuild(rig *s, const rig_plan *plan)
{
    skv_scene *scene = skv_rig_ok(s) ? load(s, plan, s->settings.spacing) : NULL;
    if (!scene)
        return;
    skv_terrain *terrain = skv_scene_world_def(scene).terrain;
    skv_scene_destroy(scene);
    skv_rig_keep(s, skv_world_set_terrain(s->world, terrain, NULL, s->error));
    if (!skv_rig_ok(s))
        skv_terrain_destroy(terrain);
}

void skv_rig_build_beside(rig *s, const rig_plan *plan, double particles)
{
    if (!skv_rig_ok(s))
        return;
    int own = s->particles;
    double spacing = s->spacing;
    s->own_substeps = skv_world_substeps_per_frame(s->world);
    s->own_seconds = s->done;
    rig_plan beside = *plan;
    beside.share = (particles + 0.5) / s->settings.common[PARAM_PARTICLES];
    skv_rig_build(s, &beside);
    s->particles = own;
    s->spacing = spacing;
}

void skv_rig_check_passage(rig *s, int own, double share)
{
    double needed = SIDE_BY_SIDE * s->spacing, width = share * skv_rig_length(s, own);
    if (!skv_rig_ok(s) && !s->outline)
        return;
    double more = s->settings.common[PARAM_PARTICLES] * needed * needed / (width * width);
    s->enough = fmax(s->enough, 100 * ceil(1.02 * more / 100));
    if (s->outline || width >= needed)
        return;
    const char *path = s->experiment->parameters[own].path;
    double value = skv_rig_value(s, own), fits = width / s->spacing;
    if (s->settings.spacing > 0) {
        s->result = skv_fail(s->error, SKV_ERROR_VALUE,
                             "%s: %g m leave room for %.1f particles side by side, and %d are "
                             "needed; take fluid.spacing=%.2g or less, or more of %s",
                             path, value, fits, SIDE_BY_SIDE, 0.98 * width / SIDE_BY_SIDE, path);
        return;
    }
    s->result =
        skv_fail(s->error, SKV_ERROR_VALUE,
                 "%s: %g m leave room for %.1f particles side by side, and %d are needed; take "
                 "particles=%.0f or more, or more of %s",
                 path, value, fits, SIDE_BY_SIDE, s->enough, path);
}

double skv_rig_density(const rig *s)
{
    return s->world ? (double)skv_world_fluid(s->world)->density : (double)NAN;
}

double skv_rig_area(const rig *s)
{
    return s->world ? skv_world_particle_count(s->world) * s->spacing * s->spacing : (double)NAN;
}

static int frames_in(double seconds)
{
    return (int)(seconds * 60 + 0.5);
}

/* ---- Instruments ----------------------------------------------------------------------------- */

skv_instrument skv_rig_add(rig *s, skv_instrument_kind kind, double x0, double y0, double x1,
                           double y1, double window)
{
    skv_instrument id = 0;
    skv_instrument_def def = skv_default_instrument_def(kind);
    def.x0 = x0;
    def.y0 = y0;
    def.x1 = x1;
    def.y1 = y1;
    def.window = window;
    int frames = frames_in(s->total);
    def.capacity = frames < HISTORY ? HISTORY : frames;
    if (skv_rig_ok(s) && !s->sketch)
        skv_rig_keep(s, skv_lab_add(s->lab, &def, &id, s->error));
    return id;
}

double skv_rig_read(const rig *s, skv_instrument id, int channel)
{
    return skv_rig_ok(s) && !s->sketch ? skv_lab_reading(s->lab, id, channel) : (double)NAN;
}

double skv_rig_mean_level(const rig *s, const skv_instrument *gauges, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += skv_rig_read(s, gauges[i], 2) / count;
    return sum;
}

int skv_rig_history(const rig *s, skv_instrument id, int channel, double *times, double *values,
                    int capacity)
{
    return skv_rig_ok(s) ? skv_lab_history(s->lab, id, channel, times, values, capacity) : 0;
}

void skv_rig_trace(const rig *s, skv_instrument id, int channel, int every)
{
    skv_plot *plot = &s->found->plot;
    int count = skv_rig_history(s, id, channel, NULL, NULL, 0);
    double *times = skv_calloc(2 * (size_t)count + 1, sizeof *times);
    if (!times) {
        plot->failed = true;
        return;
    }
    skv_rig_history(s, id, channel, times, times + count, count);
    for (int i = 0; i < count; i += every)
        skv_plot_point(plot, times[i], times[count + i]);
    skv_free(times);
}

/* ---- Time ------------------------------------------------------------------------------------ */

static void step(rig *s)
{
    skv_rig_keep(s, skv_world_step(s->world, FRAME, s->error));
    if (skv_rig_ok(s))
        s->done += (double)FRAME;
}

/* The theory of the conditions as they are now. It is asked for again only when they change, for
 * some have to solve an equation first. Null if it is not known yet, or memory is out. */
static const skv_plot *foresee(rig *s)
{
    if (s->found->foreseen && !s->foresight)
        s->foresight = skv_calloc(1, sizeof *s->foresight);
    foresight *f = s->foresight;
    if (!f)
        return NULL;
    bool changed = !f->known;
    for (int i = 0; i < MAX_CONDITIONS; i++)
        changed |= f->condition[i] != s->found->condition[i];
    if (changed) {
        expectation unused = {0};
        skv_plot_cut(&f->theory, 0);
        s->experiment->expect(s->found->condition, &unused, &f->theory);
        memcpy(f->condition, s->found->condition, sizeof f->condition);
        f->known = true;
    }
    return &f->theory;
}

/* Calls the observer with the curves so far, and theory behind them. */
static void show(rig *s)
{
    if (!skv_rig_ok(s) || !s->options || !s->options->observe)
        return;
    skv_rig_draw(s);
    const skv_plot *const plots[] = {&s->found->plot, foresee(s)};
    skv_curve curves[2 * MAX_CURVES];
    int count = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; plots[k] && i < plots[k]->count; i++)
            curves[count++] = skv_plot_curve(plots[k], i);
    skv_frame frame = skv_world_frame(s->world);
    skv_lab_moment moment = {fmin(1, s->done / s->total), &frame, curves, count};
    if (!s->options->observe(&moment, s->options->user))
        s->result = skv_fail(s->error, SKV_STOPPED, "%s: it was stopped", s->experiment->info.name);
}

void skv_rig_show(rig *s, draw_curves *draw, const void *set_up)
{
    s->draw = draw;
    s->set_up = set_up;
}

void skv_rig_draw(rig *s)
{
    if (!s->draw)
        return;
    skv_plot_cut(&s->found->plot, 0);
    s->draw(s, s->set_up, s->found);
}

/* Whether nothing but the plan is asked for, and it is complete after so much waiting. */
static bool is_sketched(rig *s, bool complete)
{
    if (s->sketch && complete && skv_rig_ok(s))
        s->result = SKV_STOPPED;
    return s->sketch;
}

void skv_rig_wait(rig *s, double seconds)
{
    if (is_sketched(s, s->done > 0)) {
        s->done += seconds;
        return;
    }
    for (int i = frames_in(seconds); i > 0 && skv_rig_ok(s); i--) {
        step(s);
        show(s);
    }
}

void skv_rig_sample(rig *s)
{
    if (skv_rig_ok(s) && !s->sketch)
        skv_rig_keep(s, skv_lab_sample(s->lab, s->world, s->error));
}

void skv_rig_watch(rig *s, double seconds)
{
    if (is_sketched(s, true))
        return;
    for (int i = frames_in(seconds); i > 0 && skv_rig_ok(s); i--) {
        step(s);
        skv_rig_sample(s);
        show(s);
    }
}
