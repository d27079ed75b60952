/* Controls: tables, and what buttons and keys do to a stage. Invariant: whatever a person can
 * choose in one front end is the same in all others. */
#include "skvalp/controls.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/fields.h"
#include "session/placing.h"
#include "session/showing.h"

#define COUNT(table) ((int)(sizeof(table) / sizeof *(table)))
#define AT(table, i) ((i) >= 0 && (i) < COUNT(table) ? &(table)[i] : NULL)

/* Of particles. */
#define USUAL_AMOUNT 3000

static const skv_limits limits = {
    .least_brush = 0.004,
    .largest_brush = 0.25,
    .zoom_step = 1.25,
    .frames_a_second = 60,
    .reach = 30 * 60,
    .grip = 22,
    .margin = 6,
    .usual_amount = USUAL_AMOUNT,
    .first_scene = "dam-break",
};

/* s: nobody minds beginning anew what is not older. */
enum { WATCHED = 30 };

const skv_limits *skv_control_limits(void)
{
    return &limits;
}

/* ---- Time ------------------------------------------------------------------------------------ */

static const skv_named_number speeds[] = {
    {"Twice as Fast", 2}, {"Real Time", 1}, {"Half", 0.5}, {"A Quarter", 0.25}, {"A Tenth", 0.1},
};

const skv_named_number *skv_speed_at(int i)
{
    return AT(speeds, i);
}

void skv_control_shift_speed(skv_stage *stage, int direction)
{
    SKV_ASSERT(stage);
    /* One that is between two is taken for the faster. */
    double speed = skv_stage_speed(stage) * (1 - 1e-9);
    int at = COUNT(speeds) - 1;
    while (at > 0 && speeds[at].number < speed)
        at--;
    at -= (direction > 0) - (direction < 0);
    at = at < 0 ? 0 : at < COUNT(speeds) ? at : COUNT(speeds) - 1;
    skv_stage_set_speed(stage, speeds[at].number);
}

bool skv_control_would_be_missed(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, false);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    return picture->opened != 0 && !picture->watching &&
           (picture->can_undo || picture->end >= WATCHED * limits.frames_a_second);
}

void skv_control_seek(skv_stage *stage, int64_t frame)
{
    SKV_ASSERT(stage);
    int64_t end = skv_stage_picture(stage, 0)->end;
    int64_t first = end > limits.reach ? end - limits.reach : 0;
    skv_stage_set_paused(stage, true);
    skv_stage_seek(stage, frame < first ? first : frame < end ? frame : end);
}

void skv_control_go(skv_stage *stage, int64_t frames)
{
    SKV_ASSERT(stage);
    skv_stage_go(stage, frames, limits.reach);
}

/* Below this share of its speed a scene counts as slow. */
#define KEEPS_UP 0.95

enum { BACK, PAUSED, AT_REST, STARTING, REAL_TIME, TIMES };
static const char *const going_words[] = {
    [BACK] = "going back",   [PAUSED] = "paused",       [AT_REST] = "at rest",
    [STARTING] = "starting", [REAL_TIME] = "real time", [TIMES] = "%s× of real time",
};

const char *skv_going_words(int i)
{
    return i >= 0 && i < COUNT(going_words) ? going_words[i] : NULL;
}

skv_going skv_control_going(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, ((skv_going){going_words[PAUSED], 1, false}));
    const skv_picture *picture = skv_stage_picture(stage, 0);
    skv_stage_state now = skv_stage_now(stage);
    bool plays = !now.seeking && !picture->paused && !now.at_rest;
    bool slow = plays && now.pace < KEEPS_UP;
    /* How long a step takes is not known before the first one is done. */
    bool starting = picture->moment == 0 && now.step_ms <= 0;
    double times = picture->speed * (slow ? now.pace : 1);
    int words = now.seeking       ? BACK
                : picture->paused ? PAUSED
                : now.at_rest     ? AT_REST
                : starting        ? STARTING
                : times == 1      ? REAL_TIME
                                  : TIMES;
    return (skv_going){going_words[words], times, slow};
}

/* ---- The number of particles ----------------------------------------------------------------- */

static const int amounts[] = {500, 1000, 2000, USUAL_AMOUNT, 5000, 10000, 20000};

int skv_amount_at(int i)
{
    const int *amount = AT(amounts, i);
    return amount ? *amount : 0;
}

/* Whether a file of that name is a scene. */
static bool is_scene(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending && (strcmp(ending, ".json") == 0 || strcmp(ending, ".png") == 0);
}

int skv_amount_of(const char *name_or_path, int chosen)
{
    SKV_ASSERT_OR(name_or_path, 0);
    const skv_scene_info *info;
    skv_scene *scene = NULL;
    int own = 0;
    for (int i = 0; (info = skv_builtin_scene(i)); i++)
        if (strcmp(info->name, name_or_path) == 0 &&
            skv_scene_load(name_or_path, NULL, &scene, NULL) == SKV_OK)
            own = skv_scene_amount(scene);
    skv_scene_destroy(scene);
    if (chosen <= 0 || (own == 0 && !is_scene(name_or_path)))
        return 0;
    return own == 0 ? chosen : (int)(((int64_t)own * chosen + USUAL_AMOUNT / 2) / USUAL_AMOUNT);
}

/* ---- The world and its tools ----------------------------------------------------------------- */

static const skv_named_number planets[] = {
    {"Moon", -1.62}, {"Mars", -3.71}, {"Earth", -9.81}, {"Jupiter", -24.79}};

const skv_named_number *skv_planet_at(int i)
{
    return AT(planets, i);
}

void skv_control_planet(skv_stage *stage, int side, const skv_named_number *planet)
{
    SKV_ASSERT(stage && planet);
    char text[16];
    skv_format(text, sizeof text, "%.2f", planet->number);
    if (skv_stage_picture(stage, side)->parameters.gravity_x != 0)
        skv_stage_set(stage, side, "gravity.x", "0");
    skv_stage_set(stage, side, "gravity.y", text);
}

void skv_control_tool(skv_stage *stage, int tool)
{
    SKV_ASSERT(stage);
    const skv_tool *info = skv_tool_info(tool);
    int next = skv_stage_dye(stage) + 1, shape = skv_stage_shape(stage) + 1;
    bool again = info && tool == skv_stage_tool(stage);
    if (again && info->dyes)
        skv_stage_set_dye(stage, skv_dye_name(next) ? next : 0);
    if (again && info->drops)
        skv_stage_set_shape(stage, skv_drop_shape(shape) ? shape : 0);
    skv_stage_set_tool(stage, tool);
}

void skv_control_fluid(skv_stage *stage, int fluid)
{
    SKV_ASSERT(stage);
    int tool = 0;
    skv_stage_set_fluid(stage, fluid);
    if (skv_tool_info(skv_stage_tool(stage))->pours)
        return;
    while (!skv_tool_info(tool)->pours)
        tool++;
    skv_stage_set_tool(stage, tool);
}

void skv_control_next_fluid(skv_stage *stage)
{
    SKV_ASSERT(stage);
    int count = skv_stage_picture(stage, 0)->frame.fluid_count;
    if (count > 1)
        skv_control_fluid(stage, (skv_stage_fluid(stage) + 1) % count);
}

void skv_control_brush(skv_stage *stage, double radius)
{
    SKV_ASSERT(stage);
    skv_camera camera = skv_stage_camera(stage, 0);
    double size = fmax(camera.world_width, camera.world_height);
    if (isfinite(radius))
        skv_stage_set_brush(
            stage, fmin(fmax(radius, limits.least_brush * size), limits.largest_brush * size));
}

void skv_control_scale_brush(skv_stage *stage, double factor)
{
    SKV_ASSERT(stage);
    skv_control_brush(stage, skv_stage_picture(stage, 0)->brush * factor);
}

static const char *const refusal_words[] = {
    "Give a number from %s to %s.",
    "Give a whole number from %s to %s.",
};

const char *skv_refusal_words(int i)
{
    return i >= 0 && i < COUNT(refusal_words) ? refusal_words[i] : NULL;
}

const char *skv_field_refusal(const skv_field *field, const char *text)
{
    SKV_ASSERT_OR(field && text, NULL);
    double number;
    bool numeric = field->type == SKV_FIELD_NUMBER || field->type == SKV_FIELD_INTEGER;
    if (!numeric || !skv_field_read(field, text, &number))
        return NULL;
    return refusal_words[field->type == SKV_FIELD_INTEGER];
}

/* ---- Instruments ----------------------------------------------------------------------------- */

static const skv_gauge gauges[] = {
    {SKV_INSTRUMENT_PRESSURE, "Pressure", false, false, 0},
    {SKV_INSTRUMENT_VELOCITY, "Speed", false, false, 2},
    {SKV_INSTRUMENT_LEVEL, "Water level", true, false, 2},
    {SKV_INSTRUMENT_RULER, "Ruler", true, false, 0},
    {SKV_INSTRUMENT_GATE, "Flow through a gate", true, false, 0},
    {SKV_INSTRUMENT_FORCE, "Force on walls", true, true, 3},
};

const skv_gauge *skv_gauge_at(int i)
{
    return AT(gauges, i);
}

const skv_gauge *skv_gauge_of(skv_instrument_kind kind)
{
    for (int i = 0; i < COUNT(gauges); i++)
        if (gauges[i].kind == kind)
            return &gauges[i];
    return NULL;
}

/* Along one axis, within what is seen of the world. */
static double within(double value, double centre, double seen, double most)
{
    return fmin(fmax(value, fmax(centre - seen / 2, 0)), fmin(centre + seen / 2, most));
}

/* Shares of what is seen: how high a level's upper end lies over the middle, and how long other
 * lines are. */
#define HIGH   0.4
#define LENGTH 0.3

/* To the other side where the world ends before. */
static double beside(double from, double length, double most)
{
    return from + length <= most ? from + length : fmax(from - length, 0);
}

uint32_t skv_control_add_gauge(skv_stage *stage, const skv_gauge *gauge)
{
    SKV_ASSERT_OR(stage && gauge, 0);
    if (skv_stage_picture(stage, 0)->opened == 0)
        return 0;
    skv_camera camera = skv_stage_camera(stage, 0);
    skv_instrument_def def = skv_default_instrument_def(gauge->kind);
    double width = camera.world_width, height = camera.world_height;
    double length = LENGTH * fmin(width, height) / camera.zoom;
    skv_place(stage, gauge->kind == SKV_INSTRUMENT_LEVEL, &def.x0, &def.y0);
    def.x1 = def.x0, def.y1 = def.y0;
    if (gauge->kind == SKV_INSTRUMENT_LEVEL) {
        double top = camera.centre_y + HIGH * height / camera.zoom;
        def.y1 = def.y0 < top ? fmin(top, height) : height;
    } else if (gauge->kind == SKV_INSTRUMENT_GATE) {
        def.y1 = beside(def.y0, length, height);
    } else if (gauge->line) {
        def.x1 = beside(def.x0, length, width);
        def.y1 = gauge->box ? beside(def.y0, length / 2, height) : def.y0;
    }
    skv_format(def.name, sizeof def.name, "%s", skv_instrument_kind_name(gauge->kind));
    return skv_stage_add_probe(stage, &def);
}

void skv_control_drag(skv_stage *stage, int side, uint32_t probe, int end, double x, double y)
{
    SKV_ASSERT(stage);
    const skv_probe *dragged = skv_stage_probe(stage, side, probe);
    if (!dragged || !isfinite(x) || !isfinite(y))
        return;
    skv_camera camera = skv_stage_camera(stage, side);
    const skv_instrument_def *def = &dragged->def;
    x = within(x, camera.centre_x, camera.width / camera.scale, camera.world_width);
    y = within(y, camera.centre_y, camera.height / camera.scale, camera.world_height);
    if (end)
        skv_stage_move_probe(stage, probe, def->x0, def->y0, x, y);
    else
        skv_stage_move_probe(stage, probe, x, y, def->x1 + x - def->x0, def->y1 + y - def->y0);
}

/* ---- Comparing ------------------------------------------------------------------------------- */

static const skv_choice choices[] = {
    {"same", "The same, to be changed", NULL, NULL, 0},
    {"water", "Water", "fluid.material", "water", 0},
    {"oil", "Oil", "fluid.material", "oil", 0},
    {"honey", "Honey", "fluid.material", "honey", 0},
    {"mercury", "Mercury", "fluid.material", "mercury", 0},
    {"clavet", "The pressure law as in the thesis", "fluid.law", "clavet", 0},
    {"finer", "Four times as many particles", NULL, NULL, 4},
    {"coarser", "A quarter of the particles", NULL, NULL, 0.25},
};

const skv_choice *skv_choice_at(int i)
{
    return AT(choices, i);
}

const skv_choice *skv_choice_named(const char *name)
{
    SKV_ASSERT_OR(name, NULL);
    for (int i = 0; i < COUNT(choices); i++)
        if (strcmp(choices[i].name, name) == 0)
            return &choices[i];
    return NULL;
}

void skv_control_compare(skv_stage *stage, const skv_choice *choice)
{
    SKV_ASSERT(stage && choice);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    const skv_setting setting = {choice->path, choice->value};
    skv_scene_options options = skv_default_scene_options();
    options.settings = choice->path ? &setting : NULL;
    options.setting_count = choice->path ? 1 : 0;
    if (choice->particles > 0) {
        int count =
            picture->scene ? skv_scene_amount(picture->scene) : picture->frame.particles.count;
        options.particles = (int)fmax(count * choice->particles, 1);
    }
    skv_stage_compare(stage, &options);
    skv_stage_want_choice(stage, choice->name);
}

static const char *const alike[][2] = {
    {"hydrostatics", "pool"}, {"rest", "pool"},     {"dam-break", "dam-break"},
    {"slosh", "waves"},       {"u-tube", "u-tube"}, {"vessels", "communicating"},
    {"viscosity", "splash"},
};

const char *skv_experiment_like(const char *experiment)
{
    SKV_ASSERT_OR(experiment, NULL);
    for (int i = 0; i < COUNT(alike); i++)
        if (strcmp(alike[i][0], experiment) == 0)
            return alike[i][1];
    return NULL;
}
