/* Asking one world or both. Invariant: two worlds side by side are asked for the same time and the
 * same instruments. */
#include "asking.h"

/* Time. */

void play_ask_pause(PlayView *view, gboolean paused)
{
    if (play_view_pair(view))
        skv_pair_set_paused(play_view_pair(view), paused);
    else
        skv_session_set_paused(play_view_session(view), paused);
}

void play_ask_step(PlayView *view)
{
    if (play_view_pair(view))
        skv_pair_step_once(play_view_pair(view));
    else
        skv_session_step_once(play_view_session(view));
}

void play_ask_speed(PlayView *view, double speed)
{
    if (play_view_pair(view))
        skv_pair_set_speed(play_view_pair(view), speed);
    else
        skv_session_set_speed(play_view_session(view), speed);
}

void play_ask_seek(PlayView *view, gint64 frame)
{
    if (play_view_pair(view))
        skv_pair_seek(play_view_pair(view), frame);
    else
        skv_session_seek(play_view_session(view), frame);
}

void play_ask_undo(PlayView *view)
{
    if (play_view_pair(view))
        skv_pair_undo(play_view_pair(view));
    else
        skv_session_undo(play_view_session(view));
}

void play_ask_redo(PlayView *view)
{
    if (play_view_pair(view))
        skv_pair_redo(play_view_pair(view));
    else
        skv_session_redo(play_view_session(view));
}

gboolean play_can_undo(PlayView *view)
{
    PlayView *twin = play_view_twin(view);
    return play_view_picture(view)->can_undo || (twin && play_view_picture(twin)->can_undo);
}

gboolean play_can_redo(PlayView *view)
{
    PlayView *twin = play_view_twin(view);
    return play_view_picture(view)->can_redo && (!twin || play_view_picture(twin)->can_redo);
}

/* Tools and gravity. */

void play_ask_tool(PlayView *view, int tool)
{
    skv_session_set_tool(play_view_session(view), tool);
    if (play_view_twin(view))
        skv_session_set_tool(play_view_session(play_view_twin(view)), tool);
}

void play_ask_dye(PlayView *view, int dye)
{
    skv_session_set_dye(play_view_session(view), dye);
    if (play_view_twin(view))
        skv_session_set_dye(play_view_session(play_view_twin(view)), dye);
}

void play_ask_brush(PlayView *view, double radius)
{
    skv_session_set_brush(play_view_session(view), radius);
    if (play_view_twin(view))
        skv_session_set_brush(play_view_session(play_view_twin(view)), radius);
}

/* The session beside, if hands and gravity are for both; null otherwise. */
static skv_session *linked(PlayView *view)
{
    PlayView *twin = play_view_is_linked(view) ? play_view_twin(view) : NULL;
    return twin ? play_view_session(twin) : NULL;
}

void play_ask_gravity(PlayView *view, double x, double y)
{
    skv_session_set_gravity(play_view_session(view), x, y);
    if (linked(view))
        skv_session_set_gravity(linked(view), x, y);
}

void play_ask_push(PlayView *view, double x, double y)
{
    skv_session_push(play_view_session(view), x, y);
    if (linked(view))
        skv_session_push(linked(view), x, y);
}

void play_ask_keyboard(PlayView *view, int right, int up, gboolean down)
{
    skv_session_keyboard(play_view_session(view), right, up, down);
    if (linked(view))
        skv_session_keyboard(linked(view), right, up, down);
}

/* Instruments. */

const skv_probe *play_probe_beside(PlayView *view, guint32 probe)
{
    PlayView *twin = play_view_twin(view);
    const skv_picture *other = twin ? play_view_picture(twin) : NULL;
    for (int i = 0; other && i < other->probe_count; i++)
        if (other->probes[i].id == probe)
            return &other->probes[i];
    return NULL;
}

void play_ask_probe(PlayView *view, const skv_instrument_def *def)
{
    skv_session_add_probe(play_view_session(view), def);
    if (play_view_twin(view))
        skv_session_add_probe(play_view_session(play_view_twin(view)), def);
}

void play_ask_move(PlayView *view, guint32 probe, double x0, double y0, double x1, double y1)
{
    skv_session_move_probe(play_view_session(view), probe, x0, y0, x1, y1);
    if (play_view_twin(view))
        skv_session_move_probe(play_view_session(play_view_twin(view)), probe, x0, y0, x1, y1);
}

void play_ask_watch(PlayView *view, guint32 probe, gboolean watched)
{
    skv_session_watch_probe(play_view_session(view), probe, watched);
    if (play_view_twin(view))
        skv_session_watch_probe(play_view_session(play_view_twin(view)), probe, watched);
}

void play_ask_remove(PlayView *view, guint32 probe)
{
    skv_session_remove_probe(play_view_session(view), probe);
    if (play_view_twin(view))
        skv_session_remove_probe(play_view_session(play_view_twin(view)), probe);
}
