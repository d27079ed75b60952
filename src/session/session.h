/* A session: one world of a stage on a thread of its own, and the face's side of it. Its calls are
 * those of the stage (skvalp/stage.h) for this world alone. */
#ifndef SKV_SESSION_SESSION_H
#define SKV_SESSION_SESSION_H

#include "session/keyboard.h"
#include "session/worker.h"

typedef struct skv_session {
    skv_worker worker;
    /* The face's own. */
    skv_camera camera; /* its size is the view's */
    bool moved;        /* the camera, since that was looked at */
    uint32_t seen;     /* what is open as the camera was set: picture's `opened` */
    skv_pointer_event down[SKV_MAX_HANDS]; /* in view pixels */
    int down_count;
    bool lost;      /* a message that must not be */
    bool move_lost; /* the last place of a pointer: it is said again */
    bool failed;    /* a request could not even be asked for: `failure` says which */
    skv_outcome failure;
    unsigned granted; /* frames */
    skv_keyboard keyboard;
} skv_session;

skv_result skv_session_create(const skv_stage_def *def, skv_session **session, skv_error *error);
void skv_session_destroy(skv_session *session);
void skv_session_wait(skv_session *session);

/* Leaves a message that must not be lost; false if it was, and all pointers are let go. */
bool skv_session_post(skv_session *session, const skv_message *message);
/* What could not even be asked for is reported, too. */
void skv_session_fail(skv_session *session, skv_outcome_kind kind, skv_result code,
                      const char *cause, const char *name);
bool skv_session_next_outcome(skv_session *session, skv_outcome *report);

void skv_session_open(skv_session *session, const char *name_or_path,
                      const skv_scene_options *options);
void skv_session_open_memory(skv_session *session, const void *data, size_t size,
                             const char *format, const char *label,
                             const skv_scene_options *options);
void skv_session_save(skv_session *session, const char *path, bool moment);
void skv_session_edit(skv_session *session, const skv_command *command);
void skv_session_set(skv_session *session, const char *path, const char *text);

/* What a link holds, reported as SKV_OUTCOME_SHARE; the same for a second world, reported as
 * SKV_OUTCOME_COMPARE; and a part of the first's link, of which nothing is reported. */
bool skv_session_share(skv_session *session, skv_share share);
bool skv_session_read_shared(skv_session *session, skv_share share, skv_write *write, void *user);
/* For the first: how it is shown; and a replay of the second, to be kept with what is saved or
 * shared next. False if memory or room is out. */
bool skv_session_show(skv_session *session, const skv_showing *showing);
bool skv_session_set_beside(skv_session *session, const void *bytes, size_t size);

void skv_session_advance(skv_session *session, double seconds, double drawing);
bool skv_session_is_active(const skv_session *session);
void skv_session_set_paused(skv_session *session, bool paused);
bool skv_session_paused(const skv_session *session);

/* The newest picture, to be released again; two at most may be held at once. */
const skv_picture *skv_session_acquire(skv_session *session);
void skv_session_release(skv_session *session, const skv_picture *picture);

void skv_session_set_view(skv_session *session, int width, int height);
skv_camera skv_session_camera(const skv_session *session);
void skv_session_set_camera(skv_session *session, const skv_camera *camera);
void skv_session_pointer(skv_session *session, const skv_pointer_event *event);
void skv_session_cancel_pointers(skv_session *session);
void skv_session_keyboard(skv_session *session, int right, int up, bool down);

/* Frames to step, unless it is paused by then, of one that is led; `factor`: simulated over real
 * seconds. How many of them were not stepped yet. */
void skv_session_grant(skv_session *session, int frames, double factor);
int skv_session_owed(const skv_session *session);

/* Whether all that was asked for is done and can be seen. */
bool skv_session_is_settled(const skv_session *session);

#endif
