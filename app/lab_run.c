/* Lab run: the thread that runs an experiment, and the messages it sends; its set-up as a scene.
 * Invariant: what the main loop gets is a copy of its own, and not more of it than can be looked
 * at. */
#include "lab_run.h"

#include <math.h>
#include <skvalp/experiments.h>
#include <string.h>

#include "settings.h"
#include "words.h"
#include "workers.h"

#define WIDTH       480
#define MOST_CURVES 8
#define PERIOD      (G_USEC_PER_SEC / 12) /* between two messages, unless so much of it has passed: */
#define STRETCH     (1.0 / 32)            /* what is over in a moment is seen, too, up to its end */

typedef struct run {
    gint uses; /* by the thread and by messages on their way */
    int experiment, particles;
    skv_render_style style;
    GCancellable *stop;
    PlayLabShow *show;
    gpointer user;
    skv_offscreen *offscreen; /* null: none, or not yet */
    int height;
    gint64 last;
    double share; /* how far it was at the last message */
} run;

typedef struct message {
    run *of;
    PlayLabNews news;
    PlayCurve curves[MOST_CURVES];
    char *error, *results;
} message;

static void leave(run *r)
{
    if (!g_atomic_int_dec_and_test(&r->uses))
        return;
    g_object_unref(r->stop);
    g_free(r);
}

static gboolean on_message(gpointer data)
{
    message *m = data;
    if (!g_cancellable_is_cancelled(m->of->stop))
        m->of->show(&m->news, m->of->user);
    for (int i = 0; i < m->news.curve_count; i++) {
        g_free((char *)m->curves[i].label);
        g_free((double *)m->curves[i].x);
        g_free((double *)m->curves[i].y);
    }
    g_clear_object(&m->news.picture);
    g_free(m->error);
    g_free(m->results);
    leave(m->of);
    g_free(m);
    return G_SOURCE_REMOVE;
}

static message *begin(run *r, double share)
{
    message *m = g_new0(message, 1);
    g_atomic_int_inc(&r->uses);
    m->of = r;
    m->news.share = share;
    m->news.curves = m->curves;
    return m;
}

static void add_curve(message *m, const skv_curve *curve)
{
    if (m->news.curve_count == MOST_CURVES)
        return;
    PlayCurveStyle style = curve->style == SKV_CURVE_THEORY ? PLAY_CURVE_THEORY
                           : curve->style == SKV_CURVE_LINE ? PLAY_CURVE_LINE
                                                            : PLAY_CURVE_DOTS;
    size_t size = (size_t)curve->count * sizeof(double);
    m->curves[m->news.curve_count++] =
        (PlayCurve){g_strdup(play_word(curve->label)), style, curve->count,
                    g_memdup2(curve->x, size), g_memdup2(curve->y, size)};
}

static GdkTexture *draw(run *r, const skv_frame *frame)
{
    if (!r->offscreen && r->height == 0) {
        double ratio = skv_terrain_height(frame->terrain) / skv_terrain_width(frame->terrain);
        r->height = CLAMP((int)lround(WIDTH * ratio), 48, WIDTH);
        if (skv_offscreen_create(WIDTH, r->height, &r->offscreen, NULL) != SKV_OK)
            r->offscreen = NULL; /* the curves do */
    }
    if (!r->offscreen)
        return NULL;
    gsize size = (gsize)WIDTH * (gsize)r->height * 3;
    guint8 *rgb = g_malloc(size);
    if (skv_offscreen_render(r->offscreen, frame, &r->style, rgb, NULL) != SKV_OK) {
        g_free(rgb);
        return NULL;
    }
    GBytes *bytes = g_bytes_new_take(rgb, size);
    GdkTexture *texture =
        gdk_memory_texture_new(WIDTH, r->height, GDK_MEMORY_R8G8B8, bytes, (gsize)WIDTH * 3);
    g_bytes_unref(bytes);
    return texture;
}

static bool observe(const skv_lab_moment *moment, void *user)
{
    run *r = user;
    gint64 now = g_get_monotonic_time();
    if (g_cancellable_is_cancelled(r->stop))
        return false;
    if (now - r->last < PERIOD && moment->share - r->share < STRETCH)
        return true;
    r->share = moment->share;
    message *m = begin(r, moment->share);
    m->news.picture = draw(r, moment->frame);
    for (int i = 0; i < moment->curve_count; i++)
        add_curve(m, &moment->curves[i]);
    g_idle_add_full(G_PRIORITY_DEFAULT, on_message, m, NULL);
    r->last = g_get_monotonic_time(); /* so that as much time goes into stepping */
    return true;
}

static char *list_results(const skv_report *report)
{
    GString *text = g_string_new(NULL);
    const skv_lab_row *row;
    for (int i = 0; (row = skv_report_row(report, i)); i++)
        /* Translators: a quantity, its measured and its theoretical value, and their unit. */
        g_string_append_printf(text, _("%s: measured %s, theory %s %s\n"), gettext(row->quantity),
                               play_number_short(row->measured, 4).text,
                               play_number_short(row->theory, 4).text,
                               skv_unit_of(row->unit, false).name);
    if (text->len > 0)
        g_string_truncate(text, text->len - 1);
    return g_string_free(text, FALSE);
}

static gpointer work(gpointer data)
{
    run *r = data;
    skv_lab_options options = skv_default_lab_options();
    options.particles = r->particles;
    options.observe = observe;
    options.user = r;
    skv_report *report = NULL;
    skv_error error;
    skv_result result = skv_experiment_run(r->experiment, &options, &report, &error);
    message *m = begin(r, 1);
    m->news.ended = true;
    if (result == SKV_OK) {
        skv_curve curve;
        for (int i = 0; skv_report_curve(report, i, &curve); i++)
            add_curve(m, &curve);
        m->news.results = m->results = list_results(report);
        skv_report_destroy(report);
    } else {
        m->news.error = m->error = g_strdup(error.text);
    }
    skv_offscreen_destroy(r->offscreen);
    g_idle_add_full(G_PRIORITY_DEFAULT, on_message, m, NULL);
    leave(r);
    return NULL;
}

void play_lab_run(int experiment, int particles, const skv_render_style *style, GCancellable *stop,
                  PlayLabShow *show, gpointer user)
{
    run *r = g_new0(run, 1);
    *r = (run){.uses = 1,
               .experiment = experiment,
               .particles = particles,
               .style = *style,
               .stop = g_object_ref(stop),
               .show = show,
               .user = user};
    play_workers_start("experiment", work, r);
}

/* The set-up, to play with: made on a thread, opened on the main loop. */

static bool add_bytes(const char *bytes, size_t size, void *user)
{
    g_byte_array_append(user, (const guint8 *)bytes, (guint)size);
    return true;
}

static void make_set_up(GTask *task, G_GNUC_UNUSED gpointer view, gpointer name,
                        G_GNUC_UNUSED GCancellable *stop)
{
    GByteArray *bytes = g_byte_array_new();
    int found;
    if (skv_experiment_find(name, &found, NULL) == SKV_OK)
        skv_experiment_scene(found, add_bytes, bytes, NULL);
    g_task_return_pointer(task, bytes, (GDestroyNotify)g_byte_array_unref);
}

/* What is not complete is refused as what it is: a scene that cannot be read. */
static void on_set_up(GObject *view, GAsyncResult *result, G_GNUC_UNUSED gpointer user)
{
    GByteArray *bytes = g_task_propagate_pointer(G_TASK(result), NULL);
    const void *data = bytes->len > 0 ? (const void *)bytes->data : "";
    const char *name = g_task_get_task_data(G_TASK(result));
    skv_scene_options options = skv_default_scene_options();
    int found, chosen = play_settings_number("particles", 0);
    if (chosen > 0 && skv_experiment_find(name, &found, NULL) == SKV_OK)
        options.particles = skv_experiment_particles(found, chosen);
    skv_stage_open_memory(play_view_stage(PLAY_VIEW(view)), data, bytes->len, "json", name,
                          &options);
    g_byte_array_unref(bytes);
}

void play_lab_open(const char *experiment, PlayView *view)
{
    GTask *task = g_task_new(view, NULL, on_set_up, NULL);
    g_task_set_task_data(task, g_strdup(experiment), g_free);
    g_task_run_in_thread(task, make_set_up);
    g_object_unref(task);
}
