/* Led by another's time. Invariant: frames that were granted are counted as played by the worker
 * only, also those that it left out. */
#include "session/led.h"

#include "session/face.h"

void skv_session_set_led(skv_session *session, bool led)
{
    skv_session_post(session, &(skv_message){.kind = SKV_MESSAGE_LED, .number = led});
}

bool skv_session_has_thread(const skv_session *session)
{
    return session->worker.def.own_thread;
}

void skv_session_grant(skv_session *session, int frames, double factor)
{
    skv_message message = {.kind = SKV_MESSAGE_PLAY};
    message.play.frames = frames;
    message.play.factor = factor;
    if (skv_session_post(session, &message))
        session->granted += (unsigned)frames;
}

void skv_session_go_back(skv_session *session, int64_t frame)
{
    skv_session_post(session, &(skv_message){.kind = SKV_MESSAGE_GO_BACK, .frame = frame});
}

void skv_session_replay_shared(skv_session *session)
{
    skv_session_post(session, &(skv_message){.kind = SKV_MESSAGE_REPLAY, .number = 1});
}

int skv_session_owed(const skv_session *session)
{
    return (int)(session->granted - atomic_load(&session->worker.played));
}

bool skv_session_is_settled(const skv_session *session)
{
    return atomic_load(&session->worker.posted) == atomic_load(&session->worker.settled);
}
