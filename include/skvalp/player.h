/** @file
 * Player: a world that is played with, and can be played again.
 *
 * A player steps a world in whole frames of 1/60 s and keeps a log of what was done to it: at which
 * frame which command. Start and log give every later moment, bit for bit, so this one log is undo
 * and redo, rewinding, replay files and recordings. No clock and no thread of its own: whoever
 * calls it decides when a frame is due (docs/stage.md).
 *
 * A moment lies between two frames. What is at hand after rewinding is played again as it was; the
 * first command given there cuts off what came after, and skv_player_redo brings it back.
 */
#ifndef SKVALP_PLAYER_H
#define SKVALP_PLAYER_H

#include "skvalp/acting.h"
#include "skvalp/base.h"
#include "skvalp/scene.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What can be done to a world between two frames. */
typedef enum skv_command_kind {
    SKV_COMMAND_MARK,    /**< nothing; here skv_player_undo goes back to */
    SKV_COMMAND_CHECK,   /**< nothing; the world's hash has to be this one */
    SKV_COMMAND_HANDS,   /**< skv_world_set_hands */
    SKV_COMMAND_GRAVITY, /**< skv_world_set_gravity */
    SKV_COMMAND_PUSH,    /**< skv_world_add_velocity to all particles */
    SKV_COMMAND_SET,     /**< skv_world_set */
    SKV_COMMAND_POUR,    /**< an aligned skv_world_fill */
    SKV_COMMAND_TAKE,    /**< skv_world_remove_area */
    SKV_COMMAND_PAINT,   /**< skv_terrain_paint and skv_world_set_terrain */
    SKV_COMMAND_EMIT,    /**< skv_world_set_emitters, with one more */
    SKV_COMMAND_DRAIN,   /**< skv_world_set_drains, with one more, which takes all */
    SKV_COMMAND_CLOSE,   /**< both, and fans, without those whose middle a brush comes over; a fan
                            is a force in a swept circle, which only commands make; and bodies over
                            which its way leads */
    SKV_COMMAND_DYE,     /**< skv_world_dye_area, and the emitters whose middle it comes over */
    SKV_COMMAND_FORCE,   /**< skv_world_set_forces, with one more, another, or one less */
    SKV_COMMAND_DROP     /**< skv_world_add_body, where there is room */
} skv_command_kind;

typedef struct skv_hands {
    int count;
    skv_hand list[SKV_MAX_HANDS];
} skv_hands;
typedef struct skv_vector {
    float x, y;
} skv_vector;
typedef struct skv_assignment {
    char path[64], text[64];
} skv_assignment;
typedef struct skv_dab {
    float x0, y0, x1, y1, radius; /**< m: of a brush on a straight way */
    float vx, vy;                 /**< of water that is poured, m/s */
    int dye;                      /**< of water that is poured or dyed */
    int fluid;                    /**< number of the fluid that is poured, as skv_world_liquid */
} skv_dab;

#define SKV_MOST_STROKES 16
typedef struct skv_strokes {
    int count;
    skv_brush_stroke list[SKV_MOST_STROKES];
} skv_strokes;

/** One force field comes, is replaced or goes; the others stay as they are, and in their order. */
typedef struct skv_force_change {
    int place;       /**< of the force in skv_world_forces, counted from 0; -1: one more */
    bool remove;     /**< it goes; not with place -1 */
    skv_force force; /**< what comes there, unless it goes */
} skv_force_change;

/** A body that comes: of a shape that skv_drop_shape names, in a circle of a radius about (x, y).
 */
typedef struct skv_drop {
    int shape;     /**< counted from 0 */
    float x, y;    /**< m */
    float vx, vy;  /**< m/s */
    float radius;  /**< m */
    float density; /**< kg/m^2 */
} skv_drop;

/** "duck", "ball", "crate"; null beyond. Static. */
SKV_API const char *skv_drop_shape(int i);

/** A command: plain data, with nothing in it that depends on the machine or the hour. */
typedef struct skv_command {
    skv_command_kind kind;
    union {
        uint64_t hash;          /**< CHECK */
        skv_hands hands;        /**< HANDS */
        skv_vector vector;      /**< GRAVITY: m/s^2; PUSH: m/s */
        skv_assignment set;     /**< SET */
        skv_dab water;          /**< POUR, TAKE, DRAIN, CLOSE, DYE */
        skv_emitter source;     /**< EMIT */
        skv_strokes paint;      /**< PAINT: walls drawn and erased */
        skv_force_change force; /**< FORCE */
        skv_drop drop;          /**< DROP */
    };
} skv_command;

typedef struct skv_player skv_player;

/** How to make a player. Initialise with skv_default_player_def. */
typedef struct skv_player_def {
    uint32_t cookie;
    int threads;    /**< as in skv_world_def */
    skv_pool *pool; /**< threads shared with other worlds; null: threads of its own */
    size_t history; /**< bytes for key frames, from which rewinding starts; default 64 MiB */
    const skv_scene_options *changed; /**< set over the scene of a replay that is loaded: what was
                                         done is done to this one, which goes its own way, and no
                                         check is made; null: none */
} skv_player_def;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_player_def skv_default_player_def(void);
SKV_API void skv_player_def_init(skv_player_def *def, size_t size);

/** Makes a player at a scene's start. Takes the scene over if it succeeds; `*player` is null on
 * failure. `def` may be null. */
SKV_API skv_result skv_player_create(skv_scene *scene, const skv_player_def *def,
                                     skv_player **player, skv_error *error);

/** Makes a player from bytes that skv_player_save has written, at the start and with the whole log
 * before it, or from a snapshot with terrain. Fails with SKV_ERROR_FORMAT (neither, damaged, cut
 * short, of another version), SKV_ERROR_VALUE or SKV_ERROR_MEMORY. Any bytes may be given. */
SKV_API skv_result skv_player_load(const void *data, size_t size, const skv_player_def *def,
                                   skv_player **player, skv_error *error);
SKV_API void skv_player_destroy(skv_player *player);

/** What a replay or a state asks of whoever opens it. */
typedef struct skv_demands {
    int64_t frames;  /**< that it plays */
    int particles;   /**< with which it begins */
    int at_once;     /**< commands that it gives before one frame, at most */
    double crowding; /**< of a state: the particles in the fullest square whose side is a smoothing
                          radius, against those of fluid at rest */
} skv_demands;

/** More than these nobody's play needs, and it takes long or much memory: a face asks before it
 * opens what a stranger may have sent. Half an hour; what is there in a second; a wall painted
 * while time stands still; three times what any fluid was seen pressed to. */
#define SKV_MODEST_FRAMES    108000
#define SKV_MODEST_PARTICLES 100000
#define SKV_MODEST_AT_ONCE   5000
#define SKV_MODEST_CROWDING  10

/** Finds out what bytes ask for that skv_player_load would take, without making a world. Fails as
 * that does. Any bytes may be given; of a log at most 16 MiB are read. */
SKV_API skv_result skv_player_ask(const void *data, size_t size, skv_demands *demands,
                                  skv_error *error);
/** SKV_ERROR_LIMIT, and a message that says what it asks for, if demands are not modest. */
SKV_API skv_result skv_demands_check(const skv_demands *demands, skv_error *error);

/** Its world, for reading. */
SKV_API const skv_world *skv_player_world(const skv_player *player);
/** Its scene; null for a player that began with a snapshot, and with a replay of one. */
SKV_API const skv_scene *skv_player_scene(const skv_player *player);

/** Does something to the world, now, and logs it; what came after this moment is cut off. What the
 * world refuses is not logged, and its error is returned. */
SKV_API skv_result skv_player_apply(skv_player *player, const skv_command *command,
                                    skv_error *error);
/** The same with a mark before it, which goes with it if it is refused: an edit, or the first
 * command of one. */
SKV_API skv_result skv_player_edit(skv_player *player, const skv_command *command,
                                   skv_error *error);

/** One frame on, along the log as far as it goes; while a moment is sought, a bounded piece of work
 * towards it. Of a frame before which the log has more than 256 commands so many are given, and it
 * comes with a later call. Fails as skv_world_step does, and may be called again. */
SKV_API skv_result skv_player_step(skv_player *player, skv_error *error);

/** Frames since the start, at present and at the log's end. */
SKV_API int64_t skv_player_frame(const skv_player *player);
SKV_API int64_t skv_player_end(const skv_player *player);

/** Seeks a moment, 0 to skv_player_end, cut to that: the nearest key frame before it is taken up at
 * once, and skv_player_step goes on from there until skv_player_seeking is false. */
SKV_API skv_result skv_player_seek(skv_player *player, int64_t frame, skv_error *error);
SKV_API bool skv_player_seeking(const skv_player *player);

/** Cuts off what comes after this moment. skv_player_redo brings it back. */
SKV_API skv_result skv_player_cut(skv_player *player, skv_error *error);

/** Back to before the last mark, and on again to where undo or cut was called: the moment is sought
 * as by skv_player_seek. Nothing happens if there is none. A new mark ends what can be redone. */
SKV_API bool skv_player_can_undo(const skv_player *player);
SKV_API bool skv_player_can_redo(const skv_player *player);
SKV_API skv_result skv_player_undo(skv_player *player, skv_error *error);
SKV_API skv_result skv_player_redo(skv_player *player, skv_error *error);

/** The first frame at which the world was not the one of the log's checks, which happens if another
 * version of the library wrote it; -1 if there was none so far. */
SKV_API int64_t skv_player_mismatch(const skv_player *player);

/** Bytes that key frames take at present. */
SKV_API size_t skv_player_history(const skv_player *player);

/** Writes start and log as a replay file. Not while a moment is sought. Fails with SKV_ERROR_FILE
 * if `write` does, or with SKV_ERROR_MEMORY. */
SKV_API skv_result skv_player_save(const skv_player *player, skv_write *write, void *user,
                                   skv_error *error);

/** Writes this moment as a replay file that begins and ends here: its scene, the state, and no log.
 * Fails as skv_player_save does. */
SKV_API skv_result skv_player_save_moment(const skv_player *player, skv_write *write, void *user,
                                          skv_error *error);

/** Writes a replay for a link (skvalp/link.h): without the state it began with, which is made again
 * from the scene, and up to this moment, whose hash comes last. Fails with SKV_ERROR_VALUE if there
 * is no scene to make it from: it began with a snapshot, or with a picture of more than 1 MiB. */
SKV_API skv_result skv_player_share(const skv_player *player, skv_write *write, void *user,
                                    skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
