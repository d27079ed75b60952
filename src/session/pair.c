/* Two sessions at one moment. Invariant: both are granted the same frames, never more while one of
 * them still owes more than one; where an edit in time has led them apart, the later one goes back
 * to the earlier before any other frame is granted.
 */
#include "skvalp/pair.h"

#include <math.h>

#include "base/assert.h"
#include "base/memory.h"
#include "session/led.h"
#include "session/pace.h"

struct skv_pair {
    skv_session *worlds[2];
    skv_pace pace;
    bool introduced; /* the second has the instruments of the first */
};

/* What can be seen of a world's time. */
typedef struct look {
    int64_t moment, undo_to, redo_to;
    bool seeking, at_rest;
    double step_ms;
} look;

static look look_at(skv_session *session)
{
    const skv_picture *p = skv_session_acquire(session);
    look seen = {p->moment, p->undo_to, p->redo_to, p->seeking, p->at_rest, p->step_ms};
    skv_session_release(session, p);
    return seen;
}

skv_result skv_pair_create(skv_session *a, skv_session *b, skv_pair **out, skv_error *error)
{
    SKV_ASSERT_OR(out && a && b && a != b, SKV_ERROR_VALUE);
    skv_pair *pair = *out = skv_calloc(1, sizeof *pair);
    if (!pair)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a pair");
    pair->worlds[0] = a;
    pair->worlds[1] = b;
    pair->pace = skv_pace_start();
    skv_pair_set_speed(pair, skv_session_speed(a));
    skv_pair_set_paused(pair, skv_session_paused(a));
    for (int i = 0; i < 2; i++) {
        /* A finger that is down would take over from the replay at its start. */
        skv_session_cancel_pointers(pair->worlds[i]);
        skv_session_set_led(pair->worlds[i], true);
        skv_session_replay_shared(pair->worlds[i]);
    }
    skv_session_number_alike(a, b);
    return SKV_OK;
}

void skv_pair_destroy(skv_pair *pair)
{
    if (!pair)
        return;
    for (int i = 0; i < 2; i++)
        skv_session_set_led(pair->worlds[i], false);
    skv_free(pair);
}

/* ---- Time ------------------------------------------------------------------------------------ */

/* Whether both have done what was asked of them; where they are, then. */
static bool have_settled(const skv_pair *pair, look seen[2])
{
    for (int i = 0; i < 2; i++) {
        if (skv_session_owed(pair->worlds[i]) > 0 || !skv_session_is_settled(pair->worlds[i]))
            return false;
        seen[i] = look_at(pair->worlds[i]);
        if (seen[i].seeking)
            return false;
    }
    return true;
}

/* Once what was asked of each alone is done: only then does the first's picture show all its
 * instruments. False before. */
static bool introduce(skv_pair *pair)
{
    look seen[2];
    if (pair->introduced)
        return true;
    if (!have_settled(pair, seen))
        return false;
    const skv_picture *picture = skv_session_acquire(pair->worlds[0]);
    skv_session_take_probes(pair->worlds[1], picture);
    skv_session_release(pair->worlds[0], picture);
    pair->introduced = true;
    return true;
}

/* Leads them together; false if they were apart. */
static bool align(skv_pair *pair)
{
    look seen[2];
    if (!introduce(pair))
        return false;
    if (!have_settled(pair, seen) || seen[0].moment == seen[1].moment)
        return true;
    int later = seen[1].moment > seen[0].moment;
    skv_session_seek(pair->worlds[later], seen[!later].moment);
    return false;
}

/* A step that failed has paused its world: the other stops, too. */
static bool is_paused(skv_pair *pair)
{
    bool first = skv_session_paused(pair->worlds[0]), second = skv_session_paused(pair->worlds[1]);
    if (first != second)
        skv_pair_set_paused(pair, true);
    return first || second;
}

/* Threads of their own step beside each other; without them both are stepped within this call. */
static void grant(skv_pair *pair, double seconds, double drawing)
{
    look a = look_at(pair->worlds[0]), b = look_at(pair->worlds[1]);
    bool beside =
        skv_session_has_thread(pair->worlds[0]) && skv_session_has_thread(pair->worlds[1]);
    double cost = beside ? fmax(a.step_ms, b.step_ms) : a.step_ms + b.step_ms;
    pair->pace.step_cost = cost / 1000;
    double budget = skv_pace_budget(beside, seconds, drawing);
    int frames = skv_pace_pass(&pair->pace, seconds, budget);
    for (int i = 0; frames > 0 && i < 2; i++)
        skv_session_grant(pair->worlds[i], frames, pair->pace.speed * pair->pace.factor);
}

void skv_pair_advance(skv_pair *pair, double seconds, double drawing)
{
    SKV_ASSERT(pair);
    bool together = align(pair), paused = is_paused(pair), busy = false, rest = true;
    for (int i = 0; i < 2; i++) {
        skv_session_advance(pair->worlds[i], seconds, drawing);
        look seen = look_at(pair->worlds[i]);
        busy = busy || seen.seeking || skv_session_owed(pair->worlds[i]) > 1;
        rest = rest && seen.at_rest;
    }
    if (paused || rest || !together)
        skv_pace_rest(&pair->pace);
    else if (busy)
        skv_pace_wait(&pair->pace, seconds);
    else
        grant(pair, seconds, drawing);
}

bool skv_pair_is_active(const skv_pair *pair)
{
    SKV_ASSERT_OR(pair, false);
    look seen[2];
    bool active = !pair->introduced;
    for (int i = 0; i < 2; i++)
        active = active || skv_session_is_active(pair->worlds[i]) ||
                 skv_session_owed(pair->worlds[i]) > 0;
    return active || !have_settled(pair, seen) || seen[0].moment != seen[1].moment;
}

/* ---- What is asked of both ------------------------------------------------------------------- */

void skv_pair_set_paused(skv_pair *pair, bool paused)
{
    SKV_ASSERT(pair);
    for (int i = 0; i < 2; i++)
        skv_session_set_paused(pair->worlds[i], paused);
}

void skv_pair_step_once(skv_pair *pair)
{
    SKV_ASSERT(pair);
    for (int i = 0; i < 2; i++)
        skv_session_step_once(pair->worlds[i]);
}

void skv_pair_set_speed(skv_pair *pair, double speed)
{
    SKV_ASSERT(pair);
    for (int i = 0; i < 2; i++)
        skv_session_set_speed(pair->worlds[i], speed);
    pair->pace.speed = skv_session_speed(pair->worlds[0]);
}

void skv_pair_seek(skv_pair *pair, int64_t frame)
{
    SKV_ASSERT(pair);
    for (int i = 0; i < 2; i++)
        skv_session_seek(pair->worlds[i], frame);
}

/* The one that has no such edit goes along, so that redo finds both ways cut at the same moments.
 */
void skv_pair_undo(skv_pair *pair)
{
    SKV_ASSERT(pair);
    look a = look_at(pair->worlds[0]), b = look_at(pair->worlds[1]);
    int64_t to = a.undo_to > b.undo_to ? a.undo_to : b.undo_to;
    for (int i = 0; i < 2 && to >= 0; i++)
        skv_session_go_back(pair->worlds[i], to);
}

/* An edit in one of them has ended what can be redone, in both. */
void skv_pair_redo(skv_pair *pair)
{
    SKV_ASSERT(pair);
    look a = look_at(pair->worlds[0]), b = look_at(pair->worlds[1]);
    for (int i = 0; i < 2 && a.redo_to == b.redo_to; i++)
        skv_session_redo(pair->worlds[i]);
}
