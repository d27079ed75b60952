/* The door: what the app is like at this moment, told to tests. It is linked with the app's own
 * objects into skvalp-play-tested, so the app that people get has none. Invariant: it looks and
 * never acts, but that no tooltips come up, toasts stay, worlds have one thread, and frames: few,
 * and one if a caller asks for it; and without SKVALP_DOOR in the environment it does nothing more.
 *
 * It listens on the Unix socket that SKVALP_DOOR names. Each line that comes is answered by a line
 * of JSON, on the main loop, between two events: the state under the names that the page's
 * window.skvalp.state has, then the windows with all that shows in them. A line that is not empty
 * asks for a frame of each window, too. Rectangles are in pixels of the window from its upper left
 * corner; a point of the world in m is at (originX + scale x, originY - scale y) in its area.
 */
#include <X11/extensions/XInput2.h>
#include <gdk/x11/gdkx.h>
#include <gio/gunixsocketaddress.h>
#include <glib/gstdio.h>
#include <math.h>
#include <skvalp/parameters.h>

#include "window.h"

#define CELLS 20 /* of the world, along each side, in which particles are counted */

#define FRAME                                                                                      \
    50000 /* us between two frames at least: drawn by the processor, they cost most here */

/* JSON. */

static void name(GString *json, const char *key)
{
    if (!strchr("[{", json->str[json->len - 1]))
        g_string_append_c(json, ',');
    if (key)
        g_string_append_printf(json, "\"%s\":", key);
}

static void open(GString *json, const char *key, char bracket)
{
    name(json, key);
    g_string_append_c(json, bracket);
}

static void number(GString *json, const char *key, double value)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    name(json, key);
    g_string_append(json, isfinite(value) ? g_ascii_dtostr(text, sizeof text, value) : "null");
}

static void truth(GString *json, const char *key, bool value)
{
    name(json, key);
    g_string_append(json, value ? "true" : "false");
}

static void text(GString *json, const char *key, const char *value)
{
    open(json, key, '"');
    for (const char *c = value ? value : ""; *c; c++)
        if (*c == '"' || *c == '\\' || (unsigned char)*c < 0x20)
            g_string_append_printf(json, "\\u%04x", (unsigned)*c);
        else
            g_string_append_c(json, *c);
    g_string_append_c(json, '"');
}

static void pair(GString *json, const char *key, double x, double y)
{
    open(json, key, '{');
    number(json, "x", x);
    number(json, "y", y);
    g_string_append_c(json, '}');
}

/* Places: also of what stands in a popover, which is a surface of its own. */
static void rectangle(GString *json, GtkWidget *widget)
{
    GtkNative *native = gtk_widget_get_native(widget);
    double x = 0, y = 0;
    gtk_widget_translate_coordinates(widget, GTK_WIDGET(native), 0, 0, &x, &y);
    for (;;) {
        double shift_x, shift_y;
        gtk_native_get_surface_transform(native, &shift_x, &shift_y);
        x += shift_x, y += shift_y;
        if (!GTK_IS_POPOVER(native))
            break;
        x += gdk_popup_get_position_x(GDK_POPUP(gtk_native_get_surface(native)));
        y += gdk_popup_get_position_y(GDK_POPUP(gtk_native_get_surface(native)));
        native = gtk_widget_get_native(gtk_widget_get_parent(GTK_WIDGET(native)));
    }
    number(json, "x", x);
    number(json, "y", y);
    number(json, "width", gtk_widget_get_width(widget));
    number(json, "height", gtk_widget_get_height(widget));
}

/* Worlds. */

/* Particles in each cell, rows from the bottom up; and whether a wall is in its middle. */
static void tell_cells(GString *json, const skv_frame *frame)
{
    int cells[CELLS][CELLS] = {0};
    float width = skv_terrain_width(frame->terrain), height = skv_terrain_height(frame->terrain);
    for (int i = 0; i < frame->particles.count; i++) {
        int x = (int)(frame->particles.x[i] / width * CELLS);
        int y = (int)(frame->particles.y[i] / height * CELLS);
        cells[CLAMP(y, 0, CELLS - 1)][CLAMP(x, 0, CELLS - 1)]++;
    }
    open(json, "water", '[');
    for (int i = 0; i < CELLS * CELLS; i++)
        number(json, NULL, cells[i / CELLS][i % CELLS]);
    g_string_append_c(json, ']');
    open(json, "walls", '[');
    for (int i = 0; i < CELLS * CELLS; i++) {
        double x = (i % CELLS + 0.5) / CELLS * width, y = (i / CELLS + 0.5) / CELLS * height;
        number(json, NULL, skv_terrain_distance(frame->terrain, (float)x, (float)y) < 0);
    }
    g_string_append_c(json, ']');
}

/* How many particles there are of each. */
static void tell_fluids(GString *json, const skv_frame *frame)
{
    int counts[SKV_MAX_FLUIDS] = {0};
    for (int i = 0; i < frame->particles.count; i++)
        counts[frame->particles.fluid ? frame->particles.fluid[i] : 0]++;
    open(json, "fluids", '[');
    for (int i = 0; i < frame->fluid_count; i++)
        number(json, NULL, counts[i]);
    g_string_append_c(json, ']');
}

static void tell_bodies(GString *json, const skv_frame *frame)
{
    open(json, "bodies", '[');
    for (int i = 0; i < frame->body_count; i++)
        pair(json, NULL, frame->bodies[i].x, frame->bodies[i].y);
    g_string_append_c(json, ']');
}

static void tell_probes(GString *json, const skv_picture *picture)
{
    open(json, "probes", '[');
    for (int i = 0; i < picture->probe_count; i++) {
        const skv_probe *probe = &picture->probes[i];
        open(json, NULL, '{');
        number(json, "id", probe->id);
        number(json, "kind", probe->def.kind);
        number(json, "x0", probe->def.x0);
        number(json, "y0", probe->def.y0);
        number(json, "x1", probe->def.x1);
        number(json, "y1", probe->def.y1);
        number(json, "value", probe->value[0]);
        number(json, "samples", probe->samples);
        g_string_append_c(json, '}');
    }
    g_string_append_c(json, ']');
}

/* As on_changed of legend.c: before anything is open there is none. */
static void tell_legend(GString *json, PlayView *view)
{
    const skv_picture *picture = play_view_picture(view);
    skv_legend legend = {.shown = false};
    if (picture->opened != 0)
        legend = skv_render_legend(&picture->frame, play_view_style(view));
    if (!legend.shown) {
        name(json, "legend");
        g_string_append(json, "null");
        return;
    }
    open(json, "legend", '{');
    text(json, "label", legend.label);
    text(json, "unit", legend.unit);
    number(json, "low", legend.low);
    number(json, "high", legend.high);
    g_string_append_c(json, '}');
}

static void tell_world(GString *json, PlayView *view)
{
    const skv_picture *picture = play_view_picture(view);
    const skv_camera camera = play_view_camera(view);
    static const char *const paths[] = {"fluid.material", "gravity.y"};
    open(json, NULL, '{');
    text(json, "name", picture->name);
    text(json, "title", picture->title);
    tell_fluids(json, &picture->frame);
    tell_bodies(json, &picture->frame);
    number(json, "opened", picture->opened);
    number(json, "picture", (double)picture->number);
    number(json, "time", picture->frame.time);
    number(json, "particles", picture->frame.particles.count);
    number(json, "awake", picture->frame.awake);
    number(json, "stepMs", picture->step_ms);
    number(json, "width", camera.world_width);
    number(json, "height", camera.world_height);
    number(json, "hands", picture->hand_count);
    pair(json, "gravity", picture->tilt_x, picture->tilt_y);
    open(json, "parameters", '{');
    for (size_t i = 0; i < G_N_ELEMENTS(paths); i++) {
        char value[32] = "";
        skv_world_def_get(&picture->parameters, paths[i], value, sizeof value, NULL);
        text(json, paths[i], value);
    }
    g_string_append_c(json, '}');
    open(json, "area", '{');
    rectangle(json, GTK_WIDGET(view));
    g_string_append_c(json, '}');
    open(json, "camera", '{');
    number(json, "scale", camera.scale);
    number(json, "originX", camera.origin_x);
    number(json, "originY", camera.origin_y);
    number(json, "zoom", camera.zoom);
    g_string_append_c(json, '}');
    tell_legend(json, view);
    tell_probes(json, picture);
    if (picture->frame.terrain)
        tell_cells(json, &picture->frame);
    g_string_append_c(json, '}');
}

/* What both worlds share. */
static void tell_stage(GString *json, PlayView *view)
{
    const skv_picture *picture = play_view_picture(view);
    const skv_stage *stage = play_view_stage(view);
    const skv_stage_state now = skv_stage_now(stage);
    number(json, "moment", (double)picture->moment);
    number(json, "end", (double)picture->end);
    truth(json, "paused", picture->paused);
    truth(json, "atRest", now.at_rest);
    truth(json, "seeking", now.seeking);
    truth(json, "active", skv_stage_is_active(stage));
    truth(json, "canUndo", now.can_undo);
    truth(json, "canRedo", now.can_redo);
    truth(json, "following", picture->following);
    truth(json, "watching", picture->watching);
    number(json, "withheld", picture->withheld);
    text(json, "choice", skv_stage_choice(stage));
    truth(json, "asRecorded", picture->as_recorded);
    truth(json, "mismatch", picture->mismatch);
    number(json, "speed", picture->speed);
    number(json, "pace", now.pace);
    pair(json, "gravity", picture->tilt_x, picture->tilt_y);
    number(json, "tool", skv_stage_tool(stage));
    number(json, "brush", picture->brush);
    number(json, "dye", skv_stage_dye(stage));
    number(json, "fluid", skv_stage_fluid(stage));
    truth(json, "linked", skv_stage_linked(stage));
}

static void tell_style(GString *json, const skv_render_style *style)
{
    const skv_style_choice *choice;
    open(json, "style", '{');
    for (int i = 0; (choice = skv_style_choice_at(SKV_STYLE_VIEW, i)); i++)
        if (choice->value == (int)style->view)
            text(json, "view", choice->name);
    open(json, "overlays", '[');
    for (int i = 0; (choice = skv_style_choice_at(SKV_STYLE_OVERLAY, i)); i++)
        if (style->overlays & (unsigned)choice->value)
            text(json, NULL, choice->name);
    g_string_append_c(json, ']');
    number(json, "range", style->range);
    truth(json, "comma", style->comma);
    g_string_append_c(json, '}');
}

/* Windows. */

static const char *text_of(GtkWidget *widget)
{
    if (GTK_IS_LABEL(widget))
        return gtk_label_get_text(GTK_LABEL(widget));
    if (GTK_IS_PICTURE(widget))
        return gtk_picture_get_alternative_text(GTK_PICTURE(widget));
    return GTK_IS_EDITABLE(widget) ? gtk_editable_get_text(GTK_EDITABLE(widget)) : NULL;
}

/* What assistive technology calls it. The toolkit lends the value to tests that miss another one.
 */
static char *label_of(GtkWidget *widget)
{
    char *label = gtk_test_accessible_check_property(GTK_ACCESSIBLE(widget),
                                                     GTK_ACCESSIBLE_PROPERTY_LABEL, "");
    if (g_strcmp0(label, "undefined") == 0)
        g_clear_pointer(&label, g_free);
    return label;
}

/* Whether what was typed is said to be wrong. */
static bool is_invalid(GtkWidget *widget)
{
    char *other = gtk_test_accessible_check_state(
        GTK_ACCESSIBLE(widget), GTK_ACCESSIBLE_STATE_INVALID, GTK_ACCESSIBLE_INVALID_TRUE);
    g_free(other);
    return !other;
}

/* Whether a click on its middle is its own: while a menu turns to another page both lie there. */
static bool is_reached(GtkWidget *widget)
{
    GtkWidget *native = GTK_WIDGET(gtk_widget_get_native(widget));
    double x, y;
    gtk_widget_translate_coordinates(widget, native, gtk_widget_get_width(widget) / 2.0,
                                     gtk_widget_get_height(widget) / 2.0, &x, &y);
    GtkWidget *found = gtk_widget_pick(native, x, y, GTK_PICK_DEFAULT);
    return found && (found == widget || gtk_widget_is_ancestor(found, widget) ||
                     gtk_widget_is_ancestor(widget, found));
}

static void tell_widget(GString *json, GtkWidget *widget)
{
    const char *written = text_of(widget), *kind = G_OBJECT_TYPE_NAME(widget);
    char *label = label_of(widget);
    open(json, NULL, '{');
    text(json, "id", gtk_buildable_get_buildable_id(GTK_BUILDABLE(widget)));
    text(json, "type", kind);
    text(json, "name", label ? label : "");
    text(json, "text", written);
    truth(json, "sensitive", gtk_widget_is_sensitive(widget));
    truth(json, "active", gtk_widget_get_state_flags(widget) & GTK_STATE_FLAG_CHECKED);
    truth(json, "focus", gtk_widget_has_focus(widget));
    truth(json, "reached", is_reached(widget));
    if (GTK_IS_EDITABLE(widget))
        truth(json, "invalid", is_invalid(widget));
    if (GTK_IS_RANGE(widget))
        number(json, "value", gtk_range_get_value(GTK_RANGE(widget)));
    rectangle(json, widget);
    g_string_append_c(json, '}');
    g_free(label);
}

/* A widget that shows, and after it all in it. */
static void tell_widgets(GString *json, GtkWidget *widget)
{
    if (!gtk_widget_get_mapped(widget))
        return;
    tell_widget(json, widget);
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child;
         child = gtk_widget_get_next_sibling(child))
        tell_widgets(json, child);
}

static void tell_window(GString *json, GtkWindow *window)
{
    GdkSurface *surface = gtk_native_get_surface(GTK_NATIVE(window));
    open(json, NULL, '{');
    text(json, "title", gtk_window_get_title(window));
    truth(json, "focus", gtk_window_is_active(window));
    truth(json, "fullscreen", gtk_window_is_fullscreen(window));
    if (GDK_IS_X11_SURFACE(surface))
        number(json, "xid", (double)gdk_x11_surface_get_xid(surface));
    number(json, "width", gdk_surface_get_width(surface));
    number(json, "height", gdk_surface_get_height(surface));
    number(
        json, "frames",
        (double)gdk_frame_clock_get_frame_counter(gtk_widget_get_frame_clock(GTK_WIDGET(window))));
    open(json, "widgets", '[');
    tell_widgets(json, GTK_WIDGET(window));
    g_string_append(json, "]}");
}

static void tell_app(GString *json, PlayWindow *window)
{
    PlayView *view = play_window_view(window), *twin = play_view_twin(view);
    tell_stage(json, view);
    tell_style(json, play_view_style(view));
    text(json, "page", play_window_page(window));
    open(json, "worlds", '[');
    tell_world(json, view);
    if (twin)
        tell_world(json, twin);
    g_string_append_c(json, ']');
}

/* How many clicks buttons have had. */
static guint clicks;

static gboolean count_click(G_GNUC_UNUSED GSignalInvocationHint *hint, G_GNUC_UNUSED guint count,
                            G_GNUC_UNUSED const GValue *values, G_GNUC_UNUSED gpointer data)
{
    clicks++;
    return TRUE;
}

/* How many presses of mouse buttons have come from the X server to their end, whatever the toolkit
 * makes of them. */
static guint presses;

static gboolean count_press(G_GNUC_UNUSED GdkDisplay *display, const XEvent *event,
                            G_GNUC_UNUSED gpointer data)
{
    presses += event->type == GenericEvent && event->xcookie.evtype == XI_ButtonRelease;
    return GDK_EVENT_PROPAGATE;
}

/* The app's own window first. What it tells the display knows, too: else keys could still go to a
 * menu of which it tells that it is closed. */
static char *state(void)
{
    gdk_display_flush(gdk_display_get_default());
    GString *json = g_string_new("{");
    number(json, "clicks", clicks);
    number(json, "presses", presses);
    GList *windows = gtk_window_list_toplevels();
    for (GList *one = windows; one; one = one->next)
        if (PLAY_IS_WINDOW(one->data) && gtk_widget_get_mapped(one->data))
            tell_app(json, one->data);
    open(json, "windows", '[');
    for (int other = 0; other < 2; other++)
        for (GList *one = windows; one; one = one->next)
            if (gtk_widget_get_mapped(one->data) && PLAY_IS_WINDOW(one->data) == !other)
                tell_window(json, one->data);
    g_string_append(json, "]}\n");
    g_list_free(windows);
    return g_string_free(json, FALSE);
}

/* Answering. */

/* A frame of each window, though nothing in it changes. */
static void ask_for_frames(void)
{
    GList *windows = gtk_window_list_toplevels();
    for (GList *one = windows; one; one = one->next)
        if (gtk_widget_get_mapped(one->data))
            gdk_frame_clock_request_phase(gtk_widget_get_frame_clock(one->data),
                                          GDK_FRAME_CLOCK_PHASE_PAINT);
    g_list_free(windows);
}

static void on_line(GObject *lines, GAsyncResult *result, gpointer data)
{
    GIOStream *caller = data;
    char *line =
        g_data_input_stream_read_line_finish(G_DATA_INPUT_STREAM(lines), result, NULL, NULL);
    if (line && *line)
        ask_for_frames();
    char *answer = line ? state() : NULL;
    if (answer && g_output_stream_write_all(g_io_stream_get_output_stream(caller), answer,
                                            strlen(answer), NULL, NULL, NULL))
        g_data_input_stream_read_line_async(G_DATA_INPUT_STREAM(lines), G_PRIORITY_DEFAULT, NULL,
                                            on_line, caller);
    else
        g_object_unref(lines);
    g_free(answer);
    g_free(line);
}

static gboolean on_caller(G_GNUC_UNUSED GSocketService *service, GSocketConnection *caller,
                          G_GNUC_UNUSED GObject *source, G_GNUC_UNUSED gpointer data)
{
    GDataInputStream *lines =
        g_data_input_stream_new(g_io_stream_get_input_stream(G_IO_STREAM(caller)));
    static bool counts;
    GdkDisplay *known = gdk_display_get_default();
    if (!counts && GDK_IS_X11_DISPLAY(known))
        g_signal_connect(known, "xevent", G_CALLBACK(count_press), NULL);
    counts = true;
    g_object_set_data_full(G_OBJECT(lines), "caller", g_object_ref(caller), g_object_unref);
    g_data_input_stream_read_line_async(lines, G_PRIORITY_DEFAULT, NULL, on_line, caller);
    return TRUE;
}

/* No tooltip shows: on X11 a click gets lost when one is just coming up. */
static gboolean hide_tooltip(G_GNUC_UNUSED GtkWidget *widget, G_GNUC_UNUSED int x,
                             G_GNUC_UNUSED int y, G_GNUC_UNUSED gboolean by_keyboard,
                             G_GNUC_UNUSED GtkTooltip *tooltip)
{
    return FALSE;
}

/* A toast that goes by itself would be gone when a busy machine comes to look: the newest shows,
 * until another comes or it is pressed. */
void __wrap_adw_toast_overlay_add_toast(AdwToastOverlay *overlay, AdwToast *toast);
void __real_adw_toast_overlay_add_toast(AdwToastOverlay *overlay, AdwToast *toast);
void __wrap_adw_toast_overlay_add_toast(AdwToastOverlay *overlay, AdwToast *toast)
{
    adw_toast_set_timeout(toast, 0);
    adw_toast_set_priority(toast, ADW_TOAST_PRIORITY_HIGH);
    __real_adw_toast_overlay_add_toast(overlay, toast);
}

/* After each frame: waits until another may be drawn. */
static gboolean wait_for_frame(G_GNUC_UNUSED GSignalInvocationHint *hint, G_GNUC_UNUSED guint count,
                               G_GNUC_UNUSED const GValue *values, G_GNUC_UNUSED gpointer data)
{
    static gint64 last; /* us */
    gint64 left = last + FRAME - g_get_monotonic_time();
    if (left > 0)
        g_usleep((gulong)left);
    last = g_get_monotonic_time();
    return TRUE;
}

/* The toolkit warns of a widget, by its address, that it draws before it has given it a place: here
 * with all that it is in. GTK 4.8 does so itself with the two arrows of the path bar in its dialog
 * of files, if that is drawn before the folder's name has been read from the disk. */
static GLogWriterOutput write_log(GLogLevelFlags level, const GLogField *fields, gsize count,
                                  G_GNUC_UNUSED gpointer data)
{
    const char *message = "";
    void *address = NULL;
    for (gsize i = 0; i < count; i++)
        if (g_str_equal(fields[i].key, "MESSAGE"))
            message = fields[i].value;
    if (sscanf(message, "Trying to snapshot %*s %p without a current allocation", &address) == 1) {
        GtkWidget *parent = gtk_widget_get_parent(address);
        if (parent && g_str_equal(G_OBJECT_TYPE_NAME(parent), "GtkPathBar"))
            return G_LOG_WRITER_HANDLED;
        for (GtkWidget *one = address; one; one = gtk_widget_get_parent(one))
            fprintf(stderr, "in %s: ", G_OBJECT_TYPE_NAME(one));
    }
    return g_log_writer_default(level, fields, count, NULL);
}

/* The worlds of the app are small here, and many programs run at once: one thread computes each. */
int __wrap_skv_platform_cores(void);
int __wrap_skv_platform_cores(void)
{
    return 1;
}

/* The app's own threads that were started and not joined. The linker takes calls in GLib for calls
 * of these, which therefore can't be hidden. */
static gint threads;
#pragma GCC visibility push(default)

GThread *__real_g_thread_new(const gchar *name, GThreadFunc work, gpointer data);
GThread *__wrap_g_thread_new(const gchar *name, GThreadFunc work, gpointer data);
GThread *__wrap_g_thread_new(const gchar *name, GThreadFunc work, gpointer data)
{
    g_atomic_int_inc(&threads);
    return __real_g_thread_new(name, work, data);
}

gpointer __real_g_thread_join(GThread *thread);
gpointer __wrap_g_thread_join(GThread *thread);
gpointer __wrap_g_thread_join(GThread *thread)
{
    g_atomic_int_add(&threads, -1);
    return __real_g_thread_join(thread);
}

#pragma GCC visibility pop

/* One that outlives main may draw with what its end takes from it: that goes wrong seldom, but here
 * it is told. */
__attribute__((destructor)) static void end(void)
{
    if (g_atomic_int_get(&threads) > 0)
        fprintf(stderr, "CRITICAL: the app ended before %d of its threads\n", threads);
}

/* Before main, which knows nothing of it, and before classes of widgets copy what this one does. */
__attribute__((constructor)) static void begin(void)
{
    const char *path = g_getenv("SKVALP_DOOR");
    if (!path)
        return;
    GSocketService *service = g_socket_service_new();
    GSocketAddress *address = g_unix_socket_address_new(path);
    GError *error = NULL;
    g_unlink(path);
    if (!g_socket_listener_add_address(G_SOCKET_LISTENER(service), address, G_SOCKET_TYPE_STREAM,
                                       G_SOCKET_PROTOCOL_DEFAULT, NULL, NULL, &error))
        g_error("no door at %s: %s", path, error->message);
    g_signal_connect(service, "incoming", G_CALLBACK(on_caller), NULL);
    g_object_unref(address);
    GTK_WIDGET_CLASS(g_type_class_ref(GTK_TYPE_WIDGET))->query_tooltip = hide_tooltip;
    g_log_set_writer_func(write_log, NULL, NULL);
    g_type_class_ref(GDK_TYPE_FRAME_CLOCK);
    g_signal_add_emission_hook(g_signal_lookup("after-paint", GDK_TYPE_FRAME_CLOCK), 0,
                               wait_for_frame, NULL, NULL);
    g_type_class_ref(GTK_TYPE_BUTTON);
    g_signal_add_emission_hook(g_signal_lookup("clicked", GTK_TYPE_BUTTON), 0, count_click, NULL,
                               NULL);
}
