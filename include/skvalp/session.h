/** @file
 * Session: what every front end shares below its toolkit: what is open, its player on a thread of
 * its own, tools and pointers, gravity by keys or tilt, instruments, pace, and the camera.
 *
 * The face's thread makes all calls. None of them waits for the world: they leave a message and
 * return, and what has become of it shows in the next picture (skv_session_acquire) or is reported
 * (skv_session_next_outcome). The memory hooks of skv_set_allocator are called on both threads.
 *
 * Positions of pointers come in view pixels, y down, as toolkits report them.
 */
#ifndef SKVALP_SESSION_H
#define SKVALP_SESSION_H

#include "skvalp/stage.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct skv_session skv_session;

/** Makes a session in which nothing is open; `def` may be null. SKV_ERROR_LIMIT if the system
 * refuses to start so many threads. */
SKV_API skv_result skv_session_create(const skv_stage_def *def, skv_session **session,
                                      skv_error *error);
/** Ends a session, after the step or file that it is busy with. Null is allowed. */
SKV_API void skv_session_destroy(skv_session *session);

/** Waits until everything asked for so far has been done and can be seen: for tests and tools
 * without a face. */
SKV_API void skv_session_wait(skv_session *session);

/* ---- Opening and saving ---------------------------------------------------------------------- */

/** Opens a scene by name or path, a state (.skv) or a replay (.skvr). Until it is there, and if it
 * fails, what is open goes on untouched. Reported as SKV_OUTCOME_OPEN. `options` (null is allowed)
 * are for scenes. */
SKV_API void skv_session_open(skv_session *session, const char *name_or_path,
                              const skv_scene_options *options);

/** The same from memory: `format` is "json", "png", "skv" or "skvr", `label` stands for the file's
 * name in messages. The bytes are copied. `options` (null is allowed) are also for the scene of a
 * replay: what was done in it is done to that one. */
SKV_API void skv_session_open_memory(skv_session *session, const void *data, size_t size,
                                     const char *format, const char *label,
                                     const skv_scene_options *options);

/** Back to the start of what is open; pause and speed stay. */
SKV_API void skv_session_reset(skv_session *session);
/** Back to the start, and all that was done since is played again, until somebody takes over. */
SKV_API void skv_session_replay(skv_session *session);

/** Writes the state (a name that ends in .skv) or the replay (.skvr) to a file, which appears when
 * it is complete. Reported as SKV_OUTCOME_SAVE. */
SKV_API void skv_session_save(skv_session *session, const char *path);

/** Makes what a link holds (skv_player_share) of this moment. Reported as SKV_OUTCOME_SHARE; then
 * skv_session_read_shared hands out the bytes, as often as wanted, until this is asked for again.
 */
SKV_API void skv_session_share(skv_session *session);
SKV_API bool skv_session_read_shared(skv_session *session, skv_write *write, void *user);

/** The next report that was not taken yet; false if there is none. At most 16 wait, the latest. */
SKV_API bool skv_session_next_outcome(skv_session *session, skv_outcome *report);

/* ---- Time ------------------------------------------------------------------------------------ */

/** Lets `seconds` of real time pass, since the last call: to be called for every picture while
 * skv_session_is_active. Whole 1/60 s frames are stepped, scaled by the speed; what the machine
 * cannot keep up with is dropped, and the picture's pace says so. `drawing` is how long the face
 * took for its last picture, s: what it takes is missing for steps. */
SKV_API void skv_session_advance(skv_session *session, double seconds, double drawing);

/** Whether time has to pass for anything to happen. Not while paused, nor while the fluid is at
 * rest and nobody touches it: nothing is stepped or published then, and every call that changes
 * something makes it active again, which `wake` tells. */
SKV_API bool skv_session_is_active(const skv_session *session);

SKV_API void skv_session_set_paused(skv_session *session, bool paused);
SKV_API bool skv_session_paused(const skv_session *session);
/** Exactly one 1/60 s frame, also while paused. */
SKV_API void skv_session_step_once(skv_session *session);
/** Simulated seconds per real second, 0.05..2; default 1. */
SKV_API void skv_session_set_speed(skv_session *session, double speed);
SKV_API double skv_session_speed(const skv_session *session);

/** Goes to a moment, in frames since the start, 0..skv_picture.end; it stays there until it plays
 * on, which cuts off what came after. A seek that follows before the first has ended replaces it.
 */
SKV_API void skv_session_seek(skv_session *session, int64_t frame);
/** As skv_player_undo and skv_player_redo. */
SKV_API void skv_session_undo(skv_session *session);
SKV_API void skv_session_redo(skv_session *session);

/* ---- Pictures -------------------------------------------------------------------------------- */

/** The newest picture, to be released again; two at most may be held at once. Never null: before
 * the first open it is empty. */
SKV_API const skv_picture *skv_session_acquire(skv_session *session);
SKV_API void skv_session_release(skv_session *session, const skv_picture *picture);

/* ---- Gravity and parameters ------------------------------------------------------------------ */

/** Gravity: a vector in units of the scene's own strength (9.81 m/s^2 in a weightless scene), at
 * most 2 long; (0, 0) is weightless. Arrow keys, a ball on the screen and tilt all end here. */
SKV_API void skv_session_set_gravity(skv_session *session, double x, double y);

/** Gives all the fluid a push, m/s, each component at most 10: a shaken glass. */
SKV_API void skv_session_push(skv_session *session, double vx, double vy);

/** Does something to the world, as one edit, which undo takes back: a force field, an emitter, all
 * that skv_player_edit does but hands and checks. What refuses it is reported as SKV_OUTCOME_EDIT.
 */
SKV_API void skv_session_edit(skv_session *session, const skv_command *command);

/** Sets a parameter of the world by path and text, as skv_world_set: an edit, too. */
SKV_API void skv_session_set(skv_session *session, const char *path, const char *text);

/* ---- The view -------------------------------------------------------------------------------- */

/** The view's size in pixels. At first, and whenever something else was opened, it shows the whole
 * world, centred, as large as fits. */
SKV_API void skv_session_set_view(skv_session *session, int width, int height);
/** The camera of the newest picture's world. */
SKV_API skv_camera skv_session_camera(const skv_session *session);
/** Shows what this camera shows, one of skv_session_camera that was zoomed or moved. */
SKV_API void skv_session_set_camera(skv_session *session, const skv_camera *camera);

/* ---- Tools and pointers ---------------------------------------------------------------------- */

/** Chooses the tool of pointers that go down from now on; default 0, the hand. */
SKV_API void skv_session_set_tool(skv_session *session, int tool);
SKV_API int skv_session_tool(const skv_session *session);
/** Radius of hand and brushes, m; 0, the default: a tenth of the world's longer side for the hand,
 * a fortieth for brushes. */
SKV_API void skv_session_set_brush(skv_session *session, double radius);
/** Chooses the colour that tools dye with, as skv_dye_name; default 1. With 0 they wash dye out. */
SKV_API void skv_session_set_dye(skv_session *session, int dye);
SKV_API int skv_session_dye(const skv_session *session);

/** Up to SKV_MAX_HANDS pointers may be down at once; more are ignored, as is what is not finite. */
SKV_API void skv_session_pointer(skv_session *session, const skv_pointer_event *event);
/** All pointers are gone: a broken grab, a window that was left. */
SKV_API void skv_session_cancel_pointers(skv_session *session);
/** How many are down. */
SKV_API int skv_session_pointer_count(const skv_session *session);

/** A pointer moved by keys: the direction of the arrows held, each -1..1, and whether it is down.
 * It moves while time passes, faster the longer it does. */
SKV_API void skv_session_keyboard(skv_session *session, int right, int up, bool down);

/* ---- Instruments ----------------------------------------------------------------------------- */

/** Adds an instrument, which is read after every frame; returns its number, 0 if there are too
 * many. What the lab refuses is reported as SKV_OUTCOME_EDIT. */
SKV_API uint32_t skv_session_add_probe(skv_session *session, const skv_instrument_def *def);
/** Moves it; its history starts anew. */
SKV_API void skv_session_move_probe(skv_session *session, uint32_t probe, double x0, double y0,
                                    double x1, double y1);
/** Whether pictures hold its history. */
SKV_API void skv_session_watch_probe(skv_session *session, uint32_t probe, bool watched);
SKV_API void skv_session_remove_probe(skv_session *session, uint32_t probe);

#ifdef __cplusplus
}
#endif
#endif
