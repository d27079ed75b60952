/* Steps of a run.
 *
 * Invariant: a world at a frame has come there by whole frames only. Substeps that are taken singly
 * round differently, so what was stepped to look at a moment between two frames is taken back.
 */
#include "stepping.h"
#include "skvalp/snapshot.h"

#include <stdlib.h>

const skv_world *stepping_world(const run_stepping *s)
{
    return s->player ? skv_player_world(s->player) : s->world;
}

static skv_result keep_frame(run_stepping *s, skv_error *error)
{
    s->size = skv_world_snapshot_size(s->world, false);
    if (s->size > s->room) {
        uint8_t *room = realloc(s->frame, s->size);
        if (!room)
            return skv_fail(error, SKV_ERROR_MEMORY, "no memory for %zu bytes", s->size);
        s->frame = room;
        s->room = s->size;
    }
    return skv_world_save(s->world, false, s->frame, s->size, error);
}

static skv_result step_world(run_stepping *s, float step, bool from_frame, bool to_frame,
                             skv_error *error)
{
    skv_result result = SKV_OK;
    if (from_frame && !to_frame)
        result = keep_frame(s, error);
    else if (to_frame && !from_frame)
        result = skv_world_restore(s->world, s->frame, s->size, error);
    return result ? result : skv_world_step(s->world, to_frame ? 1.0f / 60 : step, error);
}

skv_result stepping_advance(run_stepping *s, run_timeline *timeline, skv_error *error)
{
    bool from_frame = timeline->at_frame;
    float step = timeline_next(timeline);
    if (s->player)
        return timeline->at_frame ? skv_player_step(s->player, error) : SKV_OK;
    return step_world(s, step, from_frame, timeline->at_frame, error);
}

void stepping_free(run_stepping *s)
{
    free(s->frame);
    skv_world_destroy(s->world);
    skv_player_destroy(s->player);
}
