/* Going on: what somebody did is written every half minute, and when the window closes; what
 * windows have left behind is offered, the newest first, and never opened unasked. Invariant: a
 * window writes to a file that no other writes to (kept.c), and who goes on where another stopped
 * leaves behind what this window had; what is damaged is said, and set aside.
 */
#include "resume.h"

#include "kept.h"
#include "saving.h"
#include "words.h"

#define PERIOD     30  /* s */
#define PATIENCE   250 /* ms that a frame may take for one more file when all closes */
#define OFFER_TIME 20  /* s */

typedef struct resume {
    PlayWindow *window;
    PlayKept *kept;
    guint timer;
    guint64 written; /* number of the picture that was kept last */
    int opening;     /* place of what is being opened; 0: none */
    bool told;       /* that it cannot be written */
} resume;

static resume *resume_of(PlayWindow *window)
{
    return g_object_get_data(G_OBJECT(window), "resume");
}

/* Keeping. */

static const skv_picture *picture_of(const resume *r)
{
    return play_view_picture(play_window_view(r->window));
}

/* Whether there is anything that would be missed, and was not written yet. */
static bool is_worth_it(const resume *r)
{
    return picture_of(r)->number != r->written &&
           skv_control_would_be_missed(play_view_stage(play_window_view(r->window)));
}

static void on_kept(PlayWindow *window, const char *path, const char *cause, gpointer closes)
{
    resume *r = resume_of(window);
    if (cause && !r->told)
        play_saving_tell(window, path, cause);
    r->told |= cause != NULL;
    if (closes)
        play_saving_release(window);
}

static void keep(resume *r, gboolean closes)
{
    r->written = picture_of(r)->number;
    play_kept_name(r->kept, picture_of(r)->title);
    if (closes)
        play_saving_hold(r->window);
    play_saving_ask(r->window, play_kept_path(r->kept), on_kept, GINT_TO_POINTER(closes));
}

static gboolean on_time(gpointer data)
{
    if (is_worth_it(data))
        keep(data, FALSE);
    return G_SOURCE_CONTINUE;
}

/* Nobody waits for a frame that takes seconds: what was kept last has to do. */
static gboolean on_close(PlayWindow *window)
{
    resume *r = resume_of(window);
    if (is_worth_it(r) && picture_of(r)->step_ms < PATIENCE)
        keep(r, TRUE);
    return GDK_EVENT_PROPAGATE;
}

/* Going on. */

static void update(const resume *r)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(r->window), "go-on");
    g_simple_action_set_enabled(G_SIMPLE_ACTION(action), play_kept_left(r->kept) != 0);
}

/* What the window has is written before, to the place that it had so far. */
static void on_go_on(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                     gpointer window)
{
    resume *r = resume_of(window);
    int place = play_kept_left(r->kept);
    if (r->opening || place == 0 || !play_kept_hold(r->kept, place))
        return;
    if (is_worth_it(r))
        keep(r, FALSE);
    char *title = play_kept_title_at(r->kept, place), *path = play_kept_path_at(r->kept, place);
    if (play_saving_open(window, path, *title ? title : _("Where you were")))
        r->opening = place;
    g_free(title);
    g_free(path);
}

static void on_opened(G_GNUC_UNUSED PlayView *view, resume *r)
{
    if (r->opening)
        play_kept_move(r->kept, r->opening);
    r->opening = 0;
    update(r);
}

/* After the window has said what is wrong with it: what becomes of it matters more. */
static void on_failed(G_GNUC_UNUSED PlayView *view, G_GNUC_UNUSED const char *error, resume *r)
{
    if (!r->opening)
        return;
    char *aside = play_kept_set_aside(r->kept, r->opening);
    r->opening = 0;
    char *text =
        g_strdup_printf(_("What was kept from last time is damaged; it is now %s."), aside);
    play_window_complain(r->window, text);
    update(r);
    g_free(text);
    g_free(aside);
}

static void offer(const resume *r, int place)
{
    char *title = play_kept_title_at(r->kept, place);
    char *text = *title ? g_strdup_printf(_("Kept: %s"), play_word(title))
                        : g_strdup(_("Your last world was kept"));
    char *escaped = g_markup_escape_text(text, -1);
    AdwToast *toast = adw_toast_new(escaped);
    g_object_set(toast, "button-label", _("Go On There"), "action-name", "win.go-on", "timeout",
                 OFFER_TIME, NULL);
    play_window_add_toast(r->window, toast);
    g_free(escaped);
    g_free(text);
    g_free(title);
}

static void free_resume(gpointer data)
{
    resume *r = data;
    g_source_remove(r->timer);
    play_kept_free(r->kept);
    g_free(r);
}

void play_resume_add(PlayWindow *window, gboolean offers)
{
    static const GActionEntry entry = {.name = "go-on", .activate = on_go_on};
    PlayView *view = play_window_view(window);
    resume *r = g_new0(resume, 1);
    r->window = window;
    r->kept = play_kept_new();
    r->timer = g_timeout_add_seconds(PERIOD, on_time, r);
    g_object_set_data_full(G_OBJECT(window), "resume", r, free_resume);
    g_action_map_add_action_entries(G_ACTION_MAP(window), &entry, 1, window);
    g_signal_connect(view, "opened", G_CALLBACK(on_opened), r);
    g_signal_connect(view, "failed", G_CALLBACK(on_failed), r);
    g_signal_connect(window, "close-request", G_CALLBACK(on_close), NULL);
    int place = play_kept_left(r->kept);
    update(r);
    if (place != 0 && offers)
        offer(r, place);
}
