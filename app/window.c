/* Window: puts the parts together and says what the view cannot. Invariant: a message of something
 * that failed stays until it is closed or something else was opened. */
#include "window.h"

#include <skvalp/link.h>

#include "ball.h"
#include "cards.h"
#include "fluids.h"
#include "gallery.h"
#include "input.h"
#include "legend.h"
#include "probes.h"
#include "properties.h"
#include "said.h"
#include "settings.h"
#include "style.h"
#include "tools.h"
#include "transport.h"
#include "views.h"
#include "words.h"

#define READING_TIME 8   /* s, of a scene's description */
#define NARROW       620 /* pixels: below, tools lie under the picture, and time has two rows */

struct _PlayWindow {
    AdwApplicationWindow parent;
    GtkWidget *header, *open, *views, *menu;
    AdwButtonContent *scenes_label;
    GtkWidget *message_text, *stage, *worlds, *rail, *middle, *leave, *tray, *recording, *progress,
        *watching;
    AdwFlap *flap;
    GtkStack *pages;
    GtkBox *properties, *tools, *fluids;
    AdwWindowTitle *title;
    AdwToastOverlay *toasts;
    AdwToast *toast; /* that was said last, while it is to be seen */
    GtkRevealer *message;
    GtkLabel *status, *description_text;
    GtkRevealer *description;
    guint description_end; /* the source that hides it */
    PlayView *view;
    PlayProbes *probes;
    PlayBall *ball;
    PlayLegend *legend;
    GMenu *recent, *amounts;
    PlayTransport *transport;
    bool keep_message; /* when the next thing is opened */
    guint32 mismatch;  /* what was opened, and is known to go another way than it was recorded */
    char *spoken;      /* what the picture's description says */
    bool narrow;
    guint layout; /* the source that will lay out anew */
};

G_DEFINE_FINAL_TYPE(PlayWindow, play_window, ADW_TYPE_APPLICATION_WINDOW)

PlayView *play_window_view(PlayWindow *window)
{
    return window->view;
}

GtkWidget *play_window_stage(PlayWindow *window)
{
    return window->stage;
}

GtkBox *play_window_worlds(PlayWindow *window)
{
    return GTK_BOX(window->worlds);
}

GtkBox *play_window_properties(PlayWindow *window)
{
    return window->properties;
}

GtkWidget *play_window_ball(PlayWindow *window)
{
    return GTK_WIDGET(window->ball);
}

GMenu *play_window_recent(PlayWindow *window)
{
    return window->recent;
}

GMenu *play_window_amounts(PlayWindow *window)
{
    return window->amounts;
}

void play_window_measure(PlayWindow *window, int kind)
{
    play_probes_add(window->probes, kind);
}

/* Messages. */

void play_window_complain(PlayWindow *window, const char *text)
{
    char *said = play_said(text);
    gtk_label_set_text(GTK_LABEL(window->message_text), said);
    g_free(said);
    gtk_revealer_set_reveal_child(window->message, TRUE);
}

gboolean play_window_dismiss(PlayWindow *window)
{
    bool shown = gtk_revealer_get_reveal_child(window->message);
    gtk_revealer_set_reveal_child(window->message, FALSE);
    return shown;
}

void play_window_toast(PlayWindow *window, const char *text)
{
    char *escaped = g_markup_escape_text(text, -1); /* toasts read markup */
    if (!window->toast || !g_str_equal(adw_toast_get_title(window->toast), escaped)) {
        AdwToast *toast = adw_toast_new(escaped);
        adw_toast_set_timeout(toast, 6);
        g_set_weak_pointer(&window->toast, toast);
        play_window_add_toast(window, toast);
    }
    g_free(escaped);
}

void play_window_add_toast(PlayWindow *window, AdwToast *toast)
{
    adw_toast_overlay_add_toast(window->toasts, toast);
}

void play_window_set_watching(PlayWindow *window, gboolean watching)
{
    gtk_widget_set_visible(window->watching, watching);
}

void play_window_set_progress(PlayWindow *window, double share)
{
    gtk_widget_set_visible(window->recording, share >= 0);
    gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(window->progress), CLAMP(share, 0, 1));
}

/* Pages. */

void play_window_show_page(PlayWindow *window, const char *name)
{
    gtk_stack_set_visible_child_name(window->pages, name);
    g_signal_emit_by_name(window->view, "changed"); /* the actions' states follow */
    if (g_str_equal(name, "play"))
        gtk_widget_grab_focus(GTK_WIDGET(window->view));
}

const char *play_window_page(PlayWindow *window)
{
    return gtk_stack_get_visible_child_name(window->pages);
}

void play_window_show_experiment(PlayWindow *window, int number)
{
    GtkWidget *before = gtk_stack_get_child_by_name(window->pages, "experiment");
    GtkWidget *card = play_card_new(number, play_view_style(window->view));
    if (before)
        gtk_stack_remove(window->pages, before);
    gtk_stack_add_named(window->pages, card, "experiment");
    play_window_show_page(window, "experiment");
}

void play_window_show_properties(PlayWindow *window, gboolean shown)
{
    adw_flap_set_reveal_flap(window->flap, shown);
    if (!shown)
        gtk_widget_grab_focus(GTK_WIDGET(window->view));
}

/* Opening. */

static void show_notices(PlayWindow *window, const skv_scene *scene)
{
    const char *notice;
    for (int i = 0; scene && (notice = skv_scene_notice(scene, i)); i++) {
        char *said = play_said(notice);
        play_window_toast(window, said);
        g_free(said);
    }
}

static gboolean hide_description(gpointer data)
{
    PlayWindow *window = data;
    window->description_end = 0;
    gtk_revealer_set_reveal_child(window->description, FALSE);
    return G_SOURCE_REMOVE;
}

void play_window_hide_description(PlayWindow *window)
{
    g_clear_handle_id(&window->description_end, g_source_remove);
    hide_description(window);
}

/* Beside the legend a narrow window has no room for it. */
static void put_description_below(GtkWidget *legend, G_GNUC_UNUSED GParamSpec *property,
                                  PlayWindow *window)
{
    int high = 0, status;
    if (gtk_widget_get_visible(legend))
        gtk_widget_measure(legend, GTK_ORIENTATION_VERTICAL, -1, NULL, &high, NULL, NULL);
    gtk_widget_measure(GTK_WIDGET(window->status), GTK_ORIENTATION_VERTICAL, -1, NULL, &status,
                       NULL, NULL);
    gtk_widget_set_margin_top(GTK_WIDGET(window->description), MAX(0, high - status));
}

/* For as long as it takes to read it. */
static void show_description(PlayWindow *window, const char *text)
{
    bool any = text && *text;
    g_clear_handle_id(&window->description_end, g_source_remove);
    gtk_label_set_text(window->description_text, any ? text : "");
    gtk_revealer_set_reveal_child(window->description, any);
    if (any)
        window->description_end = g_timeout_add_seconds(READING_TIME, hide_description, window);
}

static void on_opened(PlayWindow *window)
{
    const skv_picture *picture = play_view_picture(window->view);
    const char *title = play_word(picture->title);
    skv_stage_set_paused(play_view_stage(window->view), picture->still);
    adw_window_title_set_subtitle(window->title, title);
    gtk_widget_set_tooltip_text(GTK_WIDGET(window->title), play_word(picture->description));
    char *name = g_strdup_printf("%s – Skvalp", title);
    gtk_window_set_title(GTK_WINDOW(window), name);
    g_free(name);
    if (!window->keep_message)
        play_window_dismiss(window);
    window->keep_message = false;
    show_notices(window, picture->scene);
    show_description(window, play_word(picture->description));
    play_window_show_page(window, "play");
}

/* The message that says why the default scene is shown stays although something was opened. */
static void on_failed(PlayWindow *window, const char *text)
{
    play_window_complain(window, text);
    if (play_view_picture(window->view)->opened != 0 || window->keep_message)
        return;
    window->keep_message = true;
    skv_stage_open(play_view_stage(window->view), skv_control_limits()->first_scene, NULL);
}

static bool open_linked(const char *bytes, size_t size, void *window)
{
    skv_scene_options options = skv_default_scene_options();
    options.cautious = true;
    skv_stage_open_memory(play_view_stage(PLAY_WINDOW(window)->view), bytes, size, "skvr",
                          _("link"), &options);
    return true;
}

void play_window_open(PlayWindow *window, const char *name)
{
    skv_error error;
    skv_scene_options options = skv_default_scene_options();
    options.particles = skv_amount_of(name, play_settings_number("particles", 0));
    if (!skv_link_is(name))
        skv_stage_open(play_view_stage(window->view), name, &options);
    else if (skv_link_read(name, open_linked, window, &error) != SKV_OK)
        on_failed(window, error.text);
}

void play_window_open_file(PlayWindow *window, GFile *file)
{
    char *path = g_file_get_path(file);
    if (path)
        play_window_open(window, path);
    else
        play_window_complain(window, _("This file is not on this computer: copy it here first."));
    g_free(path);
}

static gboolean on_drop(G_GNUC_UNUSED GtkDropTarget *target, const GValue *value,
                        G_GNUC_UNUSED double x, G_GNUC_UNUSED double y, PlayWindow *window)
{
    GSList *files = g_value_get_boxed(value); /* of a GdkFileList */
    if (!files)
        return FALSE;
    play_window_open_file(window, files->data);
    return TRUE;
}

/* What the view tells. */

/* Says once of a replay that it is not what happened. */
static void check_replay(PlayWindow *window, const skv_picture *picture)
{
    if (!picture->mismatch || window->mismatch == picture->opened)
        return;
    window->mismatch = picture->opened;
    play_window_complain(window, _("This replay goes another way than when it was recorded: "
                                   "another version of Skvalp made it, or the file is damaged."));
}

static void on_view_changed(PlayWindow *window)
{
    const skv_picture *picture = play_view_picture(window->view);
    check_replay(window, picture);
    gtk_widget_set_visible(GTK_WIDGET(window->status), picture->opened != 0);
    char *amount = play_words_of_amount(picture),
         *text = play_words_of_picture(play_view_stage(window->view), picture);
    gtk_label_set_text(window->status, amount);
    if (g_strcmp0(text, window->spoken) != 0) {
        gtk_accessible_update_property(GTK_ACCESSIBLE(window->view),
                                       GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
        g_free(window->spoken);
        window->spoken = g_strdup(text);
    }
    g_free(amount);
    g_free(text);
}

static void on_theme_changed(PlayWindow *window)
{
    skv_render_style style = *play_view_style(window->view);
    play_style_follow_theme(&style);
    play_view_set_style(window->view, &style);
    bool contrast = adw_style_manager_get_high_contrast(adw_style_manager_get_default());
    (contrast ? gtk_widget_add_css_class : gtk_widget_remove_css_class)(GTK_WIDGET(window),
                                                                        "high-contrast");
}

static void on_fullscreen_changed(PlayWindow *window)
{
    bool full = gtk_window_is_fullscreen(GTK_WINDOW(window));
    gtk_widget_set_visible(window->header, !full);
    gtk_widget_set_visible(window->leave, full);
}

/* Layout: rail and transport turn with the window's shape. */

static gboolean lay_out(gpointer data)
{
    PlayWindow *window = data;
    window->layout = 0;
    bool narrow = window->narrow;
    GtkOrientation across = narrow ? GTK_ORIENTATION_HORIZONTAL : GTK_ORIENTATION_VERTICAL;
    gtk_orientable_set_orientation(GTK_ORIENTABLE(window->middle),
                                   narrow ? GTK_ORIENTATION_VERTICAL : GTK_ORIENTATION_HORIZONTAL);
    gtk_orientable_set_orientation(GTK_ORIENTABLE(window->tools), across);
    gtk_orientable_set_orientation(GTK_ORIENTABLE(window->worlds),
                                   narrow ? GTK_ORIENTATION_VERTICAL : GTK_ORIENTATION_HORIZONTAL);
    gtk_box_reorder_child_after(GTK_BOX(window->middle), window->rail,
                                narrow ? GTK_WIDGET(window->toasts) : NULL);
    play_transport_set_narrow(window->transport, narrow);
    gtk_widget_set_visible(window->open, !narrow);
    adw_header_bar_set_decoration_layout(ADW_HEADER_BAR(window->header), narrow ? ":close" : NULL);
    adw_button_content_set_label(window->scenes_label, narrow ? "" : _("Scenes"));
    return G_SOURCE_REMOVE;
}

static void size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    PlayWindow *window = PLAY_WINDOW(widget);
    bool narrow = width < NARROW;
    GTK_WIDGET_CLASS(play_window_parent_class)->size_allocate(widget, width, height, baseline);
    if (narrow == window->narrow)
        return;
    window->narrow = narrow; /* not while sizes are being allocated */
    if (!window->layout)
        window->layout = g_idle_add_full(G_PRIORITY_HIGH_IDLE, lay_out, window, NULL);
}

/* The menu's arrow keys are gravity's again once it is closed. */
static void on_popover_closed(PlayWindow *window)
{
    gtk_widget_grab_focus(GTK_WIDGET(window->view));
}

static void give_focus_back(PlayWindow *window, GtkWidget *menu_button)
{
    GtkPopover *popover = gtk_menu_button_get_popover(GTK_MENU_BUTTON(menu_button));
    if (popover)
        g_signal_connect_object(popover, "closed", G_CALLBACK(on_popover_closed), window,
                                G_CONNECT_SWAPPED);
}

static void make_parts(PlayWindow *window)
{
    play_view_begin(window->view, NULL);
    play_input_attach(window->view);
    play_input_attach_keys(GTK_WIDGET(window), window->view);
    play_tools_fill(window->tools, window->view);
    play_fluids_attach(window->fluids, window->view);
    play_probes_attach(window->probes, window->view, GTK_BOX(window->tray));
    play_ball_attach(window->ball, window->view);
    play_legend_attach(window->legend, window->view);
    g_signal_connect(window->legend, "notify::visible", G_CALLBACK(put_description_below), window);
    play_transport_attach(window->transport, window->view);
    play_properties_fill(window->properties, window->view);

    GMenuModel *kinds = play_probes_menu(), *views = play_views_menu();
    gtk_menu_button_set_menu_model(GTK_MENU_BUTTON(window->views), views);
    give_focus_back(window, window->views);
    g_object_unref(views);
    GtkWidget *measure =
        play_tools_menu_button("skvalp-probe-symbolic", _("Measure"), _("Measure (M)"));
    gtk_menu_button_set_menu_model(GTK_MENU_BUTTON(measure), kinds);
    gtk_box_append(window->tools, measure);
    give_focus_back(window, measure);
    give_focus_back(window, window->menu);
    g_object_unref(kinds);

    GtkDropTarget *target = gtk_drop_target_new(GDK_TYPE_FILE_LIST, GDK_ACTION_COPY);
    g_signal_connect(target, "drop", G_CALLBACK(on_drop), window);
    gtk_widget_add_controller(window->stage, GTK_EVENT_CONTROLLER(target));
}

static gboolean save_size(PlayWindow *window)
{
    int width, height;
    gtk_window_get_default_size(GTK_WINDOW(window), &width, &height);
    play_settings_set_number("width", width);
    play_settings_set_number("height", height);
    play_settings_set_number("maximised", gtk_window_is_maximized(GTK_WINDOW(window)));
    return GDK_EVENT_PROPAGATE;
}

static void dispose(GObject *object)
{
    PlayWindow *window = PLAY_WINDOW(object);
    g_clear_handle_id(&window->layout, g_source_remove);
    g_clear_handle_id(&window->description_end, g_source_remove);
    g_clear_pointer(&window->spoken, g_free);
    g_clear_weak_pointer(&window->toast);
    G_OBJECT_CLASS(play_window_parent_class)->dispose(object);
}

static void play_window_class_init(PlayWindowClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = dispose;
    widget_class->size_allocate = size_allocate;
    g_type_ensure(PLAY_TYPE_VIEW);
    g_type_ensure(PLAY_TYPE_PROBES);
    g_type_ensure(PLAY_TYPE_BALL);
    g_type_ensure(PLAY_TYPE_LEGEND);
    g_type_ensure(PLAY_TYPE_TRANSPORT);
    gtk_widget_class_set_template_from_resource(widget_class, "/org/skvalp/Play/window.ui");
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, header);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, open);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, views);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, menu);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, message_text);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, stage);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, worlds);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, rail);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, middle);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, leave);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, tray);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, recording);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, progress);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, watching);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, flap);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, pages);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, properties);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, tools);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, fluids);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, title);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, toasts);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, message);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, status);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, description);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, description_text);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, scenes_label);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, view);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, probes);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, ball);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, recent);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, amounts);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, legend);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, transport);
}

static void follow(PlayWindow *window)
{
    AdwStyleManager *styles = adw_style_manager_get_default();
    g_signal_connect_object(window->view, "changed", G_CALLBACK(on_view_changed), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(window->view, "opened", G_CALLBACK(on_opened), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(window->view, "failed", G_CALLBACK(on_failed), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(styles, "notify::dark", G_CALLBACK(on_theme_changed), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(styles, "notify::high-contrast", G_CALLBACK(on_theme_changed), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect(window, "notify::fullscreened", G_CALLBACK(on_fullscreen_changed), NULL);
    g_signal_connect(window, "close-request", G_CALLBACK(save_size), NULL);
}

static void play_window_init(PlayWindow *window)
{
    gtk_widget_init_template(GTK_WIDGET(window));
    make_parts(window);
    follow(window);
    on_theme_changed(window);
    gtk_stack_add_named(window->pages, play_gallery_new(play_view_style(window->view)), "scenes");
    int width = play_settings_number("width", 1120);
    gtk_window_set_default_size(GTK_WINDOW(window), width, play_settings_number("height", 720));
    window->narrow = width < NARROW;
    lay_out(window);
    if (play_settings_number("maximised", 0))
        gtk_window_maximize(GTK_WINDOW(window));
    gtk_widget_grab_focus(GTK_WIDGET(window->view));
}

PlayWindow *play_window_new(GtkApplication *application, const char *scene)
{
    PlayWindow *window = g_object_new(PLAY_TYPE_WINDOW, "application", application, NULL);
    play_window_open(window, scene ? scene : skv_control_limits()->first_scene);
    return window;
}
