/* The mailbox: what the face's thread asks of the session's, in order. One writes, one reads, and
 * neither waits for the other. */
#ifndef SKV_SESSION_MAILBOX_H
#define SKV_SESSION_MAILBOX_H

#include <stdatomic.h>

#include "session/tools.h"
#include "skvalp/stage.h"

typedef enum skv_message_kind {
    SKV_MESSAGE_OPEN,   /* request */
    SKV_MESSAGE_SAVE,   /* request */
    SKV_MESSAGE_EDIT,   /* request: a command */
    SKV_MESSAGE_SHARE,  /* number: a skv_share */
    SKV_MESSAGE_SHOW,   /* request: a skv_showing, what the face knows of it */
    SKV_MESSAGE_BESIDE, /* request: a replay of the second world, for what is saved next */
    SKV_MESSAGE_LOOK,   /* at what has changed */
    SKV_MESSAGE_STEP,
    SKV_MESSAGE_SPEED, /* x */
    SKV_MESSAGE_SEEK,  /* frame */
    SKV_MESSAGE_UNDO,
    SKV_MESSAGE_REDO,
    SKV_MESSAGE_GO_BACK, /* frame */
    SKV_MESSAGE_REPLAY,  /* number: a skv_replay */
    SKV_MESSAGE_TAKE_OVER,
    SKV_MESSAGE_LED,     /* number */
    SKV_MESSAGE_TIMED,   /* number */
    SKV_MESSAGE_PLAY,    /* play */
    SKV_MESSAGE_GRAVITY, /* x, y */
    SKV_MESSAGE_PUSH,    /* x, y */
    SKV_MESSAGE_CHOSEN,  /* chosen */
    SKV_MESSAGE_POINTER, /* pointer */
    SKV_MESSAGE_CANCEL,
    SKV_MESSAGE_PROBE_ADD,   /* probe */
    SKV_MESSAGE_PROBE_MOVE,  /* probe: number and points */
    SKV_MESSAGE_PROBE_WATCH, /* probe: number and watched */
    SKV_MESSAGE_PROBE_REMOVE /* probe: number */
} skv_message_kind;

/* For what a world's start and log are handed out. */
typedef enum skv_share {
    SKV_SHARE_LINK,
    SKV_SHARE_OFFER,        /* a second world opens it */
    SKV_SHARE_BESIDE,       /* it is the second one's, for the first's link */
    SKV_SHARE_BESIDE_WHOLE, /* for the first's file: to the end of the log */
    SKV_SHARE_BESIDE_MOMENT /* for the first's moment */
} skv_share;

/* What is played again from the start. */
typedef enum skv_replay {
    SKV_REPLAY_OWN,     /* all, and people watch */
    SKV_REPLAY_OFFERED, /* up to where it was offered; people act */
    SKV_REPLAY_OPENED   /* what was just opened, and people watch */
} skv_replay;

/* What does not fit into a message; one block of memory that goes to the reader. */
typedef struct skv_request {
    const char *name; /* a path, a label */
    const char *text; /* a format, a value; of a save: that it is of a moment; may be null */
    const void *data; /* may be null */
    size_t size;
    skv_scene_options options;
} skv_request;

/* request.c: with all that it points at; null if memory is out. To be freed. */
skv_request *skv_request_copy(const skv_request *from);

typedef struct skv_message {
    skv_message_kind kind;
    union {
        skv_request *request;
        int64_t frame;
        int number;
        struct {
            double x, y;
        };
        struct {
            int frames;
            double factor;
        } play;
        skv_chosen chosen;
        skv_pointer_event pointer; /* px, py in metres, y up */
        struct {
            uint32_t id;
            bool watched;
            skv_instrument_def def;
        } probe;
    };
} skv_message;

/* Whether its request is to be freed by who has read it. */
bool skv_message_has_request(const skv_message *message);
/* Whether it is not only for the world that is there now, which is going to be replaced. */
bool skv_message_outlives(const skv_message *message);

enum {
    SKV_MAILBOX_SIZE = 512,
    /* Moves of pointers leave so much room for what must not be lost. */
    SKV_MAILBOX_RESERVE = 256
};

typedef struct skv_mailbox {
    _Alignas(64) atomic_uint written;
    _Alignas(64) atomic_uint taken;
    skv_message list[SKV_MAILBOX_SIZE];
} skv_mailbox;

/* False if there is no room. */
bool skv_mailbox_put(skv_mailbox *box, const skv_message *message);

/* The next message, null if there is none; it is there until it is dropped. */
const skv_message *skv_mailbox_next(skv_mailbox *box);
void skv_mailbox_drop(skv_mailbox *box);

#endif
