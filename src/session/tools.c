/* The table of tools, and the one way that all pointers go through it.
 *
 * Invariant: an edit begins with a mark, before its first command, so that undo takes back all that
 * one pointer drew from down to up.
 */
#include "session/tools.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "skvalp/base.h"
#include "skvalp/bodies.h"

/* What a hand does (docs/stage.md): it carries water at several metres a second. */
#define HAND_ATTRACTION 300.0f /* m/s^2 */
#define HAND_FRICTION   0.0f   /* 1/s */
#define HAND_FOLLOW     40.0f  /* 1/s */
#define FASTEST_HAND    10.0   /* m/s; faster, the fluid would only tear off */
#define SLOW_HAND       2.0    /* m/s of the world's time, in slow motion: it keeps its water */
#define FRAME           (1.0 / 60)

/* What it does to a body: that is drawn as water is, and stops swinging within a second. */
#define BODY_FRICTION 10.0f /* 1/s */
/* How far from its middle a hand feels for one, of its radius: a finger covers what it aims at. */
#define FEELS 0.1

/* Shares of the world's longer side. */
#define HAND_SHARE  0.1
#define BRUSH_SHARE 0.025
#define WALL_SHARE  0.0125
#define WIND_SHARE  0.05
#define BODY_SHARE  0.05

/* m/s of a tap or a fan a metre drawn, and the least and most of it; a tap that is shorter flows
 * down at 1 m/s, a fan blows up. */
#define FLOW_SPEED   10.0
#define SLOWEST_FLOW 0.2
#define FASTEST_FLOW 5.0
#define WOOD         500.0f /* kg/m^2: it floats half out of water */
#define WIND_DRAG    10.0f  /* 1/s: water takes most of the wind's speed on its way through */

typedef struct tool {
    skv_tool info;
    /* Draws from where it has drawn to (x, y), m; null: a hand. */
    void (*draw)(skv_toolbox *box, const skv_pointer *pointer, double x, double y);
    bool goes_on; /* draws also while the pointer rests, with every frame */
    bool at_end;  /* draws when the pointer goes up, and not before */
    double share; /* default radius */
} tool;

/* What is poured. */
static int fluid_of(const skv_toolbox *box)
{
    return box->chosen.fluid < box->fluids ? box->chosen.fluid : 0;
}

static void apply(skv_toolbox *box, const skv_command *command)
{
    box->apply(command, box->user);
}

/* Cuts a vector to a length. */
static void limit(double *x, double *y, double most)
{
    double length = sqrt(*x * *x + *y * *y);
    if (length > most) {
        *x *= most / length;
        *y *= most / length;
    }
}

/* Rounded so that no limit is passed. */
static double whole_steps(double value, double step)
{
    return step > 0 ? trunc(value / step) * step : value;
}

/* ---- Water, walls, and what erases both ------------------------------------------------------ */

/* A piece of a brush's way: from where it has drawn to a point. */
static void dab(skv_toolbox *box, skv_command_kind kind, const skv_pointer *pointer, double x,
                double y, int dye)
{
    skv_command command = {.kind = kind};
    command.water.x0 = (float)pointer->done_x;
    command.water.y0 = (float)pointer->done_y;
    command.water.x1 = (float)x;
    command.water.y1 = (float)y;
    command.water.radius = (float)skv_tools_radius(box, pointer->tool);
    command.water.dye = dye;
    command.water.fluid = kind == SKV_COMMAND_POUR ? fluid_of(box) : 0;
    apply(box, &command);
}

static void paint(skv_toolbox *box, const skv_pointer *pointer, double x, double y, bool erases)
{
    skv_command command = {.kind = SKV_COMMAND_PAINT};
    command.paint.count = 1;
    command.paint.list[0] = (skv_brush_stroke){
        (float)pointer->done_x,
        (float)pointer->done_y,
        (float)x,
        (float)y,
        (float)skv_tools_radius(box, pointer->tool),
        erases,
    };
    apply(box, &command);
}

static void draw_wall(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    paint(box, pointer, x, y, false);
}

static void pour(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    dab(box, SKV_COMMAND_POUR, pointer, x, y, 0);
}

static void dye(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    dab(box, SKV_COMMAND_DYE, pointer, x, y, box->chosen.dye);
}

static void drain(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    dab(box, SKV_COMMAND_DRAIN, pointer, x, y, 0);
}

/* The velocity of what flows the way that was drawn, the faster the longer; 1 m/s upwards or, with
 * -1, downwards, if none was. */
static void flow_along(const skv_pointer *pointer, double x, double y, double upwards, double *vx,
                       double *vy)
{
    *vx = (x - pointer->start_x) * FLOW_SPEED;
    *vy = (y - pointer->start_y) * FLOW_SPEED;
    if (hypot(*vx, *vy) < SLOWEST_FLOW) {
        *vx = 0;
        *vy = upwards;
    }
    limit(vx, vy, FASTEST_FLOW);
}

/* A tap where it went down. */
static void tap(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    double vx, vy;
    flow_along(pointer, x, y, -1, &vx, &vy);
    skv_command command = {.kind = SKV_COMMAND_EMIT};
    command.source.x = (float)pointer->start_x;
    command.source.y = (float)pointer->start_y;
    command.source.vx = (float)vx;
    command.source.vy = (float)vy;
    command.source.width = 2 * (float)skv_tools_radius(box, pointer->tool);
    command.source.fluid = fluid_of(box);
    apply(box, &command);
}

/* A fan: wind all along the way that was drawn. */
static void blow(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    double vx, vy;
    flow_along(pointer, x, y, 1, &vx, &vy);
    skv_command command = {.kind = SKV_COMMAND_FORCE, .force.place = -1};
    command.force.force = (skv_force){
        .area = skv_swept_circle((float)pointer->start_x, (float)pointer->start_y, (float)x,
                                 (float)y, (float)skv_tools_radius(box, pointer->tool)),
        .wind_x = (float)vx,
        .wind_y = (float)vy,
        .drag = WIND_DRAG};
    apply(box, &command);
}

/* A body where it went down. */
static void drop(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    double vx, vy;
    flow_along(pointer, x, y, 0, &vx, &vy);
    skv_command command = {.kind = SKV_COMMAND_DROP};
    command.drop.shape = box->chosen.shape;
    command.drop.x = (float)pointer->start_x;
    command.drop.y = (float)pointer->start_y;
    command.drop.vx = (float)vx;
    command.drop.vy = (float)vy;
    command.drop.radius = (float)skv_tools_radius(box, pointer->tool);
    command.drop.density = WOOD;
    apply(box, &command);
}

/* What lies under it: walls and taps where it moves, and the water all the time. */
static void erase(skv_toolbox *box, const skv_pointer *pointer, double x, double y)
{
    if (!pointer->begun || x != pointer->done_x || y != pointer->done_y) {
        paint(box, pointer, x, y, true);
        dab(box, SKV_COMMAND_CLOSE, pointer, x, y, 0);
    }
    dab(box, SKV_COMMAND_TAKE, pointer, x, y, 0);
}

/* ---- The table ------------------------------------------------------------------------------- */

enum { HAND, WALL, WATER, ERASER, TAP, DRAIN, DYE, WIND, BODY };

static const tool tools[] = {
    [HAND] = {.info = {"hand", "Hand", "Holds water or a body, lifts it and throws it.", '1', false,
                       false, false},
              .share = HAND_SHARE},
    [WALL] = {.info = {"wall", "Wall", "Draws walls.", '2', false, false, false},
              .draw = draw_wall,
              .share = WALL_SHARE},
    [WATER] = {.info = {"water", "Water", "Pours water.", '3', false, true, false},
               .draw = pour,
               .goes_on = true,
               .share = BRUSH_SHARE},
    [ERASER] = {.info = {"eraser", "Eraser",
                         "Takes walls, taps, drains, wind, bodies and water away.", '4', false,
                         false, false},
                .draw = erase,
                .goes_on = true,
                .share = BRUSH_SHARE},
    [TAP] = {.info = {"tap", "Tap", "Lets water flow: draw the way it is to take.", '5', false,
                      true, false},
             .draw = tap,
             .at_end = true,
             .share = WALL_SHARE},
    [DRAIN] = {.info = {"drain", "Drain", "Lets water out.", '6', false, false, false},
               .draw = drain,
               .at_end = true,
               .share = BRUSH_SHARE},
    [DYE] = {.info = {"dye", "Dye", "Colours water and taps; again: the next colour.", '7', true,
                      false, false},
             .draw = dye,
             .goes_on = true,
             .share = BRUSH_SHARE},
    [WIND] = {.info = {"wind", "Wind", "Blows on: draw the way it is to take.", '8', false, false,
                       false},
              .draw = blow,
              .at_end = true,
              .share = WIND_SHARE},
    [BODY] = {.info = {"body", "Body",
                       "Drops what floats: draw the way it is to fly; again: the next shape.", '9',
                       false, false, true},
              .draw = drop,
              .at_end = true,
              .share = BODY_SHARE},
};
enum { TOOLS = sizeof tools / sizeof *tools };

const skv_tool *skv_tool_info(int i)
{
    return i >= 0 && i < TOOLS ? &tools[i].info : NULL;
}

double skv_tools_radius(const skv_toolbox *box, int number)
{
    return box->chosen.brush > 0 ? box->chosen.brush : tools[number].share * box->world_size;
}

/* ---- Brushes --------------------------------------------------------------------------------- */

/* Draws on to (x, y), also where it has been if the tool goes on. */
static void draw_to(skv_toolbox *box, skv_pointer *pointer, double x, double y)
{
    const tool *brush = &tools[pointer->tool];
    if (pointer->begun && x == pointer->done_x && y == pointer->done_y && !brush->goes_on)
        return;
    if (!pointer->begun)
        apply(box, &(skv_command){.kind = SKV_COMMAND_MARK});
    brush->draw(box, pointer, x, y);
    pointer->begun = true;
    pointer->done_x = x;
    pointer->done_y = y;
}

/* Draws all of the way that a pointer has gone. */
static void draw_way(skv_toolbox *box, skv_pointer *pointer)
{
    for (int i = 0; i < pointer->way_count; i++)
        draw_to(box, pointer, pointer->way[i][0], pointer->way[i][1]);
    pointer->way_count = 0;
    draw_to(box, pointer, pointer->x, pointer->y);
}

/* A straight line is drawn when its end is known. */
static bool waits_for_end(const skv_pointer *pointer)
{
    return pointer->straight || tools[pointer->tool].at_end;
}

/* Notes a corner of the way; if there are too many, the last one makes room. */
static void note_way(skv_pointer *pointer)
{
    int i = pointer->way_count < SKV_MOST_WAY ? pointer->way_count++ : SKV_MOST_WAY - 1;
    pointer->way[i][0] = pointer->x;
    pointer->way[i][1] = pointer->y;
}

static bool has_way_to_go(const skv_pointer *pointer)
{
    return !pointer->begun || pointer->x != pointer->done_x || pointer->y != pointer->done_y;
}

void skv_tools_draw(skv_toolbox *box)
{
    for (int i = 0; i < box->pointers.count; i++) {
        skv_pointer *pointer = &box->pointers.list[i];
        if (tools[pointer->tool].draw && !waits_for_end(pointer) && has_way_to_go(pointer))
            draw_way(box, pointer);
    }
}

/* ---- Events ---------------------------------------------------------------------------------- */

static void go_down(skv_toolbox *box, const skv_pointer_event *event, skv_pointer_id id)
{
    skv_pointer *pointer = skv_pointers_down(&box->pointers, id, event->px, event->py, event->time);
    if (!pointer)
        return;
    bool erases = event->secondary || event->device == SKV_DEVICE_ERASER;
    pointer->tool = erases ? ERASER : box->chosen.tool;
    pointer->straight = event->straight;
    pointer->pressure = event->pressure;
    pointer->start_x = pointer->held_x = pointer->done_x = event->px;
    pointer->start_y = pointer->held_y = pointer->done_y = event->py;
}

static void go_up(skv_toolbox *box, skv_pointer_id id, bool complete)
{
    skv_pointer *pointer = skv_pointers_find(&box->pointers, id);
    if (pointer && complete && tools[pointer->tool].draw && has_way_to_go(pointer))
        draw_way(box, pointer);
    skv_pointers_up(&box->pointers, id);
}

void skv_tools_event(skv_toolbox *box, const skv_pointer_event *original)
{
    skv_pointer_event rounded = *original, *event = &rounded;
    rounded.px = skv_in_steps(original->px, box->steps.length);
    rounded.py = skv_in_steps(original->py, box->steps.length);
    skv_pointer_id id = {event->device, event->pointer};
    bool down = skv_pointers_find(&box->pointers, id) != NULL;
    bool finger = event->device == SKV_DEVICE_FINGER;
    skv_pointer *moved;
    switch (event->phase) {
    case SKV_PHASE_DOWN:
        go_down(box, event, id);
        break;
    case SKV_PHASE_MOVE:
        moved = skv_pointers_move(&box->pointers, id, event->px, event->py, event->time);
        if (moved && tools[moved->tool].draw && !waits_for_end(moved))
            note_way(moved);
        if (!down && isfinite(event->px) && isfinite(event->py)) {
            box->hover_x = event->px;
            box->hover_y = event->py;
        }
        break;
    case SKV_PHASE_UP:
    case SKV_PHASE_LEAVE:
        go_up(box, id, event->phase == SKV_PHASE_UP);
        break;
    }
    box->hovering = !finger && event->phase != SKV_PHASE_LEAVE;
    if (event->phase != SKV_PHASE_MOVE && !finger) {
        box->hover_x = event->px;
        box->hover_y = event->py;
    }
}

void skv_tools_cancel(skv_toolbox *box)
{
    box->pointers.count = 0;
    box->hovering = false;
}

/* ---- Frames ---------------------------------------------------------------------------------- */

/* What it holds is what lies where it went down: a body, or else water. */
static void grasp(const skv_toolbox *box, const skv_world *world, skv_pointer *pointer)
{
    pointer->begun = true;
    pointer->hold = skv_default_hand();
    float reach = (float)(FEELS * skv_tools_radius(box, pointer->tool));
    skv_world_grasp(world, (float)pointer->start_x, (float)pointer->start_y, reach, &pointer->hold);
}

/* What is held follows the pointer. In slow motion a finger moves fast for the water, which would
 * lose it: then it follows at a pace that water can keep, and both show. */
static skv_hand hold(const skv_toolbox *box, skv_pointer *pointer, const skv_slice *slice)
{
    double fastest = slice->slow_motion ? SLOW_HAND : FASTEST_HAND;
    double gap_x = pointer->x - pointer->held_x, gap_y = pointer->y - pointer->held_y;
    double x = gap_x * slice->share, y = gap_y * slice->share;
    limit(&x, &y, fastest * FRAME);
    pointer->held_x += whole_steps(x, box->steps.length);
    pointer->held_y += whole_steps(y, box->steps.length);

    /* It moves as the pointer does, or where it lags behind, at its own pace. */
    double scale = slice->real / FRAME;
    double vx = pointer->vx * scale, vy = pointer->vy * scale;
    if (x * x + y * y > 0.98 * (fastest * FRAME) * (fastest * FRAME)) {
        vx = x / FRAME;
        vy = y / FRAME;
    }
    limit(&vx, &vy, fastest);
    skv_hand hand = pointer->hold;
    hand.x = (float)pointer->held_x;
    hand.y = (float)pointer->held_y;
    hand.vx = (float)whole_steps(vx, box->steps.speed);
    hand.vy = (float)whole_steps(vy, box->steps.speed);
    hand.radius = (float)skv_tools_radius(box, pointer->tool);
    hand.attraction = HAND_ATTRACTION;
    hand.friction = hand.body ? BODY_FRICTION : HAND_FRICTION;
    hand.follow = HAND_FOLLOW;
    return hand;
}

int skv_tools_frame(skv_toolbox *box, const skv_world *world, const skv_slice *slice,
                    skv_hand hands[SKV_MAX_HANDS])
{
    int count = 0;
    for (int i = 0; i < box->pointers.count; i++) {
        skv_pointer *pointer = &box->pointers.list[i];
        bool holds = !tools[pointer->tool].draw;
        if (holds && !pointer->begun)
            grasp(box, world, pointer);
        if (holds)
            hands[count++] = hold(box, pointer, slice);
        else if (tools[pointer->tool].goes_on && !waits_for_end(pointer))
            draw_way(box, pointer);
    }
    return count;
}

bool skv_tools_busy(const skv_toolbox *box)
{
    return box->pointers.count > 0;
}

/* ---- What shows ------------------------------------------------------------------------------ */

static skv_mark circle(skv_mark_role role, double x, double y, double radius)
{
    return (skv_mark){.shape = SKV_MARK_CIRCLE,
                      .role = role,
                      .x0 = (float)x,
                      .y0 = (float)y,
                      .radius = (float)radius};
}

static skv_mark segment(skv_mark_role role, double x0, double y0, double x1, double y1)
{
    return (skv_mark){.shape = SKV_MARK_SEGMENT,
                      .role = role,
                      .x0 = (float)x0,
                      .y0 = (float)y0,
                      .x1 = (float)x1,
                      .y1 = (float)y1,
                      .dashed = true};
}

/* A brush of a tool, full of its colour. */
static skv_mark brush_at(const skv_toolbox *box, int number, double x, double y)
{
    skv_mark mark = circle(SKV_MARK_BRUSH, x, y, skv_tools_radius(box, number));
    mark.dye = tools[number].info.dyes ? box->chosen.dye : 0;
    return mark;
}

/* At most three marks of a pointer. */
static int mark_pointer(const skv_toolbox *box, const skv_pointer *p, skv_mark *marks)
{
    double radius = skv_tools_radius(box, p->tool);
    int count = 0;
    if (tools[p->tool].draw) {
        marks[count++] = brush_at(box, p->tool, p->x, p->y);
        if (waits_for_end(p))
            marks[count++] = segment(SKV_MARK_BRUSH, p->start_x, p->start_y, p->x, p->y);
        return count;
    }
    marks[count++] =
        circle(SKV_MARK_HAND, p->held_x, p->held_y, p->hold.body ? FEELS * radius : radius);
    if (hypot(p->x - p->held_x, p->y - p->held_y) > 0.1 * radius) {
        marks[count++] = segment(SKV_MARK_HAND, p->held_x, p->held_y, p->x, p->y);
        marks[count] = circle(SKV_MARK_HAND, p->x, p->y, 0);
        marks[count++].shape = SKV_MARK_POINT;
    }
    return count;
}

int skv_tools_marks(const skv_toolbox *box, skv_mark marks[SKV_MOST_MARKS])
{
    int count = 0;
    for (int i = 0; i < box->pointers.count; i++)
        count += mark_pointer(box, &box->pointers.list[i], &marks[count]);
    if (box->hovering && count == 0 && tools[box->chosen.tool].draw)
        marks[count++] = brush_at(box, box->chosen.tool, box->hover_x, box->hover_y);
    return count;
}
