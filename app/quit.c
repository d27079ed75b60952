/* Quitting, by key or because the system asks for it. Invariant: whatever dialog or menu is open,
 * the main window closes as if by hand, so that nothing is left half-written, and the app goes with
 * it. An application's own keys reach its main windows alone, so this key is one
 * of every window's and every menu's. */
#include "quit.h"

#include <glib-unix.h>
#include <signal.h>

#include "window.h"

static gboolean quit(G_GNUC_UNUSED gpointer data)
{
    GList *windows = gtk_window_list_toplevels();
    g_list_foreach(windows, (GFunc)(void (*)(void))g_object_ref, NULL);
    for (GList *one = windows; one; one = one->next)
        if (PLAY_IS_WINDOW(one->data))
            gtk_window_close(one->data);
    g_list_free_full(windows, g_object_unref);
    return G_SOURCE_REMOVE;
}

/* A window should not go while it hears the key. */
static gboolean on_key(G_GNUC_UNUSED GtkWidget *widget, G_GNUC_UNUSED GVariant *none,
                       G_GNUC_UNUSED gpointer data)
{
    g_idle_add_full(G_PRIORITY_DEFAULT, quit, NULL, NULL);
    return GDK_EVENT_STOP;
}

static gboolean on_signal(G_GNUC_UNUSED gpointer data)
{
    quit(NULL);
    return G_SOURCE_CONTINUE;
}

void play_quit_add(void)
{
    const int signals[] = {SIGTERM, SIGINT, SIGHUP};
    for (size_t i = 0; i < G_N_ELEMENTS(signals); i++)
        g_unix_signal_add(signals[i], on_signal, NULL);
    const GType types[] = {GTK_TYPE_WINDOW, GTK_TYPE_POPOVER};
    for (size_t i = 0; i < G_N_ELEMENTS(types); i++) {
        GtkWidgetClass *class = g_type_class_ref(types[i]);
        gtk_widget_class_add_binding(class, GDK_KEY_q, GDK_CONTROL_MASK, on_key, NULL);
        g_type_class_unref(class);
    }
}
