/* The face's side of a world: every call leaves a message, or reads what was published.
 *
 * Invariant: nothing here waits for the worker, but for skv_session_wait and skv_session_destroy;
 * and no message that must not be lost is: if there is no room, all pointers are let go.
 */
#include "session/session.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "scene/recipe.h"

#define DEFAULT_WORLD_WIDTH  1.6
#define DEFAULT_WORLD_HEIGHT 0.9
#define LONGEST_PAUSE        1.0 /* s: who calls less often was away */

enum { STAGE_COOKIE = 0x5354 };

skv_stage_def skv_default_stage_def(void)
{
    return (skv_stage_def){.own_thread = true,
                           .history = (size_t)64 << 20,
                           .cookie = SKV_COOKIE(STAGE_COOKIE, skv_stage_def)};
}

void skv_stage_def_init(skv_stage_def *def, size_t size)
{
    const skv_stage_def standard = skv_default_stage_def();
    skv_def_init(def, size, &standard, sizeof standard);
}

/* ---- Lifetime -------------------------------------------------------------------------------- */

static void run(void *argument)
{
    skv_worker *worker = argument;
    while (!atomic_load(&worker->quit)) {
        unsigned settled = atomic_load(&worker->settled);
        if (atomic_load(&worker->posted) == settled)
            skv_threads_sleep(worker->threads, &worker->posted, settled);
        skv_worker_pump(worker);
    }
}

skv_result skv_session_create(const skv_stage_def *def, skv_session **out, skv_error *error)
{
    SKV_ASSERT_OR(out, SKV_ERROR_VALUE);
    *out = NULL;
    skv_stage_def plain = skv_default_stage_def();
    def = def ? def : &plain;
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &plain, sizeof plain), SKV_ERROR_VALUE);
    skv_session *session = skv_calloc(1, sizeof *session);
    if (!session)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a session");
    skv_worker *worker = &session->worker;
    skv_worker_start(worker, def);
    session->camera = skv_camera_apart(def->margin, 1280, 720, DEFAULT_WORLD_WIDTH,
                                       DEFAULT_WORLD_HEIGHT, 0, 0, 1);
    skv_result result = skv_pool_create(def->threads, &worker->pool, error);
    if (result == SKV_OK) {
        skv_pool_set_stop(worker->pool, skv_worker_is_unwanted, worker);
        worker->threads = skv_threads_create();
        if (!worker->threads)
            result = skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a session");
    }
    if (result != SKV_OK) {
        skv_pool_destroy(worker->pool);
        skv_free(session);
        return result;
    }
    worker->def.own_thread = def->own_thread && skv_threads_start(worker->threads, run, worker);
    *out = session;
    return SKV_OK;
}

void skv_session_destroy(skv_session *session)
{
    if (!session)
        return;
    skv_worker *worker = &session->worker;
    atomic_store(&worker->quit, true);
    atomic_fetch_add(&worker->posted, 1);
    skv_threads_wake(worker->threads);
    skv_threads_join(worker->threads);
    skv_worker_close(worker);
    skv_pool_destroy(worker->pool);
    skv_free(session);
}

void skv_session_wait(skv_session *session)
{
    SKV_ASSERT(session);
    skv_worker *worker = &session->worker;
    unsigned wanted = atomic_load(&worker->posted);
    for (;;) {
        unsigned settled = atomic_load(&worker->settled);
        if ((int)(settled - wanted) >= 0)
            return;
        skv_threads_sleep(worker->threads, &worker->settled, settled);
    }
}

/* ---- Messages -------------------------------------------------------------------------------- */

/* There is something to do. */
static void stir(skv_session *session)
{
    skv_worker *worker = &session->worker;
    atomic_fetch_add(&worker->posted, 1);
    if (worker->def.own_thread)
        skv_threads_wake(worker->threads);
    else
        skv_worker_pump(worker);
}

/* After a message was lost, a pointer might be down for ever: all are let go first. */
static bool put(skv_session *session, const skv_message *message)
{
    skv_mailbox *box = &session->worker.mailbox;
    if (session->lost) {
        if (!skv_mailbox_put(box, &(skv_message){.kind = SKV_MESSAGE_CANCEL}))
            return false;
        session->lost = false;
    }
    return skv_mailbox_put(box, message);
}

/* Of what makes steps unwanted, or wanted; null for the rest. */
static atomic_int *counter_of(skv_worker *worker, skv_message_kind kind)
{
    return kind == SKV_MESSAGE_OPEN                                ? &worker->openings
           : kind == SKV_MESSAGE_SAVE || kind == SKV_MESSAGE_SHARE ? &worker->savings
                                                                   : NULL;
}

bool skv_session_post(skv_session *session, const skv_message *message)
{
    atomic_int *counter = counter_of(&session->worker, message->kind);
    if (counter)
        atomic_fetch_add(counter, 1);
    bool done = put(session, message);
    if (!done && counter)
        atomic_fetch_sub(counter, 1);
    if (!done) {
        session->lost = true;
        session->down_count = 0;
    }
    stir(session);
    return done;
}

static void post_kind(skv_session *session, skv_message_kind kind)
{
    skv_session_post(session, &(skv_message){.kind = kind});
}

void skv_session_fail(skv_session *session, skv_outcome_kind kind, skv_result code,
                      const char *cause, const char *name)
{
    session->failed = true;
    session->failure = (skv_outcome){.kind = kind};
    skv_fail(&session->failure.error, code, "%s: %s", name, cause);
    post_kind(session, SKV_MESSAGE_LOOK);
}

/* A request in one block of memory, whose owner is the worker. */
static void post_request(skv_session *session, skv_message_kind kind, skv_outcome_kind report,
                         const skv_request *from)
{
    skv_message message = {.kind = kind};
    message.request = skv_request_copy(from);
    if (message.request && skv_session_post(session, &message))
        return;
    skv_free(message.request);
    skv_session_fail(session, report, SKV_ERROR_MEMORY, "out of memory", from->name);
}

/* ---- Opening and saving ---------------------------------------------------------------------- */

void skv_session_open(skv_session *session, const char *name_or_path,
                      const skv_scene_options *options)
{
    SKV_ASSERT(session && name_or_path);
    skv_scene_options own;
    SKV_ASSERT_INITIALISED(options, skv_open_scene_options(options, &own), );
    session->down_count = 0;
    skv_request request = {.name = name_or_path, .options = *options};
    post_request(session, SKV_MESSAGE_OPEN, SKV_OUTCOME_OPEN, &request);
}

void skv_session_open_memory(skv_session *session, const void *data, size_t size,
                             const char *format, const char *label,
                             const skv_scene_options *options)
{
    SKV_ASSERT(session && data && format && label);
    skv_scene_options own;
    SKV_ASSERT_INITIALISED(options, skv_open_scene_options(options, &own), );
    session->down_count = 0;
    skv_request request = {
        .name = label, .text = format, .data = data, .size = size, .options = *options};
    post_request(session, SKV_MESSAGE_OPEN, SKV_OUTCOME_OPEN, &request);
}

void skv_session_save(skv_session *session, const char *path, bool moment)
{
    SKV_ASSERT(session && path);
    skv_request request = {.name = path, .text = moment ? "moment" : NULL};
    post_request(session, SKV_MESSAGE_SAVE, SKV_OUTCOME_SAVE, &request);
}

bool skv_session_share(skv_session *session, skv_share share)
{
    SKV_ASSERT_OR(session, false);
    return skv_session_post(session, &(skv_message){.kind = SKV_MESSAGE_SHARE, .number = share});
}

/* Taken out meanwhile, so that the worker cannot free it; there may be newer bytes by then. */
bool skv_session_read_shared(skv_session *session, skv_share share, skv_write *write, void *user)
{
    SKV_ASSERT_OR(session && write, false);
    _Atomic(skv_shared *) *place = &session->worker.shared[share];
    skv_shared *shared = atomic_exchange(place, NULL), *newer = NULL;
    bool written = shared && write(shared->bytes, shared->size, user);
    if (shared && !atomic_compare_exchange_strong(place, &newer, shared))
        skv_free(shared);
    return written;
}

static bool post_bytes(skv_session *session, skv_message_kind kind, const void *bytes, size_t size)
{
    skv_message message = {.kind = kind};
    skv_request request = {.name = "", .data = bytes, .size = size};
    message.request = skv_request_copy(&request);
    bool posted = message.request && skv_session_post(session, &message);
    if (!posted)
        skv_free(message.request);
    return posted;
}

bool skv_session_show(skv_session *session, const skv_showing *showing)
{
    return post_bytes(session, SKV_MESSAGE_SHOW, showing, sizeof *showing);
}

bool skv_session_set_beside(skv_session *session, const void *bytes, size_t size)
{
    return post_bytes(session, SKV_MESSAGE_BESIDE, bytes, size);
}

bool skv_session_next_outcome(skv_session *session, skv_outcome *report)
{
    SKV_ASSERT_OR(session && report, false);
    if (session->failed) {
        *report = session->failure;
        session->failed = false;
        return true;
    }
    skv_worker *worker = &session->worker;
    unsigned taken = atomic_load(&worker->reports_taken);
    if (taken == atomic_load(&worker->reported))
        return false;
    *report = worker->reports[taken % SKV_REPORTS];
    atomic_store(&worker->reports_taken, taken + 1);
    return true;
}

/* ---- The view -------------------------------------------------------------------------------- */

skv_camera skv_session_camera(const skv_session *session)
{
    SKV_ASSERT_OR(session, (skv_camera){.scale = 1, .width = 1, .height = 1});
    /* Counting holders is all that changes. */
    skv_gallery *gallery = (skv_gallery *)&session->worker.gallery;
    const skv_picture *picture = skv_gallery_acquire(gallery);
    const skv_terrain *terrain = picture->frame.terrain;
    double width = terrain ? (double)skv_terrain_width(terrain) : DEFAULT_WORLD_WIDTH;
    double height = terrain ? (double)skv_terrain_height(terrain) : DEFAULT_WORLD_HEIGHT;
    bool same = picture->opened == session->seen;
    skv_gallery_release(gallery, picture);
    const skv_camera *c = &session->camera;
    return skv_camera_apart(c->margin, c->width, c->height, width, height, c->centre_x, c->centre_y,
                            same ? c->zoom : 1);
}

/* There is another camera. */
static void move(skv_session *session)
{
    session->moved = true;
    if (session->worker.def.wake)
        session->worker.def.wake(session->worker.def.user);
}

static void post_pointer(skv_session *session, const skv_pointer_event *event, skv_phase phase)
{
    skv_camera camera = skv_session_camera(session);
    skv_message message = {.kind = SKV_MESSAGE_POINTER};
    message.pointer = *event;
    message.pointer.phase = phase;
    skv_camera_to_world(&camera, event->px, event->py, &message.pointer.px, &message.pointer.py);
    if (phase == SKV_PHASE_MOVE) {
        session->move_lost |= !put(session, &message);
        stir(session);
    } else {
        skv_session_post(session, &message);
    }
}

/* Where pointers are, if a move got lost: they may rest there. */
static void repeat_moves(skv_session *session)
{
    if (!session->move_lost)
        return;
    session->move_lost = false;
    for (int i = 0; i < session->down_count; i++)
        post_pointer(session, &session->down[i], SKV_PHASE_MOVE);
}

/* A finger stays where it is, and is elsewhere in the world. */
static void replace_pointers(skv_session *session)
{
    for (int i = 0; i < session->down_count; i++)
        post_pointer(session, &session->down[i], SKV_PHASE_DOWN);
}

void skv_session_set_view(skv_session *session, int width, int height)
{
    SKV_ASSERT(session);
    if (width == session->camera.width && height == session->camera.height)
        return;
    session->camera.width = width;
    session->camera.height = height;
    replace_pointers(session);
    move(session);
}

void skv_session_set_camera(skv_session *session, const skv_camera *camera)
{
    SKV_ASSERT(session && camera);
    const skv_picture *picture = skv_gallery_acquire(&session->worker.gallery);
    session->seen = picture->opened;
    skv_gallery_release(&session->worker.gallery, picture);
    session->camera = *camera;
    replace_pointers(session);
    move(session);
}

/* ---- Time ------------------------------------------------------------------------------------ */

void skv_session_advance(skv_session *session, double seconds, double drawing)
{
    SKV_ASSERT(session);
    if (!(seconds > 0) || !isfinite(seconds))
        return;
    skv_worker *worker = &session->worker;
    double passed = fmin(seconds, LONGEST_PAUSE);
    if (drawing > 0)
        atomic_store(&worker->drawing, (int)(fmin(drawing, LONGEST_PAUSE) * 1e6));
    repeat_moves(session);
    skv_pointer_event event;
    if (skv_keyboard_pass(&session->keyboard, passed, &event))
        skv_session_pointer(session, &event);
    worker->interval = passed;
    atomic_fetch_add(&worker->elapsed, (long long)(passed * 1e9 + 0.5));
    stir(session);
}

bool skv_session_is_active(const skv_session *session)
{
    SKV_ASSERT_OR(session, false);
    return atomic_load(&session->worker.active) || skv_keyboard_moves(&session->keyboard);
}

void skv_session_set_paused(skv_session *session, bool paused)
{
    SKV_ASSERT(session);
    atomic_store(&session->worker.paused, paused);
    post_kind(session, SKV_MESSAGE_LOOK);
}

bool skv_session_paused(const skv_session *session)
{
    SKV_ASSERT_OR(session, false);
    return atomic_load(&session->worker.paused);
}

/* ---- Pictures -------------------------------------------------------------------------------- */

const skv_picture *skv_session_acquire(skv_session *session)
{
    SKV_ASSERT_OR(session, NULL);
    return skv_gallery_acquire(&session->worker.gallery);
}

void skv_session_release(skv_session *session, const skv_picture *picture)
{
    SKV_ASSERT(session && picture);
    skv_gallery_release(&session->worker.gallery, picture);
}

/* ---- Edits ----------------------------------------------------------------------------------- */

void skv_session_edit(skv_session *session, const skv_command *command)
{
    SKV_ASSERT(session && command);
    SKV_ASSERT(command->kind > SKV_COMMAND_HANDS);
    skv_request request = {.name = "an edit", .data = command, .size = sizeof *command};
    post_request(session, SKV_MESSAGE_EDIT, SKV_OUTCOME_EDIT, &request);
}

void skv_session_set(skv_session *session, const char *path, const char *text)
{
    SKV_ASSERT(session && path && text);
    skv_command command = {.kind = SKV_COMMAND_SET};
    if (strlen(path) < sizeof command.set.path && strlen(text) < sizeof command.set.text) {
        memcpy(command.set.path, path, strlen(path) + 1);
        memcpy(command.set.text, text, strlen(text) + 1);
        skv_session_edit(session, &command);
    } else {
        skv_session_fail(session, SKV_OUTCOME_EDIT, SKV_ERROR_VALUE,
                         "no parameter has so long a name or value", path);
    }
}

/* ---- Pointers -------------------------------------------------------------------------------- */

static int find_down(const skv_session *session, const skv_pointer_event *event)
{
    for (int i = 0; i < session->down_count; i++)
        if (session->down[i].device == event->device && session->down[i].pointer == event->pointer)
            return i;
    return -1;
}

/* Notes who is down; false for one too many, or one that never went down. */
static bool note(skv_session *session, const skv_pointer_event *event)
{
    int i = find_down(session, event);
    switch (event->phase) {
    case SKV_PHASE_DOWN:
        if (i < 0 && session->down_count == SKV_MAX_HANDS)
            return false;
        session->down[i < 0 ? session->down_count++ : i] = *event;
        return true;
    case SKV_PHASE_MOVE:
        if (i >= 0) {
            session->down[i].px = event->px;
            session->down[i].py = event->py;
            session->down[i].time = event->time;
        }
        return i >= 0 || event->device != SKV_DEVICE_FINGER;
    default:
        if (i >= 0)
            session->down[i] = session->down[--session->down_count];
        return i >= 0 || event->phase == SKV_PHASE_LEAVE;
    }
}

void skv_session_pointer(skv_session *session, const skv_pointer_event *event)
{
    SKV_ASSERT(session && event);
    bool finite = isfinite(event->px) && isfinite(event->py) && isfinite(event->time);
    if (finite && note(session, event))
        post_pointer(session, event, event->phase);
}

void skv_session_cancel_pointers(skv_session *session)
{
    SKV_ASSERT(session);
    session->down_count = 0;
    post_kind(session, SKV_MESSAGE_CANCEL);
}

void skv_session_keyboard(skv_session *session, int right, int up, bool down)
{
    SKV_ASSERT(session);
    skv_pointer_event event;
    if (skv_keyboard_press(&session->keyboard, right, up, down, session->camera.width,
                           session->camera.height, &event))
        skv_session_pointer(session, &event);
}

/* ---- Led by the time of two ------------------------------------------------------------------ */

void skv_session_grant(skv_session *session, int frames, double factor)
{
    skv_message message = {.kind = SKV_MESSAGE_PLAY};
    message.play.frames = frames;
    message.play.factor = factor;
    if (skv_session_post(session, &message))
        session->granted += (unsigned)frames;
}

int skv_session_owed(const skv_session *session)
{
    return (int)(session->granted - atomic_load(&session->worker.played));
}

bool skv_session_is_settled(const skv_session *session)
{
    return atomic_load(&session->worker.posted) == atomic_load(&session->worker.settled);
}
