/* Choices: what a world is compared with, as a menu. */
#include "choices.h"

#include "words.h"

GMenuModel *play_choices_menu(const char *scene)
{
    GMenu *menu = g_menu_new();
    const skv_choice *choice;
    for (int i = 0; (choice = skv_choice_at(i)); i++) {
        char *target = g_strdup_printf("%s %s", choice->name, scene ? scene : "");
        GMenuItem *item = g_menu_item_new(play_word(choice->title), NULL);
        g_menu_item_set_action_and_target(item, "win.compare", "s", target);
        g_menu_append_item(menu, item);
        g_object_unref(item);
        g_free(target);
    }
    return G_MENU_MODEL(menu);
}

char *play_choices_scene_of(const char *experiment)
{
    const char *like = skv_experiment_like(experiment);
    return like ? g_strdup(like) : g_strconcat(PLAY_SET_UP, experiment, NULL);
}
