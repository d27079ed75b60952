/* Task pool: runs one function over a range of indices on several threads, its own or a host's.
 *
 * The range is cut into chunks that do not depend on the number of threads; which thread runs
 * which chunk must not matter to the result. With one thread nothing is created at all.
 */
#ifndef SKV_BASE_POOL_H
#define SKV_BASE_POOL_H

#include "skvalp/base.h"

#include <stdatomic.h>

/* Handles indices begin..end-1. */
typedef void skv_task(int begin, int end, void *context);

/* Like skv_pool_create, but on a host's threads. */
skv_result skv_pool_create_lent(const skv_task_system *tasks, skv_pool **pool, skv_error *error);

/* The most threads that a team can have, the caller's included. */
int skv_pool_threads(const skv_pool *pool);

/* Runs `task` over 0..count-1 and returns when all of it is done; without a pool (null) on the
 * calling thread. Not reentrant. */
void skv_pool_run(skv_pool *pool, int count, skv_task *task, void *context);

/* Runs `member` once on each of `threads` threads at the same time, with the thread's index
 * 0..threads-1; the members may meet in skv_pool_barrier. Own threads make a team of all, lent ones
 * of those that came. Without a pool: once, with 0 of 1. */
typedef void skv_member(int thread, int threads, void *context);
void skv_pool_team(skv_pool *pool, skv_member *member, void *context);

/* Waits until every member of the running team is here. What was written before is seen after. */
void skv_pool_barrier(skv_pool *pool);

/* A barrier at which the last member to come runs `work` before anybody goes on. */
void skv_pool_gather(skv_pool *pool, void (*work)(void *context), void *context);

/* Work that can be stopped begins. Whether it is to stop: asks, unless it was said already. Whether
 * that was said. */
void skv_pool_go(skv_pool *pool);
bool skv_pool_asks_to_stop(skv_pool *pool);
bool skv_pool_is_stopped(const skv_pool *pool);

/* How far a member has come, for waits of one member for another that need no barrier: a number
 * that only rises. On a cache line of its own, where its writer meets nobody but who waits. */
typedef struct skv_progress {
    _Alignas(64) atomic_uint reached;
} skv_progress;

/* Raises the caller's progress, and waits until another's has come so far. What was written before
 * the first is seen after the second. */
void skv_pool_reach(skv_pool *pool, skv_progress *own, unsigned reached);
void skv_pool_await(skv_pool *pool, skv_progress *other, unsigned reached);

#endif
