/* What a snapshot asks of whoever opens it. */
#ifndef SKV_WORLD_CROWDING_H
#define SKV_WORLD_CROWDING_H

#include "skvalp/base.h"

/* Reads a snapshot as skv_world_load does, but makes no world: its particles, and how crowded the
 * fullest square is whose side is a smoothing radius, against fluid at rest. */
skv_result skv_snapshot_ask(const void *data, size_t size, int *particles, double *crowding,
                            skv_error *error);

#endif
