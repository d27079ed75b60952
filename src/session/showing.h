/* How a moment was shown: what a replay or a link holds beside the world and its log, so that who
 * opens it sees what was seen (docs/stage.md). */
#ifndef SKV_SESSION_SHOWING_H
#define SKV_SESSION_SHOWING_H

#include "base/bytes.h"
#include "skvalp/stage.h"

/* Characters of names, with the end: those of all overlays together have fewer. */
enum { SKV_SHOWN_NAMES = 128, SKV_SHOWN_NAME = 32 };

typedef struct skv_shown_probe {
    skv_instrument_kind kind;
    double x0, y0, x1, y1; /* m */
    bool watched;
} skv_shown_probe;

typedef struct skv_showing {
    char view[SKV_SHOWN_NAME], overlays[SKV_SHOWN_NAMES]; /* as the renderer names them; or "" */
    char choice[SKV_SHOWN_NAME]; /* what a second world differs in; or "" */
    bool paused;                 /* time stood still at the last moment */
    bool apart;                  /* hands were for one of two worlds */
    int probe_count;
    skv_shown_probe probes[SKV_MOST_PROBES];
} skv_showing;

/* Takes a list of names over; one that is none, or too long, becomes "". */
void skv_shown_name(char *to, size_t room, const char *names);

/* Whether it says nothing. */
bool skv_showing_is_plain(const skv_showing *showing);

void skv_showing_put(skv_writer *writer, const skv_showing *showing);
/* From any bytes; false if they are none. */
bool skv_showing_get(skv_reader *reader, skv_showing *showing);

/* keeping.c: by which choice the second world is made that was asked for last; "" by none. */
void skv_stage_want_choice(skv_stage *stage, const char *choice);

#endif
