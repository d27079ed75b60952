/* What people do on a stage: gravity, parameters, cameras, tools, pointers, instruments. Invariant:
 * tools and instruments are the same in both worlds, and both cameras show the same part of them.
 */
#include <math.h>

#include "base/assert.h"
#include "session/stage.h"

#define STRONGEST_TILT 2.0
#define FASTEST_PUSH   10.0 /* m/s */
#define WIDEST_BRUSH   100.0

/* Whether what is done on a side is done in world i. */
static bool concerns(const skv_stage *stage, int side, int i)
{
    return !stage->apart || i == skv_stage_at(stage, side);
}

void skv_stage_set_linked(skv_stage *stage, bool linked)
{
    SKV_ASSERT(stage);
    skv_stage_cancel_pointers(stage);
    stage->apart = !linked;
}

bool skv_stage_linked(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, true);
    return !stage->apart;
}

/* ---- Gravity and parameters ------------------------------------------------------------------ */

static void ask_vector(skv_stage *stage, int side, skv_message_kind kind, double x, double y)
{
    skv_message message = {.kind = kind};
    message.x = x;
    message.y = y;
    for (int i = 0; i < stage->count; i++)
        if (concerns(stage, side, i))
            skv_session_post(stage->worlds[i], &message);
}

void skv_stage_set_gravity(skv_stage *stage, int side, double x, double y)
{
    SKV_ASSERT(stage);
    double length = hypot(x, y), cut = length > STRONGEST_TILT ? STRONGEST_TILT / length : 1;
    if (isfinite(length))
        ask_vector(stage, side, SKV_MESSAGE_GRAVITY, x * cut, y * cut);
}

static double bounded_speed(double speed)
{
    return fmin(fmax(speed, -FASTEST_PUSH), FASTEST_PUSH);
}

void skv_stage_push(skv_stage *stage, int side, double vx, double vy)
{
    SKV_ASSERT(stage);
    if (isfinite(vx) && isfinite(vy))
        ask_vector(stage, side, SKV_MESSAGE_PUSH, bounded_speed(vx), bounded_speed(vy));
}

void skv_stage_edit(skv_stage *stage, int side, const skv_command *command)
{
    SKV_ASSERT(stage);
    skv_session_edit(stage->worlds[skv_stage_at(stage, side)], command);
}

void skv_stage_set(skv_stage *stage, int side, const char *path, const char *text)
{
    SKV_ASSERT(stage);
    skv_session_set(stage->worlds[skv_stage_at(stage, side)], path, text);
}

/* ---- The view -------------------------------------------------------------------------------- */

void skv_stage_set_view(skv_stage *stage, int side, int width, int height)
{
    SKV_ASSERT(stage);
    if (side < stage->count)
        skv_session_set_view(stage->worlds[side], width, height);
}

skv_camera skv_stage_camera(const skv_stage *stage, int side)
{
    SKV_ASSERT_OR(stage, (skv_camera){.scale = 1, .width = 1, .height = 1});
    return skv_session_camera(stage->worlds[skv_stage_at(stage, side)]);
}

void skv_stage_follow(skv_stage *stage, int side)
{
    skv_camera led = skv_stage_camera(stage, side);
    for (int i = 0; i < stage->count; i++) {
        skv_camera own = skv_stage_camera(stage, i);
        own = skv_camera_apart(own.margin, own.width, own.height, own.world_width, own.world_height,
                               led.centre_x, led.centre_y, led.zoom);
        skv_session_set_camera(stage->worlds[i], &own);
    }
}

static void show(skv_stage *stage, int side, const skv_camera *camera)
{
    skv_session_set_camera(stage->worlds[skv_stage_at(stage, side)], camera);
    skv_stage_follow(stage, side);
}

void skv_stage_zoom(skv_stage *stage, int side, double factor, double px, double py)
{
    SKV_ASSERT(stage);
    if (!(factor > 0) || !isfinite(factor) || !isfinite(px) || !isfinite(py))
        return;
    skv_camera camera = skv_stage_camera(stage, side);
    skv_camera_zoom(&camera, factor, px, py);
    show(stage, side, &camera);
}

void skv_stage_pan(skv_stage *stage, int side, double dx, double dy)
{
    SKV_ASSERT(stage);
    if (!isfinite(dx) || !isfinite(dy))
        return;
    skv_camera camera = skv_stage_camera(stage, side);
    skv_camera_pan(&camera, dx, dy);
    show(stage, side, &camera);
}

void skv_stage_show_all(skv_stage *stage)
{
    SKV_ASSERT(stage);
    skv_camera c = skv_stage_camera(stage, 0);
    c = skv_camera_apart(c.margin, c.width, c.height, c.world_width, c.world_height, 0, 0, 1);
    show(stage, 0, &c);
}

/* ---- Tools and pointers ---------------------------------------------------------------------- */

static void ask_chosen(skv_stage *stage)
{
    skv_stage_ask(stage, &(skv_message){.kind = SKV_MESSAGE_CHOSEN, .chosen = stage->chosen});
}

void skv_stage_set_tool(skv_stage *stage, int tool)
{
    SKV_ASSERT(stage);
    if (!skv_tool_info(tool))
        return;
    stage->chosen.tool = tool;
    ask_chosen(stage);
}

int skv_stage_tool(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, 0);
    return stage->chosen.tool;
}

void skv_stage_set_brush(skv_stage *stage, double radius)
{
    SKV_ASSERT(stage);
    if (isnan(radius))
        return;
    stage->chosen.brush = fmin(fmax(radius, 0), WIDEST_BRUSH);
    ask_chosen(stage);
}

void skv_stage_set_dye(skv_stage *stage, int dye)
{
    SKV_ASSERT(stage);
    if (!skv_dye_name(dye))
        return;
    stage->chosen.dye = dye;
    ask_chosen(stage);
}

int skv_stage_dye(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, 0);
    return stage->chosen.dye;
}

void skv_stage_set_fluid(skv_stage *stage, int fluid)
{
    SKV_ASSERT(stage);
    if (fluid < 0 || fluid >= SKV_MAX_FLUIDS)
        return;
    stage->chosen.fluid = fluid;
    ask_chosen(stage);
}

int skv_stage_fluid(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, 0);
    return stage->chosen.fluid < stage->shown[0]->frame.fluid_count ? stage->chosen.fluid : 0;
}

void skv_stage_set_shape(skv_stage *stage, int shape)
{
    SKV_ASSERT(stage);
    if (!skv_drop_shape(shape))
        return;
    stage->chosen.shape = shape;
    ask_chosen(stage);
}

int skv_stage_shape(const skv_stage *stage)
{
    SKV_ASSERT_OR(stage, 0);
    return stage->chosen.shape;
}

/* A finger that is lifted is nowhere. */
static void note_hover(skv_stage *stage, int side, const skv_pointer_event *event)
{
    stage->hover.known = event->phase != SKV_PHASE_LEAVE && event->device != SKV_DEVICE_FINGER &&
                         isfinite(event->px) && isfinite(event->py);
    stage->hover.side = skv_stage_at(stage, side);
    stage->hover.px = event->px;
    stage->hover.py = event->py;
}

void skv_stage_pointer(skv_stage *stage, int side, const skv_pointer_event *event)
{
    SKV_ASSERT(stage && event);
    note_hover(stage, side, event);
    skv_camera seen = skv_stage_camera(stage, side);
    double x, y;
    skv_camera_to_world(&seen, event->px, event->py, &x, &y);
    for (int i = 0; i < stage->count; i++) {
        skv_pointer_event sent = *event;
        skv_camera own = skv_stage_camera(stage, i);
        if (i != skv_stage_at(stage, side))
            skv_camera_to_view(&own, x, y, &sent.px, &sent.py);
        if (concerns(stage, side, i))
            skv_session_pointer(stage->worlds[i], &sent);
    }
}

static double carry_out(skv_stage *stage, int side, const skv_gesture *gesture)
{
    for (int i = 0; i < gesture->event_count; i++)
        skv_stage_pointer(stage, side, &gesture->events[i]);
    if (gesture->dx != 0 || gesture->dy != 0)
        skv_stage_pan(stage, side, gesture->dx, gesture->dy);
    if (gesture->factor != 1)
        skv_stage_zoom(stage, side, gesture->factor, gesture->px, gesture->py);
    if (gesture->undo)
        skv_stage_undo(stage);
    return gesture->wait;
}

double skv_stage_touch(skv_stage *stage, int side, const skv_pointer_event *event, double tremble)
{
    SKV_ASSERT_OR(stage && event, 0);
    skv_fingers *fingers = &stage->fingers[skv_stage_at(stage, side)];
    fingers->tremble = tremble;
    skv_gesture gesture = skv_fingers_event(fingers, event);
    return carry_out(stage, side, &gesture);
}

double skv_stage_touch_waited(skv_stage *stage, int side)
{
    SKV_ASSERT_OR(stage, 0);
    skv_gesture gesture = skv_fingers_wait(&stage->fingers[skv_stage_at(stage, side)]);
    return carry_out(stage, side, &gesture);
}

void skv_stage_cancel_pointers(skv_stage *stage)
{
    SKV_ASSERT(stage);
    stage->hover.known = false;
    for (int i = 0; i < stage->count; i++) {
        stage->fingers[i] = (skv_fingers){0};
        skv_session_cancel_pointers(stage->worlds[i]);
    }
}

int skv_stage_pointer_count(const skv_stage *stage, int side)
{
    SKV_ASSERT_OR(stage, 0);
    return stage->worlds[skv_stage_at(stage, side)]->down_count;
}

void skv_stage_keyboard(skv_stage *stage, int side, int right, int up, bool down)
{
    SKV_ASSERT(stage);
    for (int i = 0; i < stage->count; i++)
        if (concerns(stage, side, i))
            skv_session_keyboard(stage->worlds[i], right, up, down);
}

/* ---- Instruments ----------------------------------------------------------------------------- */

const skv_probe *skv_stage_probe(const skv_stage *stage, int side, uint32_t probe)
{
    SKV_ASSERT_OR(stage, NULL);
    const skv_picture *picture = side < stage->count ? stage->shown[side] : NULL;
    for (int i = 0; picture && i < picture->probe_count; i++)
        if (picture->probes[i].id == probe)
            return &picture->probes[i];
    return NULL;
}

static void ask_probe(skv_stage *stage, skv_message_kind kind, uint32_t id, bool watched,
                      const skv_instrument_def *def)
{
    skv_message message = {.kind = kind};
    message.probe.id = id;
    message.probe.watched = watched;
    message.probe.def = *def;
    skv_stage_ask(stage, &message);
}

uint32_t skv_stage_add_probe(skv_stage *stage, const skv_instrument_def *def)
{
    SKV_ASSERT_OR(stage && def, 0);
    const skv_picture *picture = stage->shown[0];
    for (int i = 0; i < picture->probe_count;
         i++) /* also those that were there when it was opened */
        if (picture->probes[i].id > stage->next_probe)
            stage->next_probe = picture->probes[i].id;
    ask_probe(stage, SKV_MESSAGE_PROBE_ADD, ++stage->next_probe, false, def);
    return stage->next_probe;
}

void skv_stage_move_probe(skv_stage *stage, uint32_t probe, double x0, double y0, double x1,
                          double y1)
{
    SKV_ASSERT(stage);
    ask_probe(stage, SKV_MESSAGE_PROBE_MOVE, probe, false,
              &(skv_instrument_def){.x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1});
}

void skv_stage_shift_probe(skv_stage *stage, uint32_t probe, double dx, double dy)
{
    SKV_ASSERT(stage);
    const skv_probe *at = skv_stage_probe(stage, 0, probe);
    if (at)
        skv_stage_move_probe(stage, probe, at->def.x0 + dx, at->def.y0 + dy, at->def.x1 + dx,
                             at->def.y1 + dy);
}

void skv_stage_watch_probe(skv_stage *stage, uint32_t probe, bool watched)
{
    SKV_ASSERT(stage);
    ask_probe(stage, SKV_MESSAGE_PROBE_WATCH, probe, watched, &(skv_instrument_def){0});
}

void skv_stage_remove_probe(skv_stage *stage, uint32_t probe)
{
    SKV_ASSERT(stage);
    ask_probe(stage, SKV_MESSAGE_PROBE_REMOVE, probe, false, &(skv_instrument_def){0});
}
