/** @file
 * Snapshots: the whole state of a world as bytes, the same on every machine (docs/snapshot.md). A
 * world that goes on from one gives the same bits as one that was never interrupted, whatever its
 * threads and instruction set.
 */
#ifndef SKVALP_SNAPSHOT_H
#define SKVALP_SNAPSHOT_H

#include "skvalp/base.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How many bytes skv_world_save writes. `with_terrain`: the snapshot holds the terrain's picture,
 * so that skv_world_load can make a world of it; else the world it is for has to be at hand. */
SKV_API size_t skv_world_snapshot_size(const skv_world *world, bool with_terrain);

/** Writes a snapshot of skv_world_snapshot_size bytes. Fails with SKV_ERROR_LIMIT if `size` is
 * less, or with SKV_ERROR_VALUE if a particle is not finite. */
SKV_API skv_result skv_world_save(const skv_world *world, bool with_terrain, void *data,
                                  size_t size, skv_error *error);

/** Puts a world back into a state that it, or one of the same terrain, law, spacing, radius ratio,
 * solver and sleep, has been in; whatever can change while a world runs comes from the snapshot.
 * Fails with SKV_ERROR_FORMAT (no snapshot, damaged, cut short, of another version),
 * SKV_ERROR_VALUE (of another kind of world, or with values that no world has), or
 * SKV_ERROR_MEMORY, and the world stays as it was. Any bytes may be given. */
SKV_API skv_result skv_world_restore(skv_world *world, const void *data, size_t size,
                                     skv_error *error);

/** Makes a world from a snapshot with terrain; `*world` is null on failure. Any bytes may be given.
 * Of `host`, null for the defaults, what is the host's counts and nothing else: threads, pool,
 * tasks, instruction_set, capacity, log and log_user. Fails as skv_world_restore and
 * skv_world_create do. */
SKV_API skv_result skv_world_load(const void *data, size_t size, const skv_world_def *host,
                                  skv_world **world, skv_error *error);

/** Makes a second world in the same state, which shares the terrain; `*copy` is null on failure.
 * `host` as in skv_world_load: it may have the first one's pool. */
SKV_API skv_result skv_world_copy(const skv_world *world, const skv_world_def *host,
                                  skv_world **copy, skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
