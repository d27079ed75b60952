/* Settings: a key file in the user's configuration folder. Invariant: nothing of it is needed; a
 * home that cannot be read or written costs no more than what was remembered. */
#include "settings.h"

#define GROUP "play"

static GKeyFile *file;
static char *path;

void play_settings_load(void)
{
    if (file)
        return;
    file = g_key_file_new();
    path = g_build_filename(g_get_user_config_dir(), "skvalp", "play.ini", NULL);
    g_key_file_load_from_file(file, path, G_KEY_FILE_NONE, NULL);
}

/* Another window may have written something meanwhile, which is not to get lost. */
static void load_anew(void)
{
    GKeyFile *newer = g_key_file_new();
    play_settings_load();
    if (g_key_file_load_from_file(newer, path, G_KEY_FILE_NONE, NULL)) {
        g_key_file_free(file);
        file = newer;
    } else {
        g_key_file_free(newer);
    }
}

static void save(void)
{
    char *folder = g_path_get_dirname(path);
    if (g_mkdir_with_parents(folder, 0700) == 0)
        g_key_file_save_to_file(file, path, NULL);
    g_free(folder);
}

char *play_settings_text(const char *key, const char *otherwise)
{
    play_settings_load();
    char *value = g_key_file_get_string(file, GROUP, key, NULL);
    return value ? value : g_strdup(otherwise);
}

int play_settings_number(const char *key, int otherwise)
{
    play_settings_load();
    GError *error = NULL;
    int value = g_key_file_get_integer(file, GROUP, key, &error);
    if (error)
        value = otherwise;
    g_clear_error(&error);
    return value;
}

void play_settings_set_text(const char *key, const char *value)
{
    load_anew();
    g_key_file_set_string(file, GROUP, key, value);
    save();
}

void play_settings_set_number(const char *key, int value)
{
    load_anew();
    g_key_file_set_integer(file, GROUP, key, value);
    save();
}
