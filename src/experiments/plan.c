/* Writes a set-up down as a scene, and loads it.
 *
 * Invariant: what decides the particles' paths (corners, speeds, gravity) is computed with +, -, *,
 * / and sqrt alone, and written in the same digits on every machine.
 */
#include "experiments/plan.h"

#include "base/memory.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

/* Longest side of a world, m; the range of the scenes' world.width. */
#define MOST_METRES 16.0
/* Pixels a spacing, and the longest side of a picture. */
#define PIXELS      4
#define MOST_PIXELS (SKV_TERRAIN_MAX_PIXELS - 1)

shape skv_shape_box(double x0, double y0, double x1, double y1)
{
    return (shape){4, {x0, x1, x1, x0}, {y0, y0, y1, y1}, 0, 0};
}

shape skv_shape_ellipse(double x, double y, double a, double b)
{
    enum { QUARTER = MAX_CORNERS / 4 };
    /* What the polygon with these corners on the unit circle lacks, as a share of the radius. */
    const double grow = 1.000903;
    shape e = {.corners = MAX_CORNERS};
    for (int i = 0; i < QUARTER; i++) {
        /* ((1 - t^2), 2t) / (1 + t^2) runs along a quarter of the unit circle. */
        double t = (double)i / QUARTER, away = 1 + t * t;
        double along = grow * (1 - t * t) / away, up = grow * 2 * t / away;
        const double xs[4] = {along, -up, -along, up}, ys[4] = {up, along, -up, -along};
        for (int quarter = 0; quarter < 4; quarter++) {
            e.x[quarter * QUARTER + i] = x + a * xs[quarter];
            e.y[quarter * QUARTER + i] = y + b * ys[quarter];
        }
    }
    return e;
}

static double area_of(const shape *s)
{
    double sum = 0;
    for (int i = 0; i < s->corners; i++) {
        int next = (i + 1) % s->corners;
        sum += s->x[i] * s->y[next] - s->x[next] * s->y[i];
    }
    return fabs(sum) / 2;
}

double skv_plan_area(const rig_plan *plan)
{
    double area = 0;
    for (int i = 0; i < plan->waters; i++)
        area += area_of(&plan->water[i]);
    return area;
}

/* ---- The scene's text ------------------------------------------------------------------------ */

enum { ROOM = 1 << 16 };

typedef struct text {
    char *bytes;
    size_t length;
} text;

/* A text that is cut is no JSON, which the scene's reader notices. */
static void __attribute__((format(printf, 2, 3))) say(text *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    skv_format_list(t->bytes + t->length, ROOM - t->length, format, arguments);
    va_end(arguments);
    t->length += strlen(t->bytes + t->length);
}

/* All of a shape but what opens it. */
static void say_shape(text *t, const shape *s)
{
    say(t, "\"shape\": \"polygon\", ");
    if (s->vx != 0 || s->vy != 0)
        say(t, "\"vx\": %.9g, \"vy\": %.9g, ", s->vx, s->vy);
    say(t, "\"points\": [");
    for (int k = 0; k < s->corners; k++)
        say(t, "%s[%.9g, %.9g]", k ? ", " : "", s->x[k], s->y[k]);
    say(t, "]}");
}

/* Experiments beside alone have these (experiment.h). */
#ifdef SKV_WITHOUT_EXPERIMENTS_BESIDE
#define say_fluid(t, plan, water) ((void)(plan))
#define say_beside(t, plan)       ((void)(plan))
#else
static void say_fluid(text *t, const rig_plan *plan, int water)
{
    if (plan && plan->fluid_of[water] > 0)
        say(t, "\"fluid\": \"%s\", ", plan->fluid[plan->fluid_of[water] - 1].name);
}

static void say_beside(text *t, const rig_plan *plan)
{
    say(t, ", \"fluids\": [");
    for (int i = 0; i < plan->fluids; i++)
        say(t, "%s{\"name\": \"%s\", \"density\": %.9g, \"shear_modulus\": %.9g}", i ? ", " : "",
            plan->fluid[i].name, plan->fluid[i].density, plan->fluid[i].shear_modulus);
    say(t, "], \"bodies\": [");
    for (int i = 0; i < plan->bodies; i++) {
        say(t, "%s{\"density\": %.9g, ", i ? ", " : "", plan->body[i].density);
        say_shape(t, &plan->body[i].outline);
    }
    say(t, "]");
    if (plan->air > 0)
        say(t, ", \"air\": {\"pressure\": %.9g}", plan->air / 1000);
}
#endif

static void say_shapes(text *t, const char *list, const shape *shapes, int count,
                       const rig_plan *fluids)
{
    say(t, ", \"%s\": [", list);
    for (int i = 0; i < count; i++) {
        say(t, i ? ", {" : "{");
        say_fluid(t, fluids, i);
        say_shape(t, &shapes[i]);
    }
    say(t, "]");
}

static void say_scene(text *t, const rig_plan *plan, double pixel)
{
    say(t, "\"depth\": %.9g, ", plan->depth);
    say(t, "\"world\": {\"width\": %.9g, \"height\": %.9g, \"pixel\": %.9g, ", plan->width,
        plan->height, pixel);
    say(t, "\"open\": {\"right\": %s, \"bottom\": %s}}, ", plan->open_right ? "true" : "false",
        plan->open_bottom ? "true" : "false");
    say(t, "\"gravity\": {\"x\": %.9g, \"y\": %.9g}", plan->gravity_x, plan->gravity_y);
    say_shapes(t, "solid", plan->solid, plan->solids, NULL);
    say_shapes(t, "water", plan->water, plan->waters, plan);
    say_beside(t, plan);
    say(t, "}\n");
}

/* ---- Loading --------------------------------------------------------------------------------- */

/* Refuses at once what would be refused after the walls of a huge picture have been drawn. */
static skv_result check_size(const rig_plan *plan, const char *name, double spacing,
                             skv_error *error)
{
    double longest = fmax(plan->width, plan->height);
    if (!(longest <= MOST_METRES))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%s: its world would be %.3g m long, and %g m are allowed; take a smaller "
                        "scale or smaller lengths",
                        name, longest, MOST_METRES);
    double area = skv_plan_area(plan);
    if (area / (spacing * spacing) > SKV_MAX_PARTICLES)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "fluid.spacing: %g m make %.0f particles of the water of %s, and %d are "
                        "allowed; take %.2g or more",
                        spacing, area / (spacing * spacing), name, SKV_MAX_PARTICLES,
                        1.05 * sqrt(area / SKV_MAX_PARTICLES));
    return SKV_OK;
}

static double pixel_of(const rig_plan *plan, double spacing)
{
    double longest = fmax(plan->width, plan->height);
    double shortest = fmin(plan->width, plan->height);
    double pixel = fmax(spacing / PIXELS, longest / MOST_PIXELS);
    return fmin(pixel, shortest / (SKV_TERRAIN_MIN_PIXELS + 1));
}

skv_result skv_plan_scene(const rig_plan *plan, const char *name, double spacing,
                          const skv_setting *settings, int setting_count, skv_scene **scene,
                          skv_error *error)
{
    *scene = NULL;
    skv_result result = check_size(plan, name, spacing, error);
    if (result != SKV_OK)
        return result;
    double pixel = pixel_of(plan, spacing);
    text t = {skv_calloc(ROOM, 1), 0};
    if (!t.bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", name);
    say(&t, "{\"sleep\": false, ");
    say_scene(&t, plan, pixel);
    skv_scene_options options = skv_default_scene_options();
    options.settings = settings;
    options.setting_count = setting_count;
    result = skv_scene_load_memory(t.bytes, t.length, "json", name, &options, scene, error);
    skv_free(t.bytes);
    return result;
}

skv_result skv_plan_write(const rig_plan *plan, const skv_experiment *of, double particles,
                          const skv_setting *settings, int setting_count, skv_write *write,
                          void *user, skv_error *error)
{
    text t = {skv_calloc(ROOM, 1), 0};
    if (!t.bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", of->name);
    /* Who plays with it is to know why gravity points elsewhere than down. */
    const char *words = plan->gravity_x != 0 ? of->measure : of->description;
    say(&t, "{\"name\": \"%s\", \"title\": \"%s\", \"description\": \"%s\", ", of->name, of->title,
        words);
    say(&t, "\"particles\": %.0f, \"fluid\": {", particles);
    for (int i = 0; i < setting_count; i++)
        say(&t, "%s\"%s\": %s", i ? ", " : "", strchr(settings[i].path, '.') + 1,
            settings[i].value);
    say(&t, "}, ");
    say_scene(&t, plan, pixel_of(plan, sqrt(skv_plan_area(plan) / particles)));
    bool written = write(t.bytes, t.length, user);
    skv_free(t.bytes);
    if (!written)
        return skv_fail(error, SKV_ERROR_FILE, "%s: its scene could not be written", of->name);
    return SKV_OK;
}
