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

#include "skvalp/base.h"
#include "skvalp/camera.h"
#include "skvalp/frame.h"
#include "skvalp/mark.h"
#include "skvalp/measure.h"
#include "skvalp/player.h"
#include "skvalp/scene.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct skv_session skv_session;

/** How to make a session. Initialise with skv_default_session_def. */
typedef struct skv_session_def {
    int threads;     /**< on which all its worlds are stepped: as in skv_pool_create */
    bool own_thread; /**< default true: worlds are loaded and stepped on a thread of the session's
                        own. False: within the calls, which then take as long as that takes; so it
                        is, too, where there are no threads */
    size_t history;  /**< bytes for rewinding; default 64 MiB */
    /** Called when there is a new picture or report, on the session's own thread if it has one:
     * to be passed on to the face's thread. It must not call the session. Null: nobody is told. */
    void (*wake)(void *user);
    void *user;
    double (*clock)(void); /**< s from any origin, for what steps cost; null: the system's */
    int cookie;
} skv_session_def;

SKV_API skv_session_def skv_default_session_def(void);

/** Makes a session in which nothing is open; `def` may be null. SKV_ERROR_LIMIT if the system
 * refuses to start so many threads. */
SKV_API skv_result skv_session_create(const skv_session_def *def, skv_session **session,
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

/** What has become of something that was asked for. */
typedef enum skv_outcome_kind {
    SKV_OUTCOME_OPEN,  /**< something was opened, or could not be */
    SKV_OUTCOME_SAVE,  /**< a file was written, or could not be */
    SKV_OUTCOME_SHARE, /**< what a link holds is ready, or could not be made */
    SKV_OUTCOME_STEP,  /**< a step failed: it is paused now, and playing on tries again */
    SKV_OUTCOME_EDIT   /**< an edit, a parameter or an instrument was refused */
} skv_outcome_kind;
typedef struct skv_outcome {
    skv_outcome_kind kind;
    skv_error error; /**< code SKV_OK: it was done */
} skv_outcome;

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

/** Marks that a picture can have. */
#define SKV_MOST_MARKS 112
/** Instruments that a session can have. */
#define SKV_MOST_PROBES 32

/** An instrument as it reads. */
typedef struct skv_probe {
    uint32_t id;
    skv_instrument_def def;
    double value[SKV_MAX_CHANNELS]; /**< as skv_lab_reading */
    int samples;                    /**< of the history, oldest first; 0 unless it is watched */
    const double *times;            /**< s */
    const double *history[SKV_MAX_CHANNELS];
} skv_probe;

/** All that there is to see at a moment. It never changes while it is held. */
typedef struct skv_picture {
    uint64_t number;   /**< of the picture, counted from 1 */
    skv_frame frame;   /**< without a world, before the first open: all 0 */
    const char *name;  /**< "dam-break"; of a file that is no scene, its own; "" before */
    const char *title; /**< "Dam break" */
    const char *description;
    const skv_scene *scene;   /**< null if what is open is no scene */
    uint32_t opened;          /**< changes when something else was opened */
    int substeps;             /**< a frame */
    skv_world_def parameters; /**< of the world at this moment, for skv_world_def_get; the standard
                                 ones before the first open. Its pointers are null */

    int64_t moment, end; /**< frames since the start, at present and at the log's end */
    bool paused;
    bool seeking; /**< on its way to a moment */
    bool at_rest; /**< the fluid sleeps and nobody touches it */
    bool can_undo, can_redo;
    int64_t undo_to, redo_to; /**< moments to which these lead; -1: nowhere */
    bool following;           /**< plays what a replay says, until somebody takes over */
    bool as_recorded;         /**< a replay was played to its end, and every hash was the same */
    bool mismatch;            /**< it went another way than when it was recorded */
    double speed;             /**< as set */
    double pace;    /**< simulated seconds per real second over the speed, measured: below 1 the
                       machine cannot keep up; 1 while nothing was measured */
    double step_ms; /**< what a frame's step takes, measured */
    double draw_ms; /**< what drawing takes, as told */

    double tilt_x, tilt_y; /**< gravity over the strength of the scene's own */
    int tool;
    double brush; /**< m */
    skv_hand hands[SKV_MAX_HANDS];
    int hand_count;
    skv_mark marks[SKV_MOST_MARKS]; /**< what tools show, then taps, drains and fans */
    int mark_count;
    skv_probe probes[SKV_MOST_PROBES];
    int probe_count;
} skv_picture;

/** The newest picture, to be released again; two at most may be held at once. Never null: before
 * the first open it is empty. */
SKV_API const skv_picture *skv_session_acquire(skv_session *session);
SKV_API void skv_session_release(skv_session *session, const skv_picture *picture);

/** Says what a picture shows in words, for a status line or to be read out: "playing, 2960
 * particles, at rest". Cut to `size`. */
SKV_API void skv_picture_describe(const skv_picture *picture, char *text, size_t size);

/** The unit in which a reading is shown that is in `unit`, of a skv_channel: if `plain`, the one
 * that people know, "cm of water" for "Pa m"; else, and where they know no other, `unit` itself.
 * `*size` (null is allowed) is how much of `unit` one of it is. */
SKV_API const char *skv_reading_unit(const char *unit, bool plain, double *size);

/** A value as people read it, in that unit: of a pressure in Pa m "24.5 cm of water", of a speed
 * "1.20 m/s", of a length "31.4 cm". Cut to `size`. */
SKV_API void skv_format_reading(double value, const char *unit, bool plain, char *text,
                                size_t size);

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

/** A tool, by its number; null past the last. Static. */
typedef struct skv_tool {
    const char *name;  /**< "hand" */
    const char *title; /**< "Hand", in English */
    const char *help;  /**< one sentence */
    char key;          /**< that chooses it */
    bool dyes;         /**< works with a colour: skv_session_set_dye */
} skv_tool;
SKV_API const skv_tool *skv_tool_info(int i);

/** Chooses the tool of pointers that go down from now on; default 0, the hand. */
SKV_API void skv_session_set_tool(skv_session *session, int tool);
SKV_API int skv_session_tool(const skv_session *session);
/** Radius of hand and brushes, m; 0, the default: a tenth of the world's longer side for the hand,
 * a fortieth for brushes. */
SKV_API void skv_session_set_brush(skv_session *session, double radius);
/** Chooses the colour that tools dye with, as skv_dye_name; default 1. With 0 they wash dye out. */
SKV_API void skv_session_set_dye(skv_session *session, int dye);
SKV_API int skv_session_dye(const skv_session *session);

typedef enum skv_device {
    SKV_DEVICE_MOUSE,
    SKV_DEVICE_FINGER,
    SKV_DEVICE_PEN,
    SKV_DEVICE_ERASER, /**< the other end of a pen */
    SKV_DEVICE_KEYBOARD
} skv_device;
typedef enum skv_phase {
    SKV_PHASE_DOWN,
    SKV_PHASE_MOVE, /**< of a pointer that is not down: it hovers */
    SKV_PHASE_UP,
    SKV_PHASE_LEAVE /**< it is gone: what it did stays, what it had begun does not happen */
} skv_phase;

/** What a pointer did. Mouse, fingers, pens and keys go this one way. */
typedef struct skv_pointer_event {
    skv_phase phase;
    skv_device device;
    uint64_t pointer; /**< told apart within its device */
    double px, py;    /**< view pixels */
    double time;      /**< s, from any origin: speeds are measured by it */
    double pressure;  /**< of a pen, 0..1; 0 if it has none */
    bool secondary;   /**< the right button: erases */
    bool straight;    /**< Shift: draws a straight line */
} skv_pointer_event;

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
