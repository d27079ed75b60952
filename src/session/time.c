/* The time of a stage, and two worlds at one moment. Invariant: both are granted the same frames,
 * never more while one of them still owes more than one; where an edit in time has led them apart,
 * the later one goes back to the earlier before any other frame is granted.
 */
#include <math.h>

#include "base/assert.h"
#include "session/stage.h"

/* What can be seen of a world's time. */
typedef struct look {
    int64_t moment, undo_to, redo_to;
    bool seeking, at_rest;
    double step_ms;
} look;

static look look_at(skv_session *world)
{
    const skv_picture *p = skv_session_acquire(world);
    look seen = {p->moment, p->undo_to, p->redo_to, p->seeking, p->at_rest, p->step_ms};
    skv_session_release(world, p);
    return seen;
}

void skv_stage_join(skv_stage *stage, skv_replay replay)
{
    stage->pace = skv_pace_start();
    stage->introduced = false;
    /* A finger that is down would take over from the replay at its start. */
    for (int i = 0; i < 2; i++)
        skv_session_cancel_pointers(stage->worlds[i]);
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_LED, .number = true});
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_REPLAY, .number = replay});
}

void skv_stage_part(skv_stage *stage)
{
    skv_session_post(stage->worlds[0], &(skv_message){.kind = SKV_MESSAGE_LED});
}

/* Whether both have done what was asked of them; where they are, then. */
static bool have_settled(const skv_stage *stage, look seen[2])
{
    for (int i = 0; i < 2; i++) {
        skv_session *world = stage->worlds[i];
        if (skv_session_owed(world) > 0 || !skv_session_is_settled(world))
            return false;
        seen[i] = look_at(world);
        if (seen[i].seeking)
            return false;
    }
    return true;
}

bool skv_stage_is_level(const skv_stage *stage)
{
    look seen[2];
    return have_settled(stage, seen) && seen[0].moment == seen[1].moment;
}

/* Adds an instrument of the first to the second, unless that was done for both. */
static void take_probe(skv_stage *stage, const skv_probe *probe, const skv_picture *own)
{
    skv_message message = {.kind = SKV_MESSAGE_PROBE_ADD};
    message.probe.id = probe->id;
    message.probe.def = probe->def;
    message.probe.watched = probe->samples > 0;
    bool known = false;
    for (int i = 0; i < own->probe_count; i++)
        known = known || own->probes[i].id == probe->id;
    if (!known)
        skv_session_post(stage->worlds[1], &message);
    message.kind = SKV_MESSAGE_PROBE_WATCH;
    skv_session_post(stage->worlds[1], &message);
}

/* Once what was asked of each alone is done: only then does the first's picture show all its
 * instruments. False before. */
static bool introduce(skv_stage *stage)
{
    look seen[2];
    if (stage->introduced)
        return true;
    if (!have_settled(stage, seen))
        return false;
    const skv_picture *picture = skv_session_acquire(stage->worlds[0]);
    const skv_picture *own = skv_session_acquire(stage->worlds[1]);
    for (int i = 0; i < picture->probe_count; i++)
        take_probe(stage, &picture->probes[i], own);
    skv_session_release(stage->worlds[1], own);
    skv_session_release(stage->worlds[0], picture);
    stage->introduced = true;
    return true;
}

/* Leads them together; false if they were apart. */
static bool align(skv_stage *stage)
{
    look seen[2];
    if (!introduce(stage))
        return false;
    if (!have_settled(stage, seen) || seen[0].moment == seen[1].moment)
        return true;
    int later = seen[1].moment > seen[0].moment;
    skv_session_post(stage->worlds[later],
                     &(skv_message){.kind = SKV_MESSAGE_SEEK, .frame = seen[!later].moment});
    return false;
}

/* A step that failed has paused its world: the other stops, too. */
static bool is_paused(skv_stage *stage)
{
    bool first = skv_session_paused(stage->worlds[0]);
    bool second = skv_session_paused(stage->worlds[1]);
    for (int i = 0; first != second && i < 2; i++)
        skv_session_set_paused(stage->worlds[i], true);
    return first || second;
}

/* Threads of their own step beside each other; without them both are stepped within this call. */
static void grant(skv_stage *stage, double seconds, double drawing)
{
    look a = look_at(stage->worlds[0]), b = look_at(stage->worlds[1]);
    bool beside =
        stage->worlds[0]->worker.def.own_thread && stage->worlds[1]->worker.def.own_thread;
    double cost = beside ? fmax(a.step_ms, b.step_ms) : a.step_ms + b.step_ms;
    stage->pace.speed = stage->speed;
    stage->pace.step_cost = cost / 1000;
    double budget = skv_pace_budget(beside, seconds, drawing);
    int frames = skv_pace_pass(&stage->pace, seconds, budget);
    for (int i = 0; frames > 0 && i < 2; i++)
        skv_session_grant(stage->worlds[i], frames, stage->pace.speed * stage->pace.factor);
}

static void advance_both(skv_stage *stage, double seconds, double drawing)
{
    bool together = align(stage), paused = is_paused(stage), busy = false, rest = true;
    for (int i = 0; i < 2; i++) {
        skv_session_advance(stage->worlds[i], seconds, drawing);
        look seen = look_at(stage->worlds[i]);
        busy = busy || stage->errands || seen.seeking || skv_session_owed(stage->worlds[i]) > 1;
        rest = rest && seen.at_rest && !stage->timed;
    }
    if (paused || rest || !together)
        skv_pace_rest(&stage->pace);
    else if (busy)
        skv_pace_wait(&stage->pace, seconds);
    else
        grant(stage, seconds, drawing);
}

static bool are_active(const skv_stage *stage)
{
    bool active = !stage->introduced || stage->errands;
    for (int i = 0; i < 2; i++)
        active = active || skv_session_is_active(stage->worlds[i]) ||
                 skv_session_owed(stage->worlds[i]) > 0;
    return active || !skv_stage_is_level(stage);
}

/* The one that has no such edit goes along, so that redo finds both ways cut at the same moments.
 */
static void undo_both(skv_stage *stage)
{
    look a = look_at(stage->worlds[0]), b = look_at(stage->worlds[1]);
    int64_t to = a.undo_to > b.undo_to ? a.undo_to : b.undo_to;
    if (to >= 0)
        skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_GO_BACK, .frame = to});
}

/* An edit in one of them has ended what can be redone, in both. */
static void redo_both(skv_stage *stage)
{
    look a = look_at(stage->worlds[0]), b = look_at(stage->worlds[1]);
    if (a.redo_to == b.redo_to)
        skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_REDO});
}

/* ---- One world or two ------------------------------------------------------------------------ */

void skv_stage_advance(skv_stage *stage, double seconds, double drawing)
{
    SKV_ASSERT(stage);
    if (stage->count == 2)
        advance_both(stage, seconds, drawing);
    else
        skv_session_advance(stage->worlds[0], seconds, drawing);
}

bool skv_stage_is_active(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, false);
    return stage->count == 2 ? are_active(stage) : skv_session_is_active(stage->worlds[0]);
}

void skv_stage_set_paused(skv_stage *stage, bool paused)
{
    SKV_ASSERT(stage);
    for (int i = 0; i < stage->count; i++)
        skv_session_set_paused(stage->worlds[i], paused);
}

bool skv_stage_paused(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, false);
    return skv_session_paused(stage->worlds[0]);
}

void skv_stage_set_timed(skv_stage *stage, bool timed)
{
    SKV_ASSERT(stage);
    if (timed == stage->timed)
        return;
    stage->timed = timed;
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_TIMED, .number = timed});
}

void skv_stage_step_once(skv_stage *stage)
{
    SKV_ASSERT(stage);
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_STEP});
}

void skv_stage_set_speed(skv_stage *stage, double speed)
{
    SKV_ASSERT(stage);
    if (isnan(speed))
        return;
    stage->speed = fmin(fmax(speed, 0.05), 2);
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_SPEED, .x = stage->speed});
}

double skv_stage_speed(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, 1);
    return stage->speed;
}

void skv_stage_seek(skv_stage *stage, int64_t frame)
{
    SKV_ASSERT(stage);
    stage->goal = frame > 0 ? frame : 0;
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_SEEK, .frame = frame});
}

void skv_stage_go(skv_stage *stage, int64_t frames, int64_t reach)
{
    SKV_ASSERT(stage);
    const skv_picture *picture = stage->shown[0];
    int64_t wanted = (stage->goal >= 0 ? stage->goal : picture->moment) + frames;
    int64_t first = picture->end > reach ? picture->end - reach : 0;
    if (!skv_stage_paused(stage)) /* a message, for which what follows would wait while it seeks */
        skv_stage_set_paused(stage, true);
    wanted = wanted > first ? wanted : first;
    skv_stage_seek(stage, wanted < picture->end ? wanted : picture->end);
}

void skv_stage_undo(skv_stage *stage)
{
    SKV_ASSERT(stage);
    if (stage->count == 2)
        undo_both(stage);
    else
        skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_UNDO});
}

void skv_stage_redo(skv_stage *stage)
{
    SKV_ASSERT(stage);
    if (stage->count == 2)
        redo_both(stage);
    else
        skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_REDO});
}
