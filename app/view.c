/* View: lets time pass for the stage by the frame clock, and draws the newest picture of a side of
 * it. Invariant: the frame clock ticks for the first side's view only, and only while the stage is
 * active, so that a scene that is paused or at rest costs nothing; a picture is drawn again only if
 * there is a newer one. A frame clock that always has something to draw keeps the main loop from
 * all that is idle, assistive technology first: so the ticks end now and then, until the loop has
 * been idle once.
 */
#include "view.h"

#include "words.h"

#define STATUS_PERIOD  0.1
#define TICKS_IN_A_ROW 30 /* without an idle main loop */

struct _PlayView {
    GtkGLArea parent;
    skv_stage *stage; /* the first side's view's own */
    PlayView *twin;   /* the view of the other side; null: none */
    gboolean follows; /* it is the second */
    skv_renderer *renderer;
    skv_render_style style;
    skv_camera camera;
    guint tick;       /* 0: nothing moves, or the main loop has its turn */
    guint idle;       /* the source that tells that the loop was idle; 0: none waits */
    int ticks;        /* since then */
    unsigned offered; /* by the newest pictures */
    gint woken;       /* the stage has news, and the main loop knows */
    gint64 last_tick;
    double drawing; /* s, that the last picture took */

    gint64 measured_since;
    int pictures; /* since then */
    double frame_rate;
};

G_DEFINE_FINAL_TYPE(PlayView, play_view, GTK_TYPE_GL_AREA)

static guint changed_signal, failed_signal, opened_signal, saved_signal, shared_signal,
    compared_signal;

static void changed(PlayView *view)
{
    g_signal_emit(view, changed_signal, 0);
}

static void both_changed(PlayView *view)
{
    changed(view);
    if (view->twin)
        changed(view->twin);
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
    PlayView *view = PLAY_VIEW(area);
    skv_stage_set_view(view->stage, view->follows, width, height);
    view->camera = skv_stage_camera(view->stage, view->follows);
}

static gboolean render(GtkGLArea *area, G_GNUC_UNUSED GdkGLContext *context)
{
    PlayView *view = PLAY_VIEW(area);
    const skv_picture *picture = play_view_picture(view);
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

static bool shows_else(const skv_camera *before, const skv_camera *after)
{
    return before->zoom != after->zoom || before->centre_x != after->centre_x ||
           before->centre_y != after->centre_y;
}

/* Draws the newest picture if it is another one, or is seen otherwise. */
static void show(PlayView *view)
{
    skv_camera before = view->camera;
    view->camera = skv_stage_camera(view->stage, view->follows);
    gtk_gl_area_queue_render(GTK_GL_AREA(view));
    if (shows_else(&before, &view->camera))
        changed(view);
}

/* What can be undone and redone. */
static unsigned offers(const skv_stage *stage)
{
    skv_stage_state now = skv_stage_now(stage);
    return (unsigned)now.can_undo | (unsigned)now.can_redo << 1;
}

/* Takes the newest pictures, of both sides. What they offer is told at once, for a key that is
 * pressed before that does nothing. */
static void look(PlayView *view)
{
    unsigned sides = skv_stage_look(view->stage), offered = view->offered;
    if (sides & 1)
        show(view);
    if (sides & 2 && view->twin)
        show(view->twin);
    view->offered = offers(view->stage);
    if (view->offered != offered)
        both_changed(view);
}

static void measure_frame_rate(PlayView *view, gint64 now)
{
    double seconds = (double)(now - view->measured_since) / G_USEC_PER_SEC;
    if (seconds < STATUS_PERIOD)
        return;
    view->frame_rate = view->pictures / seconds;
    view->measured_since = now;
    view->pictures = 0;
    both_changed(view);
}

static void update_tick(PlayView *view);

static gboolean on_idle(gpointer data)
{
    PlayView *view = data;
    view->idle = 0;
    view->ticks = 0;
    update_tick(view);
    if (!view->tick) /* it has come to rest meanwhile */
        both_changed(view);
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
    if (!skv_stage_is_active(view->stage)) { /* two worlds come to rest between their news */
        view->tick = 0;
        view->frame_rate = 0;
        both_changed(view);
        return G_SOURCE_REMOVE;
    }
    skv_stage_advance(view->stage, seconds, view->drawing + (view->twin ? view->twin->drawing : 0));
    look(view);
    measure_frame_rate(view, now);
    if (!is_overdue(view))
        return G_SOURCE_CONTINUE;
    view->tick = 0;
    return G_SOURCE_REMOVE;
}

/* Starts or stops the frame clock, whichever the stage asks for. */
static void update_tick(PlayView *view)
{
    bool active = skv_stage_is_active(view->stage) && view->ticks <= TICKS_IN_A_ROW;
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
    while (skv_stage_next_outcome(view->stage, &outcome)) {
        bool failed = outcome.error.code != SKV_OK;
        if (outcome.kind == SKV_OUTCOME_SAVE)
            g_signal_emit(view, saved_signal, 0, failed ? outcome.error.text : NULL);
        else if (outcome.kind == SKV_OUTCOME_SHARE)
            g_signal_emit(view, shared_signal, 0, failed ? outcome.error.text : NULL);
        else if (outcome.kind == SKV_OUTCOME_COMPARE)
            g_signal_emit(view, compared_signal, 0, failed ? outcome.error.text : NULL);
        else if (failed)
            g_signal_emit(view, failed_signal, 0, outcome.error.text);
        else if (outcome.kind == SKV_OUTCOME_OPEN)
            g_signal_emit(view, opened_signal, 0);
    }
}

/* The stage's news, on the main loop. */
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
    both_changed(view);
    return G_SOURCE_REMOVE;
}

/* On a world's thread. */
static void wake(void *user)
{
    PlayView *view = user;
    if (g_atomic_int_compare_and_exchange(&view->woken, 0, 1))
        g_idle_add_full(G_PRIORITY_DEFAULT, on_news, view, NULL);
}

skv_stage *play_view_stage(PlayView *view)
{
    return view->stage;
}

int play_view_side(PlayView *view)
{
    return view->follows;
}

const skv_picture *play_view_picture(PlayView *view)
{
    return skv_stage_picture(view->stage, view->follows);
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

void play_view_begin(PlayView *view, PlayView *first)
{
    skv_error error;
    skv_stage_def def = skv_default_stage_def();
    def.wake = wake;
    def.margin = skv_control_limits()->margin;
    def.user = view;
    if (first)
        view->stage = first->stage;
    else if (skv_stage_create(&def, &view->stage, &error) != SKV_OK)
        g_error("%s", error.text); /* out of memory before anything was shown */
    view->camera = skv_stage_camera(view->stage, first != NULL);
    if (!first)
        return;
    view->follows = TRUE;
    view->twin = first;
    first->twin = view;
    set_style(view, &first->style);
}

void play_view_end_twin(PlayView *view)
{
    view->twin->twin = NULL;
    view->twin = NULL;
}

PlayView *play_view_twin(PlayView *view)
{
    return view->twin;
}

double play_view_frame_rate(PlayView *view)
{
    return view->frame_rate;
}

static void finalize(GObject *object)
{
    PlayView *view = PLAY_VIEW(object);
    if (!view->follows)
        skv_stage_destroy(view->stage);
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
    compared_signal = g_signal_new("compared", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                                   NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
    opened_signal = g_signal_new("opened", PLAY_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                 G_TYPE_NONE, 0);
}

static void play_view_init(PlayView *view)
{
    view->style = skv_default_render_style();
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
