/* The worker: what is open, and what the session's thread does with it. A session without a thread
 * of its own lets it work within its calls. */
#ifndef SKV_SESSION_WORKER_H
#define SKV_SESSION_WORKER_H

#include "base/platform.h"
#include "session/forecast.h"
#include "session/gallery.h"
#include "session/mailbox.h"
#include "session/pace.h"
#include "session/player.h"
#include "session/probes.h"
#include "session/tools.h"

/* Reports that wait; what is handed out, each at a place of its own. */
enum { SKV_REPORTS = 16, SKV_SHARES = 3 };

/* What a link holds, or a part of one. */
typedef struct skv_shared {
    skv_result result; /* not SKV_OK: without bytes, and why */
    skv_error error;
    size_t size;
    char bytes[];
} skv_shared;

/* A world that was shown beside what was opened. */
typedef struct skv_companion {
    char choice[SKV_SHOWN_NAME];
    bool apart;
    bool still; /* nothing plays at first */
    size_t size;
    uint8_t bytes[]; /* its replay */
} skv_companion;

typedef struct skv_worker {
    skv_mailbox mailbox; /* between the threads */
    skv_stage_def def;
    skv_pool *pool;

    /* Between the threads. */
    skv_gallery gallery;
    atomic_llong elapsed;    /* ns that have passed and were not taken yet */
    atomic_uint posted;      /* rises with everything that may concern the worker */
    atomic_uint settled;     /* up to which of these all is done and can be seen */
    atomic_int drawing;      /* us that the last picture took to draw */
    _Atomic double interval; /* s between the face's last two pictures */
    atomic_uint played;      /* frames of those granted */
    atomic_int openings;     /* asked for and not begun */
    atomic_int savings;      /* of files and links, asked for and not done */
    atomic_bool paused, active, quit;
    skv_threads *threads; /* where both wait for the counters above */
    /* For a link, for a second world, for the first's link. Who takes one out owns it; null: none,
     * or taken out. */
    _Atomic(skv_shared *) shared[SKV_SHARES];
    _Atomic(skv_companion *) companion;
    skv_outcome reports[SKV_REPORTS];
    atomic_uint reported, reports_taken;

    /* The worker's own. */
    skv_player *player; /* null: nothing is open */
    skv_opened *opened;
    skv_pace pace;
    skv_toolbox tools;
    skv_probes probes;
    skv_request *beside; /* a replay of the second world, for what is saved next; null: none */
    uint64_t wary; /* hash of the last that was not opened because it asks for much; 0: none */
    double tilt_x, tilt_y; /* gravity as asked for, in units of the scene's own */
    skv_hand hands[SKV_MAX_HANDS];
    int hand_count;
    unsigned withheld; /* things that people did while it was watched */
    bool tilt_pending;
    bool following;   /* plays what a replay says, until somebody takes over */
    bool watching;    /* nobody has taken over: what people do is not done */
    bool stops;       /* time stands still at the end of what is followed */
    bool followed;    /* to the end */
    bool again;       /* it was played here before: nobody recorded it */
    bool halted;      /* a step was stopped for what is to be opened: the world is at no moment */
    bool timed;       /* time passes though the fluid rests */
    bool led;         /* frames are granted (led.h) */
    bool hands_known; /* the world's are these */
    bool begins;      /* an edit, with the next command that the world takes */
    bool refused;     /* an edit was, since the last picture: said once */
    bool dry;         /* taps stand at the limit of emitters, and it was told */
    bool unbalanced;  /* no substep was taken since the balance was changed, and none foreseen */
    bool unread;      /* instruments, since they or the world were changed */
    bool changed;     /* since the last picture */
    skv_showing look; /* what the face says of it */
    skv_forecast forecast;
} skv_worker;

/* Nothing open, nothing asked for; pool and threads are the session's affair. */
void skv_worker_start(skv_worker *worker, const skv_stage_def *def);
/* Frees what is open and what was not looked at. */
void skv_worker_close(skv_worker *worker);

/* Whether nobody waits any more for the step of a worker that runs. */
bool skv_worker_is_unwanted(void *worker);

/* Does all that there is to do. */
void skv_worker_pump(skv_worker *worker);

/* openings.c: opens what a request says; saves to where it says; makes what a link holds. Report by
 * themselves. */
void skv_worker_open(skv_worker *worker, const skv_request *request);
void skv_worker_save(skv_worker *worker, const skv_request *request);
void skv_worker_share(skv_worker *worker, skv_share share);
/* Whether a file of this name is to hold a replay. */
bool skv_names_replay(const char *path);

/* shown.c: takes what the face says of how it is shown, or a second world's replay; tells the
 * player how it is shown, before it is saved or shared; shows what was opened as that says. */
void skv_worker_hear_shown(skv_worker *worker, const skv_message *message);
skv_result skv_worker_tell_shown(skv_worker *worker, bool plain, skv_error *error);
void skv_worker_show(skv_worker *worker, bool changed);

/* scenery.c: tells the face, with the next picture. */
void skv_worker_report(skv_worker *worker, skv_outcome_kind kind, const skv_error *error);
/* Hangs up a picture of everything; false if that has to wait. */
bool skv_worker_publish(skv_worker *worker);
bool skv_worker_at_rest(const skv_worker *worker);

#endif
