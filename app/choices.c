/* Choices: what a world is compared with. Invariant: each changes nothing but what its label says.
 */
#include "choices.h"

#include "words.h"

static const PlayChoice choices[] = {
    {"same", N_("The same, to be changed"), NULL, NULL, 0},
    {"water", N_("Water"), "fluid.material", "water", 0},
    {"oil", N_("Oil"), "fluid.material", "oil", 0},
    {"honey", N_("Honey"), "fluid.material", "honey", 0},
    {"mercury", N_("Mercury"), "fluid.material", "mercury", 0},
    {"clavet", N_("The pressure law as in the thesis"), "fluid.law", "clavet", 0},
    {"finer", N_("Four times as many particles"), NULL, NULL, 4},
    {"coarser", N_("A quarter of the particles"), NULL, NULL, 0.25},
};

const PlayChoice *play_choice_named(const char *name)
{
    for (size_t i = 0; i < G_N_ELEMENTS(choices); i++)
        if (g_str_equal(choices[i].name, name))
            return &choices[i];
    return NULL;
}

GMenuModel *play_choices_menu(const char *scene)
{
    GMenu *menu = g_menu_new();
    for (size_t i = 0; i < G_N_ELEMENTS(choices); i++) {
        char *target = g_strdup_printf("%s %s", choices[i].name, scene ? scene : "");
        GMenuItem *item = g_menu_item_new(_(choices[i].label), NULL);
        g_menu_item_set_action_and_target(item, "win.compare", "s", target);
        g_menu_append_item(menu, item);
        g_object_unref(item);
        g_free(target);
    }
    return G_MENU_MODEL(menu);
}

char *play_choices_scene_of(const char *experiment)
{
    static const char *const scenes[][2] = {
        {"hydrostatics", "pool"}, {"rest", "pool"},     {"dam-break", "dam-break"},
        {"slosh", "waves"},       {"u-tube", "u-tube"}, {"vessels", "communicating"},
        {"viscosity", "splash"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(scenes); i++)
        if (g_str_equal(scenes[i][0], experiment))
            return g_strdup(scenes[i][1]);
    return g_strconcat(PLAY_SET_UP, experiment, NULL);
}
