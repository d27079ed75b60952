/** @file
 * Session: what every front end shares below its toolkit: the open scene and its world, pointers
 * (mouse and fingers), gravity by keys or tilt, the camera, and playback.
 *
 * Positions of pointers come in view pixels, y down, as toolkits report them. All calls come from
 * one thread.
 */
#ifndef SKVALP_SESSION_H
#define SKVALP_SESSION_H

#include "skvalp/base.h"
#include "skvalp/camera.h"
#include "skvalp/scene.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct skv_session skv_session;

/** Makes a session without a scene, and the threads on which all its worlds will be stepped:
 * `threads` as in skv_pool_create. */
SKV_API skv_result skv_session_create(int threads, skv_session **session, skv_error *error);
SKV_API void skv_session_destroy(skv_session *session);

/** Opens a scene by name or path, or from a scene that was loaded elsewhere (taken over on
 * success). On failure the running scene goes on untouched. */
SKV_API skv_result skv_session_open(skv_session *session, const char *name_or_path,
                                    const skv_scene_options *options, skv_error *error);
SKV_API skv_result skv_session_open_scene(skv_session *session, skv_scene *scene, skv_error *error);

/** The world and scene that are open, null before the first open. They change on open and reset. */
SKV_API const skv_world *skv_session_world(const skv_session *session);
SKV_API const skv_scene *skv_session_scene(const skv_session *session);

/** Back to the scene's start; gravity keys are released, pause and speed stay. */
SKV_API skv_result skv_session_reset(skv_session *session, skv_error *error);

/** Lets `seconds` of real time pass: steps whole 1/60 s frames, scaled by the playback speed, and
 * drops what the machine cannot keep up with (at most four frames a call). Writes the number of
 * frames stepped to *frames (null is allowed). Fails as skv_world_step does, and then pauses: the
 * world is that of the last complete substep, and playing on tries again. */
SKV_API skv_result skv_session_advance(skv_session *session, double seconds, int *frames,
                                       skv_error *error);

SKV_API void skv_session_set_paused(skv_session *session, bool paused);
SKV_API bool skv_session_paused(const skv_session *session);
/** Exactly one 1/60 s frame, also while paused. Fails as skv_world_step does. */
SKV_API skv_result skv_session_step_once(skv_session *session, skv_error *error);
/** Simulated seconds per real second, 0.05..2; default 1. */
SKV_API void skv_session_set_speed(skv_session *session, double speed);
SKV_API double skv_session_speed(const skv_session *session);

/** Gravity: a direction (need not be of length 1; (0, 0) is weightless) times the scene's own
 * strength. Arrow keys and tilt both end here. */
SKV_API void skv_session_set_gravity_direction(skv_session *session, double x, double y);
SKV_API void skv_session_gravity_direction(const skv_session *session, double *x, double *y);

/** The view: its size in pixels. The whole world is shown, centred, as large as fits. */
SKV_API void skv_session_set_view(skv_session *session, int width, int height);
SKV_API skv_camera skv_session_camera(const skv_session *session);

/** Pointers: any number-coded finger or mouse button up to SKV_MAX_HANDS at once; more are ignored.
 * Each one holds fluid from down to up. `time` in seconds from any origin: the pointer's velocity
 * is measured from it. */
SKV_API void skv_session_pointer_down(skv_session *session, uint64_t pointer, double px, double py,
                                      double time);
SKV_API void skv_session_pointer_move(skv_session *session, uint64_t pointer, double px, double py,
                                      double time);
SKV_API void skv_session_pointer_up(skv_session *session, uint64_t pointer);
SKV_API void skv_session_pointer_cancel_all(skv_session *session);
SKV_API int skv_session_pointer_count(const skv_session *session);
/** Radius of the grip in metres; default a tenth of the world's longer side. */
SKV_API void skv_session_set_grip(skv_session *session, double radius);
SKV_API double skv_session_grip(const skv_session *session);
/** The hands that act now, for drawing; returns their number, writes at most `capacity`. */
SKV_API int skv_session_hands(const skv_session *session, skv_hand *hands, int capacity);

#ifdef __cplusplus
}
#endif
#endif
