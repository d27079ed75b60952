/** @file
 * Stage: what every front end shares below its toolkit: one world, or two of them side by side, on
 * threads of their own; tools and pointers, gravity by keys or tilt, instruments, pace, cameras.
 *
 * The worlds are its sides, 0 and 1; who asks for side 1 while there is one world means side 0. Two
 * worlds are at the same moment: time, tools and instruments are asked of both at once, and so are
 * hands and gravity unless they were told apart (docs/stage.md).
 *
 * The face's thread makes all calls. None of them waits for a world: they leave a message and
 * return, and what has become of it shows in the next picture (skv_stage_look) or is reported
 * (skv_stage_next_outcome). The memory hooks of skv_set_allocator are called on all threads.
 *
 * Numbers are cut to what is possible, and calls with such as are not finite, or that name nothing,
 * do nothing. Positions of pointers come in pixels of a side's view, y down, as toolkits report
 * them.
 */
#ifndef SKVALP_STAGE_H
#define SKVALP_STAGE_H

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

typedef struct skv_stage skv_stage;

/** How to make a stage. Initialise with skv_default_stage_def. */
typedef struct skv_stage_def {
    uint32_t cookie;
    int threads;     /**< on which each world is stepped: as in skv_pool_create */
    bool own_thread; /**< default true: each side's worlds are loaded and stepped on a thread of
                        their own. False: within the calls, which then take as long as that takes;
                        so it is, too, where there are no threads */
    size_t history;  /**< bytes for rewinding, a world; default 64 MiB */
    /** Called when there is a new picture or report, on the world's own thread if it has one, and
     * on the face's when a camera has moved: to be passed on to the face's thread. It must not call
     * the stage. Null: nobody is told. */
    void (*wake)(void *user);
    void *user;
    double (*clock)(void); /**< s from any origin, for what steps cost; null: the system's */
    int margin;            /**< of the views' cameras, pixels; default 0 */
} skv_stage_def;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_stage_def skv_default_stage_def(void);
SKV_API void skv_stage_def_init(skv_stage_def *def, size_t size);

/** Makes a stage on which nothing is open; `def` may be null. SKV_ERROR_LIMIT if the system refuses
 * to start so many threads. */
SKV_API skv_result skv_stage_create(const skv_stage_def *def, skv_stage **stage, skv_error *error);
/** Ends a stage, after the file or the substep that it is busy with; what else was asked for is not
 * done. Null is allowed. */
SKV_API void skv_stage_destroy(skv_stage *stage);

/** Waits until everything asked for so far has been done and can be seen: for tests and tools
 * without a face. */
SKV_API void skv_stage_wait(skv_stage *stage);

/* ---- Opening and saving ---------------------------------------------------------------------- */

/** Opens a scene by name or path, a state (.skv) or a replay (.skvr). Until it is there, and if it
 * fails, what is open goes on untouched; a second world goes once it is there. Reported as
 * SKV_OUTCOME_OPEN, unless another opening, asked for meanwhile, replaces it. It does not wait for
 * the step that runs, nor for what was asked of that world but to save or share it. `options` (null
 * is allowed) are for scenes. */
SKV_API void skv_stage_open(skv_stage *stage, const char *name_or_path,
                            const skv_scene_options *options);

/** The same from memory: `format` is "json", "png", "skv" or "skvr", `label` stands for the file's
 * name in messages. The bytes are copied. `options` (null is allowed) are also for the scene of a
 * replay: what was done in it is done to that one. */
SKV_API void skv_stage_open_memory(skv_stage *stage, const void *data, size_t size,
                                   const char *format, const char *label,
                                   const skv_scene_options *options);

/** Back to the start, and all that was done since is played again: watched, as a replay that was
 * opened is. Meanwhile nothing that people do to the fluid is done, so nobody cuts off what is
 * still to come without meaning it (skv_picture.withheld); time, tools, views and instruments are
 * theirs.
 */
SKV_API void skv_stage_replay(skv_stage *stage);
/** Ends watching here: from now on people act, and with the first frame what was still to come is
 * cut off; redo brings it back until the next edit. */
SKV_API void skv_stage_take_over(skv_stage *stage);
/** Goes to the end of what is watched, and on from there. */
SKV_API void skv_stage_skip(skv_stage *stage);

/** Tells how the fluid is shown, by the renderer's names: "pressure", and of overlays several with
 * commas between them. Replays and links keep it, besides the second world, the instruments and
 * whether time stands still. */
SKV_API void skv_stage_set_look(skv_stage *stage, const char *view, const char *overlays);

/** Writes the first world's state (a name that ends in .skv) or a replay (.skvr) to a file, which
 * appears when it is complete. Reported as SKV_OUTCOME_SAVE, in the order of these calls; why it
 * failed is the cause alone, "No space left on device", for who asks knows the file. */
SKV_API void skv_stage_save(skv_stage *stage, const char *path);

/** Writes this moment of all worlds, and what is seen of them, as a replay that begins and ends
 * here (skv_player_save_moment): who opens it goes on from here. Reported as skv_stage_save is. */
SKV_API void skv_stage_save_moment(skv_stage *stage, const char *path);

/** Makes what a link holds (skv_player_share) of this moment and what is seen of it. Reported as
 * SKV_OUTCOME_SHARE; then skv_stage_read_shared hands out the bytes, as often as wanted, until this
 * or skv_stage_compare is asked for again. */
SKV_API void skv_stage_share(skv_stage *stage);
SKV_API bool skv_stage_read_shared(skv_stage *stage, skv_write *write, void *user);

/** What has become of something that was asked for. */
typedef enum skv_outcome_kind {
    SKV_OUTCOME_OPEN,   /**< something was opened, or could not be */
    SKV_OUTCOME_SAVE,   /**< a file was written, or could not be */
    SKV_OUTCOME_SHARE,  /**< what a link holds is ready, or could not be made */
    SKV_OUTCOME_STEP,   /**< a step failed: it is paused now, and playing on tries again */
    SKV_OUTCOME_EDIT,   /**< an edit, a parameter or an instrument was refused */
    SKV_OUTCOME_COMPARE /**< a second world is beside the first, or could not be made */
} skv_outcome_kind;
typedef struct skv_outcome {
    skv_outcome_kind kind;
    skv_error error; /**< code SKV_OK: it was done */
} skv_outcome;

/** The next report that was not taken yet; false if there is none. At most 16 of each world wait,
 * the latest. A second world appears, and disappears with what was open, within this call. */
SKV_API bool skv_stage_next_outcome(skv_stage *stage, skv_outcome *report);

/* ---- Two worlds ------------------------------------------------------------------------------ */

/** Opens what is open a second time, beside the first and in place of a second one, with other
 * options (null is allowed) over its scene. Once it is there both play from the start, what was
 * done up to this call is done to both, and what was done to the first since is cut off. Until
 * then, and if it fails, what there is goes on untouched. Reported as SKV_OUTCOME_COMPARE. */
SKV_API void skv_stage_compare(skv_stage *stage, const skv_scene_options *options);
/** By which of skv_choice_at the second world was chosen; "" if by none. Valid until it changes. */
SKV_API const char *skv_stage_choice(const skv_stage *stage);
/** One world again; the first goes on by itself. */
SKV_API void skv_stage_end_compare(skv_stage *stage);
/** How many worlds there are: 1 or 2. */
SKV_API int skv_stage_sides(const skv_stage *stage);
/** Whether hands and gravity are for both worlds, whichever they are asked of; default true. All
 * pointers are let go. */
SKV_API void skv_stage_set_linked(skv_stage *stage, bool linked);
SKV_API bool skv_stage_linked(const skv_stage *stage);

/* ---- Time ------------------------------------------------------------------------------------ */

/** Lets `seconds` of real time pass, since the last call: to be called for every picture while
 * skv_stage_is_active. Whole 1/60 s frames are stepped, scaled by the speed; of two worlds the one
 * that takes longer sets the pace. What the machine cannot keep up with is dropped, and the
 * picture's pace says so. `drawing` is how long the face took for its last picture of all sides, s:
 * what it takes is missing for steps. */
SKV_API void skv_stage_advance(skv_stage *stage, double seconds, double drawing);

/** Whether time has to pass for anything to happen. Not while paused, nor while the fluid is at
 * rest and nobody touches it: nothing is stepped or published then, and every call that changes
 * something makes it active again, which `wake` tells. */
SKV_API bool skv_stage_is_active(const skv_stage *stage);

SKV_API void skv_stage_set_paused(skv_stage *stage, bool paused);
SKV_API bool skv_stage_paused(const skv_stage *stage);
/** Whether time is measured, default false: if so it passes at rest, too, for the stopwatch that a
 * front end shows while it runs (skvalp/stopwatch.h). */
SKV_API void skv_stage_set_timed(skv_stage *stage, bool timed);
/** Exactly one 1/60 s frame, also while paused. */
SKV_API void skv_stage_step_once(skv_stage *stage);
/** Simulated seconds per real second, 0.05..2; default 1. */
SKV_API void skv_stage_set_speed(skv_stage *stage, double speed);
SKV_API double skv_stage_speed(const skv_stage *stage);

/** Goes to a moment, in frames since the start, 0..skv_picture.end; it stays there until it plays
 * on, which cuts off what came after. A seek that follows before the first has ended replaces it.
 */
SKV_API void skv_stage_seek(skv_stage *stage, int64_t frame);
/** Stops, and goes so many frames back or forth from where it is or was sent last; not further back
 * than `reach` before the end. */
SKV_API void skv_stage_go(skv_stage *stage, int64_t frames, int64_t reach);
/** As skv_player_undo and skv_player_redo. Of two worlds undo takes the latest edit back, whichever
 * it was made in, and the other goes to that moment, too; redo brings both back, if both can. */
SKV_API void skv_stage_undo(skv_stage *stage);
SKV_API void skv_stage_redo(skv_stage *stage);

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
    const char *lack;    /**< why channels have none, as skv_lab_lack; "" if all have one */
    int samples;         /**< of the history, oldest first; 0 unless it is watched */
    const double *times; /**< s */
    const double *history[SKV_MAX_CHANNELS];
} skv_probe;

/** All that there is to see at a moment. It never changes while it is held. */
typedef struct skv_picture {
    uint64_t number;   /**< of the picture, counted from 1 */
    skv_frame frame;   /**< without a world, before the first open: all 0. Where nothing is stepped
                          since the start, or since the balance was changed, the pressures are those
                          of the next frame */
    const char *name;  /**< "dam-break"; of a file that is no scene, its own; "" before */
    const char *title; /**< "Dam break" */
    const char *description;
    const skv_scene *scene;      /**< null if what is open is no scene */
    const char *view, *overlays; /**< how what was opened is to be shown, as skv_stage_set_look;
                                    names that the renderer need not know; "" if it does not say */
    uint32_t opened;             /**< changes when something else was opened */
    int substeps;                /**< a frame */
    skv_world_def parameters; /**< of the world at this moment, for skv_world_def_get; the standard
                                 ones before the first open. Its pointers are null */

    int64_t moment, end;      /**< frames since the start, at present and at the log's end */
    int64_t undo_to, redo_to; /**< moments to which these lead; -1: nowhere */
    bool can_undo, can_redo;
    bool paused;
    bool still;        /**< what was opened was shared as it stood still, and plays nothing */
    bool seeking;      /**< on its way to a moment */
    bool at_rest;      /**< the fluid sleeps and nobody touches it */
    bool following;    /**< plays what a replay says, until somebody takes over */
    bool watching;     /**< and people only watch (skv_stage_take_over) */
    bool as_recorded;  /**< a replay was played to its end, and every hash was the same */
    bool mismatch;     /**< it went another way than when it was recorded */
    unsigned withheld; /**< things that people did while they watched, which were not done */
    double speed;      /**< as set */
    double pace;       /**< simulated seconds per real second over the speed, measured: below 1 the
                          machine cannot keep up; 1 while nothing was measured */
    double step_ms;    /**< what a frame's step takes, measured */
    double draw_ms;    /**< what drawing takes, as told */

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

/** Takes the newest pictures. Returns which sides have something new to draw, another picture or
 * another camera: 1 for the first, 2 for the second, 3 for both; 0: none. */
SKV_API unsigned skv_stage_look(skv_stage *stage);
/** A side's picture, as looked at last: valid until that is done again, or the side is gone. Never
 * null: before the first open it is empty. */
SKV_API const skv_picture *skv_stage_picture(const skv_stage *stage, int side);
/** An instrument of that picture; null if it is not there, or there is no such side. Two worlds
 * have the same ones. */
SKV_API const skv_probe *skv_stage_probe(const skv_stage *stage, int side, uint32_t probe);

/** What these pictures say together. */
typedef struct skv_stage_state {
    bool at_rest, seeking, can_undo, can_redo;
    double pace;    /**< of the slower */
    double step_ms; /**< of both */
} skv_stage_state;
SKV_API skv_stage_state skv_stage_now(const skv_stage *stage);

/* ---- Gravity and parameters ------------------------------------------------------------------ */

/** Gravity: a vector in units of the scene's own strength (9.81 m/s^2 in a weightless scene), at
 * most 2 long; (0, 0) is weightless. Arrow keys, a ball on the screen and tilt all end here. */
SKV_API void skv_stage_set_gravity(skv_stage *stage, int side, double x, double y);

/** Gives all the fluid a push, m/s, each component at most 10: a shaken glass. */
SKV_API void skv_stage_push(skv_stage *stage, int side, double vx, double vy);

/** Does something to one side's world, as one edit, which undo takes back: a force field, an
 * emitter, all that skv_player_edit does but hands and checks. What refuses it is reported as
 * SKV_OUTCOME_EDIT. */
SKV_API void skv_stage_edit(skv_stage *stage, int side, const skv_command *command);

/** Sets a parameter of one side's world by path and text, as skv_world_set: an edit, too. */
SKV_API void skv_stage_set(skv_stage *stage, int side, const char *path, const char *text);

/* ---- The view -------------------------------------------------------------------------------- */

/** The size of a side's view in pixels. At first, and whenever something else was opened, it
 * shows the whole world, centred, as large as fits. */
SKV_API void skv_stage_set_view(skv_stage *stage, int side, int width, int height);
/** The camera of a side's newest picture's world. */
SKV_API skv_camera skv_stage_camera(const skv_stage *stage, int side);
/** Zooms about a pixel of a side's view, moves the picture by pixels, shows all of it again. Both
 * sides show the same part of their worlds. */
SKV_API void skv_stage_zoom(skv_stage *stage, int side, double factor, double px, double py);
SKV_API void skv_stage_pan(skv_stage *stage, int side, double dx, double dy);
SKV_API void skv_stage_show_all(skv_stage *stage);

/* ---- Tools and pointers ---------------------------------------------------------------------- */

/** A tool, by its number; null past the last. Static. */
typedef struct skv_tool {
    const char *name;  /**< "hand" */
    const char *title; /**< "Hand", in English */
    const char *help;  /**< one sentence */
    char key;          /**< that chooses it */
    bool dyes;         /**< works with a colour: skv_stage_set_dye */
    bool pours;        /**< places fluid: skv_stage_set_fluid */
    bool drops;        /**< places bodies: skv_stage_set_shape */
} skv_tool;
SKV_API const skv_tool *skv_tool_info(int i);

/** Chooses the tool of pointers that go down from now on; default 0, the hand. */
SKV_API void skv_stage_set_tool(skv_stage *stage, int tool);
SKV_API int skv_stage_tool(const skv_stage *stage);
/** Radius of hand and brushes, m; 0, the default: a tenth of the world's longer side for the hand,
 * a fortieth for brushes. */
SKV_API void skv_stage_set_brush(skv_stage *stage, double radius);
/** Chooses the colour that tools dye with, as skv_dye_name; default 1. With 0 they wash dye out. */
SKV_API void skv_stage_set_dye(skv_stage *stage, int dye);
SKV_API int skv_stage_dye(const skv_stage *stage);
/** Chooses the fluid that tools pour, by its number in skv_frame.fluids; default 0, which is
 * poured, too, where a world has none of the number chosen. */
SKV_API void skv_stage_set_fluid(skv_stage *stage, int fluid);
/** What is poured in the first side's world. */
SKV_API int skv_stage_fluid(const skv_stage *stage);
/** Chooses the shape of bodies that tools drop, as skv_drop_shape; default 0. */
SKV_API void skv_stage_set_shape(skv_stage *stage, int shape);
SKV_API int skv_stage_shape(const skv_stage *stage);

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

/** Up to SKV_MAX_HANDS pointers may be down at once; more are ignored, as is what is not finite. In
 * both worlds they are at the same place. */
SKV_API void skv_stage_pointer(skv_stage *stage, int side, const skv_pointer_event *event);
/** The same through skv_fingers, of each side its own: two fingers move and zoom the picture, a tap
 * of three is undo. `tremble` is as in skv_fingers. Returns in how many seconds
 * skv_stage_touch_waited is due if no event comes before, which returns the same; 0: never. */
SKV_API double skv_stage_touch(skv_stage *stage, int side, const skv_pointer_event *event,
                               double tremble);
SKV_API double skv_stage_touch_waited(skv_stage *stage, int side);
/** All pointers are gone: a broken grab, a window that was left. */
SKV_API void skv_stage_cancel_pointers(skv_stage *stage);
/** How many are down on a side. */
SKV_API int skv_stage_pointer_count(const skv_stage *stage, int side);

/** A pointer moved by keys: the direction of the arrows held, each -1..1, and whether it is down.
 * It moves while time passes, faster the longer it does. */
SKV_API void skv_stage_keyboard(skv_stage *stage, int side, int right, int up, bool down);

/* ---- Instruments ----------------------------------------------------------------------------- */

/** Adds an instrument to all worlds, which is read after every frame, and whenever it, the world or
 * the moment is changed; returns its number. What the
 * lab refuses is reported as SKV_OUTCOME_EDIT. */
SKV_API uint32_t skv_stage_add_probe(skv_stage *stage, const skv_instrument_def *def);
/** Moves it; its history starts anew. */
SKV_API void skv_stage_move_probe(skv_stage *stage, uint32_t probe, double x0, double y0, double x1,
                                  double y1);
/** The same by so much, from where its picture shows it. */
SKV_API void skv_stage_shift_probe(skv_stage *stage, uint32_t probe, double dx, double dy);
/** Whether pictures hold its history. */
SKV_API void skv_stage_watch_probe(skv_stage *stage, uint32_t probe, bool watched);
SKV_API void skv_stage_remove_probe(skv_stage *stage, uint32_t probe);

#ifdef __cplusplus
}
#endif
#endif
