/* What a world's files and links say of how it is seen: noted before they are made, and done when
 * they are opened. Invariant: only the worker's thread is here. */
#include <string.h>

#include "base/memory.h"
#include "session/worker.h"

void skv_worker_hear_shown(skv_worker *worker, const skv_message *message)
{
    if (message->kind == SKV_MESSAGE_SHOW) {
        memcpy(&worker->look, message->request->data, sizeof worker->look);
        return;
    }
    skv_free(worker->beside);
    worker->beside = skv_request_copy(message->request);
}

skv_result skv_worker_tell_shown(skv_worker *worker, bool plain, skv_error *error)
{
    skv_showing showing = {0};
    const skv_request *beside = plain ? NULL : worker->beside;
    if (!plain) {
        showing = worker->look;
        showing.paused = atomic_load(&worker->paused);
        skv_probes_note(&worker->probes, &showing);
    }
    if (!beside) {
        showing.choice[0] = '\0';
        showing.apart = false;
    }
    skv_result result = skv_player_show(worker->player, &showing, beside ? beside->data : NULL,
                                        beside ? beside->size : 0, error);
    if (!plain) {
        skv_free(worker->beside);
        worker->beside = NULL;
    }
    return result;
}

static void add_probe(skv_worker *worker, const skv_shown_probe *shown, uint32_t id)
{
    skv_message message = {.kind = SKV_MESSAGE_PROBE_ADD};
    skv_instrument_def *def = &message.probe.def;
    *def = skv_default_instrument_def(shown->kind);
    def->x0 = shown->x0, def->y0 = shown->y0;
    def->x1 = shown->x1, def->y1 = shown->y1;
    skv_format(def->name, sizeof def->name, "%s", skv_instrument_kind_name(shown->kind));
    message.probe.id = id;
    skv_error error;
    if (skv_probes_handle(&worker->probes, &message, &error) != SKV_OK) {
        skv_worker_report(worker, SKV_OUTCOME_EDIT, &error);
        return;
    }
    message.kind = SKV_MESSAGE_PROBE_WATCH;
    message.probe.watched = shown->watched;
    skv_probes_handle(&worker->probes, &message, NULL);
}

/* The second world of what was opened; null if there is none. */
static skv_companion *make_companion(const skv_worker *worker)
{
    const skv_player *player = worker->player;
    if (player->second_size == 0)
        return NULL;
    skv_companion *companion = skv_calloc(1, sizeof *companion + player->second_size);
    if (!companion)
        return NULL;
    memcpy(companion->choice, player->showing.choice, sizeof companion->choice);
    companion->apart = player->showing.apart;
    companion->still = worker->opened->still;
    companion->size = player->second_size;
    memcpy(companion->bytes, player->second, player->second_size);
    return companion;
}

void skv_worker_show(skv_worker *worker, bool changed)
{
    const skv_showing *shown = &worker->player->showing;
    memcpy(worker->opened->view, shown->view, sizeof shown->view);
    memcpy(worker->opened->overlays, shown->overlays, sizeof shown->overlays);
    for (int i = 0; i < shown->probe_count; i++) /* those of before are gone: they begin at 1 */
        add_probe(worker, &shown->probes[i], 1 + (uint32_t)i);
    worker->stops = shown->paused && worker->following;
    worker->opened->still = shown->paused && !worker->following;
    if (worker->opened->still)
        atomic_store(&worker->paused, true);
    skv_free(atomic_exchange(&worker->companion, changed ? NULL : make_companion(worker)));
}
