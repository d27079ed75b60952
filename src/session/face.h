/* The face's side of a session, shared by session.c, instruments.c and led.c. */
#ifndef SKV_SESSION_FACE_H
#define SKV_SESSION_FACE_H

#include "session/keyboard.h"
#include "session/worker.h"

struct skv_session {
    skv_worker worker;
    /* The face's own. */
    double speed;
    int tool, dye;
    skv_camera camera; /* its size is the view's */
    bool moved;        /* the camera, since that was looked at */
    uint32_t seen;     /* what is open as the camera was set: picture's `opened` */
    skv_pointer_event down[SKV_MAX_HANDS]; /* in view pixels */
    int down_count;
    bool lost;      /* a message that must not be */
    bool move_lost; /* the last place of a pointer: it is said again */
    bool failed;    /* a request could not even be asked for: `failure` says which */
    skv_outcome failure;
    uint32_t next_probe;
    unsigned granted; /* frames, by a pair */
    skv_keyboard keyboard;
};

/* session.c: leaves a message that must not be lost; false if it was, and all pointers are let go.
 */
bool skv_session_post(skv_session *session, const skv_message *message);
/* What could not even be asked for is reported, too. */
void skv_session_fail(skv_session *session, skv_outcome_kind kind, skv_result code,
                      const char *cause, const char *name);
/* As skv_session_share and _read_shared, for a second world: reported as SKV_OUTCOME_COMPARE. */
bool skv_session_offer(skv_session *session);
bool skv_session_read_offered(skv_session *session, skv_write *write, void *user);

#endif
