/* What a stage keeps: files and links of one world or two, and how they are shown. Of two worlds
 * the second hands out its replay first, which goes with the first's.
 *
 * Invariant: what is asked for is done in order; while something waits for the second world, no
 * frame is granted, so that both end at one moment.
 */
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "session/stage.h"

/* ---- How it is shown ------------------------------------------------------------------------- */

static void show(skv_stage *stage)
{
    skv_session_show(stage->worlds[0], &stage->look);
}

void skv_stage_set_look(skv_stage *stage, const char *view, const char *overlays)
{
    SKV_ASSERT(stage && view && overlays);
    skv_shown_name(stage->look.view, sizeof stage->look.view, view);
    skv_shown_name(stage->look.overlays, sizeof stage->look.overlays, overlays);
    show(stage);
}

void skv_stage_set_choice(skv_stage *stage, const char *choice)
{
    skv_shown_name(stage->look.choice, sizeof stage->look.choice, choice);
    show(stage);
}

void skv_stage_want_choice(skv_stage *stage, const char *choice)
{
    skv_shown_name(stage->choice, sizeof stage->choice, choice);
}

const char *skv_stage_choice(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, "");
    return stage->look.choice;
}

/* ---- Saving and sharing ---------------------------------------------------------------------- */

/* Asks the first world for it. */
static void ask_first(skv_stage *stage, const skv_errand *errand)
{
    stage->look.apart = stage->apart;
    show(stage);
    if (errand->shares)
        skv_session_share(stage->worlds[0], SKV_SHARE_LINK);
    else
        skv_session_save(stage->worlds[0], errand->path, errand->moment);
}

static void drop_errand(skv_stage *stage)
{
    skv_errand *done = stage->errands;
    stage->errands = done->next;
    stage->asked = false;
    skv_free(done);
}

void skv_stage_drop_errands(skv_stage *stage)
{
    while (stage->errands)
        drop_errand(stage);
}

static void fail(skv_stage *stage, const skv_error *why)
{
    const skv_errand *errand = stage->errands;
    skv_session_fail(stage->worlds[0], errand->shares ? SKV_OUTCOME_SHARE : SKV_OUTCOME_SAVE,
                     why->code, why->text, errand->shares ? "the second world" : errand->path);
    drop_errand(stage);
}

/* The second world has handed out its replay, or cannot. False if it is still at it. */
static bool take_beside(skv_stage *stage)
{
    bool settled = skv_session_is_settled(stage->worlds[1]); /* before what it made is looked for */
    skv_shared *beside = atomic_exchange(&stage->worlds[1]->worker.shared[SKV_SHARE_BESIDE], NULL);
    skv_error error = {.code = SKV_ERROR_MEMORY, .text = "out of memory"};
    if (!beside && !settled)
        return false;
    if (beside && beside->result != SKV_OK)
        error = beside->error;
    else if (beside && skv_session_set_beside(stage->worlds[0], beside->bytes, beside->size))
        error.code = SKV_OK;
    skv_free(beside);
    if (error.code != SKV_OK) {
        fail(stage, &error);
        return true;
    }
    ask_first(stage, stage->errands);
    drop_errand(stage);
    return true;
}

/* Of two worlds at one moment. False if nothing can be done before something else has happened. */
static bool go_on(skv_stage *stage)
{
    const skv_errand *errand = stage->errands;
    if (stage->asked)
        return take_beside(stage);
    if (!skv_stage_is_level(stage))
        return false;
    stage->asked = true;
    skv_session_share(stage->worlds[1], errand->shares   ? SKV_SHARE_BESIDE
                                        : errand->moment ? SKV_SHARE_BESIDE_MOMENT
                                                         : SKV_SHARE_BESIDE_WHOLE);
    return true;
}

void skv_stage_keep_on(skv_stage *stage)
{
    while (stage->errands) {
        const skv_errand *errand = stage->errands;
        if (stage->count == 2 &&
            (errand->shares || errand->moment || skv_names_replay(errand->path))) {
            if (!go_on(stage))
                return;
        } else {
            ask_first(stage, stage->errands);
            drop_errand(stage);
        }
    }
}

static void add_errand(skv_stage *stage, bool shares, bool moment, const char *path)
{
    skv_errand *errand = skv_calloc(1, sizeof *errand + strlen(path) + 1), **last = &stage->errands;
    if (!errand) {
        skv_session_fail(stage->worlds[0], shares ? SKV_OUTCOME_SHARE : SKV_OUTCOME_SAVE,
                         SKV_ERROR_MEMORY, "out of memory", path);
        return;
    }
    errand->shares = shares;
    errand->moment = moment;
    memcpy(errand->path, path, strlen(path) + 1);
    while (*last)
        last = &(*last)->next;
    *last = errand;
    skv_stage_keep_on(stage);
}

void skv_stage_save(skv_stage *stage, const char *path)
{
    SKV_ASSERT(stage && path);
    add_errand(stage, false, false, path);
}

void skv_stage_save_moment(skv_stage *stage, const char *path)
{
    SKV_ASSERT(stage && path);
    add_errand(stage, false, true, path);
}

void skv_stage_share(skv_stage *stage)
{
    SKV_ASSERT(stage);
    add_errand(stage, true, false, "");
}

bool skv_stage_read_shared(skv_stage *stage, skv_write *write, void *user)
{
    SKV_ASSERT_OR(stage, false);
    return skv_session_read_shared(stage->worlds[0], SKV_SHARE_LINK, write, user);
}

/* ---- Opening --------------------------------------------------------------------------------- */

void skv_stage_open_companion(skv_stage *stage)
{
    skv_companion *companion = atomic_exchange(&stage->worlds[0]->worker.companion, NULL);
    skv_error error;
    if (!companion)
        return;
    skv_free(stage->companion);
    skv_session_destroy(stage->next);
    stage->next = NULL;
    stage->companion = companion;
    if (skv_session_create(&stage->def, &stage->next, &error) == SKV_OK) {
        skv_scene_options plain = skv_default_scene_options();
        skv_session_open_memory(stage->next, companion->bytes, companion->size, "skvr", "link",
                                &plain);
    } else {
        skv_session_fail(stage->worlds[0], SKV_OUTCOME_COMPARE, error.code, error.text,
                         "the second world");
    }
}
