/* View: lets time pass for the session by the frame clock, and draws its newest picture. Invariant:
 * the frame clock ticks for this view only while the session is active, so that a scene that is
 * paused or at rest costs nothing; a picture is drawn again only if there is a newer one. A frame
 * clock that always has something to draw keeps the main loop from all that is idle, assistive
 * technology first: so the ticks end now and then, until the loop has been idle once.
 */
#include "view.h"

#include "words.h"

#define STATUS_PERIOD  0.1
#define TICKS_IN_A_ROW 30 /* without an idle main loop */

struct _PlayView {
    GtkGLArea parent;
    skv_session *session;
    const skv_picture *picture; /* that is shown, held */
    skv_renderer *renderer;
    skv_render_style style;
    skv_camera camera;
    guint tick; /* 0: nothing moves, or the main loop has its turn */
    guint idle; /* the source that tells that the loop was idle; 0: none waits */
    int ticks;  /* since then */
    gint woken; /* the session's thread has news, and the main loop knows */
    gint64 last_tick;
    double drawing; /* s, that the last picture took */
    PlayView *twin; /* the view beside; null: none */
    skv_pair *pair; /* of both */
    bool follows;   /* time passes by the other one */
    bool alone;     /* fingers are here only */

    gint64 measured_since;
    int pictures; /* since then */
    double frame_rate;
};

G_DEFINE_FINAL_TYPE(PlayView, play_view, GTK_TYPE_GL_AREA)

static guint changed_signal, failed_signal, opened_signal, saved_signal, shared_signal;

static void changed(PlayView *view)
{
    g_signal_emit(view, changed_signal, 0);
}

/* Drawing. */

static void fail_with(PlayView *view, const char *text)
{
    GError *error = g_error_new_literal(GDK_GL_ERROR, GDK_GL_ERROR_NOT_AVAILABLE, text);
    gtk_gl_area_set_error(GTK_GL_AREA(view), error);
    g_error_free(error);
}

static void realize(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(play_view_parent_class)->realize(widget);
    PlayView *view = PLAY_VIEW(widget);
    gtk_gl_area_make_current(GTK_GL_AREA(view));
    if (gtk_gl_area_get_error(GTK_GL_AREA(view)))
        return;
    skv_error error;
    if (skv_renderer_create(&view->renderer, &error) != SKV_OK)
        fail_with(view, error.text);
}

static void unrealize(GtkWidget *widget)
{
    PlayView *view = PLAY_VIEW(widget);
    gtk_gl_area_make_current(GTK_GL_AREA(view));
    g_clear_pointer(&view->renderer, skv_renderer_destroy);
    GTK_WIDGET_CLASS(play_view_parent_class)->unrealize(widget);
}

/* The camera stays where it looks while the view or the world changes its size. */
static void update_camera(PlayView *view, int width, int height)
{
    skv_camera fit = skv_session_camera(view->session);
    const skv_camera *old = &view->camera;
    if (old->world_width == fit.world_width && old->world_height == fit.world_height)
        view->camera = skv_camera_at(width, height, fit.world_width, fit.world_height,
                                     old->centre_x, old->centre_y, old->zoom);
    else
        view->camera = fit;
}

static void resize(GtkGLArea *area, int width, int height)
{
    PlayView *view = PLAY_VIEW(area);
    skv_session_set_view(view->session, width, height);
    update_camera(view, width, height);
}

static gboolean render(GtkGLArea *area, G_GNUC_UNUSED GdkGLContext *context)
{
    PlayView *view = PLAY_VIEW(area);
    const skv_picture *picture = view->picture;
    if (!view->renderer || picture->opened == 0)
        return FALSE;
    gint64 before = g_get_monotonic_time();
    skv_error error;
    if (skv_renderer_draw(view->renderer, &picture->frame, &view->camera, &view->style,
                          picture->marks, picture->mark_count, &error) != SKV_OK)
        fail_with(view, error.text);
    view->drawing = (double)(g_get_monotonic_time() - before) / G_USEC_PER_SEC;
    view->pictures++;
    return TRUE;
}

/* Playing. */

/* Takes the newest picture; draws it if it is another one. */
static void look(PlayView *view)
{
    const skv_picture *before = view->picture;
    guint64 number = before->number;
    view->picture = skv_session_acquire(view->session);
    skv_session_release(view->session, before);
    if (view->picture->number == number)
        return;
    update_camera(view, view->camera.width, view->camera.height);
    gtk_gl_area_queue_render(GTK_GL_AREA(view));
}

static void measure_frame_rate(PlayView *view, gint64 now)
{
    double seconds = (double)(now - view->measured_since) / G_USEC_PER_SEC;
    if (seconds < STATUS_PERIOD)
        return;
    view->frame_rate = view->pictures / seconds;
    view->measured_since = now;
    view->pictures = 0;
    changed(view);
}

static void update_tick(PlayView *view);

static gboolean on_idle(gpointer data)
{
    PlayView *view = data;
    view->idle = 0;
    view->ticks = 0;
    update_tick(view);
    if (!view->tick) /* it has come to rest meanwhile */
        changed(view);
    return G_SOURCE_REMOVE;
}

/* Whether the main loop has to be idle before the next tick. */
static bool is_overdue(PlayView *view)
{
    if (!view->idle)
        view->idle = g_idle_add_full(G_PRIORITY_LOW, on_idle, view, NULL);
    return ++view->ticks > TICKS_IN_A_ROW;
}

static gboolean on_tick(GtkWidget *widget, GdkFrameClock *clock, G_GNUC_UNUSED gpointer data)
{
    PlayView *view = PLAY_VIEW(widget);
    gint64 now = gdk_frame_clock_get_frame_time(clock);
    double seconds = (double)(now - view->last_tick) / G_USEC_PER_SEC;
    view->last_tick = now;
    if (view->pair && !skv_pair_is_active(view->pair)) {
        view->tick = 0;
        view->frame_rate = 0;
        changed(view);
        return G_SOURCE_REMOVE;
    }
    if (view->pair)
        skv_pair_advance(view->pair, seconds, view->drawing + view->twin->drawing);
    else
        skv_session_advance(view->session, seconds, view->drawing);
    look(view);
    measure_frame_rate(view, now);
    if (!is_overdue(view))
        return G_SOURCE_CONTINUE;
    view->tick = 0;
    return G_SOURCE_REMOVE;
}

/* Starts or stops the frame clock for this view, whichever the session asks for. */
static void update_tick(PlayView *view)
{
    if (view->twin && view->follows) {
        update_tick(view->twin);
        return;
    }
    bool active =
        view->pair ? skv_pair_is_active(view->pair) : skv_session_is_active(view->session);
    active = active && view->ticks <= TICKS_IN_A_ROW;
    if (active && !view->tick) {
        gint64 now = g_get_monotonic_time();
        if (now - view->last_tick > G_USEC_PER_SEC / 4) /* it rested: not the loop's turn alone */
            view->last_tick = view->measured_since = now;
        view->tick = gtk_widget_add_tick_callback(GTK_WIDGET(view), on_tick, NULL, NULL);
    } else if (!active && view->tick) {
        gtk_widget_remove_tick_callback(GTK_WIDGET(view), view->tick);
        view->tick = 0;
        view->frame_rate = 0;
    }
}

static void take_outcomes(PlayView *view)
{
    skv_outcome outcome;
    while (skv_session_next_outcome(view->session, &outcome)) {
        bool failed = outcome.error.code != SKV_OK;
        if (outcome.kind == SKV_OUTCOME_SAVE)
            g_signal_emit(view, saved_signal, 0, failed ? outcome.error.text : NULL);
        else if (outcome.kind == SKV_OUTCOME_SHARE)
            g_signal_emit(view, shared_signal, 0, failed ? outcome.error.text : NULL);
        else if (failed)
            g_signal_emit(view, failed_signal, 0, outcome.error.text);
        else if (outcome.kind == SKV_OUTCOME_OPEN)
            g_signal_emit(view, opened_signal, 0);
    }
}

/* The session's news, on the main loop. */
static gboolean on_news(gpointer data)
{
    PlayView *view = data;
    g_atomic_int_set(&view->woken, 0);
    bool moved = view->tick != 0;
    look(view);
    take_outcomes(view);
    update_tick(view);
    if (moved && view->tick) /* a few times a second will do */
        return G_SOURCE_REMOVE;
    changed(view);
    if (view->twin && view->follows) /* what can be undone is said for both */
        changed(view->twin);
    return G_SOURCE_REMOVE;
}

/* On the session's thread. */
static void wake(void *user)
{
    PlayView *view = user;
    if (g_atomic_int_compare_and_exchange(&view->woken, 0, 1))
        g_idle_add_full(G_PRIORITY_DEFAULT, on_news, view, NULL);
}

skv_session *play_view_session(PlayView *view)
{
    return view->session;
}

const skv_picture *play_view_picture(PlayView *view)
{
    return view->picture;
}

const skv_render_style *play_view_style(PlayView *view)
{
    return &view->style;
}

static void set_style(PlayView *view, const skv_render_style *style)
{
    view->style = *style;
    gtk_gl_area_queue_render(GTK_GL_AREA(view));
    changed(view);
}

void play_view_set_style(PlayView *view, const skv_render_style *style)
{
    set_style(view, style);
    if (view->twin)
        set_style(view->twin, style);
}

skv_camera play_view_camera(PlayView *view)
{
    return view->camera;
}

/* The view beside shows the same part of its world. */
static void camera_changed(PlayView *view)
{
    PlayView *twin = view->twin;
    gtk_gl_area_queue_render(GTK_GL_AREA(view));
    changed(view);
    if (!twin)
        return;
    const skv_camera *own = &view->camera, *other = &twin->camera;
    twin->camera = skv_camera_at(other->width, other->height, other->world_width,
                                 other->world_height, own->centre_x, own->centre_y, own->zoom);
    gtk_gl_area_queue_render(GTK_GL_AREA(twin));
    changed(twin);
}

void play_view_zoom(PlayView *view, double factor, double px, double py)
{
    skv_camera_zoom(&view->camera, factor, px, py);
    camera_changed(view);
}

void play_view_pan(PlayView *view, double dx, double dy)
{
    skv_camera_pan(&view->camera, dx, dy);
    camera_changed(view);
}

void play_view_show_all(PlayView *view)
{
    view->camera = skv_session_camera(view->session);
    camera_changed(view);
}

/* A session's camera shows the whole world; that of a view perhaps a part of it. */
static void send(PlayView *view, const skv_pointer_event *event, double x, double y)
{
    skv_pointer_event sent = *event;
    skv_camera whole = skv_session_camera(view->session);
    skv_camera_to_view(&whole, x, y, &sent.px, &sent.py);
    skv_session_pointer(view->session, &sent);
}

void play_view_send(PlayView *view, const skv_pointer_event *event)
{
    double x, y;
    skv_camera_to_world(&view->camera, event->px, event->py, &x, &y);
    send(view, event, x, y);
    if (view->twin && !view->alone)
        send(view->twin, event, x, y);
}

void play_view_join(PlayView *view, PlayView *twin, skv_pair *pair)
{
    PlayView *other = twin ? twin : view->twin;
    view->twin = twin;
    view->pair = pair;
    if (other) {
        other->twin = twin ? view : NULL;
        other->pair = pair;
        other->follows = twin != NULL;
        other->alone = view->alone;
        if (other->tick)
            gtk_widget_remove_tick_callback(GTK_WIDGET(other), other->tick);
        other->tick = 0;
        if (twin)
            set_style(twin, &view->style);
    }
    update_tick(view);
    camera_changed(view);
}

PlayView *play_view_twin(PlayView *view)
{
    return view->twin;
}

gboolean play_view_follows(PlayView *view)
{
    return view->twin && view->follows;
}

skv_pair *play_view_pair(PlayView *view)
{
    return view->pair;
}

void play_view_cancel(PlayView *view)
{
    skv_session_cancel_pointers(view->session);
    if (view->twin && !view->alone)
        skv_session_cancel_pointers(view->twin->session);
}

void play_view_set_linked(PlayView *view, gboolean linked)
{
    view->alone = false;
    play_view_cancel(view);
    view->alone = !linked;
    if (view->twin)
        view->twin->alone = !linked;
}

gboolean play_view_is_linked(PlayView *view)
{
    return !view->alone;
}

double play_view_frame_rate(PlayView *view)
{
    return view->frame_rate;
}

static void finalize(GObject *object)
{
    PlayView *view = PLAY_VIEW(object);
    if (view->session && view->picture)
        skv_session_release(view->session, view->picture);
    skv_session_destroy(view->session);
    while (g_idle_remove_by_data(view))
        continue;
    G_OBJECT_CLASS(play_view_parent_class)->finalize(object);
}

static void play_view_class_init(PlayViewClass *class)
{
    G_OBJECT_CLASS(class)->finalize = finalize;
    GTK_WIDGET_CLASS(class)->realize = realize;
    GTK_WIDGET_CLASS(class)->unrealize = unrealize;
    GTK_GL_AREA_CLASS(class)->resize = resize;
    GTK_GL_AREA_CLASS(class)->render = render;
    changed_signal = g_signal_new("changed", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                  G_TYPE_NONE, 0);
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_IMG);
    failed_signal = g_signal_new("failed", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                 G_TYPE_NONE, 1, G_TYPE_STRING);
    saved_signal = g_signal_new("saved", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                G_TYPE_NONE, 1, G_TYPE_STRING);
    shared_signal = g_signal_new("shared", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                 G_TYPE_NONE, 1, G_TYPE_STRING);
    opened_signal = g_signal_new("opened", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                 G_TYPE_NONE, 0);
}

static void play_view_init(PlayView *view)
{
    skv_error error;
    skv_stage_def def = skv_default_stage_def();
    def.wake = wake;
    def.user = view;
    if (skv_session_create(&def, &view->session, &error) != SKV_OK)
        g_error("%s", error.text); /* out of memory before anything was shown */
    view->picture = skv_session_acquire(view->session);
    view->style = skv_default_render_style();
    view->camera = skv_session_camera(view->session);
    gtk_gl_area_set_use_es(GTK_GL_AREA(view), TRUE);
    gtk_gl_area_set_required_version(GTK_GL_AREA(view), 3, 0);
    gtk_gl_area_set_auto_render(GTK_GL_AREA(view), FALSE);
    gtk_widget_set_focusable(GTK_WIDGET(view), TRUE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(view), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Water"),
                                   GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   _("Drag to use the tool that is chosen"), -1);
    gtk_widget_set_hexpand(GTK_WIDGET(view), TRUE);
    gtk_widget_set_vexpand(GTK_WIDGET(view), TRUE);
}
