/* What the session's tests share: a session that works within its calls, by a clock that stands
 * still, so that nothing depends on the machine. */
#ifndef SKV_TESTS_SESSION_SUPPORT_H
#define SKV_TESTS_SESSION_SUPPORT_H

#include <skvalp/session.h>

/* A pool of some particles in a view of 1600 x 900 pixels: 1000 of them are a metre. */
skv_session *session_open_pool(int particles, bool own_thread);

/* A player of 300 particles in a pool; `history` in bytes, 0: as by default. */
skv_player *session_open_player(size_t history);

/* Set up and tear down tests of such a pool of 200 particles. */
int session_setup(void **state);
int session_setup_thread(void **state);
int session_teardown(void **state);

/* Lets real time pass, and waits; returns the frames stepped. */
int session_advance(skv_session *session, double seconds);

/* Facts of the newest picture. */
int64_t session_moment(skv_session *session);
uint64_t session_hash(skv_session *session);
void session_look(skv_session *session, skv_picture *picture); /* all but what it points at */

/* A pointer of a device, at a view pixel. */
void session_point(skv_session *session, skv_phase phase, skv_device device, uint64_t pointer,
                   double px, double py, double time);

/* The next report's result; -1 if there is none. */
int session_report(skv_session *session, skv_outcome *report);

#endif
