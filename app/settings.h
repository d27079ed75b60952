/* Settings: what the app remembers from one start to the next. */
#ifndef SKVALP_PLAY_SETTINGS_H
#define SKVALP_PLAY_SETTINGS_H

#include <glib.h>

/* Reads what was written by the last start. A file that is missing or damaged counts as empty. */
void play_settings_load(void);

/* A value, or what it is until somebody changes it. The text is to be freed. */
char *play_settings_text(const char *key, const char *otherwise);
int play_settings_number(const char *key, int otherwise);

/* Remembers a value, at once. Where nothing can be written it lasts until the app ends. */
void play_settings_set_text(const char *key, const char *value);
void play_settings_set_number(const char *key, int value);

#endif
