/* Task pool: runs one function over a range of indices on several threads, its own or a host's.
 *
 * The range is cut into chunks that do not depend on the number of threads; which thread runs
 * which chunk must not matter to the result. With one thread nothing is created at all.
 */
#ifndef SKV_BASE_POOL_H
#define SKV_BASE_POOL_H

#include "skvalp/base.h"

typedef struct skv_pool skv_pool;

/* Handles indices begin..end-1. */
typedef void skv_task(int begin, int end, void *context);

/* Creates a pool of `threads` threads, the caller's included; 0: one per physical core. */
skv_result skv_pool_create(int threads, skv_pool **pool, skv_error *error);
void skv_pool_destroy(skv_pool *pool);

/* Creates a pool on a host's threads instead. */
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

/* For waits between members that are shorter than a barrier: call in a loop with `*turns` from 0.
 */
void skv_pool_pause(int *turns);

#endif
