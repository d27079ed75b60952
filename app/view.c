/* View: drives the session by the frame clock and draws it. Invariant: the frame clock ticks for
 * this view exactly while it plays, so that a paused scene costs nothing; and while the fluid
 * sleeps the picture, which would be the same, is not drawn again. */
#include "view.h"

#include <skvalp/render.h>

/* A frame may take this long to step; a scene that needs more runs slower than real time instead
 * of making the window sluggish. */
#define STEP_BUDGET   0.030
#define STATUS_PERIOD 0.25

struct _PlayView {
    GtkGLArea parent;
    skv_session *session;
    skv_renderer *renderer;
    skv_render_style style;
    guint tick;  /* 0: not playing */
    bool asleep; /* the picture shows the fluid as it sleeps */
    gint64 last_tick;
    double frame_cost; /* seconds that one frame took to step, averaged */

    gint64 measured_since;
    int pictures; /* since then */
    double frame_rate;
};

G_DEFINE_FINAL_TYPE(PlayView, play_view, GTK_TYPE_GL_AREA)

static guint changed_signal, failed_signal;

static void changed(PlayView *view)
{
    gtk_gl_area_queue_render(GTK_GL_AREA(view));
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

static void resize(GtkGLArea *area, int width, int height)
{
    skv_session_set_view(PLAY_VIEW(area)->session, width, height);
}

static gboolean render(GtkGLArea *area, G_GNUC_UNUSED GdkGLContext *context)
{
    PlayView *view = PLAY_VIEW(area);
    const skv_world *world = skv_session_world(view->session);
    if (!view->renderer || !world)
        return FALSE;
    skv_hand hands[SKV_MAX_HANDS];
    int count = skv_session_hands(view->session, hands, SKV_MAX_HANDS);
    skv_camera camera = skv_session_camera(view->session);
    skv_error error;
    if (skv_renderer_draw(view->renderer, world, &camera, &view->style, hands, count, &error) !=
        SKV_OK)
        fail_with(view, error.text);
    view->pictures++;
    return TRUE;
}

/* Playing. */

static void measure_frame_rate(PlayView *view, gint64 now)
{
    double seconds = (double)(now - view->measured_since) / G_USEC_PER_SEC;
    if (seconds < STATUS_PERIOD)
        return;
    view->frame_rate = view->pictures / seconds;
    view->measured_since = now;
    view->pictures = 0;
    g_signal_emit(view, changed_signal, 0);
}

/* Steps the session by real time, but no more frames than fit into the budget. */
static int advance(PlayView *view, double seconds)
{
    double fitting = view->frame_cost > 0 ? floor(STEP_BUDGET / view->frame_cost) : 4;
    gint64 before = g_get_monotonic_time();
    int frames;
    skv_error error;
    if (skv_session_advance(view->session, MIN(seconds, CLAMP(fitting, 1, 4) / 60), &frames,
                            &error) != SKV_OK)
        g_signal_emit(view, failed_signal, 0, error.text);
    if (frames > 0) {
        double cost = (double)(g_get_monotonic_time() - before) / G_USEC_PER_SEC / frames;
        view->frame_cost += 0.1 * (cost - view->frame_cost);
    }
    return frames;
}

static bool is_asleep(PlayView *view)
{
    return skv_world_awake_count(skv_session_world(view->session)) == 0 &&
           skv_session_pointer_count(view->session) == 0;
}

static gboolean on_tick(GtkWidget *widget, GdkFrameClock *clock, G_GNUC_UNUSED gpointer data)
{
    PlayView *view = PLAY_VIEW(widget);
    gint64 now = gdk_frame_clock_get_frame_time(clock);
    double seconds = (double)(now - view->last_tick) / G_USEC_PER_SEC;
    view->last_tick = now;
    if (advance(view, seconds) > 0) {
        bool asleep = is_asleep(view);
        if (!asleep || !view->asleep)
            gtk_gl_area_queue_render(GTK_GL_AREA(view));
        view->asleep = asleep;
    }
    measure_frame_rate(view, now);
    if (!skv_session_paused(view->session))
        return G_SOURCE_CONTINUE;
    /* A step failed. */
    view->tick = 0;
    view->frame_rate = 0;
    changed(view);
    return G_SOURCE_REMOVE;
}

/* Starts or stops the frame clock for this view, whichever the session asks for. */
static void update_playing(PlayView *view)
{
    bool playing = skv_session_world(view->session) && !skv_session_paused(view->session);
    if (playing && !view->tick) {
        view->last_tick = view->measured_since = g_get_monotonic_time();
        view->pictures = 0;
        view->tick = gtk_widget_add_tick_callback(GTK_WIDGET(view), on_tick, NULL, NULL);
    } else if (!playing && view->tick) {
        gtk_widget_remove_tick_callback(GTK_WIDGET(view), view->tick);
        view->tick = 0;
        view->frame_rate = 0;
    }
    changed(view);
}

skv_session *play_view_session(PlayView *view)
{
    return view->session;
}

bool play_view_open(PlayView *view, const char *name_or_path, skv_error *error)
{
    if (skv_session_open(view->session, name_or_path, NULL, error) != SKV_OK)
        return false;
    view->frame_cost = 0;
    play_view_set_paused(view, false);
    return true;
}

void play_view_set_paused(PlayView *view, bool paused)
{
    skv_session_set_paused(view->session, paused);
    update_playing(view);
}

void play_view_step(PlayView *view)
{
    skv_session_set_paused(view->session, true);
    skv_error error;
    if (skv_session_step_once(view->session, &error) != SKV_OK)
        g_signal_emit(view, failed_signal, 0, error.text);
    update_playing(view);
}

bool play_view_reset(PlayView *view, skv_error *error)
{
    bool done = skv_session_reset(view->session, error) == SKV_OK;
    changed(view);
    return done;
}

void play_view_set_speed(PlayView *view, double speed)
{
    skv_session_set_speed(view->session, speed);
    changed(view);
}

void play_view_set_tracers(PlayView *view, bool tracers)
{
    view->style.tracers = tracers;
    changed(view);
}

void play_view_set_dark(PlayView *view, bool dark)
{
    view->style.dark = dark;
    changed(view);
}

void play_view_set_gravity(PlayView *view, double x, double y)
{
    skv_session_set_gravity_direction(view->session, x, y);
    changed(view);
}

double play_view_frame_rate(PlayView *view)
{
    return view->frame_rate;
}

static void finalize(GObject *object)
{
    skv_session_destroy(PLAY_VIEW(object)->session);
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
    failed_signal = g_signal_new("failed", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                 G_TYPE_NONE, 1, G_TYPE_STRING);
}

static void play_view_init(PlayView *view)
{
    skv_error error;
    if (skv_session_create(0, &view->session, &error) != SKV_OK)
        g_error("%s", error.text); /* out of memory before anything was shown */
    view->style = skv_default_render_style();
    gtk_gl_area_set_use_es(GTK_GL_AREA(view), TRUE);
    gtk_gl_area_set_required_version(GTK_GL_AREA(view), 3, 0);
    gtk_gl_area_set_auto_render(GTK_GL_AREA(view), FALSE);
    gtk_widget_set_focusable(GTK_WIDGET(view), TRUE);
    gtk_widget_set_hexpand(GTK_WIDGET(view), TRUE);
    gtk_widget_set_vexpand(GTK_WIDGET(view), TRUE);
}
