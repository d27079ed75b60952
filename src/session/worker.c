/* The worker's loop: messages, a moment that is sought, the frames that are due, and a picture.
 *
 * Invariants: commands reach the world through the player only, between two frames; what the face
 * asks for while a moment is sought waits until it is reached, but for another moment.
 */
#include "session/worker.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "world/parameters.h"

#define FRAME             (1.0 / 60)
#define STRONGEST_GRAVITY 1000.0
/* Simulated over real seconds below which pointers are held back (tools.c). */
#define SLOW 0.95

/* ---- Commands -------------------------------------------------------------------------------- */

/* A step, or a way to a moment, has failed: it stands still until somebody plays on. */
static void fail_step(skv_worker *worker, const skv_error *error)
{
    skv_pace_rest(&worker->pace);
    atomic_store(&worker->paused, true);
    skv_worker_report(worker, SKV_OUTCOME_STEP, error);
}

/* The pressures are those of what was there before. */
static void unbalance(skv_worker *worker)
{
    worker->unbalanced = worker->unread = true;
    worker->forecast.known = false;
}

/* What a person does takes over from a replay. */
static bool give(skv_worker *worker, const skv_command *command, bool edits, skv_error *error)
{
    skv_result result = edits ? skv_player_edit(worker->player, command, error)
                              : skv_player_apply(worker->player, command, error);
    if (result != SKV_OK)
        return false;
    worker->following = worker->watching = false;
    worker->changed = worker->unread = true;
    if (skv_command_changes_balance(command->kind))
        unbalance(worker);
    return true;
}

static skv_result find_room(const skv_world *world, skv_error *error)
{
    skv_world_def def = skv_world_describe(world);
    if (def.emission_replaces || skv_world_particle_count(world) < def.emission_limit)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_LIMIT,
                    "there are %d particles, and emission.limit is %d; raise it, or let water out",
                    skv_world_particle_count(world), def.emission_limit);
}

/* Water that people add keeps to the limit of emitters, and a tap that would stay dry is none. */
static skv_result check_room(const skv_worker *worker, skv_command_kind kind, skv_error *error)
{
    bool adds = kind == SKV_COMMAND_POUR || kind == SKV_COMMAND_EMIT;
    return adds ? find_room(skv_player_world(worker->player), error) : SKV_OK;
}

/* Of a tap that has run dry is told once, until there is room again. */
static void look_at_taps(skv_worker *worker)
{
    const skv_world *world = skv_player_world(worker->player);
    skv_error error;
    int taps;
    skv_world_emitters(world, &taps);
    bool dry = taps > 0 && find_room(world, &error) != SKV_OK;
    if (dry && !worker->dry)
        skv_worker_report(worker, SKV_OUTCOME_EDIT, &error);
    worker->dry = dry;
}

/* An edit, which begins with its first command that the world takes; what refuses one is told once
 * a picture, for a brush asks for many. */
static void edit(const skv_command *command, void *user)
{
    skv_worker *worker = user;
    skv_error error;
    if (command->kind == SKV_COMMAND_MARK) {
        worker->begins = true;
    } else if (worker->player && check_room(worker, command->kind, &error) == SKV_OK &&
               give(worker, command, worker->begins, &error)) {
        worker->begins = false;
    } else if (worker->player && !worker->refused) {
        worker->refused = true;
        skv_worker_report(worker, SKV_OUTCOME_EDIT, &error);
    }
}

/* Gravity as it shows is the world's, whoever has changed it. */
static void look_at_gravity(skv_worker *worker)
{
    float x, y;
    skv_world_gravity(skv_player_world(worker->player), &x, &y);
    worker->tilt_x = (double)x / worker->tools.steps.strength;
    worker->tilt_y = (double)y / worker->tools.steps.strength;
    worker->tilt_pending = false;
}

static void change_probes(skv_worker *worker, const skv_message *message)
{
    skv_error error;
    worker->unread = true;
    if (worker->player && skv_probes_handle(&worker->probes, message, &error) != SKV_OK)
        skv_worker_report(worker, SKV_OUTCOME_EDIT, &error);
}

/* What people do while they watch is not done: one touch would cut off what is still to come. */
static bool withhold(skv_worker *worker)
{
    worker->withheld += worker->watching;
    return worker->watching;
}

/* What is no edit: it can be gone back behind, but not undone. */
static void act(skv_worker *worker, const skv_command *command)
{
    skv_error error;
    if (worker->player && !give(worker, command, false, &error))
        skv_worker_report(worker, SKV_OUTCOME_EDIT, &error);
}

static float gravity_component(double value)
{
    return (float)fmin(fmax(value, -STRONGEST_GRAVITY), STRONGEST_GRAVITY);
}

static void tilt(skv_worker *worker)
{
    float x, y;
    skv_world_gravity(skv_player_world(worker->player), &x, &y);
    skv_command command = {.kind = SKV_COMMAND_GRAVITY};
    const skv_steps *steps = &worker->tools.steps;
    double ax = worker->tilt_x * steps->strength, ay = worker->tilt_y * steps->strength;
    command.vector.x = gravity_component(skv_in_steps(ax, steps->gravity));
    command.vector.y = gravity_component(skv_in_steps(ay, steps->gravity));
    worker->tilt_pending = false;
    if (command.vector.x != x || command.vector.y != y)
        act(worker, &command);
}

static void do_edit(skv_worker *worker, const skv_command *command)
{
    if (!worker->player)
        return;
    if (worker->tilt_pending) /* which was asked for before */
        tilt(worker);
    worker->begins = true;
    edit(command, worker);
    worker->begins = false;
    look_at_gravity(worker);
}

/* The world's hands are what tools hold, as soon as the session is the one who plays. */
static void give_hands(skv_worker *worker, const skv_hand *hands, int count)
{
    size_t size = (size_t)count * sizeof *hands;
    bool same = worker->hands_known && count == worker->hand_count &&
                (count == 0 || memcmp(hands, worker->hands, size) == 0);
    if (same || (worker->following && count == 0))
        return;
    skv_command command = {.kind = SKV_COMMAND_HANDS};
    command.hands.count = count;
    if (count)
        memcpy(command.hands.list, hands, size);
    skv_error error;
    if (!give(worker, &command, false, &error)) {
        skv_worker_report(worker, SKV_OUTCOME_EDIT, &error);
        return;
    }
    if (count)
        memcpy(worker->hands, hands, size);
    worker->hand_count = count;
    worker->hands_known = true;
}

/* ---- Moments --------------------------------------------------------------------------------- */

/* At the end of what is followed, the hash there given, too. */
static void end_following(skv_worker *worker)
{
    worker->following = worker->watching = false;
    worker->followed = !worker->again;
    if (worker->stops)
        atomic_store(&worker->paused, true);
    worker->stops = false;
}

static bool is_at_end(const skv_worker *worker)
{
    return skv_player_frame(worker->player) >= skv_player_end(worker->player);
}

/* After a move in time: hands and gravity are those of the moment. */
static void arrive(skv_worker *worker, skv_result result, const skv_error *error)
{
    if (result != SKV_OK) {
        fail_step(worker, error);
        return;
    }
    look_at_gravity(worker);
    worker->hands_known = false;
    worker->changed = worker->unread = true;
    worker->unbalanced = skv_player_unbalanced(worker->player);
    worker->forecast.known = false;
    skv_pace_rest(&worker->pace);
    if (worker->following && !skv_player_seeking(worker->player) && is_at_end(worker))
        end_following(worker);
}

static skv_result play_again(skv_worker *worker, skv_replay replay, skv_error *error)
{
    skv_result result =
        replay == SKV_REPLAY_OFFERED ? skv_player_cut_to_shared(worker->player, error) : SKV_OK;
    if (result == SKV_OK)
        result = skv_player_seek(worker->player, 0, error);
    worker->following = result == SKV_OK && skv_player_end(worker->player) > 0;
    worker->watching = worker->following && replay != SKV_REPLAY_OFFERED;
    worker->again = worker->following && replay != SKV_REPLAY_OPENED;
    worker->stops = worker->stops && replay == SKV_REPLAY_OPENED;
    if (worker->watching)
        skv_tools_cancel(&worker->tools);
    return result;
}

static void travel(skv_worker *worker, const skv_message *message)
{
    skv_error error;
    skv_result result = SKV_OK;
    bool cuts = message->kind != SKV_MESSAGE_SEEK && message->kind != SKV_MESSAGE_REPLAY;
    if (!worker->player || (cuts && withhold(worker)))
        return;
    if (message->kind == SKV_MESSAGE_SEEK)
        result = skv_player_seek(worker->player, message->frame, &error);
    else if (message->kind == SKV_MESSAGE_UNDO)
        result = skv_player_undo(worker->player, &error);
    else if (message->kind == SKV_MESSAGE_REDO)
        result = skv_player_redo(worker->player, &error);
    else if (message->kind == SKV_MESSAGE_GO_BACK)
        result = skv_player_go_back(worker->player, message->frame, &error);
    else
        result = play_again(worker, (skv_replay)message->number, &error);
    arrive(worker, result, &error);
}

/* ---- Frames ---------------------------------------------------------------------------------- */

static bool step_frame(skv_worker *worker)
{
    skv_error error;
    double before = worker->def.clock();
    skv_result result = skv_player_step(worker->player, &error);
    if (result == SKV_OK)
        result = skv_probes_sample(&worker->probes, skv_player_world(worker->player), NULL, &error);
    worker->halted = result == SKV_STOPPED;
    if (result != SKV_OK) {
        if (!worker->halted)
            fail_step(worker, &error);
        return false;
    }
    look_at_taps(worker);
    worker->unread = worker->unbalanced = worker->forecast.known = false;
    skv_pace_stepped(&worker->pace, worker->def.clock() - before);
    worker->changed = true;
    return true;
}

/* What stands in the log after its last frame, the hash there, is given on the way. */
static void reach_end(skv_worker *worker)
{
    skv_error error;
    end_following(worker);
    if (skv_player_seek(worker->player, skv_player_end(worker->player), &error) != SKV_OK)
        fail_step(worker, &error);
}

/* One of the session's own: what tools hold first, and no way back to what came after. False if no
 * other may follow at once. */
static bool play_frame(skv_worker *worker, const skv_slice *slice)
{
    skv_hand hands[SKV_MAX_HANDS];
    skv_error error;
    if (!worker->following && skv_player_cut(worker->player, &error) != SKV_OK) {
        fail_step(worker, &error);
        return false;
    }
    if (worker->tilt_pending)
        tilt(worker);
    const skv_world *world = skv_player_world(worker->player);
    give_hands(worker, hands, skv_tools_frame(&worker->tools, world, slice, hands));
    if (!step_frame(worker))
        return false;
    if (!worker->following || !is_at_end(worker))
        return true;
    reach_end(worker);
    return false;
}

/* Steps some frames at once; the pointers' ways are shared out among them. */
static void play(skv_worker *worker, int frames, double factor)
{
    skv_slice slice = {.real = FRAME / factor, .slow_motion = factor < SLOW};
    for (int i = 0; i < frames; i++) {
        slice.share = 1.0 / (frames - i);
        if (!play_frame(worker, &slice))
            return;
    }
}

/* In the past, one along the log: looking on cuts nothing off. */
static void step_once(skv_worker *worker)
{
    if (!worker->player)
        return;
    if (is_at_end(worker))
        play(worker, 1, 1);
    else if (step_frame(worker) && worker->following && is_at_end(worker))
        reach_end(worker);
}

/* Frames that another's time grants. */
static void play_granted(skv_worker *worker, int frames, double factor)
{
    if (worker->player && !worker->halted && !atomic_load(&worker->paused)) {
        worker->pace.factor = factor / worker->pace.speed;
        play(worker, frames, factor);
    }
    atomic_fetch_add(&worker->played, (unsigned)frames);
}

static double take_elapsed(skv_worker *worker)
{
    return (double)atomic_exchange(&worker->elapsed, 0) * 1e-9;
}

/* Lets the time pass that has passed. */
static void pass_time(skv_worker *worker)
{
    double seconds = take_elapsed(worker);
    bool plays = worker->player && !atomic_load(&worker->paused);
    if (seconds <= 0)
        return;
    skv_pace_drawn(&worker->pace, atomic_load(&worker->drawing) * 1e-6);
    skv_pointers_pass(&worker->tools.pointers, seconds);
    if (worker->led)
        return;
    if (!plays || (skv_worker_at_rest(worker) && !worker->timed)) {
        skv_pace_rest(&worker->pace);
        return;
    }
    double budget = skv_pace_budget(worker->def.own_thread, worker->interval, worker->pace.drawing);
    int frames = skv_pace_pass(&worker->pace, seconds, budget);
    play(worker, frames, worker->pace.speed * worker->pace.factor);
}

/* ---- Messages -------------------------------------------------------------------------------- */

static void handle(skv_worker *worker, const skv_message *message)
{
    switch (message->kind) {
    case SKV_MESSAGE_OPEN:
        atomic_fetch_sub(&worker->openings, 1); /* so that another one stops it */
        skv_worker_open(worker, message->request);
        break;
    case SKV_MESSAGE_SAVE:
        skv_worker_save(worker, message->request);
        atomic_fetch_sub(&worker->savings, 1);
        break;
    case SKV_MESSAGE_EDIT:
        if (!withhold(worker))
            do_edit(worker, message->request->data);
        break;
    case SKV_MESSAGE_SHARE:
        skv_worker_share(worker, (skv_share)message->number);
        atomic_fetch_sub(&worker->savings, 1);
        break;
    case SKV_MESSAGE_SHOW:
    case SKV_MESSAGE_BESIDE:
        skv_worker_hear_shown(worker, message);
        break;
    case SKV_MESSAGE_LOOK:
        break;
    case SKV_MESSAGE_STEP:
        step_once(worker);
        break;
    case SKV_MESSAGE_SPEED:
        worker->pace.speed = message->x;
        break;
    case SKV_MESSAGE_SEEK:
    case SKV_MESSAGE_UNDO:
    case SKV_MESSAGE_REDO:
    case SKV_MESSAGE_GO_BACK:
    case SKV_MESSAGE_REPLAY:
        travel(worker, message);
        break;
    case SKV_MESSAGE_LED:
        worker->led = message->number != 0;
        break;
    case SKV_MESSAGE_TIMED:
        worker->timed = message->number != 0;
        break;
    case SKV_MESSAGE_PLAY:
        play_granted(worker, message->play.frames, message->play.factor);
        break;
    case SKV_MESSAGE_TAKE_OVER:
        worker->following = worker->watching = worker->stops = false;
        break;
    case SKV_MESSAGE_GRAVITY: /* a device that is held says it all the time: no word of that */
        if (worker->watching)
            break;
        worker->tilt_x = message->x;
        worker->tilt_y = message->y;
        worker->tilt_pending = worker->player != NULL;
        break;
    case SKV_MESSAGE_PUSH:
        if (!worker->watching)
            act(worker, &(skv_command){.kind = SKV_COMMAND_PUSH,
                                       .vector = {(float)message->x, (float)message->y}});
        break;
    case SKV_MESSAGE_CHOSEN:
        worker->tools.chosen = message->chosen;
        break;
    case SKV_MESSAGE_POINTER:
        if (message->pointer.phase != SKV_PHASE_DOWN || !withhold(worker))
            skv_tools_event(&worker->tools, &message->pointer);
        break;
    case SKV_MESSAGE_CANCEL:
        skv_tools_cancel(&worker->tools);
        break;
    default:
        change_probes(worker, message);
        break;
    }
    worker->changed = true;
}

static void drop(skv_worker *worker, const skv_message *message)
{
    if (skv_message_has_request(message))
        skv_free(message->request);
    skv_mailbox_drop(&worker->mailbox);
}

static bool is_seeking(const skv_worker *worker)
{
    return worker->player && skv_player_seeking(worker->player);
}

/* Whether a message has to wait until the moment is reached that is sought. */
static bool has_to_wait(const skv_worker *worker, const skv_message *message)
{
    return is_seeking(worker) && !worker->halted && message->kind != SKV_MESSAGE_SEEK &&
           message->kind != SKV_MESSAGE_OPEN;
}

static void handle_messages(skv_worker *worker)
{
    const skv_message *message;
    while ((message = skv_mailbox_next(&worker->mailbox)) && !atomic_load(&worker->quit) &&
           !has_to_wait(worker, message)) {
        if (!worker->halted || skv_message_outlives(message))
            handle(worker, message);
        drop(worker, message);
    }
}

/* ---- The loop -------------------------------------------------------------------------------- */

/* What was changed shows in the next picture, whether it is stepped or not. */
static void read_still(skv_worker *worker)
{
    skv_error error;
    if (!worker->player || is_seeking(worker))
        return;
    const skv_world *world = skv_player_world(worker->player);
    if (worker->unbalanced && !atomic_load(&worker->active)) {
        skv_forecast_make(&worker->forecast, world, worker->pool);
        worker->unbalanced = false;
        worker->changed = worker->unread = true;
    }
    if (!worker->unread)
        return;
    worker->unread = false;
    const float *pressure = worker->forecast.known ? worker->forecast.pressure : NULL;
    if (skv_probes_sample(&worker->probes, world, pressure, &error) != SKV_OK)
        skv_worker_report(worker, SKV_OUTCOME_EDIT, &error);
}

/* Some steps are not waited for: those after which nothing of the world is wanted. */
bool skv_worker_is_unwanted(void *user)
{
    skv_worker *worker = user;
    return atomic_load(&worker->quit) ||
           (atomic_load(&worker->openings) > 0 && atomic_load(&worker->savings) == 0);
}

/* A step on the way to the moment that is sought. */
static void seek_on(skv_worker *worker)
{
    skv_error error;
    skv_result result = skv_player_step(worker->player, &error);
    worker->halted = result == SKV_STOPPED;
    if (!worker->halted && (result != SKV_OK || !skv_player_seeking(worker->player)))
        arrive(worker, result, &error);
    take_elapsed(worker);
}

/* What was to be opened could not be: the world goes back to its moment. */
static void recover(skv_worker *worker)
{
    skv_tools_cancel(&worker->tools);
    seek_on(worker);
}

/* A piece of work; false if none is left: time that passes may lead to a moment that is sought. */
static bool work(skv_worker *worker)
{
    handle_messages(worker);
    if (worker->halted && atomic_load(&worker->openings) > 0)
        return false;
    if (worker->halted)
        recover(worker);
    if (is_seeking(worker)) {
        seek_on(worker);
    } else {
        if (worker->player)
            skv_tools_draw(&worker->tools);
        pass_time(worker);
    }
    if (worker->halted)
        return false;
    bool plays = worker->player && !atomic_load(&worker->paused);
    bool active = plays && (worker->timed || !skv_worker_at_rest(worker));
    if (active != atomic_load(&worker->active)) {
        atomic_store(&worker->active, active);
        worker->changed = true;
    }
    read_still(worker);
    if (worker->changed && skv_worker_publish(worker)) {
        worker->changed = worker->refused = false;
        if (worker->def.wake)
            worker->def.wake(worker->def.user);
    }
    return is_seeking(worker);
}

void skv_worker_pump(skv_worker *worker)
{
    for (;;) {
        unsigned posted = atomic_load(&worker->posted);
        bool busy = work(worker);
        if (atomic_load(&worker->quit))
            return;
        if (busy || posted != atomic_load(&worker->posted))
            continue;
        atomic_store(&worker->settled, posted);
        skv_threads_wake(worker->threads);
        return;
    }
}

void skv_worker_start(skv_worker *worker, const skv_stage_def *def)
{
    worker->def = *def;
    if (!worker->def.clock)
        worker->def.clock = skv_clock;
    worker->pace = skv_pace_start();
    worker->tools.apply = edit;
    worker->tools.user = worker;
    worker->tools.chosen.dye = 1;
    skv_gallery_create(&worker->gallery);
}

void skv_worker_close(skv_worker *worker)
{
    const skv_message *message;
    while ((message = skv_mailbox_next(&worker->mailbox)))
        drop(worker, message);
    skv_player_destroy(worker->player);
    skv_opened_leave(worker->opened);
    for (int i = 0; i < SKV_SHARES; i++)
        skv_free(atomic_load(&worker->shared[i]));
    skv_free(atomic_load(&worker->companion));
    skv_free(worker->beside);
    skv_probes_destroy(&worker->probes);
    skv_forecast_free(&worker->forecast);
    skv_gallery_destroy(&worker->gallery);
}
