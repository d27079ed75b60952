/* A stage's insides, shared by time.c, acting.c and stage.c. */
#ifndef SKV_SESSION_STAGE_H
#define SKV_SESSION_STAGE_H

#include "session/pace.h"
#include "session/session.h"
#include "skvalp/fingers.h"

/* What waits for a replay of the second world. */
typedef struct skv_errand {
    struct skv_errand *next;
    bool shares, moment; /* else it saves all from the start */
    char path[];
} skv_errand;

struct skv_stage {
    skv_stage_def def;
    skv_session *worlds[2]; /* `count` of them */
    int count;
    const skv_picture *shown[2]; /* held */
    bool timed;                  /* as in skv_stage_set_timed */
    bool apart;                  /* hands and gravity are for one side only */
    /* What a second world is told, too. */
    skv_chosen chosen;
    double speed;
    uint32_t next_probe;
    int64_t goal; /* the moment sought last, until it is reached; -1: none */
    skv_fingers fingers[2];
    /* Where a mouse or pen is over a side's view, in its pixels. */
    struct {
        bool known;
        int side;
        double px, py;
    } hover;

    skv_showing look;    /* how it is shown, but for what the first world knows itself */
    skv_errand *errands; /* of two worlds, in order */
    bool asked;          /* the second was, for the first of them */

    /* On the way to a second world. */
    int offers;                  /* that were asked of the first, and not reported yet */
    char choice[SKV_SHOWN_NAME]; /* by which it is wanted; or "" */
    skv_request *wanted; /* options for what the last one holds; null: none is wanted any more */
    skv_session *next;   /* in which that is opened; null: none */
    skv_companion
        *companion; /* it was shown beside what was opened, and is this; null: it was not */

    /* Two worlds in step. */
    skv_pace pace;
    bool introduced; /* the second has the instruments of the first */
};

/* The number of a side that is there. */
static inline int skv_stage_at(const skv_stage *stage, int side)
{
    return side == 1 && stage->count == 2;
}

/* Leaves a message for both worlds. */
static inline void skv_stage_ask(skv_stage *stage, const skv_message *message)
{
    for (int i = 0; i < stage->count; i++)
        skv_session_post(stage->worlds[i], message);
}

/* keeping.c: goes on with what is to be saved or shared of two worlds; of the first alone, once the
 * second is gone. */
void skv_stage_keep_on(skv_stage *stage);
void skv_stage_drop_errands(skv_stage *stage);
/* Takes the second world of what was opened, if there is one, and opens it. */
void skv_stage_open_companion(skv_stage *stage);
/* By which choice the second world was made; "" by none. */
void skv_stage_set_choice(skv_stage *stage, const char *choice);

/* acting.c: shows the same part of the other side's world. */
void skv_stage_follow(skv_stage *stage, int side);

/* time.c: two worlds go on together from now on; the first goes on alone. */
void skv_stage_join(skv_stage *stage, skv_replay replay);
/* Whether both have done what was asked of them, and are at one moment. */
bool skv_stage_is_level(const skv_stage *stage);
void skv_stage_part(skv_stage *stage);

#endif
