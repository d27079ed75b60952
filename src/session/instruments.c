/* Instruments of a session: messages to those of the worker (probes.c). */
#include "base/assert.h"
#include "session/face.h"
#include "session/led.h"

static bool post_probe(skv_session *session, skv_message_kind kind, uint32_t id, bool watched,
                       const skv_instrument_def *def)
{
    skv_message message = {.kind = kind};
    message.probe.id = id;
    message.probe.watched = watched;
    if (def)
        message.probe.def = *def;
    return skv_session_post(session, &message);
}

uint32_t skv_session_add_probe(skv_session *session, const skv_instrument_def *def)
{
    SKV_ASSERT_OR(session && def, 0);
    uint32_t id = ++session->next_probe;
    return post_probe(session, SKV_MESSAGE_PROBE_ADD, id, false, def) ? id : 0;
}

void skv_session_move_probe(skv_session *session, uint32_t probe, double x0, double y0, double x1,
                            double y1)
{
    SKV_ASSERT(session);
    skv_instrument_def to = {.x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1};
    post_probe(session, SKV_MESSAGE_PROBE_MOVE, probe, false, &to);
}

void skv_session_watch_probe(skv_session *session, uint32_t probe, bool watched)
{
    SKV_ASSERT(session);
    post_probe(session, SKV_MESSAGE_PROBE_WATCH, probe, watched, NULL);
}

void skv_session_remove_probe(skv_session *session, uint32_t probe)
{
    SKV_ASSERT(session);
    post_probe(session, SKV_MESSAGE_PROBE_REMOVE, probe, false, NULL);
}

/* ---- Of a pair ------------------------------------------------------------------------------- */

void skv_session_number_alike(skv_session *session, skv_session *other)
{
    uint32_t next =
        session->next_probe > other->next_probe ? session->next_probe : other->next_probe;
    session->next_probe = other->next_probe = next;
}

static const skv_probe *find(const skv_picture *picture, const skv_probe *like)
{
    for (int i = 0; i < picture->probe_count; i++)
        if (picture->probes[i].id == like->id && picture->probes[i].def.kind == like->def.kind)
            return &picture->probes[i];
    return NULL;
}

void skv_session_take_probes(skv_session *session, const skv_picture *from)
{
    const skv_picture *own = skv_session_acquire(session);
    for (int i = 0; i < own->probe_count; i++)
        if (!find(from, &own->probes[i]))
            skv_session_remove_probe(session, own->probes[i].id);
    for (int i = 0; i < from->probe_count; i++) {
        const skv_probe *probe = &from->probes[i];
        if (!find(own, probe))
            post_probe(session, SKV_MESSAGE_PROBE_ADD, probe->id, false, &probe->def);
        skv_session_watch_probe(session, probe->id, probe->samples > 0);
    }
    skv_session_release(session, own);
}
