/* Style: names of everything that can be chosen, and the scale of a view. Invariant: the table is
 * the only place that knows a name; whoever lists, sets or describes choices walks it. */
#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/defs.h"
#include "base/exact.h"
#include "render/look.h"
#include "render/style.h"

#define EARTH_GRAVITY 9.81
#define LONGEST_NAME  24

static const skv_style_choice views[] = {
    {"water", "Water", "light on its rim, deeper blue below, foam where it is violent",
     SKV_VIEW_WATER},
    {"pressure", "Pressure", "pressure, with isobars", SKV_VIEW_PRESSURE},
    {"speed", "Speed", "speed", SKV_VIEW_SPEED},
    {"density", "Density", "particles per area against the number at rest", SKV_VIEW_DENSITY},
    {"particles", "Particles", "each particle as a disc, coloured by its speed",
     SKV_VIEW_PARTICLES},
    {"fluid", "Fluid", "water without light and foam", SKV_VIEW_FLUID},
    {0}};

static const skv_style_choice overlays[] = {
    {"tracers", "Tracers", "every tenth particle as a dot", SKV_OVERLAY_TRACERS},
    {"arrows", "Arrows", "the velocity on a grid", SKV_OVERLAY_ARROWS},
    {"streamlines", "Streamlines", "lines along the velocity, longer where it is faster",
     SKV_OVERLAY_STREAMLINES},
    {"grid", "Grid", "lines every 10 cm, or what suits the zoom", SKV_OVERLAY_GRID},
    {"ruler", "Ruler", "lengths along the left and lower side", SKV_OVERLAY_RULER},
    {"legend", "Legend", "the view's scale with its figures", SKV_OVERLAY_LEGEND},
    {0}};

static const skv_style_choice palettes[] = {
    {"dark", "Dark", "for dark surroundings", SKV_PALETTE_DARK},
    {"light", "Light", "for light surroundings and for paper", SKV_PALETTE_LIGHT},
    {"contrast", "High contrast", "black, white and one blue", SKV_PALETTE_CONTRAST},
    {0}};

static const skv_style_choice details[] = {
    {"auto", "Automatic", "plain where the processor draws, else full", SKV_DETAIL_AUTO},
    {"full", "Full", "smooth outlines, light and foam", SKV_DETAIL_FULL},
    {"plain", "Plain", "coarser outlines, no light, no foam", SKV_DETAIL_PLAIN},
    {0}};

static const struct {
    const char *name; /* for messages */
    const skv_style_choice *choices;
} parts[] = {[SKV_STYLE_VIEW] = {"view", views},
             [SKV_STYLE_OVERLAY] = {"overlay", overlays},
             [SKV_STYLE_PALETTE] = {"palette", palettes},
             [SKV_STYLE_DETAIL] = {"detail", details}};

skv_render_style skv_default_render_style(void)
{
    return (skv_render_style){.cookie = SKV_COOKIE(SKV_STYLE_COOKIE, skv_render_style)};
}

void skv_render_style_init(skv_render_style *def, size_t size)
{
    const skv_render_style standard = skv_default_render_style();
    skv_def_init(def, size, &standard, sizeof standard);
}

static int choice_count(skv_style_part part)
{
    int count = 0;
    while (parts[part].choices[count].name)
        count++;
    return count;
}

const skv_style_choice *skv_style_choice_at(skv_style_part part, int index)
{
    SKV_ASSERT_OR(part >= 0 && part <= SKV_STYLE_DETAIL, NULL);
    return index >= 0 && index < choice_count(part) ? &parts[part].choices[index] : NULL;
}

static skv_result unknown(skv_style_part part, const char *name, skv_error *error)
{
    const char *names[8];
    char list[128] = "";
    int count = choice_count(part);
    for (int i = 0; i < count; i++) {
        names[i] = parts[part].choices[i].name;
        size_t used = strlen(list);
        skv_format(list + used, sizeof list - used, "%s%s", i ? ", " : "", names[i]);
    }
    const char *nearest = skv_nearest_name(name, names, count);
    if (nearest)
        return skv_fail(error, SKV_ERROR_VALUE, "%s: '%s' is none; did you mean %s?",
                        parts[part].name, name, nearest);
    return skv_fail(error, SKV_ERROR_VALUE, "%s: '%s' is none; there are %s", parts[part].name,
                    name, list);
}

/* The choice with this name, or null. */
static const skv_style_choice *find(skv_style_part part, const char *name)
{
    const skv_style_choice *choice = parts[part].choices;
    while (choice->name && strcmp(choice->name, name) != 0)
        choice++;
    return choice->name ? choice : NULL;
}

static skv_result parse_overlays(const char *names, unsigned *overlays_set, skv_error *error)
{
    *overlays_set = 0;
    if (strcmp(names, "none") == 0)
        return SKV_OK;
    for (const char *at = names;; at++) {
        char name[LONGEST_NAME];
        size_t length = strcspn(at, ",");
        skv_format(name, sizeof name, "%.*s", (int)length, at);
        const skv_style_choice *choice = find(SKV_STYLE_OVERLAY, name);
        if (!choice)
            return unknown(SKV_STYLE_OVERLAY, name, error);
        *overlays_set |= (unsigned)choice->value;
        at += length;
        if (!*at)
            return SKV_OK;
    }
}

skv_result skv_render_style_set(skv_render_style *style, skv_style_part part, const char *names,
                                skv_error *error)
{
    SKV_ASSERT_OR(style && names, SKV_ERROR_VALUE);
    SKV_ASSERT_OR(part >= 0 && part <= SKV_STYLE_DETAIL, SKV_ERROR_VALUE);
    /* What a program can name it has a member for: the style itself is written. */
    skv_render_style own = skv_default_render_style();
    const skv_render_style *whole = style;
    SKV_ASSERT_INITIALISED(whole, skv_def_open(style, &own, sizeof own), SKV_ERROR_VALUE);
    if (part == SKV_STYLE_OVERLAY) {
        unsigned wanted;
        skv_result result = parse_overlays(names, &wanted, error);
        if (result == SKV_OK)
            style->overlays = wanted;
        return result;
    }
    const skv_style_choice *choice = find(part, names);
    if (!choice)
        return unknown(part, names, error);
    if (part == SKV_STYLE_VIEW)
        style->view = (skv_view)choice->value;
    else if (part == SKV_STYLE_PALETTE)
        style->palette = (skv_palette)choice->value;
    else
        style->detail = (skv_detail)choice->value;
    return SKV_OK;
}

/* The next number with one figure that divides well, and an even part of it. */
static double nice_above(double value, double *step)
{
    static const double figures[][2] = {{1, 0.05}, {1.5, 0.1}, {2, 0.1}, {3, 0.2},
                                        {4, 0.2},  {5, 0.25},  {8, 0.5}, {10, 0.5}};
    double decade = skv_decade(value);
    int i = 0;
    while (i < 7 && figures[i][0] * decade < value * (1 - 1e-9))
        i++;
    *step = figures[i][1] * decade;
    return figures[i][0] * decade;
}

/* Density of the heaviest of a frame's fluids. */
static double densest(const skv_frame *frame)
{
    double most = (double)frame->density;
    for (int i = 0; i < frame->fluid_count; i++)
        most = fmax(most, (double)frame->fluids[i].density);
    return most;
}

static void find_scale(const skv_frame *frame, const skv_render_style *style, skv_legend *legend)
{
    double gravity = hypot((double)frame->gravity_x, (double)frame->gravity_y);
    double weight = densest(frame) * fmax(gravity, 0.1 * EARTH_GRAVITY);
    double given = style->range;
    legend->shown = true;
    switch (style->view) {
    case SKV_VIEW_PRESSURE:
        legend->label = "pressure";
        legend->unit = "Pa m";
        legend->high =
            nice_above(given > 0 ? given / weight : 0.7 * skv_look_depth(frame), &legend->step) *
            weight;
        legend->step *= weight;
        legend->depth = gravity > 0 ? 1 / weight : 0;
        break;
    case SKV_VIEW_SPEED:
    case SKV_VIEW_PARTICLES:
        legend->label = "speed";
        legend->unit = "m/s";
        legend->high = nice_above(given > 0 ? given : skv_look_speed(frame), &legend->step);
        break;
    case SKV_VIEW_DENSITY:
        legend->label = "density";
        legend->high = given > 1 ? given : 1.1;
        legend->low = 2 - legend->high;
        nice_above(2 * (legend->high - 1), &legend->step);
        return;
    case SKV_VIEW_WATER:
    case SKV_VIEW_FLUID:
        legend->shown = false;
        return;
    }
    if (given > 0)
        legend->high = given;
}

int skv_render_fluid_color(const skv_frame *frame, skv_palette palette, int fluid)
{
    SKV_ASSERT_OR(frame && fluid >= 0 && fluid < SKV_MAX_FLUIDS, 0);
    float color[3];
    skv_look_fluid(skv_look_colors(palette), frame, fluid, color);
    int code = 0;
    for (int k = 0; k < 3; k++)
        code = code << 8 | (int)lroundf(255 * color[k]);
    return code;
}

skv_legend skv_render_legend(const skv_frame *frame, const skv_render_style *style)
{
    skv_legend legend = {.label = "", .unit = "", .high = 1, .step = 1};
    SKV_ASSERT_OR(frame && style, legend);
    skv_render_style own = skv_default_render_style();
    SKV_ASSERT_INITIALISED(style, skv_def_open(style, &own, sizeof own), legend);
    find_scale(frame, style, &legend);
    for (int i = 0; legend.shown && i < SKV_LEGEND_COLORS; i++) {
        float color[3];
        skv_look_scale(style->view, i / (SKV_LEGEND_COLORS - 1.0), color);
        for (int k = 0; k < 3; k++)
            legend.colors[i][k] = (uint8_t)lroundf(255 * color[k]);
    }
    return legend;
}
