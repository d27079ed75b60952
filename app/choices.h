/* Choices: what a world can be compared with. */
#ifndef SKVALP_PLAY_CHOICES_H
#define SKVALP_PLAY_CHOICES_H

#include <gio/gio.h>

/* All of them, as a menu of "win.compare"; with a scene that is opened first, or null: with the one
 * that is open. */
GMenuModel *play_choices_menu(const char *scene);

/* What shows an experiment as a scene: a built-in one if it is about the same, else its own set-up,
 * PLAY_SET_UP and its name. To be freed. */
#define PLAY_SET_UP "lab:"
char *play_choices_scene_of(const char *experiment);

#endif
