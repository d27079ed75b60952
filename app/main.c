/* skvalp-play: reads the command line and starts the application. Invariant: a scene that cannot be
 * opened never keeps the window from opening; only a wrong command line does. */
#include <skvalp/link.h>
#include <stdio.h>

#include "actions.h"
#include "quit.h"
#include "window.h"
#include "words.h"
#include "workers.h"

/* The exit status by which run.sh knows that it has to make pictures instead. */
enum { NO_DISPLAY = 3 };

#define USAGE                                                                                      \
    "Usage: skvalp-play [SCENE]\n"                                                                 \
    "Shows a scene live: a built-in name such as dam-break, a .json, .png, .skv\n"                 \
    "or .skvr file, or a link.\n"                                                                  \
    "\n"                                                                                           \
    "  -h, --help     this text\n"                                                                 \
    "      --version  the version\n"                                                               \
    "\n"                                                                                           \
    "In the window: hold fluid with the mouse or with several fingers; arrow keys turn\n"          \
    "gravity; Space pauses, the bar goes back in time; Ctrl+? lists all keys.\n"

static void on_startup(void)
{
    play_quit_add();
}

static void on_activate(GtkApplication *application, const char *scene)
{
    /* A file manager gives an address. */
    char *path = scene && !skv_link_is(scene) ? g_filename_from_uri(scene, NULL, NULL) : NULL;
    PlayWindow *window = play_window_new(application, path ? path : scene);
    g_free(path);
    play_actions_add(window, !scene || g_str_equal(scene, skv_control_limits()->first_scene));
    gtk_window_present(GTK_WINDOW(window));
}

int main(int argc, char **argv)
{
    const char *scene = argc > 1 ? argv[1] : NULL;
    play_words_load();
    if (scene && (g_str_equal(scene, "--help") || g_str_equal(scene, "-h"))) {
        fputs(USAGE, stdout);
        return 0;
    }
    if (scene && g_str_equal(scene, "--version")) {
        printf("skvalp-play %s\n", skv_version());
        return 0;
    }
    if (argc > 2 || (scene && scene[0] == '-')) {
        fprintf(stderr, "skvalp-play: %s; try: skvalp-play --help\n",
                argc > 2 ? "one scene at a time" : "unknown option");
        return 2;
    }

    if (!gtk_init_check()) {
        const char *display = g_getenv("WAYLAND_DISPLAY");
        display = display ? display : g_getenv("DISPLAY");
        fprintf(
            stderr,
            "skvalp-play: %s%s; start it on a desktop, or make pictures without one: skvalp run "
            "dam-break --png a.png\n",
            display ? "no answer from the display " : "there is no display",
            display ? display : "");
        return NO_DISPLAY;
    }

    /* Each process is its own: two windows may show two scenes. */
    AdwApplication *application = adw_application_new("org.skvalp.Play", G_APPLICATION_NON_UNIQUE);
    g_signal_connect(application, "startup", G_CALLBACK(on_startup), NULL);
    g_signal_connect(application, "activate", G_CALLBACK(on_activate), (gpointer)scene);
    int status = g_application_run(G_APPLICATION(application), 1, argv);
    g_object_unref(application);
    play_workers_finish();
    return status;
}
