/* Dialogs of files. Invariant: a name that is no file's is no path, and nothing breaks. */
#include "dialogs.h"

char *play_chosen_path(GtkNativeDialog *dialog)
{
    GFile *file = gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog));
    char *path = file ? g_file_get_path(file) : NULL;
    g_clear_object(&file);
    return path;
}
