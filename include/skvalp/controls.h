/** @file
 * Controls: what every front end offers of a stage, as tables, and what its buttons and keys do.
 * Titles are in English; po/ has them in other languages. The tables are static.
 */
#ifndef SKVALP_CONTROLS_H
#define SKVALP_CONTROLS_H

#include "skvalp/stage.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct skv_limits {
    double least_brush, largest_brush; /**< radii: shares of the world's longer side */
    double zoom_step;                  /**< times, of a key or button */
    int frames_a_second;               /**< of simulated time */
    int reach;                         /**< of the bar that rewinds, frames */
    int grip;                          /**< round a draggable point, pixels: a finger's width */
    int margin;                        /**< round the world, pixels: a lid's line and its shadow */
    const char *first_scene;           /**< that a newcomer sees */
    int usual_amount;                  /**< of particles: the built-in scenes were made for it */
} skv_limits;
SKV_API const skv_limits *skv_control_limits(void);

/* ---- Time ------------------------------------------------------------------------------------ */

/** A number to choose; null past the last. */
typedef struct skv_named_number {
    const char *title;
    double number;
} skv_named_number;

/** Speeds, simulated seconds per real second, the fastest first. */
SKV_API const skv_named_number *skv_speed_at(int i);
/** Sets the next of them that is faster (1) or slower (-1). */
SKV_API void skv_control_shift_speed(skv_stage *stage, int direction);

/** Pauses, and goes to a moment, or so many frames on, as far as the bar reaches. */
SKV_API void skv_control_seek(skv_stage *stage, int64_t frame);
SKV_API void skv_control_go(skv_stage *stage, int64_t frames);

/** Whether somebody would miss what is open, so that a front end keeps it unasked: something was
 * done, or played for half a minute, and they do not only watch. */
SKV_API bool skv_control_would_be_missed(const skv_stage *stage);

/** How a stage goes, to be said. */
typedef struct skv_going {
    const char *words; /**< "paused"; in "%s× of real time" `times` is wanted */
    double times;      /**< simulated seconds per real second */
    bool slow;         /**< the machine cannot keep up */
} skv_going;
SKV_API skv_going skv_control_going(const skv_stage *stage);
/** All its words, for translators; null past the last. */
SKV_API const char *skv_going_words(int i);

/* ---- The world and its tools ----------------------------------------------------------------- */

/** Gravity as on planets, upwards in m/s^2. */
SKV_API const skv_named_number *skv_planet_at(int i);
SKV_API void skv_control_planet(skv_stage *stage, int side, const skv_named_number *planet);

/** Chooses a tool; one that dyes and is chosen already takes its next colour, one that drops bodies
 * its next shape. */
SKV_API void skv_control_tool(skv_stage *stage, int tool);
/** Chooses what is poured, and the tool that pours it, unless one is chosen. */
SKV_API void skv_control_fluid(skv_stage *stage, int fluid);
/** The same with the next of the first side's fluids; nothing where there is but one. */
SKV_API void skv_control_next_fluid(skv_stage *stage);
/** Sets the brush's radius, m, within the limits; or makes it `factor` times as large. */
SKV_API void skv_control_brush(skv_stage *stage, double radius);
SKV_API void skv_control_scale_brush(skv_stage *stage, double factor);

/** What to say where a field of numbers does not take a text, which is as skv_number_read gives it:
 * the first "%s" is the least that it takes, the second the greatest. Null if it takes it. */
SKV_API const char *skv_field_refusal(const skv_field *field, const char *text);
/** All these words, for translators; null past the last. */
SKV_API const char *skv_refusal_words(int i);

/* ---- Instruments ----------------------------------------------------------------------------- */

/** An instrument that people put into the picture. */
typedef struct skv_gauge {
    skv_instrument_kind kind;
    const char *title;
    bool line;   /**< has two points */
    bool box;    /**< which are corners of a box */
    int channel; /**< for which it is read: what its title says, in the axes of the rulers */
} skv_gauge;
/** In the order in which they are offered; null past the last. */
SKV_API const skv_gauge *skv_gauge_at(int i);
/** That of a kind; null if it is none of them. */
SKV_API const skv_gauge *skv_gauge_of(skv_instrument_kind kind);

/** Adds one under the mouse or pen if that is over a view, else in the water nearest to the middle
 * of what the first side shows; a level in any case in water. Never in a wall, nor where another
 * begins: close by, then. 0 if nothing is open. */
SKV_API uint32_t skv_control_add_gauge(skv_stage *stage, const skv_gauge *gauge);
/** Drags an end of one (0 or 1) to a place, which is kept within what is seen of the world: who
 * drags it out finds it at the edge. The first end takes the second with it. */
SKV_API void skv_control_drag(skv_stage *stage, int side, uint32_t probe, int end, double x,
                              double y);

/* ---- The number of particles ----------------------------------------------------------------- */

/** The numbers of particles that people choose from, ascending; 0 past the last. */
SKV_API int skv_amount_at(int i);
/** With how many a scene begins where that many are chosen: those built in that say another number
 * than skv_limits.usual_amount keep their share of it, files have just that many. 0, as it is, for
 * states, replays and links, and if 0 are chosen. */
SKV_API int skv_amount_of(const char *name_or_path, int chosen);

/* ---- Comparing ------------------------------------------------------------------------------- */

/** What a second world differs in. */
typedef struct skv_choice {
    const char *name, *title;
    const char *path, *value; /**< a setting; null: none */
    double particles;         /**< times as many; 0: as many */
} skv_choice;
/** Null past the last. */
SKV_API const skv_choice *skv_choice_at(int i);
/** Null if there is none of that name. */
SKV_API const skv_choice *skv_choice_named(const char *name);
/** Compares what is open with itself, but for what the choice says. */
SKV_API void skv_control_compare(skv_stage *stage, const skv_choice *choice);
/** The built-in scene that is about the same as an experiment; null if there is none. */
SKV_API const char *skv_experiment_like(const char *experiment);

/* ---- Keys ------------------------------------------------------------------------------------ */

/** A key, or a gesture, and what it does. Those of one title stand together: a row of a table. */
typedef struct skv_key {
    const char *section;  /**< of the table */
    const char *title;    /**< null: it is in no table */
    const char *key;      /**< "Space", "s", "Ctrl+Shift+z", "Left"; or a gesture in words */
    const char *action;   /**< null: a gesture, or what is held, such as an arrow */
    const char *argument; /**< of the action: a number, or true or false; null: none */
    bool repeats;         /**< while it is held */
} skv_key;
/** Null past the last. The keys of tools are in skv_tool_info. */
SKV_API const skv_key *skv_key_at(int i);

#ifdef __cplusplus
}
#endif
#endif
