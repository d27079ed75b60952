/* A session that does not step by the time that passes for it, but as many frames as it is granted:
 * what a pair does with its two (pair.c). */
#ifndef SKV_SESSION_LED_H
#define SKV_SESSION_LED_H

#include "skvalp/session.h"

void skv_session_set_led(skv_session *session, bool led);

/* Whether it steps on a thread of its own, beside whoever asks it to. */
bool skv_session_has_thread(const skv_session *session);

/* Frames to step, unless it is paused by then; `factor`: simulated over real seconds. */
void skv_session_grant(skv_session *session, int frames, double factor);

/* Frames granted that were not stepped yet. */
int skv_session_owed(const skv_session *session);

/* Undo if it leads to that moment; else goes there, and what comes after can be redone, too. */
void skv_session_go_back(skv_session *session, int64_t frame);

/* As skv_session_replay, but what was done since this was shared last is cut off. */
void skv_session_replay_shared(skv_session *session);

/* instruments.c: whatever is added to either next has one number; and puts the instruments of a
 * picture, of the other's, in place of the session's own, with their numbers. */
void skv_session_number_alike(skv_session *session, skv_session *other);
void skv_session_take_probes(skv_session *session, const skv_picture *from);

/* Whether all that was asked for is done and can be seen. */
bool skv_session_is_settled(const skv_session *session);

#endif
