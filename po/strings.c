/* Strings: what the library's tables say to people, for translators. Invariant: every text that the
 * app or the page takes from a table is printed here, as a template of gettext;
 * scripts/update-po.sh joins it with what xgettext finds in both.
 */
#include <skvalp/experiments.h>
#include <skvalp/measure.h>
#include <skvalp/parameters.h>
#include <skvalp/render.h>
#include <skvalp/scene.h>
#include <skvalp/stage.h>
#include <stdio.h>
#include <string.h>

#include "../app/words.h"
#include "../src/experiments/experiment.h"

static void print_text(const char *text, const char *place)
{
    if (!text || !*text)
        return;
    printf("#. %s\nmsgid \"", place);
    for (const char *c = text; *c; c++) {
        if (*c == '"' || *c == '\\')
            putchar('\\');
        if (*c == '\n')
            fputs("\\n", stdout);
        else
            putchar(*c);
    }
    fputs("\"\nmsgstr \"\"\n\n", stdout);
}

static void print_title(const char *path)
{
    char *title = play_english_title_of_path(path);
    print_text(title, path);
    g_free(title);
}

static void print_field(const skv_field *field)
{
    char *group = g_strdup(field->path), *dot = strchr(group, '.');
    if (dot)
        *dot = '\0';
    print_title(dot ? group : "world");
    print_title(field->path);
    print_text(field->help, field->path);
    for (char *choices = g_strdup(field->choices), *c = choices; c;) {
        char *end = strchr(c, '|');
        if (end)
            *end = '\0';
        print_text(c, field->path);
        c = end ? end + 1 : NULL;
        if (!c)
            g_free(choices);
    }
    g_free(group);
}

/* What the page offers to begin a scene anew with: single values. */
static bool is_setting(const skv_field *field)
{
    return field->type != SKV_FIELD_TEXT && !strchr(field->path, '[');
}

static void print_styles(void)
{
    static const skv_style_part parts[] = {SKV_STYLE_VIEW, SKV_STYLE_OVERLAY, SKV_STYLE_DETAIL};
    const skv_style_choice *choice;
    for (size_t p = 0; p < G_N_ELEMENTS(parts); p++)
        for (int i = 0; (choice = skv_style_choice_at(parts[p], i)); i++)
            print_text(choice->label, choice->name);
    skv_world *world;
    skv_world_def def = skv_default_world_def();
    skv_render_style style = skv_default_render_style();
    if (skv_world_create(&def, &world, NULL) != SKV_OK)
        return;
    skv_frame frame = skv_world_frame(world);
    for (int i = 0; (choice = skv_style_choice_at(SKV_STYLE_VIEW, i)); i++) {
        style.view = (skv_view)choice->value;
        skv_legend legend = skv_render_legend(&frame, &style);
        if (legend.shown)
            print_text(legend.label, choice->name);
    }
    skv_world_destroy(world);
}

static void print_instruments(void)
{
    for (int kind = 0; skv_instrument_kind_name((skv_instrument_kind)kind); kind++) {
        const char *name = skv_instrument_kind_name((skv_instrument_kind)kind);
        const skv_channel *channel;
        print_text(name, "an instrument");
        for (int i = 0; (channel = skv_instrument_channel((skv_instrument_kind)kind, i)); i++) {
            print_text(channel->name, name);
            print_text(skv_unit_of(channel->unit, true).name, "a unit");
        }
    }
}

static void print_experiments(void)
{
    const skv_experiment *e;
    for (int i = 0; (e = skv_experiment_info(i)); i++) {
        print_text(e->title, e->name);
        print_text(e->description, e->name);
        print_text(e->question, e->name);
        print_text(e->predict, e->name);
        print_text(e->measure, e->name);
        print_text(e->compare, e->name);
        print_text(e->x_label, e->name);
        print_text(e->y_label, e->name);
        for (int k = 0; k < MAX_QUANTITIES && skv_experiment_at(i)->quantities[k].name; k++)
            print_text(skv_experiment_at(i)->quantities[k].name, e->name);
    }
}

static void print_controls(void)
{
    const skv_named_number *number;
    const skv_choice *choice;
    const skv_gauge *gauge;
    for (int i = 0; (number = skv_speed_at(i)); i++)
        print_text(number->title, "a speed");
    for (int i = 0; (number = skv_planet_at(i)); i++)
        print_text(number->title, "a planet");
    for (int i = 0; (choice = skv_choice_at(i)); i++)
        print_text(choice->title, "what a world is compared with");
    for (int i = 0; (gauge = skv_gauge_at(i)); i++)
        print_text(gauge->title, "an instrument");
    const skv_key *key;
    for (int i = 0; (key = skv_key_at(i)); i++) {
        print_text(key->section, "a section of the table of keys");
        print_text(key->title, "what a key does");
        if (strlen(key->key) > 1 && !strchr(key->key, '+'))
            print_text(key->key, "a key, or a gesture");
    }
    for (int i = 0; skv_lack_words(i); i++)
        print_text(skv_lack_words(i), "why there is no reading");
    for (int i = 0; skv_refusal_words(i); i++)
        print_text(skv_refusal_words(i), "why a number is refused");
    print_text("collapses", "what a message says of a fluid");
    print_text("it", "what a message calls a value that is empty");
    print_text("body", "what a message is about");
    print_text("snapshot", "what a message is about");
    print_text("replay", "what a message is about");
    for (int i = 0; skv_going_words(i); i++)
        print_text(skv_going_words(i), "how the water goes");
}

int main(void)
{
    print_controls();
    const skv_tool *tool;
    for (int i = 0; (tool = skv_tool_info(i)); i++) {
        print_text(tool->title, tool->name);
        print_text(tool->help, tool->name);
    }
    for (int i = 0; skv_dye_name(i); i++)
        print_text(skv_dye_name(i), "a colour of dye");
    for (int i = 0; skv_drop_shape(i); i++)
        print_text(skv_drop_shape(i), "a shape that the tool for bodies drops");
    const skv_scene_info *scene;
    for (int i = 0; (scene = skv_builtin_scene(i)); i++) {
        print_text(scene->title, scene->name);
        print_text(scene->description, scene->name);
    }
    const skv_field *field;
    for (int i = 0; (field = skv_world_field(i)); i++)
        if (skv_world_can_change(field->path))
            print_field(field);
    for (int i = 0; (field = skv_scene_field(i)); i++)
        if (is_setting(field))
            print_field(field);
    print_styles();
    print_instruments();
    print_experiments();
    return 0;
}
