/* The stage: what is open on it, its second world, and their pictures. Time is in time.c, what
 * people do in acting.c.
 *
 * Invariants: count is 2 exactly while two worlds are in step; a second world comes and goes within
 * skv_stage_next_outcome and skv_stage_end_compare only; one picture of each side is held.
 */
#include "session/stage.h"

#include <math.h>

#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "scene/recipe.h"

/* ---- Lifetime -------------------------------------------------------------------------------- */

skv_result skv_stage_create(const skv_stage_def *def, skv_stage **out, skv_error *error)
{
    SKV_ASSERT_OR(out, SKV_ERROR_VALUE);
    *out = NULL;
    skv_stage_def own = skv_default_stage_def();
    def = def ? def : &own;
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &own, sizeof own), SKV_ERROR_VALUE);
    skv_stage *stage = skv_calloc(1, sizeof *stage);
    if (!stage)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a stage");
    skv_result result = skv_session_create(def, &stage->worlds[0], error);
    if (result != SKV_OK) {
        skv_free(stage);
        return result;
    }
    stage->def = *def;
    stage->count = 1;
    stage->shown[0] = skv_session_acquire(stage->worlds[0]);
    stage->speed = 1;
    stage->chosen.dye = 1;
    stage->goal = -1;
    *out = stage;
    return SKV_OK;
}

static void drop_next(skv_stage *stage)
{
    skv_session_destroy(stage->next);
    stage->next = NULL;
    skv_free(stage->companion);
    stage->companion = NULL;
}

static void end_second(skv_stage *stage)
{
    drop_next(stage);
    if (stage->count == 1)
        return;
    skv_stage_part(stage);
    stage->count = 1;
    stage->fingers[1] = (skv_fingers){0};
    skv_session_release(stage->worlds[1], stage->shown[1]);
    skv_session_destroy(stage->worlds[1]);
    stage->asked = false;
    skv_stage_keep_on(stage);
}

void skv_stage_destroy(skv_stage *stage)
{
    if (!stage)
        return;
    skv_stage_drop_errands(stage);
    skv_stage_end_compare(stage);
    skv_session_release(stage->worlds[0], stage->shown[0]);
    skv_session_destroy(stage->worlds[0]);
    skv_free(stage);
}

void skv_stage_wait(skv_stage *stage)
{
    SKV_ASSERT(stage);
    const skv_errand *left;
    do {
        left = stage->errands;
        for (int i = 0; i < stage->count; i++)
            skv_session_wait(stage->worlds[i]);
        if (stage->next)
            skv_session_wait(stage->next);
        skv_stage_keep_on(stage);
    } while (left && (stage->asked || stage->errands != left));
}

/* ---- Opening and saving ---------------------------------------------------------------------- */

void skv_stage_open(skv_stage *stage, const char *name_or_path, const skv_scene_options *options)
{
    SKV_ASSERT(stage);
    skv_session_open(stage->worlds[0], name_or_path, options);
}

void skv_stage_open_memory(skv_stage *stage, const void *data, size_t size, const char *format,
                           const char *label, const skv_scene_options *options)
{
    SKV_ASSERT(stage);
    skv_session_open_memory(stage->worlds[0], data, size, format, label, options);
}

void skv_stage_replay(skv_stage *stage)
{
    SKV_ASSERT(stage);
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_REPLAY});
}

void skv_stage_take_over(skv_stage *stage)
{
    SKV_ASSERT(stage);
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_TAKE_OVER});
}

void skv_stage_skip(skv_stage *stage)
{
    SKV_ASSERT(stage);
    if (stage->shown[0]->watching)
        skv_stage_seek(stage, stage->shown[0]->end);
}

/* ---- Two worlds ------------------------------------------------------------------------------ */

void skv_stage_compare(skv_stage *stage, const skv_scene_options *options)
{
    SKV_ASSERT(stage);
    skv_scene_options own;
    SKV_ASSERT_INITIALISED(options, skv_open_scene_options(options, &own), );
    skv_request request = {.name = "a second world", .options = *options};
    skv_free(stage->wanted);
    stage->wanted = skv_request_copy(&request);
    skv_stage_want_choice(stage, "");
    if (stage->wanted && skv_session_share(stage->worlds[0], SKV_SHARE_OFFER))
        stage->offers++;
    else
        skv_session_fail(stage->worlds[0], SKV_OUTCOME_COMPARE, SKV_ERROR_MEMORY, "out of memory",
                         request.name);
}

void skv_stage_end_compare(skv_stage *stage)
{
    SKV_ASSERT(stage);
    skv_free(stage->wanted);
    stage->wanted = NULL;
    end_second(stage);
}

int skv_stage_sides(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, 1);
    return stage->count;
}

static bool open_next(const char *bytes, size_t size, void *user)
{
    skv_stage *stage = user;
    skv_session_open_memory(stage->next, bytes, size, "skvr", stage->shown[0]->name,
                            &stage->wanted->options);
    return true;
}

/* The first has offered what it plays. Whether there is something to report by now. */
static bool take_offer(skv_stage *stage, skv_outcome *report)
{
    bool last = --stage->offers == 0 && stage->wanted;
    if (last && report->error.code == SKV_OK) {
        drop_next(stage);
        if (skv_session_create(&stage->def, &stage->next, &report->error) == SKV_OK)
            skv_session_read_shared(stage->worlds[0], SKV_SHARE_OFFER, open_next, stage);
    }
    return last && report->error.code != SKV_OK;
}

/* The next second world is open: both go on together. */
static void join(skv_stage *stage)
{
    skv_session *second = stage->next;
    skv_companion *shown = stage->companion;
    stage->next = NULL;
    stage->companion = NULL;
    end_second(stage);
    stage->worlds[1] = second;
    stage->shown[1] = skv_session_acquire(second);
    stage->count = 2;
    skv_session_post(second, &(skv_message){.kind = SKV_MESSAGE_CHOSEN, .chosen = stage->chosen});
    skv_stage_set_speed(stage, stage->speed);
    skv_session_post(second, &(skv_message){.kind = SKV_MESSAGE_TIMED, .number = stage->timed});
    skv_stage_join(stage, shown ? SKV_REPLAY_OPENED : SKV_REPLAY_OFFERED);
    skv_stage_set_paused(stage, shown && shown->still);
    skv_stage_follow(stage, 0);
    stage->apart = shown ? shown->apart : stage->apart;
    skv_stage_set_choice(stage, shown ? shown->choice : stage->choice);
    skv_free(shown);
}

/* Of what there is, and what comes of it. */
static bool take_report(skv_stage *stage, skv_outcome *report)
{
    while (skv_session_next_outcome(stage->worlds[0], report)) {
        if (report->kind == SKV_OUTCOME_OPEN && report->error.code == SKV_OK)
            end_second(stage);
        if (report->kind != SKV_OUTCOME_COMPARE || take_offer(stage, report))
            return true;
    }
    return stage->count == 2 && skv_session_next_outcome(stage->worlds[1], report);
}

bool skv_stage_next_outcome(skv_stage *stage, skv_outcome *report)
{
    SKV_ASSERT_OR(stage && report, false);
    skv_stage_keep_on(stage);
    if (take_report(stage, report))
        return true;
    skv_stage_open_companion(stage);
    if (!stage->next || !skv_session_next_outcome(stage->next, report))
        return false;
    report->kind = SKV_OUTCOME_COMPARE;
    if (report->error.code == SKV_OK)
        join(stage);
    else
        drop_next(stage);
    return true;
}

/* ---- Pictures -------------------------------------------------------------------------------- */

unsigned skv_stage_look(skv_stage *stage)
{
    SKV_ASSERT_OR(stage, 0);
    unsigned changed = 0;
    bool settled = skv_session_is_settled(stage->worlds[0]); /* before the picture is taken */
    for (int i = 0; i < stage->count; i++) {
        skv_session *world = stage->worlds[i];
        const skv_picture *before = stage->shown[i];
        uint64_t number = before->number;
        stage->shown[i] = skv_session_acquire(world);
        skv_session_release(world, before);
        if (stage->shown[i]->number != number || world->moved)
            changed |= 1U << i;
        world->moved = false;
    }
    if (settled && !stage->shown[0]->seeking)
        stage->goal = -1;
    return changed;
}

const skv_picture *skv_stage_picture(const skv_stage *stage, int side)
{
    SKV_ASSERT_OR(stage, NULL);
    return stage->shown[skv_stage_at(stage, side)];
}

skv_stage_state skv_stage_now(const skv_stage *stage)
{
    skv_stage_state now = {.at_rest = true, .can_redo = true, .pace = INFINITY};
    SKV_ASSERT_OR(stage, now);
    for (int i = 0; i < stage->count; i++) {
        const skv_picture *picture = stage->shown[i];
        now.at_rest &= picture->at_rest;
        now.seeking |= picture->seeking;
        now.can_undo |= picture->can_undo;
        now.can_redo &= picture->can_redo;
        now.pace = fmin(now.pace, picture->pace);
        now.step_ms += picture->step_ms;
    }
    return now;
}
