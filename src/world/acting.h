/* What acts on a world's fluid beside gravity: it is set by the host, and all of it is in
 * snapshots. */
#ifndef SKV_WORLD_ACTING_H
#define SKV_WORLD_ACTING_H

#include "base/bytes.h"
#include "skvalp/acting.h"
#include "skvalp/particles.h"
#include "solver/solver.h"

/* What an emitter has to go on with. */
enum { SKV_RECENT_ROWS = 8 };
typedef struct skv_stream {
    double travelled; /* way of the fluid since the emitter was set, m */
    double way;       /* since the last row, m */
    bool odd;         /* which row is next: rows alternate */
    bool pauses;      /* it is closed, or it cannot emit; found anew before each substep */
    skv_particle_id recent[SKV_RECENT_ROWS]; /* the first particle of the last rows, newest first */
} skv_stream;

typedef struct skv_acting {
    skv_hand hands[SKV_MAX_HANDS];
    int hand_count;
    skv_force forces[SKV_MAX_FORCES];
    int force_count;
    skv_emitter emitters[SKV_MAX_EMITTERS];
    int emitter_count;
    skv_drain drains[SKV_MAX_DRAINS];
    int drain_count;
    /* Their names, ascending in each list, and the number of the last name given. */
    skv_acting_id hand_ids[SKV_MAX_HANDS];
    skv_acting_id force_ids[SKV_MAX_FORCES];
    skv_acting_id emitter_ids[SKV_MAX_EMITTERS];
    skv_acting_id drain_ids[SKV_MAX_DRAINS];
    uint32_t named;
    /* How far they are. */
    skv_stream streams[SKV_MAX_EMITTERS];
    double drainable[SKV_MAX_DRAINS]; /* particles that may go, of a drain with a rate */
    skv_flow flow;
} skv_acting;

/* All of it as a solver sees it, for a smoothing radius and substeps of `dt`; returns their number.
 * They refer to `acting`. */
int skv_make_external_forces(const skv_acting *acting, float h, float dt,
                             skv_external_force forces[SKV_SOLVER_MOST_FORCES]);

/* The largest acceleration that may come on top of gravity, m/s^2. */
float skv_acting_strength(const skv_acting *acting);

/* The pressure over density, m^2/s^2, that it may add to that of gravity in a world of this size:
 * each force along the longest way through its area, and where the fastest jet is stopped. */
float skv_acting_head(const skv_acting *acting, float width, float height);
/* That of the fastest jet alone. */
float skv_emitted_head(const skv_acting *acting);

/* Writes or reads all of it but names; what has been read is checked for a world with so many
 * fluids. */
skv_result skv_exchange_acting(skv_port *port, skv_acting *acting, int fluids, skv_error *error);

#endif
