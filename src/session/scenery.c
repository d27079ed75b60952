/* What the worker tells the face: reports, and pictures of everything there is to see. Invariant:
 * only the worker's thread is here, and it waits for nobody: what has no room is left out. */
#include <math.h>
#include <string.h>

#include "session/worker.h"

void skv_worker_report(skv_worker *worker, skv_outcome_kind kind, const skv_error *error)
{
    unsigned reported = atomic_load_explicit(&worker->reported, memory_order_relaxed);
    if (reported - atomic_load(&worker->reports_taken) == SKV_REPORTS)
        return;
    skv_outcome *report = &worker->reports[reported % SKV_REPORTS];
    *report = (skv_outcome){.kind = kind};
    if (error)
        report->error = *error;
    atomic_store(&worker->reported, reported + 1);
    worker->changed = true;
}

/* An open tap is never at rest, though all its water may sleep. */
static bool has_open_tap(const skv_world *world)
{
    int count;
    const skv_emitter *emitters = skv_world_emitters(world, &count);
    for (int i = 0; i < count; i++)
        if (emitters[i].vx != 0 || emitters[i].vy != 0)
            return true;
    return false;
}

bool skv_worker_at_rest(const skv_worker *worker)
{
    return worker->player && skv_world_awake_count(skv_player_world(worker->player)) == 0 &&
           !skv_tools_busy(&worker->tools) && worker->hand_count == 0 && !worker->tilt_pending &&
           !worker->following && !has_open_tap(skv_player_world(worker->player));
}

static void paint_time(const skv_worker *worker, skv_picture *picture)
{
    const skv_pace *pace = &worker->pace;
    picture->paused = atomic_load(&worker->paused);
    picture->speed = pace->speed;
    picture->pace = pace->factor;
    picture->step_ms = 1000 * pace->step_cost;
    picture->draw_ms = 1000 * pace->drawing;
    picture->at_rest = skv_worker_at_rest(worker);
    const skv_player *player = worker->player;
    if (!player)
        return;
    picture->moment = skv_player_frame(player);
    picture->end = skv_player_end(player);
    picture->seeking = skv_player_seeking(player);
    picture->can_undo = skv_player_can_undo(player);
    picture->can_redo = skv_player_can_redo(player);
    picture->undo_to = skv_player_undo_frame(player);
    picture->redo_to = skv_player_redo_frame(player);
    picture->following = worker->following;
    picture->watching = worker->watching;
    picture->withheld = worker->withheld;
    picture->mismatch = skv_player_mismatch(player) >= 0;
    picture->as_recorded = worker->followed && !picture->seeking && !picture->mismatch;
    picture->substeps = skv_world_substeps_per_frame(skv_player_world(player));
}

static void paint_tools(const skv_worker *worker, skv_picture *picture)
{
    picture->tilt_x = worker->tilt_x;
    picture->tilt_y = worker->tilt_y;
    picture->tool = worker->tools.chosen.tool;
    picture->brush = skv_tools_radius(&worker->tools, worker->tools.chosen.tool);
    picture->hand_count = worker->hand_count;
    for (int i = 0; i < worker->hand_count; i++)
        picture->hands[i] = worker->hands[i];
    picture->mark_count = skv_tools_marks(&worker->tools, picture->marks);
}

/* A ring where the wind of a fan begins, and its way. */
static void paint_fans(const skv_world *world, skv_picture *picture)
{
    int count;
    const skv_force *force = skv_world_forces(world, &count);
    for (int i = 0; i < count; i++, force++) {
        skv_mark mark = {.role = SKV_MARK_WIND,
                         .x0 = force->area.x0,
                         .y0 = force->area.y0,
                         .x1 = force->area.x1,
                         .y1 = force->area.y1,
                         .radius = force->area.radius};
        if (force->area.kind != SKV_AREA_SWEPT_CIRCLE)
            continue;
        mark.shape = SKV_MARK_CIRCLE;
        picture->marks[picture->mark_count++] = mark;
        mark.shape = SKV_MARK_SEGMENT;
        picture->marks[picture->mark_count++] = mark;
    }
}

/* Taps and drains, whoever made them. */
static void paint_sources(const skv_world *world, skv_picture *picture)
{
    int count;
    const skv_emitter *emitter = skv_world_emitters(world, &count);
    for (int i = 0; i < count; i++, emitter++) {
        float speed = sqrtf(emitter->vx * emitter->vx + emitter->vy * emitter->vy);
        float x = speed > 0 ? -emitter->vy / speed : 1, y = speed > 0 ? emitter->vx / speed : 0;
        x *= 0.5f * emitter->width;
        y *= 0.5f * emitter->width;
        picture->marks[picture->mark_count++] = (skv_mark){.shape = SKV_MARK_SEGMENT,
                                                           .role = SKV_MARK_SOURCE,
                                                           .x0 = emitter->x - x,
                                                           .y0 = emitter->y - y,
                                                           .x1 = emitter->x + x,
                                                           .y1 = emitter->y + y};
    }
    const skv_drain *drain = skv_world_drains(world, &count);
    for (int i = 0; i < count; i++, drain++)
        if (drain->area.kind == SKV_AREA_CIRCLE || drain->area.kind == SKV_AREA_SWEPT_CIRCLE)
            picture->marks[picture->mark_count++] = (skv_mark){.shape = SKV_MARK_CIRCLE,
                                                               .role = SKV_MARK_SINK,
                                                               .x0 = drain->area.x0,
                                                               .y0 = drain->area.y0,
                                                               .radius = drain->area.radius};
}

bool skv_worker_publish(skv_worker *worker)
{
    const skv_world *world = worker->player ? skv_player_world(worker->player) : NULL;
    skv_canvas *canvas = skv_gallery_begin(&worker->gallery, world, worker->opened);
    if (!canvas)
        return false;
    const skv_forecast *forecast = &worker->forecast;
    if (world && forecast->known && forecast->count > 0)
        memcpy(canvas->pressure, forecast->pressure,
               (size_t)forecast->count * sizeof *canvas->pressure);
    paint_time(worker, &canvas->picture);
    paint_tools(worker, &canvas->picture);
    if (world) {
        paint_sources(world, &canvas->picture);
        paint_fans(world, &canvas->picture);
    }
    skv_probes_paint(&worker->probes, canvas);
    skv_gallery_hang(&worker->gallery, canvas);
    return true;
}
