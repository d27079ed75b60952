/* The player's inside, shared by moments.c (where its world is put back to), branches.c (undo and
 * redo), player.c (going on) and replay.c (files); each uses those before it. */
#ifndef SKV_SESSION_PLAYER_H
#define SKV_SESSION_PLAYER_H

#include "session/history.h"
#include "session/showing.h"

/* What was cut off, and from where. */
typedef struct skv_branch {
    skv_position cut;
    uint8_t *tail; /* of the log */
    size_t size;
    int64_t end;
    skv_history keys; /* after `cut`; the last one at its end */
} skv_branch;

enum { SKV_MOST_BRANCHES = 16 };

struct skv_player {
    skv_player_def def;
    skv_scene *scene;
    skv_world *world;
    skv_terrain *terrain; /* at the start, shared */
    uint8_t *recipe;      /* of its scene; null: none */
    size_t recipe_size;
    bool saved_start; /* it was read, and not made from the scene */
    skv_showing showing;
    uint8_t *second; /* a replay of the world beside it, to be kept with its own; null: none */
    size_t second_size;
    bool adrift; /* the world is at no moment: one has to be taken up */
    skv_log log;
    skv_history keys; /* the first one at the start */
    skv_position now;
    int64_t end;

    skv_position *marks; /* of the log, in order */
    int mark_count, mark_capacity;
    skv_branch branches[SKV_MOST_BRANCHES]; /* the latest last */
    int branch_count;

    skv_position shared; /* up to where the log was handed out last; frame -1: it was not */

    bool seeking;
    skv_position goal;
    int64_t mismatch; /* frame, or -1 */
};

/* moments.c: a second world at the start. */
skv_result skv_player_make_start(const skv_player *player, skv_world **world, skv_error *error);
/* Seeks a position of the log; `from_here`: the world is at a moment of the log. */
skv_result skv_player_seek_to(skv_player *player, skv_position goal, bool from_here,
                              skv_error *error);
/* Makes a key frame of this moment, if memory allows. */
void skv_player_keep(skv_player *player);
/* Writes key frame `i`, of which this moment is one, as it lies in memory; nothing beyond the last.
 * The same program takes it back in a player of this one's replay; no file holds it, for nobody
 * checks that it is of that log. False if there is one of its moment, none such, or no memory. */
void skv_player_write_key(skv_player *player, int i, skv_write *write, void *user);
bool skv_player_take_key(skv_player *player, const uint8_t *written);

/* branches.c */
void skv_branch_free(skv_branch *branch);
skv_result skv_player_reserve_mark(skv_player *player, skv_error *error);
/* Notes a mark at the present position; there is room for it. What was cut off is gone. */
void skv_player_add_mark(skv_player *player);
/* Writes what was cut off as number `i`, the oldest first, as it lies in memory; nothing beyond the
 * last. The same program takes it back, in this order, in a player of this one's replay; as
 * skv_player_write_key. */
void skv_player_write_branch(const skv_player *player, int i, skv_write *write, void *user);
bool skv_player_take_branch(skv_player *player, const uint8_t *written);
/* Cuts the log at one of its positions. */
skv_result skv_player_cut_at(skv_player *player, skv_position cut, skv_error *error);
/* The frames to which undo and redo lead; -1: nowhere. */
int64_t skv_player_undo_frame(const skv_player *player);
int64_t skv_player_redo_frame(const skv_player *player);
/* Finds the marks of the log from `at` on. */
skv_result skv_player_find_marks(skv_player *player, size_t at, skv_error *error);

/* replay.c: what is kept with its replays from now on: how it is shown, and a replay of a second
 * world, of size 0 without one. Nothing changes on failure. */
skv_result skv_player_show(skv_player *player, const skv_showing *showing, const uint8_t *second,
                           size_t size, skv_error *error);

/* As skv_player_share, up to the log's end, and with all of its checks. */
skv_result skv_player_share_whole(const skv_player *player, skv_write *write, void *user,
                                  skv_error *error);

/* player.c: whether nothing was stepped since the balance was changed, or at all: pressures are
 * those of what was there before. */
bool skv_player_unbalanced(const skv_player *player);

/* Gives a player that has none its scene. Nothing changes on failure. */
skv_result skv_player_take_scene(skv_player *player, skv_scene *scene, skv_error *error);
/* Back to a frame, and what comes after is cut off: as undo goes to a mark. */
skv_result skv_player_go_back(skv_player *player, int64_t frame, skv_error *error);
/* Back to where it was shared last, and what comes after is cut off. */
skv_result skv_player_cut_to_shared(skv_player *player, skv_error *error);
/* A player at the start of a world, which it takes over with the scene (may be null). */
skv_result skv_player_begin(skv_world *world, skv_scene *scene, const skv_player_def *def,
                            skv_player **player, skv_error *error);

#endif
