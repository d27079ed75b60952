/** @file
 * Measuring: calibrated instruments for a world.
 *
 * Two parts. A survey is one look at the fluid: it answers what the pressure, the velocity or the
 * level is at a place. A lab holds instruments that are read after every frame and remembers their
 * readings. Units are SI for a sheet of fluid: pressure in Pa m, density in kg/m^2, force in N. For
 * a sheet one metre thick they read like Pa, kg/m^3 and N. The experiments that set such readings
 * against the textbook are in skvalp/experiments.h.
 */
#ifndef SKVALP_MEASURE_H
#define SKVALP_MEASURE_H

#include "skvalp/base.h"
#include "skvalp/bodies.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Survey: the fluid at one moment ------------------------------------------------------- */

typedef struct skv_survey skv_survey;

/** Makes an empty survey. */
SKV_API skv_result skv_survey_create(skv_survey **survey, skv_error *error);
SKV_API void skv_survey_destroy(skv_survey *survey);

/** Looks at a world: copies its particles and sorts them into cells, once for all questions that
 * follow. The survey stays valid when the world moves on, but not when it is destroyed: questions
 * near walls ask its terrain. Costs a fraction of a substep; allocates only when the world has
 * outgrown the last one. */
SKV_API skv_result skv_survey_take(skv_survey *survey, const skv_world *world, skv_error *error);

/** The fluid around a point, averaged with the kernel (1 - r/h)^2 over the smoothing radius h. */
typedef struct skv_local {
    bool wet;    /**< the free space around the point is at least half full, and it is not solid */
    double fill; /**< share of the free space that is fluid; 1 in the bulk at rest, 0.5 at a flat
                    surface */
    double density;  /**< kg/m^2: fill times the fluid's density, of several their mean */
    double pressure; /**< Pa m; a plane is fitted, so that a linear field is read exactly */
    double vx, vy;   /**< m/s, fitted in the same way */
    int particles;   /**< within h */
} skv_local;
SKV_API skv_local skv_survey_at(const skv_survey *survey, double x, double y);

/** The free surface on the way from (x0, y0), inside the fluid, to (x1, y1), outside: the outermost
 * point where fill falls to one half and behind which at least h of fluid lie, so that spray does
 * not count. Writes the distance from (x0, y0) in metres; false if no fluid is found. */
SKV_API bool skv_survey_surface(const skv_survey *survey, double x0, double y0, double x1,
                                double y1, double *distance);

/** The share of a body's area that lies below the fluid's surface, 0..1: each row across
 * gravity as far as its ends are in the fluid. A hollow of it does not count. */
SKV_API double skv_survey_submerged(const skv_survey *survey, const skv_body *body);

/** What a field shows. */
typedef enum skv_quantity {
    SKV_QUANTITY_PRESSURE,   /**< Pa m */
    SKV_QUANTITY_SPEED,      /**< m/s */
    SKV_QUANTITY_DENSITY,    /**< kg/m^2 */
    SKV_QUANTITY_VELOCITY_X, /**< m/s */
    SKV_QUANTITY_VELOCITY_Y  /**< m/s */
} skv_quantity;

/** A grid of nodes: (x + column*step, y + row*step). */
typedef struct skv_grid {
    double x, y, step;
    int columns, rows; /**< each 2..4096 */
} skv_grid;

/** Reads a quantity at every node into `values`, row by row from the bottom; NaN where the node is
 * not wet. */
SKV_API skv_result skv_survey_field(const skv_survey *survey, skv_quantity quantity,
                                    const skv_grid *grid, float *values, skv_error *error);

/** A piece of a contour line. */
typedef struct skv_segment {
    float x0, y0, x1, y1; /**< m */
} skv_segment;

/** The lines on which a field has the value `level` (marching squares, linear between nodes; cells
 * with a NaN are left out). Writes at most `capacity` pieces, cell by cell, the higher values on
 * their left; returns how many there are in all. */
SKV_API int skv_contours(const skv_grid *grid, const float *values, double level,
                         skv_segment *segments, int capacity);

/** A point of a streamline. */
typedef struct skv_point {
    float x, y; /**< m */
} skv_point;

/** Follows the present velocity downstream from (x, y) in steps of `step` metres (midpoint rule)
 * until it leaves the fluid, comes to rest (speed below 1e-6 m/s) or `capacity` points are written.
 * A negative step goes upstream. Returns the number of points, the start included; 0 if it is not
 * in fluid. */
SKV_API int skv_streamline(const skv_survey *survey, double x, double y, double step,
                           skv_point *points, int capacity);

/* ---- Surface: the outline of the fluid, for drawing ------------------------------------------ */

typedef struct skv_surface skv_surface;

/** How to look for it. Initialise with skv_default_surface_def. */
typedef struct skv_surface_def {
    uint32_t cookie;
    double step;  /**< m: of the grid on which it is found; 0, the default: a spacing */
    double level; /**< the fill that is the surface, 0.05..0.95; default 0.5. A lone particle has
                     about 0.2: with less than that every drop has an outline */
    bool closed; /**< default false: lines lie where fluid meets air and end at walls. True: they go
                    on along walls, so that each is closed and can be filled with colour */
} skv_surface_def;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_surface_def skv_default_surface_def(void);
SKV_API void skv_surface_def_init(skv_surface_def *def, size_t size);

/** Makes an empty surface. */
SKV_API skv_result skv_surface_create(skv_surface **surface, skv_error *error);
SKV_API void skv_surface_destroy(skv_surface *surface);

/** Finds the surface of the fluid that a survey has looked at: the contour on which fill has the
 * level, joined to lines, the fluid on their left. `def` may be null. Costs a few substeps with
 * the default step; allocates only when surface or grid have outgrown the last ones. Fails with
 * SKV_ERROR_VALUE (a number out of range, or a step so small that the grid has more than 4096
 * columns or rows) or SKV_ERROR_MEMORY, and has no lines then. */
SKV_API skv_result skv_surface_find(skv_surface *surface, const skv_survey *survey,
                                    const skv_surface_def *def, skv_error *error);

/** The lines: their number, and the points of one, at least 2, owned by the surface and valid until
 * it finds the next. Of a closed line the last point is joined to the first. */
SKV_API int skv_surface_line_count(const skv_surface *surface);
SKV_API const skv_point *skv_surface_line(const skv_surface *surface, int line, int *count,
                                          bool *closed);

/* ---- Instruments ---------------------------------------------------------------------------- */

#define SKV_MAX_CHANNELS 8

typedef enum skv_instrument_kind {
    SKV_INSTRUMENT_PRESSURE, /**< probe at (x0, y0): pressure; and, theory, what the water that
                                stands straight above it weighs, density times gravity times depth;
                                NaN without gravity, or where a wall is before the surface */
    SKV_INSTRUMENT_VELOCITY, /**< probe at (x0, y0): vx, vy, speed */
    SKV_INSTRUMENT_LEVEL, /**< gauge from (x0, y0) in the fluid to (x1, y1) outside: distance of the
                             surface from (x0, y0), its x, and its level, y, as the world's rulers
                             have it; for a water level, upwards */
    SKV_INSTRUMENT_GATE,  /**< segment (x0, y0)-(x1, y1): flow and particles a second, net, forward
                             and back; forward is from its left to its right as seen from (x0, y0)
                             looking at (x1, y1) */
    SKV_INSTRUMENT_FORCE, /**< on the walls inside the box: fx, fy, torque about its centre,
                             and how strong the force is */
    SKV_INSTRUMENT_ENERGY, /**< of all fluid: kinetic, potential (against y = 0), rms speed */
    SKV_INSTRUMENT_REGION, /**< fluid inside the box: particles, area, mean x, y, vx, vy, pressure,
                              rms speed */
    SKV_INSTRUMENT_RULER,  /**< from (x0, y0) to (x1, y1): length, dx, dy, angle */
    SKV_INSTRUMENT_WAVES,  /**< gauge at x0 from y0 in the fluid up to y1 above it: level and slope
                              of the surface; of the waves that have passed, as far as the history
                              reaches: mean height from trough to crest, period from one rise
                              through the mean level to the next, and steepness, height over length;
                              NaN before a wave has passed. For waves twelve smoothing radii long
                              or longer, higher than half a spacing, that run or stand anywhere but
                              at a node or a crest */
    SKV_INSTRUMENT_STOPWATCH /**< time at which another instrument's reading passed a threshold */
} skv_instrument_kind;

/** A number in a lab; zero is none. Ids of removed instruments are not used again. */
typedef uint32_t skv_instrument;

/** How to make an instrument. Initialise with skv_default_instrument_def. */
typedef struct skv_instrument_def {
    uint32_t cookie;
    skv_instrument_kind kind;
    char name[32];         /**< for exports; printable ASCII without commas and quotes */
    double x0, y0, x1, y1; /**< m; a box is spanned by two opposite corners */
    /** Readings are means over the samples of the last `window` seconds; 0: the last sample alone.
     * A gate always counts over at least one sample interval. Default 0 (gate: 0.25 s). */
    double window;
    int capacity; /**< samples that the history remembers, 1..1000000; default 1200 */
    /** Stopwatch: runs from the first sample until `channel` of `watched` has been above (or below)
     * the threshold for `hold` seconds; reads the moment at which that began. */
    skv_instrument watched;
    int channel;
    double threshold;
    bool above;
    double hold;
} skv_instrument_def;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_instrument_def skv_default_instrument_def(skv_instrument_kind kind);
SKV_API void skv_instrument_def_init(skv_instrument_def *def, size_t size,
                                     skv_instrument_kind kind);

/** What an instrument's channel is called and measured in; null past the last. Static. */
typedef struct skv_channel {
    const char *name; /**< "pressure" */
    const char *unit; /**< "Pa m" */
    bool theory; /**< not measured: what the textbook says of the channel before, as things are; to
                    be drawn as a dashed line over it */
} skv_channel;
SKV_API const skv_channel *skv_instrument_channel(skv_instrument_kind kind, int channel);
/** "pressure probe"; null past the last kind. */
SKV_API const char *skv_instrument_kind_name(skv_instrument_kind kind);

typedef struct skv_lab skv_lab;

SKV_API skv_result skv_lab_create(skv_lab **lab, skv_error *error);
SKV_API void skv_lab_destroy(skv_lab *lab);

/** Adds an instrument, with room for its history; `*id` is 0 on failure. SKV_ERROR_VALUE for
 * coordinates that are not finite, an unknown kind, a stopwatch that watches nothing. */
SKV_API skv_result skv_lab_add(skv_lab *lab, const skv_instrument_def *def, skv_instrument *id,
                               skv_error *error);
/** Moves an instrument to other points; its history starts anew. */
SKV_API skv_result skv_lab_move(skv_lab *lab, skv_instrument id, double x0, double y0, double x1,
                                double y1, skv_error *error);
/** Takes an instrument away; an unknown id is ignored. */
SKV_API void skv_lab_remove(skv_lab *lab, skv_instrument id);
/** The instruments in the order in which they were added; 0 past the last. */
SKV_API skv_instrument skv_lab_instrument(const skv_lab *lab, int i);
/** Its definition; null for an unknown id. Valid until the lab changes. */
SKV_API const skv_instrument_def *skv_lab_def(const skv_lab *lab, skv_instrument id);

/** Reads every instrument. Call it after each frame, always with the same world; if the world's
 * time has gone back (a reset), every history starts anew. Called again at the same moment, because
 * the world or an instrument was changed, it replaces that moment's sample. No allocation once
 * every instrument has read a world of this size once. Same world, same readings, bit by bit. */
SKV_API skv_result skv_lab_sample(skv_lab *lab, const skv_world *world, skv_error *error);

/** Every history starts anew, and no gate counts who has passed since the last sample: for a world
 * whose time has jumped. */
SKV_API void skv_lab_restart(skv_lab *lab);

/** The survey of the last sample, for questions besides the instruments. Owned by the lab. */
SKV_API const skv_survey *skv_lab_survey(const skv_lab *lab);

/** A channel's reading: the mean over the instrument's window of the samples that had one; NaN if
 * none had (a probe in the dry, a stopwatch that still runs, no sample yet). */
SKV_API double skv_lab_reading(const skv_lab *lab, skv_instrument id, int channel);

/** Why channels have no reading, in two or three words of English: "no water here"; null if all
 * have one. Static. */
SKV_API const char *skv_lab_lack(const skv_lab *lab, skv_instrument id);
/** All such words, for translators; null past the last. */
SKV_API const char *skv_lack_words(int i);

/** The last samples of a channel, oldest first, not averaged (a gate: the flow since the sample
 * before). Writes at most `capacity` times (s) and values; either array may be null. Returns how
 * many the history holds. */
SKV_API int skv_lab_history(const skv_lab *lab, skv_instrument id, int channel, double *times,
                            double *values, int capacity);

/** Writes the histories as CSV: a head "t [s],name channel [unit],...", then a row for every sample
 * that the shortest history still holds, oldest first, an empty field for NaN. `id` 0: all
 * instruments.
 */
SKV_API skv_result skv_lab_write_csv(const skv_lab *lab, skv_instrument id, skv_write *write,
                                     void *user, skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
