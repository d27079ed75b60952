/* A snapshot between its bytes and a world; shared by snapshot.c, which knows the format, and
 * restore.c, which knows worlds. */
#ifndef SKV_WORLD_SNAPSHOT_H
#define SKV_WORLD_SNAPSHOT_H

#include "base/bytes.h"
#include "world/world_internal.h"

/* What a snapshot says, its particles apart. */
typedef struct skv_snapshot {
    skv_world_def def; /* without terrain and threads; substeps: those at present */
    bool substeps_fixed, with_load, with_names, with_ramp, with_fluids, with_holds, with_bodies;
    bool with_touches, with_air, with_compression;
    unsigned liquid_extras; /* liquids.h */
    unsigned holds;         /* of the particles' attributes: skv_saved */
    skv_load load;
    skv_ramp ramp;
    float filled, compression;
    double due, time, watched;
    int64_t steps;
    int stepped;
    uint32_t next_id;
    skv_acting acting;
    skv_reader bodies, springs, air; /* where they begin */

    uint64_t terrain_hash;
    bool with_terrain;
    skv_terrain_def terrain; /* without coverage, which begins at `picture` */
    skv_reader picture;

    int count; /* particles */
    int ends;  /* how many of them springs need */
    skv_reader particles;
} skv_snapshot;

/* Reads and checks all of a snapshot. */
skv_result skv_snapshot_read(const void *data, size_t size, skv_snapshot *snapshot,
                             skv_error *error);

/* Writes the picture, width * height bytes; false if it is not that long. */
bool skv_snapshot_picture(const skv_snapshot *snapshot, uint8_t *coverage);

/* Writes the particles into a state with room for them. */
void skv_snapshot_particles(const skv_snapshot *snapshot, skv_state *state);

#endif
