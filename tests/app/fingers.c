/* Fingers and keys for the windows of a headless compositor: Mutter's remote control by D-Bus.
 * Reads commands, some on a line with semicolons between, which come without a wait, and answers
 * each line with a line "done" once the compositor has it:
 *
 *     down SLOT X Y     move SLOT X Y     up SLOT     key KEYVAL...
 *
 * Places are pixels of the screen. Keys of one line go down in their order, and up in the opposite
 * one. What goes wrong is one line on the standard error, and the end.
 */
#include <gio/gio.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define REMOTE "org.gnome.Mutter.RemoteDesktop"
#define CAST   "org.gnome.Mutter.ScreenCast"

static GDBusConnection *bus;
static char *remote, *stream; /* paths of a session of remote control, and of the screen in it */

static GVariant *call(const char *name, const char *path, const char *interface, const char *method,
                      GVariant *arguments)
{
    GError *error = NULL;
    GVariant *answer =
        g_dbus_connection_call_sync(bus, name, path, interface, method, arguments, NULL,
                                    G_DBUS_CALL_FLAGS_NONE, 60000, NULL, &error);
    if (!answer) {
        fprintf(stderr, "%s: %s\n", method, error->message);
        exit(1);
    }
    return answer;
}

static char *call_for_path(const char *name, const char *path, const char *interface,
                           const char *method, GVariant *arguments)
{
    GVariant *answer = call(name, path, interface, method, arguments);
    char *result;
    g_variant_get(answer, "(o)", &result);
    g_variant_unref(answer);
    return result;
}

/* Places are those of a stream, which comes from a session that records the screen. */
static void begin(void)
{
    remote =
        call_for_path(REMOTE, "/org/gnome/Mutter/RemoteDesktop", REMOTE, "CreateSession", NULL);
    GVariant *answer = call(REMOTE, remote, "org.freedesktop.DBus.Properties", "Get",
                            g_variant_new("(ss)", REMOTE ".Session", "SessionId"));
    GVariant *id;
    g_variant_get(answer, "(v)", &id);
    GVariantBuilder options;
    g_variant_builder_init(&options, G_VARIANT_TYPE_VARDICT);
    g_variant_builder_add(&options, "{sv}", "remote-desktop-session-id", id);
    char *cast = call_for_path(CAST, "/org/gnome/Mutter/ScreenCast", CAST, "CreateSession",
                               g_variant_new("(a{sv})", &options));
    g_variant_builder_init(&options, G_VARIANT_TYPE_VARDICT);
    stream = call_for_path(CAST, cast, CAST ".Session", "RecordMonitor",
                           g_variant_new("(sa{sv})", "", &options));
    g_variant_unref(call(REMOTE, remote, REMOTE ".Session", "Start", NULL));
}

static int waiting; /* calls that are not answered */

static void end_call(GObject *source, GAsyncResult *result, gpointer data)
{
    (void)source;
    GError *error = NULL;
    GVariant *answer = g_dbus_connection_call_finish(bus, result, &error);
    if (!answer) {
        fprintf(stderr, "%s: %s\n", (const char *)data, error->message);
        exit(1);
    }
    g_variant_unref(answer);
    waiting--;
}

static void control(const char *method, GVariant *arguments)
{
    waiting++;
    g_dbus_connection_call(bus, REMOTE, remote, REMOTE ".Session", method, arguments, NULL,
                           G_DBUS_CALL_FLAGS_NONE, 60000, NULL, end_call, (gpointer)method);
}

static void press(char **keys)
{
    int count = (int)g_strv_length(keys);
    for (int i = 0; i < count; i++)
        control("NotifyKeyboardKeysym",
                g_variant_new("(ub)", (guint)strtoul(keys[i], NULL, 0), TRUE));
    for (int i = count - 1; i >= 0; i--)
        control("NotifyKeyboardKeysym",
                g_variant_new("(ub)", (guint)strtoul(keys[i], NULL, 0), FALSE));
}

static void act(const char *line)
{
    char **words = g_strsplit(line, " ", -1);
    int count = (int)g_strv_length(words);
    guint slot = count > 1 ? (guint)atoi(words[1]) : 0;
    double x = count > 3 ? g_ascii_strtod(words[2], NULL) : 0;
    double y = count > 3 ? g_ascii_strtod(words[3], NULL) : 0;
    if (count == 4 && g_str_equal(words[0], "down"))
        control("NotifyTouchDown", g_variant_new("(sudd)", stream, slot, x, y));
    else if (count == 4 && g_str_equal(words[0], "move"))
        control("NotifyTouchMotion", g_variant_new("(sudd)", stream, slot, x, y));
    else if (count == 2 && g_str_equal(words[0], "up"))
        control("NotifyTouchUp", g_variant_new("(u)", slot));
    else if (count > 1 && g_str_equal(words[0], "key"))
        press(words + 1);
    else {
        fprintf(stderr, "no command: %s\n", line);
        exit(1);
    }
    g_strfreev(words);
}

int main(void)
{
    char line[4096];
    GError *error = NULL;
    bus = g_bus_get_sync(G_BUS_TYPE_SESSION, NULL, &error);
    if (!bus) {
        fprintf(stderr, "%s\n", error->message);
        return 1;
    }
    begin();
    puts("done");
    fflush(stdout);
    while (fgets(line, sizeof line, stdin)) {
        char **commands = g_strsplit(line, ";", -1);
        for (char **command = commands; *command; command++)
            act(g_strstrip(*command));
        g_strfreev(commands);
        while (waiting > 0)
            g_main_context_iteration(NULL, TRUE);
        puts("done");
        fflush(stdout);
    }
    return 0;
}
